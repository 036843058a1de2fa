// Edits of one curve or surface. What they share with the player's inputs is also told in tests/player/edit_test.cpp.

#include "studio/edit_curve.hpp"

#include <algorithm>

#include "geometry/document.hpp"
#include "kernel/derivatives.hpp"
#include "kernel/evaluate.hpp"
#include "scenes.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

using Points = std::vector<HPoint<Exact>>;

Points own(const Curve<Exact>& curve) {
  return {curve.points.begin(), curve.points.begin() + static_cast<std::ptrdiff_t>(own_points(curve))};
}

// Points that go round, wherever one begins.
bool same_ring(const Points& a, Points b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (a == b) return true;
    std::rotate(b.begin(), b.begin() + 1, b.end());
  }
  return false;
}

// A closed curve of this degree through so many points of its own, with knots at random.
Curve<Exact> random_ring(RandomScenes& random, int degree, int points, bool rational = false) {
  Curve<Exact> curve;
  curve.degree = degree;
  curve.dimension = 3;
  curve.rational = rational;
  std::vector<Exact> between{Exact(random.whole(-3, 3))};
  while (static_cast<int>(between.size()) <= points)
    between.push_back(between.back() + Exact::ratio(random.whole(1, 8), 4));
  const Exact period = between.back() - between.front();
  for (int i = -degree; i <= points + degree; ++i) {
    const int turn = (i + 4 * points) / points - 4;
    curve.knots.push_back(between[static_cast<std::size_t>(i - turn * points)] + period * Exact(turn));
  }
  for (int i = 0; i < points; ++i) curve.points.push_back(random_point(random.engine(), rational));
  for (int i = 0; i < degree; ++i) curve.points.push_back(curve.points[static_cast<std::size_t>(i)]);
  return curve;
}

template <class T>
T taken(Checked<T> edited) {
  INFO(to_string(edited.diagnostics));
  REQUIRE(edited);
  return std::move(*edited);
}
template <class T>
std::string said(const Checked<T>& edited) {
  return to_string(edited.diagnostics);
}

// What a reader of files makes of its text.
template <class T, class Read>
std::optional<T> reread(const std::string& text, Read&& read) {
  const auto document = JsonDocument::parse("geometry", text);
  REQUIRE(document);
  Diagnostics diagnostics;
  return read(Cursor(*document, diagnostics));
}

}  // namespace

TEST_CASE("every curve that edits make is one a file can hold") {
  const unsigned seed = GENERATE(range(1u, 61u));
  RandomScenes random(seed);
  Curve<Exact> curve = random.curve(random.whole(2, 3));
  std::string history = "seed " + std::to_string(seed) + "\n" + write_curve(curve) + "\n";
  for (int i = 0; i < 60; ++i) {
    const auto [what, change] = random.curve_edit(curve);
    history += what + "\n";
    INFO(history);
    auto edited = change(curve);
    if (!edited) {
      CHECK(!edited.diagnostics.empty());
      continue;
    }
    curve = *edited;
    const auto read = reread<Curve<Exact>>(write_curve(curve), [](const Cursor& at) { return read_curve(at); });
    REQUIRE(read);
    CHECK(*read == curve);
  }
}

// ---- forms ----------------------------------------------------------------------------------------------------------

TEST_CASE("the form of a curve is what its knots and points say") {
  const auto form = [](const std::string& text) {
    return form_of(*reread<Curve<Exact>>(text, [](const Cursor& at) { return read_curve(at); }));
  };
  CHECK(form(R"({"degree": 2, "points": [[0, 0], [1, 1], [0, 0]]})") == CurveForm::clamped);
  CHECK(form(R"({"degree": 1, "knots": [0, 0, 1, 3, 3], "points": [[0, 0], [1, 1], [0, 0]]})") == CurveForm::clamped);
  CHECK(form(R"({"degree": 1, "knots": [0, 1, 2, 3, 4], "points": [[0, 0], [1, 1], [2, 0]]})") == CurveForm::open);
  CHECK(form(R"({"degree": 1, "knots": [0, 1, 2, 3, 4], "points": [[0, 0], [1, 1], [0, 0]]})") == CurveForm::closed);
  CHECK(form(R"({"degree": 1, "knots": [0, 2, 3, 5, 6], "points": [[0, 0], [1, 1], [0, 0]]})") == CurveForm::closed);
  CHECK(form(R"({"degree": 1, "knots": [0, 2, 3, 5, 7], "points": [[0, 0], [1, 1], [0, 0]]})") == CurveForm::open);
  CHECK(form(R"({"degree": 1, "knots": [0, 1, 2, 3, 4], "points": [[0, 0], [1, 1], [0, 0]], "weights": [1, 1, 2]})") ==
        CurveForm::open);
}

TEST_CASE("a closed curve runs into itself as smoothly as it is inside") {
  const unsigned seed = GENERATE(range(1u, 21u));
  INFO("seed " << seed);
  RandomScenes random(seed);
  const Curve<Exact> open = random.curve(3, true);
  if (open.points.size() < 3) return;
  const Curve<Exact> closed = taken(edit::set_form(open, CurveForm::closed));
  REQUIRE(form_of(closed) == CurveForm::closed);
  CHECK(own_points(closed) == open.points.size());
  CHECK(closed.domain_begin() == open.domain_begin());
  CHECK(closed.domain_end() == open.domain_end());
  const Exact a = closed.domain_begin(), b = closed.domain_end();
  CHECK(homogeneous_point(closed, a) == homogeneous_point(closed, b));

  // A curve that is a period longer has no corner where this one begins: up to p - 1 derivatives agree.
  const int p = closed.degree;
  std::vector<HPoint<Exact>> begin(static_cast<std::size_t>(p)), end(begin);
  homogeneous_derivatives(closed, a, p - 1, Out<HPoint<Exact>>(begin));
  homogeneous_derivatives(closed, b, p - 1, Out<HPoint<Exact>>(end));
  CHECK(begin == end);
}

TEST_CASE("a curve that was closed opens with the points it had") {
  const unsigned seed = GENERATE(range(1u, 21u));
  INFO("seed " << seed);
  RandomScenes random(seed);
  Curve<Exact> curve = random.curve(2, true);
  curve = taken(edit::set_kind(curve, curve.rational ? CurveKind::nurbs : CurveKind::bspline));
  if (curve.points.size() < 3) return;
  const Curve<Exact> clamped = taken(edit::set_form(taken(edit::set_form(curve, CurveForm::open)), CurveForm::clamped));
  const Curve<Exact> closed = taken(edit::set_form(clamped, CurveForm::closed));
  CHECK(taken(edit::set_form(closed, CurveForm::clamped)) == clamped);
  CHECK(own(closed) == curve.points);
}

TEST_CASE("closed curves stay closed, whatever is done to them") {
  const unsigned seed = GENERATE(range(1u, 41u));
  RandomScenes random(seed);
  Curve<Exact> curve = random_ring(random, random.whole(1, 4), random.whole(3, 8), random.one_in(2));
  std::string history = "seed " + std::to_string(seed) + "\n";
  REQUIRE(form_of(curve) == CurveForm::closed);
  for (int i = 0; i < 40; ++i) {
    const auto [what, change] = random.curve_edit(curve);
    if (what.starts_with("form") || what.starts_with("kind Béz") || what.starts_with("kind rational")) continue;
    history += what + "\n";
    INFO(history);
    const auto edited = change(curve);
    if (!edited) continue;
    curve = *edited;
    REQUIRE(form_of(curve) == CurveForm::closed);
  }
}

TEST_CASE("a point and its twin in a closed curve are one") {
  RandomScenes random(7);
  const Curve<Exact> ring = random_ring(random, 3, 5);
  const Point<Exact> to(9, 8, 7);
  const Curve<Exact> moved = taken(edit::move_point(ring, 1, to));
  CHECK(affine(moved, 1) == to);
  CHECK(affine(moved, 6) == to);
  CHECK(taken(edit::move_point(ring, 6, to)) == moved);
  const Curve<Exact> heavy = taken(edit::set_weight(ring, 7, Exact(3)));
  CHECK(heavy.points[2].w == Exact(3));
  CHECK(affine(heavy, 2) == affine(ring, 2));
}

TEST_CASE("a point more in a closed curve changes it only nearby, and stands behind the one that was named") {
  const unsigned seed = GENERATE(range(1u, 41u));
  INFO("seed " << seed);
  RandomScenes random(seed);
  const int p = random.whole(1, 3), k = 14;
  const Curve<Exact> ring = random_ring(random, p, k, random.one_in(2));
  const int behind = random.whole(0, k + p - 1);
  const Curve<Exact> longer = taken(edit::insert_point(ring, static_cast<std::size_t>(behind), {100, 100, 100}));
  REQUIRE(form_of(longer) == CurveForm::closed);
  REQUIRE(own_points(longer) == k + 1);
  Points expected = own(ring);
  expected.insert(expected.begin() + behind % k + 1, HPoint<Exact>(100, 100, 100, 1));
  CHECK(same_ring(own(longer), expected));

  // The new point's functions reach over p + 1 spans, and those that got another knot are among them or next to them.
  int same = 0;
  for (int span = p; span < p + k; ++span) {
    const auto s = static_cast<std::size_t>(span);
    bool all = true;
    for (const int part : {1, 2}) {
      const Exact u = ring.knots[s] + (ring.knots[s + 1] - ring.knots[s]) * Exact::ratio(part, 3);
      all = all && homogeneous_point(ring, u) == homogeneous_point(longer, u);
    }
    same += all ? 1 : 0;
  }
  CHECK(same >= k - 2 * p - 2);
}

TEST_CASE("a point less in a closed curve changes it only nearby, and the others stay in order") {
  const unsigned seed = GENERATE(range(1u, 41u));
  INFO("seed " << seed);
  RandomScenes random(seed);
  const int p = random.whole(1, 3), k = 14;
  const Curve<Exact> ring = random_ring(random, p, k);
  const int point = random.whole(0, k + p - 1);
  const Curve<Exact> shorter = taken(edit::delete_point(ring, static_cast<std::size_t>(point)));
  REQUIRE(form_of(shorter) == CurveForm::closed);
  Points expected = own(ring);
  expected.erase(expected.begin() + point % k);
  CHECK(same_ring(own(shorter), expected));
  CHECK(shorter.domain_begin() == ring.domain_begin());
  CHECK(shorter.domain_end() == ring.domain_end());
  int same = 0;
  for (int span = p; span < p + k; ++span) {
    const auto s = static_cast<std::size_t>(span);
    const Exact u = (ring.knots[s] + ring.knots[s + 1]) / Exact(2);
    same += homogeneous_point(ring, u) == homogeneous_point(shorter, u) ? 1 : 0;
  }
  CHECK(same >= k - 2 * p - 4);
}

TEST_CASE("the knots of a closed curve move together a period apart, and stay in order") {
  RandomScenes random(3);
  Curve<Exact> ring = taken(edit::set_form(random_curve(random.engine(), 2, 3, 1, true, false), CurveForm::closed));
  ring = taken(edit::set_knots(ring, {-2, -1, 0, 1, 2, 3, 4, 5, 6, 7}));
  REQUIRE(form_of(ring) == CurveForm::closed);
  const Curve<Exact> moved = taken(edit::set_knot(ring, 3, Exact::ratio(3, 2)));
  CHECK(moved.knots[8] == Exact::ratio(13, 2));
  CHECK(form_of(moved) == CurveForm::closed);
  const Curve<Exact> ends = taken(edit::set_knot(ring, 2, Exact::ratio(1, 2)));  // where the domain begins, and ends
  CHECK(ends.domain_end() == Exact::ratio(11, 2));
  CHECK(said(edit::set_knot(ring, 3, Exact(3))) ==
        "knots[3]: knots must not decrease: it must be at most u_4 = 2, not 3\n");
}

TEST_CASE("a closed curve keeps three points, and says so") {
  RandomScenes random(5);
  const Curve<Exact> ring = random_ring(random, 2, 3);
  CHECK(said(edit::delete_point(ring, 4)) == "points[4]: a closed curve has at least 3 control points\n");
  const Curve<Exact> segment{1, {0, 0, 1, 1}, {{0, 0, 0, 1}, {1, 0, 0, 1}}, 2, false, true};
  CHECK(said(edit::set_form(segment, CurveForm::closed)) == "points: a closed curve has at least 3 control points\n");
}

TEST_CASE("a point before the first") {
  const Curve<Exact> segment{1, {0, 0, 1, 1}, {{0, 0, 0, 1}, {1, 0, 0, 1}}, 2, false, true};
  const Curve<Exact> arc = taken(edit::insert_point(segment, SIZE_MAX, {-1, 1, 0}));
  CHECK(arc.degree == 2);
  CHECK(affine(arc, 0) == Point<Exact>(-1, 1, 0));
  const Curve<Exact> polyline = taken(edit::set_kind(segment, CurveKind::bspline));
  CHECK(affine(taken(edit::insert_point(polyline, SIZE_MAX, {-1, 1, 0})), 0) == Point<Exact>(-1, 1, 0));
}

TEST_CASE("knots are typed all at once, or what is wrong with them is said") {
  const Curve<Exact> arc{2, bezier_knots<Exact>(2), {{0, 0, 0, 1}, {1, 1, 0, 1}, {2, 0, 0, 1}}, 2, false, true};
  CHECK(taken(edit::set_knots(arc, {0, 1, 2, 3, 4, 5})).domain_end() == Exact(3));
  CHECK(said(edit::set_knots(arc, {0, 1, 2, 3})) == "knots: needs 6 knots (3 points + degree 2 + 1), not 4\n");
}

TEST_CASE("z is dropped, and comes back as 0") {
  RandomScenes random(9);
  const Curve<Exact> spatial = random_curve(random.engine(), 2, 2, 1, true, true);
  const Curve<Exact> flat = taken(edit::set_dimension(spatial, 2));
  CHECK(flat.points[1].z == Exact(0));
  CHECK(flat.points[1].x == spatial.points[1].x);
  CHECK(taken(edit::set_dimension(flat, 3)).points == flat.points);
  CHECK(said(edit::set_dimension(flat, 4)) == "points: a point must have 2 or 3 coordinates, not 4\n");
}

// ---- surfaces -------------------------------------------------------------------------------------------------------

TEST_CASE("a new surface is a flat net, centred, of clamped uniform knots") {
  const Surface<Exact> surface = planar_surface(5, 4, 3, 2, Exact(8));
  CHECK(surface.at(0, 0) == HPoint<Exact>(-4, -4, 0, 1));
  CHECK(surface.at(4, 3) == HPoint<Exact>(4, 4, 0, 1));
  CHECK(surface.at(2, 0).x == Exact(0));
  CHECK(surface.knots[0] == std::vector<Exact>{0, 0, 0, 0, Exact::ratio(1, 2), 1, 1, 1, 1});
  CHECK(reread<Surface<Exact>>(write_surface(surface), [](const Cursor& at) { return read_surface(at); }) == surface);
}

TEST_CASE("a row or column more lies between its neighbours, or goes on behind the last") {
  const Surface<Exact> surface = planar_surface(4, 3, 2, 2, Exact(6));
  const int direction = GENERATE(0, 1);
  const auto behind_first = taken(edit::insert_row(surface, direction, 0));
  CHECK(affine(direction == 0 ? behind_first.at(1, 0) : behind_first.at(0, 1)) ==
        (direction == 0 ? Point<Exact>(-2, -3, 0) : Point<Exact>(-3, Exact::ratio(-3, 2), 0)));
  CHECK(behind_first.degree == surface.degree);
  const int last = direction == 0 ? 3 : 2;
  const auto behind_last = taken(edit::insert_row(surface, direction, last));
  CHECK(affine(direction == 0 ? behind_last.at(4, 0) : behind_last.at(0, 3)) ==
        (direction == 0 ? Point<Exact>(5, -3, 0) : Point<Exact>(-3, 6, 0)));
  const auto before_first = taken(edit::insert_row(surface, direction, -1));
  CHECK(affine(before_first.at(0, 0)) == (direction == 0 ? Point<Exact>(-5, -3, 0) : Point<Exact>(-3, -6, 0)));
  // What was put in can be taken out again.
  CHECK(taken(edit::delete_row(behind_last, direction, last + 1)).points == surface.points);
}

TEST_CASE("a surface has as many rows as its degree needs") {
  const Surface<Exact> surface = planar_surface(3, 3, 2, 2, Exact(6));
  CHECK(said(edit::delete_row(surface, 0, 1)) ==
        "points[1]: a surface of degree 2 has at least 3 rows; lower the degree first\n");
  CHECK(said(edit::delete_row(surface, 1, 3)) == "points[0][3]: there is no such column\n");
  CHECK(said(edit::set_degree(surface, 1, 3)) == "degree[1]: must be from 1 to 2 (3 columns), not 3\n");
  CHECK(said(edit::insert_row(surface, 0, 3)) == "points: has 3 rows, none of index 3\n");
}

TEST_CASE("raising the degree of a Bezier surface keeps its shape") {
  RandomScenes random(11);
  Surface<Exact> surface = random_surface(random.engine(), 2, 3, 1, true, true);
  surface = taken(edit::set_kind(surface, CurveKind::rational_bezier));
  const int direction = GENERATE(0, 1);
  const Surface<Exact> raised = taken(edit::set_degree(surface, direction, 5));
  CHECK(raised.bezier);
  CHECK(raised.degree[static_cast<std::size_t>(direction)] == 5);
  for (int i = 0; i <= 4; ++i)
    for (int j = 0; j <= 4; ++j)
      CHECK(homogeneous_point(raised, Exact::ratio(i, 4), Exact::ratio(j, 4)) ==
            homogeneous_point(surface, Exact::ratio(i, 4), Exact::ratio(j, 4)));
}

TEST_CASE("a weight moves no point of a surface, and a point of weight 0 has no place") {
  const Surface<Exact> surface = planar_surface(3, 3, 2, 2, Exact(6));
  const Surface<Exact> heavy = taken(edit::set_weight(surface, 1, 1, Exact(4)));
  CHECK(affine(heavy.at(1, 1)) == affine(surface.at(1, 1)));
  CHECK(kind_of(heavy) == CurveKind::nurbs);
  const Surface<Exact> gone = taken(edit::set_weight(surface, 1, 1, Exact(0)));
  CHECK(said(edit::move_point(gone, 1, 1, {1, 1, 1})) ==
        "weights[1][1]: is 0, so that the point has no place; give it a positive weight first\n");
  CHECK(taken(edit::set_kind(heavy, CurveKind::bspline)) == surface);
}
