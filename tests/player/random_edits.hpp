#pragma once
// What the player's tests share: edits as somebody makes them who tries everything.

#include <random>
#include <string>

#include "player/edit.hpp"

namespace blossom::test {

struct RandomEdit {
  std::string what;
  Edited edited;
};

class RandomEdits {
 public:
  explicit RandomEdits(unsigned seed) : random_(seed) {}

  int whole(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random_); }

  RandomEdit next(const Algorithm& algorithm, const Inputs<Exact>& inputs) {
    const auto curves = curves_of(inputs);
    if (curves.empty()) return other_input(algorithm, inputs);
    const CurveAddress at = curves[index(curves.size())];
    const Curve<Exact>& curve = curve_at(inputs, at);
    const std::size_t point = index(curve.points.size()), knot = index(curve.knots.size());
    const PointAddress address{at.input, at.curve, point};
    const std::string place = at.input + "[" + std::to_string(at.curve) + "]";
    switch (whole(0, 13)) {
      case 0:
      case 1: {
        const Point<Exact> to(number(), number(), number());
        return {"move " + place + "." + std::to_string(point), move_point(algorithm, inputs, address, to)};
      }
      case 2: {
        const Exact w = Exact::ratio(whole(-1, 8), 4);
        return {"weight " + w.to_string() + " to " + place + "." + std::to_string(point),
                set_weight(algorithm, inputs, address, w)};
      }
      case 3:
        return {"insert behind " + place + "." + std::to_string(point),
                insert_point(algorithm, inputs, address, {number(), number(), number()})};
      case 4:
        return {"delete " + place + "." + std::to_string(point), delete_point(algorithm, inputs, address)};
      case 5: {
        const Exact to = curve.knots[knot] + Exact::ratio(whole(-3, 3), 4);
        return {"knot " + std::to_string(knot) + " of " + place + " to " + to.to_string(),
                set_knot(algorithm, inputs, at, knot, to)};
      }
      case 6: {
        const Exact to = curve.knots[knot] + Exact::ratio(whole(-3, 3), 4);
        return {"knots like " + std::to_string(knot) + " of " + place + " to " + to.to_string(),
                set_equal_knots(algorithm, inputs, at, knot, to)};
      }
      case 7: {
        const int degree = whole(0, 7);
        return {"degree " + std::to_string(degree) + " of " + place, set_degree(algorithm, inputs, at, degree)};
      }
      case 8: {
        const auto kind = static_cast<CurveKind>(whole(0, 3));
        return {"kind " + std::string(curve_kind_name(kind)) + " of " + place, set_kind(algorithm, inputs, at, kind)};
      }
      case 9:
        return {"add " + place, add_curve(algorithm, inputs, at)};
      case 10:
        return {"remove " + place, delete_curve(algorithm, inputs, at)};
      default:
        return other_input(algorithm, inputs);
    }
  }

 private:
  std::size_t index(std::size_t count) { return static_cast<std::size_t>(whole(0, static_cast<int>(count) - 1)); }
  Exact number() { return Exact::ratio(whole(-200, 200), 10); }

  RandomEdit other_input(const Algorithm& algorithm, const Inputs<Exact>& inputs) {
    const InputSpec& spec = algorithm.inputs[index(algorithm.inputs.size())];
    const std::string what = "input " + std::string(spec.name);
    if (spec.type == InputSpec::Type::integer)
      return {what, set_integer(algorithm, inputs, spec.name, whole(spec.at_least - 1, spec.at_least + 3))};
    if (spec.type == InputSpec::Type::choice)
      return {what, set_choice(algorithm, inputs, spec.name, spec.choices[index(spec.choices.size())])};
    if (spec.type != InputSpec::Type::number) return {what, Edited(inputs)};  // edited in the studio
    return {what, set_number(algorithm, inputs, spec.name, Exact::ratio(whole(-2, 14), 4))};
  }

  std::mt19937 random_;
};

}  // namespace blossom::test
