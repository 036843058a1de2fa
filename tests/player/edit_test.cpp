#include "player/edit.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "kernel/evaluate.hpp"
#include "kernel/lift.hpp"
#include "lesson/catalog.hpp"
#include "player/history.hpp"
#include "player/random_edits.hpp"

using namespace blossom;

namespace {

const auto lessons_folder = std::filesystem::path(BLOSSOM_SOURCE_DIR) / "lessons";

const Catalog& shipped() {
  static const Catalog catalog = load_catalog(lessons_folder);
  return catalog;
}

Inputs<Exact> inputs_of(const Algorithm& algorithm, const std::string& text) {
  const auto document = JsonDocument::parse("inputs", text);
  REQUIRE(document);
  Diagnostics diagnostics;
  auto inputs = read_inputs(algorithm, Cursor(*document, diagnostics));
  INFO(to_string(diagnostics));
  REQUIRE(inputs);
  return *std::move(inputs);
}

const Algorithm& de_boor_algorithm() { return *find_algorithm("de_boor"); }
const CurveAddress the_curve{"curve", 0};
PointAddress point(std::size_t i) { return {"curve", 0, i}; }

// The NURBS Book's example knots with simple points.
Inputs<Exact> cubic(const std::string& u = "1/2") {
  return inputs_of(de_boor_algorithm(), R"({"curve": {"degree": 3, "knots": [0, 0, 0, 0, 1, 2, 2, 2, 2],
    "points": [[0, 0], [1, 2], [3, 3], [5, 1], [6, 0]]}, "u": ")" +
                                            u + "\"}");
}
Inputs<Exact> bezier(const std::string& weights = "") {
  return inputs_of(*find_algorithm("de_casteljau"),
                   R"({"curve": {"degree": 3, "points": [[0, 0, 1], [1, 2, 0], [3, 3, "1/3"], [5, 1, 2]])" + weights +
                       R"(}, "u": "2/5"})");
}

// "path: message" of each, which is all an edit may say.
std::string said(const Edited& edited) {
  CHECK(edited.value.has_value() == edited.diagnostics.empty());
  return to_string(edited.diagnostics);
}

const Curve<Exact>& curve_of(const Edited& edited) {
  INFO(to_string(edited.diagnostics));
  REQUIRE(edited);
  return edited->curve("curve");
}

// What a file with these inputs would be read as.
std::optional<Inputs<Exact>> reread(const Algorithm& algorithm, const Inputs<Exact>& inputs) {
  const auto document = JsonDocument::parse("inputs", write_inputs(inputs));
  REQUIRE(document);
  Diagnostics diagnostics;
  return read_inputs(algorithm, Cursor(*document, diagnostics));
}

void check_same_shape(const Curve<Exact>& a, const Curve<Exact>& b) {
  CHECK(a.domain_begin() == b.domain_begin());
  CHECK(a.domain_end() == b.domain_end());
  for (int i = 0; i <= 20; ++i) {
    const Exact u = a.domain_begin() + (a.domain_end() - a.domain_begin()) * Exact::ratio(i, 20);
    CHECK(point(a, u) == point(b, u));
  }
}

}  // namespace

TEST_CASE("the control points of every algorithm are known by their values, and the values by their points") {
  std::set<std::string_view> seen;
  for (const auto& [file, lesson] : shipped().lessons) {
    INFO(file.string());
    const auto run = record<Exact>(*lesson.algorithm, lesson.inputs);
    REQUIRE(run);
    seen.insert(lesson.algorithm->id);
    std::set<ValueId> values;
    for (const CurveAddress& at : curves_of(lesson.inputs)) {
      const Curve<Exact>& curve = curve_at(lesson.inputs, at);
      for (std::size_t i = 0; i < curve.points.size(); ++i) {
        const PointAddress address{at.input, at.curve, i};
        const auto value = value_of(run->trace, lesson.inputs, address);
        REQUIRE(value.has_value());
        CHECK(address_of(run->trace, lesson.inputs, *value) == address);
        const auto numbers = run->trace.numbers(*value);
        // Some algorithms begin with the points of a plane curve in the plane at height 1.
        const HPoint<Exact> given = lesson.algorithm->lifts ? at_height_one(curve.points[i]) : curve.points[i];
        CHECK(HPoint<Exact>(numbers[0], numbers[1], numbers[2], numbers[3]) == given);
        CHECK(run->trace.value(*value).name.index[run->trace.value(*value).name.arity - 1] == static_cast<int>(i));
        values.insert(*value);
      }
      CHECK_FALSE(value_of(run->trace, lesson.inputs, {at.input, at.curve, curve.points.size()}));
    }
    for (ValueId v = 0; v < run->trace.value_count(); ++v)
      if (!values.contains(v)) CHECK_FALSE(address_of(run->trace, lesson.inputs, v));
  }
  for (const Algorithm* algorithm : algorithms()) {
    INFO(algorithm->id);
    CHECK(seen.contains(algorithm->id));
  }
}

TEST_CASE("random edits of every shipped lesson never make inputs that a file could not have") {
  const unsigned seed = 51;
  INFO("seed " << seed);
  test::RandomEdits edits(seed);
  int applied = 0, refused = 0, impossible = 0;
  for (const auto& [file, lesson] : shipped().lessons) {
    INFO(file.string());
    const Algorithm& algorithm = *lesson.algorithm;
    History<Inputs<Exact>> history(lesson.inputs);
    std::vector<Inputs<Exact>> states{lesson.inputs};
    for (int i = 0; i < 100; ++i) {
      const Inputs<Exact> before = history.current();
      auto [what, edited] = edits.next(algorithm, before);
      INFO("edit " << i << ": " << what << ", of " << write_inputs(before));
      REQUIRE(edited.value.has_value() == edited.diagnostics.empty());
      CHECK(history.current() == before);
      if (!edited) {
        ++refused;
        for (const Diagnostic& diagnostic : edited.diagnostics) {
          CHECK(diagnostic.file.empty());
          CHECK(diagnostic.line == 0);
          // It is about an input, or about one that the change would have made unfit.
          CHECK(algorithm.input(diagnostic.path.substr(0, diagnostic.path.find_first_of(".["))) != nullptr);
        }
        continue;
      }
      ++applied;
      const auto read = reread(algorithm, *edited);
      REQUIRE(read);
      REQUIRE(*read == *edited);
      if (!record<double>(algorithm, *edited)) ++impossible;  // a point at infinity, profiles that coincide
      history.push(*edited, what);
      states.push_back(*edited);
    }
    for (std::size_t i = states.size(); i-- > 1;) {
      REQUIRE(history.current() == states[i]);
      REQUIRE(history.undo());
    }
    REQUIRE(history.current() == lesson.inputs);
    while (history.redo()) {
    }
    CHECK(history.current() == states.back());
  }
  CHECK(applied > 500);
  CHECK(refused > 50);
  CHECK(impossible < applied / 10);
}

TEST_CASE("a point goes where it is put, in a rational curve too, and nothing else changes") {
  const Inputs<Exact> before = bezier(R"(, "weights": [1, 2, "1/3", 1])");
  const auto& algorithm = *find_algorithm("de_casteljau");
  const Point<Exact> to(Exact::ratio(5, 2), Exact(-1), Exact::ratio(1, 7));
  const auto edited = move_point(algorithm, before, point(2), to);
  CHECK(affine(curve_of(edited), 2) == to);
  CHECK(curve_of(edited).points[2].w == Exact::ratio(1, 3));
  Inputs<Exact> back = *move_point(algorithm, *edited, point(2), affine(before.curve("curve"), 2));
  CHECK(back == before);
  // In the plane the third coordinate is none.
  const auto flat = move_point(de_boor_algorithm(), cubic(), point(0), {7, 8, 9});
  CHECK(curve_of(flat).points[0] == HPoint<Exact>(7, 8, 0, 1));
}

TEST_CASE("the quick way of moving a point refuses what the reader of files refuses") {
  const auto huge = *Exact::parse("1e308") * Exact(10);
  CHECK_THAT(said(move_point(de_boor_algorithm(), cubic(), point(1), {huge, 0, 0})),
             Catch::StartsWith("curve.points[1][0]: too large"));
  const Exact third = *Exact::parse("1e399") / Exact(3);  // its text has more than 400 characters
  CHECK_THAT(said(move_point(de_boor_algorithm(), cubic(), point(4), {Exact(1) / third / third, 0, 0})),
             Catch::StartsWith("curve.points[4][0]: must be a number of at most 400 characters"));
  const auto heavy = set_weight(de_boor_algorithm(), cubic(), point(1), *Exact::parse("1e200"));
  REQUIRE(heavy);
  CHECK_THAT(said(move_point(de_boor_algorithm(), *heavy, point(1), {*Exact::parse("1e200"), 0, 0})),
             Catch::StartsWith("curve.weights[1]: the point times this weight is too large"));
}

TEST_CASE("the first weight that is not 1 makes a curve rational, and its points stay where they are") {
  CHECK_FALSE(curve_of(set_weight(de_boor_algorithm(), cubic(), point(1), 1)).rational);
  const auto edited = set_weight(de_boor_algorithm(), cubic(), point(1), 3);
  CHECK(curve_of(edited).rational);
  CHECK(curve_of(edited).points[1] == HPoint<Exact>(3, 6, 0, 3));
  CHECK(said(set_weight(de_boor_algorithm(), cubic(), point(1), -1)) ==
        "curve.weights[1]: a weight must not be negative, not -1\n");
  CHECK(said(set_weight(de_boor_algorithm(), cubic(), point(4), 0)) ==
        "curve.weights[4]: must be positive: at u = 2 no other point has influence\n");
  const auto none = set_weight(de_boor_algorithm(), cubic(), point(2), 0);
  REQUIRE(none);
  CHECK_THAT(said(move_point(de_boor_algorithm(), *none, point(2), {1, 1, 0})),
             Catch::StartsWith("curve.weights[2]: is 0, so that the point has no place"));
}

TEST_CASE("a knot out of order is refused at the knot, and moved within its neighbours it is not") {
  const auto& a = de_boor_algorithm();
  CHECK(said(set_knot(a, cubic(), the_curve, 4, 3)) ==
        "curve.knots[4]: knots must not decrease: it must be at most u_5 = 2, not 3\n");
  CHECK(said(set_knot(a, cubic(), the_curve, 4, -1)) ==
        "curve.knots[4]: knots must not decrease: it must be at least u_3 = 0, not -1\n");
  CHECK(said(set_equal_knots(a, cubic(), the_curve, 6, Exact::ratio(1, 2))) ==
        "curve.knots[6]: knots must not decrease: it must be at least u_4 = 1, not 1/2\n");
  CHECK_THAT(said(set_knot(a, cubic(), the_curve, 4, 0)), Catch::Contains("a knot may stand at most 4 times"));
  CHECK(said(set_knot(a, cubic(), the_curve, 9, 0)) == "curve.knots[9]: there is no such knot\n");
  const Exact half = Exact::ratio(3, 2);
  CHECK(curve_of(set_knot(a, cubic(), the_curve, 4, half)).knots == std::vector<Exact>{0, 0, 0, 0, half, 2, 2, 2, 2});
  CHECK(curve_of(set_equal_knots(a, cubic(), the_curve, 7, 5)).knots == std::vector<Exact>{0, 0, 0, 0, 1, 5, 5, 5, 5});
  CHECK(curve_of(set_knot(a, cubic(), the_curve, 8, 5)).knots == std::vector<Exact>{0, 0, 0, 0, 1, 2, 2, 2, 5});
}

TEST_CASE("the parameter goes along when the domain does not reach it any more") {
  const auto& a = de_boor_algorithm();
  const auto shorter = set_equal_knots(a, cubic("2"), the_curve, 8, Exact::ratio(3, 2));
  REQUIRE(shorter);
  CHECK(shorter->number("u") == Exact::ratio(3, 2));
  // Nothing can be inserted at the clamped end: there u goes to the middle of the last span.
  const auto& insertion = *find_algorithm("knot_insertion");
  const auto before = inputs_of(insertion, R"({"curve": {"degree": 2, "knots": [0, 0, 0, 1, 2, 2, 2],
    "points": [[0, 0], [1, 2], [3, 3], [5, 1]]}, "u": "7/4", "times": 2})");
  const auto at_end = set_equal_knots(insertion, before, the_curve, 6, Exact::ratio(3, 2));
  REQUIRE(at_end);
  CHECK(at_end->number("u") == Exact::ratio(5, 4));
  CHECK(at_end->integer("times") == 2);
  // A lower degree leaves room for fewer insertions.
  const auto linear = set_degree(insertion, before, the_curve, 1);
  REQUIRE(linear);
  CHECK(linear->integer("times") == 1);
  CHECK(linear->number("u") == Exact::ratio(7, 4));
}

TEST_CASE("an inserted point stands behind the one that was named, and a B-spline curve keeps its degree") {
  const auto edited = insert_point(de_boor_algorithm(), cubic(), point(1), {2, 2, 0});
  const auto& curve = curve_of(edited);
  CHECK(curve.degree == 3);
  CHECK(curve.points.size() == 6);
  CHECK(curve.points[2] == HPoint<Exact>(2, 2, 0, 1));
  CHECK(curve.knots == std::vector<Exact>{0, 0, 0, 0, Exact::ratio(1, 2), 1, 2, 2, 2, 2});
  const auto longer = curve_of(insert_point(*find_algorithm("de_casteljau"), bezier(), point(3), {9, 9, 9}));
  CHECK(longer.degree == 4);
  CHECK(longer.bezier);
  CHECK(longer.points.back() == HPoint<Exact>(9, 9, 9, 1));
}

TEST_CASE("a deleted point takes a knot along, or a degree, or is refused") {
  const auto& a = de_boor_algorithm();
  const auto edited = delete_point(a, cubic(), point(2));
  CHECK(curve_of(edited).knots == std::vector<Exact>{0, 0, 0, 0, 2, 2, 2, 2});
  CHECK(said(delete_point(a, *edited, point(0))) ==
        "curve.points[0]: a curve of degree 3 has at least 4 control points; lower the degree first\n");
  const auto& de_casteljau = *find_algorithm("de_casteljau");
  Edited shorter = bezier();
  for (int degree = 2; degree >= 1; --degree) {
    shorter = delete_point(de_casteljau, *shorter, point(1));
    CHECK(curve_of(shorter).degree == degree);
  }
  CHECK(said(delete_point(de_casteljau, *shorter, point(1))) ==
        "curve.points[1]: a curve has at least 2 control points\n");
}

TEST_CASE("raising the degree of a Bezier curve keeps its shape") {
  const auto& de_casteljau = *find_algorithm("de_casteljau");
  for (const std::string weights : {"", R"(, "weights": [1, 2, "1/3", 1])"}) {
    const Inputs<Exact> before = bezier(weights);
    const auto raised = set_degree(de_casteljau, before, the_curve, 6);
    CHECK(curve_of(raised).degree == 6);
    CHECK(curve_of(raised).points.size() == 7);
    CHECK(curve_of(raised).bezier);
    check_same_shape(before.curve("curve"), curve_of(raised));
  }
  // The NURBS Book, 5.5 and Forrest: (0, 0), (2, 4), (4, 0) raised is (0, 0), (4/3, 8/3), (8/3, 8/3), (4, 0).
  const auto parabola =
      inputs_of(de_casteljau, R"({"curve": {"degree": 2, "points": [[0, 0], [2, 4], [4, 0]]}, "u": 0})");
  const auto cubic_points = curve_of(set_degree(de_casteljau, parabola, the_curve, 3)).points;
  CHECK(cubic_points[1] == HPoint<Exact>(Exact::ratio(4, 3), Exact::ratio(8, 3), 0, 1));
  CHECK(cubic_points[2] == HPoint<Exact>(Exact::ratio(8, 3), Exact::ratio(8, 3), 0, 1));
}

TEST_CASE("the degree of a B-spline curve changes over the same points and the same domain") {
  const auto lower = set_degree(de_boor_algorithm(), cubic(), the_curve, 2);
  CHECK(curve_of(lower).knots == std::vector<Exact>{0, 0, 0, Exact::ratio(2, 3), Exact::ratio(4, 3), 2, 2, 2});
  CHECK(curve_of(lower).points == cubic().curve("curve").points);
  CHECK(*set_degree(de_boor_algorithm(), cubic(), the_curve, 3) == cubic());
  CHECK(said(set_degree(de_boor_algorithm(), cubic(), the_curve, 5)) ==
        "curve.degree: must be from 1 to 4 (5 control points), not 5\n");
  CHECK(said(set_degree(*find_algorithm("de_casteljau"), bezier(), the_curve, 26)) ==
        "curve.degree: must be from 1 to 25, not 26\n");
}

TEST_CASE("a Bezier curve as a B-spline curve, and a polynomial one as a rational one, keep their shape") {
  const auto& de_casteljau = *find_algorithm("de_casteljau");
  const Inputs<Exact> before = bezier();
  for (const CurveKind kind : {CurveKind::bspline, CurveKind::nurbs, CurveKind::rational_bezier, CurveKind::bezier}) {
    INFO(curve_kind_name(kind));
    const auto edited = set_kind(de_casteljau, before, the_curve, kind);
    CHECK(kind_of(curve_of(edited)) == kind);
    check_same_shape(before.curve("curve"), curve_of(edited));
    CHECK(*set_kind(de_casteljau, *edited, the_curve, CurveKind::bezier) == before);
  }
}

TEST_CASE("a NURBS curve as a polynomial Bezier curve keeps the places of its points") {
  const auto rational = set_weight(de_boor_algorithm(), cubic("2"), point(2), 5);
  REQUIRE(rational);
  const auto edited = set_kind(de_boor_algorithm(), *rational, the_curve, CurveKind::bezier);
  CHECK(curve_of(edited).degree == 4);
  CHECK(curve_of(edited).points == cubic().curve("curve").points);
  CHECK(edited->number("u") == Exact(1));  // the domain was [0, 2]
}

TEST_CASE("curves are added behind others, moved on, and removed as long as there are enough") {
  const auto* entry = shipped().find("skinning");
  REQUIRE(entry != nullptr);
  const Algorithm& skinning = *entry->lesson.algorithm;
  const Inputs<Exact>& before = entry->lesson.inputs;
  for (std::size_t i = 0; i < before.curves("profiles").size(); ++i) {
    const auto more = add_curve(skinning, before, {"profiles", i});
    REQUIRE(more);
    CHECK(more->curves("profiles").size() == before.curves("profiles").size() + 1);
    CHECK(record<double>(skinning, *more));  // it does not coincide with a neighbour
    CHECK(*delete_curve(skinning, *more, {"profiles", i + 1}) == before);
  }
  Edited fewer = before;
  while (fewer->curves("profiles").size() > 2) {
    fewer = delete_curve(skinning, *fewer, {"profiles", 0});
    REQUIRE(fewer);
  }
  CHECK(fewer->integer("degree_v") == 1);  // two profiles allow no more
  CHECK(said(delete_curve(skinning, *fewer, {"profiles", 0})) == "profiles: must have at least 2 items, not 1\n");
  CHECK(said(add_curve(de_boor_algorithm(), cubic(), the_curve)) == "curve: is one curve, not a list of them\n");
}

TEST_CASE("paths of mistakes in one of several curves name the curve") {
  const auto* entry = shipped().find("skinning");
  REQUIRE(entry != nullptr);
  const Algorithm& skinning = *entry->lesson.algorithm;
  CHECK_THAT(said(set_knot(skinning, entry->lesson.inputs, {"profiles", 1}, 3, 7)),
             Catch::StartsWith("profiles[1].knots[3]: knots must not decrease"));
  CHECK_THAT(said(set_weight(skinning, entry->lesson.inputs, {"profiles", 2, 0}, -1)),
             Catch::StartsWith("profiles[2].weights[0]: a weight must not be negative"));
}

TEST_CASE("numbers, whole numbers and choices are what the algorithm takes, or refused where they stand") {
  CHECK(set_number(de_boor_algorithm(), cubic(), "u", 2)->number("u") == Exact(2));
  CHECK(said(set_number(de_boor_algorithm(), cubic(), "u", 3)) == "u: must lie in the domain [0, 2], not at 3\n");
  CHECK(said(set_number(de_boor_algorithm(), cubic(), "v", 3)) == "v: is no such input of de_boor\n");
  CHECK(said(set_integer(de_boor_algorithm(), cubic(), "u", 3)) == "u: is no such input of de_boor\n");
  const auto& lesson = shipped().find("skinning")->lesson;
  CHECK(set_choice(*lesson.algorithm, lesson.inputs, "parametrization", "uniform")->choice("parametrization") ==
        "uniform");
  CHECK_THAT(said(set_choice(*lesson.algorithm, lesson.inputs, "parametrization", "chords")),
             Catch::Contains("did you mean \"chord\"?"));
  CHECK_THAT(said(set_integer(*lesson.algorithm, lesson.inputs, "degree_v", 9)),
             Catch::StartsWith("degree_v: must be from 1 to 3"));
}

TEST_CASE("a curve alone becomes the inputs of algorithms that take one") {
  const Curve<Exact> curve = cubic().curve("curve");
  const auto inputs = inputs_around(de_boor_algorithm(), curve);
  REQUIRE(inputs);
  CHECK(inputs->number("u") == Exact(1));
  // u = 1 is a knot there, but with room for one more.
  CHECK(inputs_around(*find_algorithm("knot_insertion"), curve)->integer("times") == 1);
  CHECK(inputs_around(*find_algorithm("degree_elevation"), curve));
  CHECK_THAT(said(inputs_around(*find_algorithm("de_casteljau"), curve)),
             Catch::StartsWith("curve: must be a Bézier curve"));
  CHECK_THAT(said(inputs_around(*find_algorithm("skinning"), curve)), Catch::Contains("needs more"));
}

TEST_CASE("a drag means a number as fine as the pixel, not finer") {
  CHECK(snapped(1.23456, 0.013) == Exact::ratio(124, 100));
  CHECK(snapped(24.516, 0.04) == Exact::ratio(245, 10));
  CHECK(snapped(24.516, 0.06) == Exact::ratio(245, 10));
  CHECK(snapped(1.23456, 0.01) == Exact::ratio(123, 100));
  CHECK(snapped(1.23456, 0.001) == Exact::ratio(1235, 1000));
  CHECK(snapped(-0.5004, 0.002) == Exact::ratio(-1, 2));
  CHECK(snapped(-0.0004, 0.01) == Exact(0));
  CHECK(snapped(17.4, 1) == Exact(17));
  CHECK(snapped(1234.5, 30) == Exact(1250));
  CHECK(snapped(7e20, 1e19) == *Exact::parse("7e20"));
  CHECK(snapped(1e-7, 1e-9) == *Exact::parse("1e-7"));
  CHECK(snapped(0.37, 0.01, 0.25) == Exact::ratio(1, 4));
  CHECK(snapped(0.29, 0.01, 0.1) == Exact::ratio(3, 10));
  CHECK(snapped(-7.6, 0.01, 5) == Exact(-10));
}

TEST_CASE("inputs as text are short to read, and read the same again") {
  CHECK(write_inputs(cubic("1/3")) == R"({
  "curve": {
    "degree": 3,
    "knots": [0, 0, 0, 0, 1, 2, 2, 2, 2],
    "points": [[0, 0], [1, 2], [3, 3], [5, 1], [6, 0]]
  },
  "u": "1/3"
})");
  for (const auto& [file, lesson] : shipped().lessons) {
    INFO(file.string());
    CHECK(reread(*lesson.algorithm, lesson.inputs) == lesson.inputs);
  }
}
