#pragma once
// A curve as a form: kind, degree, a table of control points, knots.

#include "player/ui/number_field.hpp"

namespace blossom {

// "curve", "profiles[2]": the path of the curve in diagnostics.
std::string path_of_curve(const Session&, const CurveAddress&);
void draw_curve_fields(Ui&, InputFields&, const CurveAddress&);
// - [n] +, where n can be typed; nothing while it stays.
std::optional<int> draw_stepper(Ui&, const std::string& name, int value, int least, int most);

}  // namespace blossom
