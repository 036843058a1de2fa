// Values in words: what a formula calls its operands, and how it writes their numbers.
#include "scene/panel_parts.hpp"
#include "scene/panels_sheet.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

template <class Body>
void for_each_computed(const PreparedLesson<Exact>& lesson, Body&& body) {
  const auto& trace = lesson.run.trace;
  for (ValueId v = 0; v < trace.value_count(); ++v) {
    if (trace.is_input(v)) continue;
    INFO(trace.name(v) << " = " << lesson.source.formula(v) << " = " << lesson.source.numbers(v));
    body(v);
  }
}

}  // namespace

TEST_CASE("The point of a rational curve is its coordinates over its weight") {
  const auto lesson = prepare("rational-quarter-circle");
  const ValueId C = *lesson->run.trace.find("C");
  CHECK(lesson->source.formula(C) == "(wx, wy) / w of P[2][0]");
  CHECK(lesson->source.numbers(C) == "(3/4, 1) / (5/4)");
  CHECK(lesson->source.value_text(C) == "(3/5, 4/5)");
}

TEST_CASE("The shares at a divided segment of a rational curve are those of the formula") {
  const auto lesson = prepare("rational-quarter-circle");
  const ValueId v = *lesson->run.trace.find("P[1][0]");
  const View view = lesson->scenes.viewport(lesson->run.trace.value(v).step, 700, 500);
  std::vector<std::string> shares;
  for (const auto& label : view.labels)
    if (label.priority == 20) shares.push_back(plain_text(label.text));
  const std::string u = lesson->source.value_text(lesson->run.trace.operands(v)[0]);
  CHECK(shares == std::vector{u, (Exact(1) - *Exact::parse(u)).to_string()});
}

TEST_CASE("No operand goes by the name of the value made from it") {
  int named = 0;
  for (const char* id : {"skinning", "degree-elevation-bspline", "subdivision"}) {
    const auto lesson = prepare(id);
    const auto& trace = lesson->run.trace;
    for_each_computed(*lesson, [&](ValueId v) {
      const std::string own = lesson->source.own_name(v);
      for (const ValueId o : trace.operands(v)) {
        const std::string called = lesson->source.operand_name(v, o);
        CHECK(called != own);
        // It is the end of the full name, but that a knot U[3] is called u_3.
        if (called.find("u_") == std::string::npos) CHECK(trace.name(o).ends_with(called));
        named += called.find('.') != std::string::npos ? 1 : 0;
      }
      CHECK(trace.name(v).ends_with(own));
    });
  }
  CHECK(named > 10);
}

TEST_CASE("A formula writes what is known as decimals only beside other decimals") {
  const auto lesson = prepare("skinning");
  int decimals = 0;
  for_each_computed(*lesson, [&](ValueId v) {
    const auto numbers = lesson->run.trace.numbers(v);
    if (std::ranges::none_of(numbers, [](const Exact& x) { return x.is_approximate(); })) return;
    const std::string text = lesson->source.made_text(v);
    CHECK(text.find('/') == std::string::npos);
    decimals += text.find('.') != std::string::npos ? 1 : 0;
  });
  CHECK(decimals > 10);
}

TEST_CASE("A basis function's name has its numbers") {
  const auto lesson = prepare("skinning");
  const ValueId N = *lesson->run.trace.find("N[3][3]");
  CHECK(lesson->source.formula(N) == "N_(3,2)(v[3])");
}

TEST_CASE("A share of an exact run is a fraction where a short one fits") {
  const auto exact = prepare("de-boor");
  const auto rounded = prepare<double>("de-boor");
  for (const auto& [share, text] : {std::pair{0.72, "18/25"}, std::pair{-0.25, "-1/4"}, std::pair{1.0, "1"},
                                    std::pair{1.0 / 3, "1/3"}, std::pair{0.123456789, "≈ 0.123"}})
    CHECK(parts::share_text(exact->source, share) == text);
  CHECK(parts::share_text(rounded->source, 1.0 / 3) == "0.333");
}

TEST_CASE("The new knot vector stands below the old one once it is made") {
  for (const auto& [id, name] : {std::pair{"knot-insertion", "Ubar"}, std::pair{"degree-elevation-bspline", "V"}}) {
    INFO(id);
    const auto lesson = prepare(id);
    const ValueId v = *lesson->run.trace.find(name);
    const std::uint32_t made = lesson->run.trace.value(v).step;
    CHECK(resulting_knots(lesson->source, made - 1) == absent);
    CHECK(resulting_knots(lesson->source, lesson->step_count() - 1) == v);
    Sheet before, after;
    CHECK(add_knot_line(before, lesson->source, made - 1, {}, 0, 0, 600, 0, true, true) == knot_line_height);
    CHECK(add_knot_line(after, lesson->source, made, {}, 0, 0, 600, 0, true, true) == knot_lines_height);
    CHECK(before.spots.size() + 1 == after.spots.size());
    check_spots(after, 600, knot_lines_height);
    const Spot* spot = spot_named(after, name);
    REQUIRE(spot != nullptr);
    CHECK(spot->link == Link{Link::Kind::value, v});
  }
  const auto evaluation = prepare("de-boor");
  CHECK(resulting_knots(evaluation->source, evaluation->step_count() - 1) == absent);
}
