#include "base/json_write.hpp"
#include "grader/variant_trial.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_tries = 64;  // of one value, with others drawn around it

bool is_number_or_text(const Json& json) { return json.kind == Json::Kind::number || json.kind == Json::Kind::string; }

class RangeCheck {
 public:
  explicit RangeCheck(const VariantMaker::Prepared& prepared)
      : prepared_(&prepared), root_(prepared.document, diagnostics) {}

  Diagnostics check() {
    const Cursor list = *root_.optional("vary")->optional("inputs");
    for (const Slot& slot : prepared_->vary.slots) {
      const Cursor entry = list[slot.entry];
      const auto last = static_cast<std::size_t>(prepared_->vary.choices[slot.choices].count) - 1;
      if (const auto choose = entry.optional("choose")) {
        for (std::size_t n = 0; n <= last; ++n) look((*choose)[n], slot, n, true);
      } else if (const auto integers = entry.optional("integers")) {
        look((*integers)[0], slot, 0, false);
        look((*integers)[1], slot, last, false);
      } else if (const auto fractions = entry.optional("fractions")) {
        look(*fractions->optional("from"), slot, 0, false);
        look(*fractions->optional("to"), slot, last, false);
      } else if (const auto grid = entry.optional("grid")) {
        look((*grid->optional("from"))[slot.coordinate], slot, 0, false);
        look((*grid->optional("to"))[slot.coordinate], slot, last, false);
      }
    }
    return std::move(diagnostics);
  }

 private:
  // The n-th value of a slot, among the model's numbers and then among others. Of a range, which may well be wider than
  // what is taken of it, only what the algorithm itself does not take is a mistake.
  void look(const Cursor& at, const Slot& slot, std::size_t n, bool chosen) {
    const Json value = prepared_->vary.choices[slot.choices].value(n);
    Json inputs = prepared_->inputs;
    VariantStream stream("", prepared_->model.id, "");
    std::string first_why;
    for (std::size_t i = 0; i < most_tries; ++i) {
      if (i > 0) draw(prepared_->vary, stream, inputs);
      at_path(inputs, slot.path) = value;
      std::string why;
      const bool good = Trial(*prepared_, inputs).comes_to_values([&](const Demand& demand, const auto& reason) {
        const bool counts =
            demand.kind == Demand::Kind::inputs ||
            (chosen && (demand.kind == Demand::Kind::no_knot || demand.kind == Demand::Kind::same_steps));
        if (counts) why = reason();
        return !counts;
      });
      if (good || why.empty()) return;
      if (first_why.empty()) first_why = why;
    }
    at.error("nobody can be given this: with " + slot.name +
             (is_number_or_text(value) ? " = " + printable(value.text) : " as it is here") + " " + first_why);
  }

  const VariantMaker::Prepared* prepared_;
  Diagnostics diagnostics;
  Cursor root_;
};

}  // namespace

Diagnostics check_ranges(const VariantMaker::Prepared& prepared) { return RangeCheck(prepared).check(); }

}  // namespace blossom
