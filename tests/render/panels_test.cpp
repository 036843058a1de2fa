// The panels of the window, set with the real letters in the theme with the largest text: nothing is cut off by its
// panel, and no text runs into another, at any width a panel may have.
#include "scene/panels.hpp"
#include "render/rich_text.hpp"
#include "render/theme.hpp"
#include "scene/shipped_lessons.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

struct TextBox {
  std::string words;
  double left, top, right, bottom;
};

std::vector<TextBox> text_boxes(const View& view, const Fonts& fonts, const Theme& theme) {
  std::vector<TextBox> boxes;
  for (const Label& label : view.labels) {
    const auto align = label.placement == Label::Placement::centre  ? TextAlign::centre
                       : label.placement == Label::Placement::right ? TextAlign::right
                                                                    : TextAlign::left;
    const TextBlock block =
        set_text(fonts, label.text, theme[label.role].text_size * label.size_scale, align, label.max_width);
    const double left = label.anchor.x + block.left;
    boxes.push_back(
        {plain_text(label.text), left, label.anchor.y + block.top, left + block.width, label.anchor.y + block.bottom});
  }
  return boxes;
}

void check_texts(const char* panel, const Sheet& sheet, double width, double height, double slack) {
  static const auto fonts = *Fonts::load();
  const auto boxes = text_boxes(sheet.view, *fonts, **find_theme("contrast"));
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const TextBox& a = boxes[i];
    if (a.left < -1 || a.top < -1 || a.right > width + 1 || a.bottom > height + 1)
      FAIL_CHECK(panel << ": \"" << a.words << "\" from (" << a.left << ", " << a.top << ") to (" << a.right << ", "
                       << a.bottom << ") leaves " << width << " x " << height);
    for (std::size_t j = 0; j < i; ++j) {
      const TextBox& b = boxes[j];
      if (std::min(a.right, b.right) - std::max(a.left, b.left) > slack &&
          std::min(a.bottom, b.bottom) - std::max(a.top, b.top) > slack)
        FAIL_CHECK(panel << ": \"" << a.words << "\" runs into \"" << b.words << "\" at " << a.left << ", " << a.top);
    }
  }
}

}  // namespace

TEST_CASE("No text of a panel is cut off or runs into another, at any width") {
  for_each_step<Exact>([](const auto& lesson, std::uint32_t step) {
    // What changes with the step is short; a lesson of hundreds of steps need not show each.
    if (lesson.step_count() > 60 && step % 7 != 0) return;
    const StepSource& source = lesson.source;
    for (const double width : {300.0, 350.0, 420.0, 500.0, 600.0}) {
      INFO("width " << width);
      Sheet code, tree, knots, basis, scheme;
      double height = add_pseudo_code(code, source, step, {}, 8, 0, width - 16);
      check_texts("pseudo-code", code, width, height, 2);
      height = add_phase_tree(tree, source, step, {}, 8, 0, width - 16);
      check_texts("phases", tree, width, height, 2);
      for (std::size_t curve = 0; curve < source.curves.size(); ++curve) {
        knots = basis = {};
        height = add_knot_line(knots, source, step, {}, 0, 0, width, curve, true);
        check_texts("knots", knots, width, height, 2);
        height = add_basis(basis, source, step, {}, 0, 0, width, 180, curve);
        check_texts("basis", basis, width, height, 3);
      }
      const auto size = add_tableau(scheme, source, step, {}, 0, 0, {false, 0, 0});
      check_texts("scheme", scheme, size.width, size.height, 3);
    }
  });
}

TEST_CASE("Nor where knots crowd and basis functions are many") {
  for (const int points : {10, 16, 26, 60, 200})
    for (const int degree : {1, 3, 9, 25}) {
      if (degree >= points) continue;
      INFO(points << " points, degree " << degree);
      Curve<Exact> curve;
      curve.degree = degree;
      const int inner = points - degree;  // spans; every third knot stands close behind the one before
      for (int i = 0; i < points; ++i) curve.points.push_back({Exact(i), Exact(i * i % 7), Exact(0), Exact(1)});
      for (int i = 0; i <= points + degree; ++i) {
        const int at = std::clamp(i - degree, 0, inner);
        const bool close = at > 0 && at < inner && at % 3 == 0;
        curve.knots.push_back(close ? Exact(at) - Exact::ratio(19, 20) : Exact(at));
      }
      Inputs<Exact> inputs;
      inputs.values["curve"] = curve;
      inputs.values["u"] = Exact::ratio(inner, 3);
      const auto run = record<double>(*find_algorithm("de_boor"), inputs);
      REQUIRE(run);
      const Narrator<double> narrator(*run, 6);
      const StepSource source = make_source(narrator);
      for (const double width : {300.0, 420.0, 600.0}) {
        INFO("width " << width);
        Sheet knots, basis;
        double height = add_knot_line(knots, source, 0, {}, 0, 0, width);
        check_texts("knots", knots, width, height, 2);
        height = add_basis(basis, source, 0, {}, 0, 0, width, 180);
        check_texts("basis", basis, width, height, 3);
        CHECK(knots.view.labels.size() >= 4);  // U, u and the two ends at least
      }
    }
}
