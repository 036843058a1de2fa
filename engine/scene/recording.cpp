#include "scene/recording.hpp"

#include "algorithms/trace_json.hpp"

namespace blossom {
namespace {

constexpr int shown_digits = 6;  // of decimals, in panels

template <Scalar S>
class RecordingOf final : public Recording {
 public:
  explicit RecordingOf(Run<S> run) : run_(std::move(run)), narrator_(run_, shown_digits) {
    source_ = std::make_unique<StepSource>(make_source(narrator_));
    scenes_ = std::make_unique<StepScenes>(*source_);
  }

  std::optional<std::string> fill(std::string_view text, std::uint32_t step) const override {
    std::vector<std::string> unknown;
    std::string filled = narrator_.fill(text, step, &unknown);
    return unknown.empty() ? std::optional(std::move(filled)) : std::nullopt;
  }
  std::size_t memory_bytes() const override { return run_.trace.memory_bytes(); }
  std::string trace_json() const override { return write_trace(Narrator<S>(run_)); }
  std::vector<Beat> beats(const LessonScene& scene) const override { return resolve_beats(scene, run_.trace); }

 private:
  Run<S> run_;
  Narrator<S> narrator_;
};

template <Scalar S>
Checked<std::shared_ptr<const Recording>> make_recording(const Algorithm& algorithm, const Inputs<Exact>& inputs) {
  auto run = record<S>(algorithm, inputs);
  if (!run) return run.diagnostics;
  return std::shared_ptr<const Recording>(std::make_shared<RecordingOf<S>>(std::move(*run)));
}

}  // namespace

Checked<std::shared_ptr<const Recording>> Recording::make(const Algorithm& algorithm, const Inputs<Exact>& inputs,
                                                          bool exact) {
  return exact ? make_recording<Exact>(algorithm, inputs) : make_recording<double>(algorithm, inputs);
}

}  // namespace blossom
