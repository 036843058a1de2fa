#pragma once
// A recorded run with all that is drawn and said of it, whatever its scalar. A value that is shared and never changed:
// an edit makes a new one.

#include <memory>

#include "lesson/lesson.hpp"
#include "scene/step_scene.hpp"

namespace blossom {

class Recording {
 public:
  // In exact arithmetic or in double precision. Diagnostics as those of record().
  static Checked<std::shared_ptr<const Recording>> make(const Algorithm&, const Inputs<Exact>&, bool exact);
  virtual ~Recording() = default;
  Recording() = default;
  Recording(const Recording&) = delete;

  const Algorithm& algorithm() const { return *source().algorithm; }
  const TraceGraph& graph() const { return *source().graph; }
  const StepSource& source() const { return *source_; }
  const StepScenes& scenes() const { return *scenes_; }
  std::uint32_t last() const { return graph().step_count() - 1; }
  // What a template says at a step; empty optional if something in it names nothing there.
  virtual std::optional<std::string> fill(std::string_view text, std::uint32_t step) const = 0;
  virtual std::size_t memory_bytes() const = 0;
  virtual std::string trace_json() const = 0;  // algorithms/trace_json.hpp
  // The beats of a lesson in this run, whose inputs may be others than the lesson's.
  virtual std::vector<Beat> beats(const LessonScene&) const = 0;

 protected:
  std::unique_ptr<StepSource> source_;
  std::unique_ptr<StepScenes> scenes_;
};

}  // namespace blossom
