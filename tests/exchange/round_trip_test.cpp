// What is written can be read again, and is then what the format says it holds.

#include <catch2/catch.hpp>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>

#include "exchange/exchange_mesh.hpp"
#include "kernel/evaluate.hpp"
#include "kernel/splines.hpp"
#include "studio/scene_file.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

const ExchangeFormat& format(const char* extension) {
  const ExchangeFormat* found = format_of(std::string("file") + extension);
  REQUIRE(found != nullptr);
  return *found;
}

Workspace scene_of(std::vector<Geometry> all) {
  Workspace scene;
  for (std::size_t i = 0; i < all.size(); ++i) {
    SceneObject object;
    object.name = "thing " + std::to_string(i);
    object.geometry = std::move(all[i]);
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

std::vector<SceneObject> round_trip(const char* extension, const Workspace& scene) {
  const auto written = format(extension).write(scene, {});
  INFO(to_string(written.diagnostics));
  REQUIRE(written);
  const auto read = format(extension).import("round trip", written->bytes);
  INFO(written->bytes << to_string(read.diagnostics));
  REQUIRE(read);
  return read->objects;
}

bool close(double a, double b) { return std::abs(a - b) <= 1e-12 * std::max({1.0, std::abs(a), std::abs(b)}); }

template <class G>
bool same_points(const G& a, const G& b) {
  if (a.points.size() != b.points.size()) return false;
  for (std::size_t i = 0; i < a.points.size(); ++i)
    for (int k = 0; k < 4; ++k)
      if (!close(a.points[i][k].to_double(), b.points[i][k].to_double())) return false;
  return true;
}

bool same_knots(const std::vector<Exact>& a, const std::vector<Exact>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!close(a[i].to_double(), b[i].to_double())) return false;
  return true;
}

}  // namespace

TEST_CASE("OBJ holds curves of all kinds, to the last digit of a double", "[exchange]") {
  const unsigned seed = GENERATE(range(1u, 30u));
  std::mt19937 random(seed);
  const int p = random_int(random, 1, 4);
  auto curve = random_curve(random, p, random_int(random, 1, 4), p, seed % 3 != 0, seed % 2 == 0);
  curve.dimension = 3;
  CAPTURE(seed);
  const auto read = round_trip(".obj", scene_of({curve}));
  REQUIRE(read.size() == 1);
  const auto& back = std::get<Curve<Exact>>(read[0].geometry);
  CHECK(back.degree == curve.degree);
  CHECK(back.rational == curve.rational);
  CHECK(same_knots(back.knots, curve.knots));
  CHECK(same_points(back, curve));
  CHECK(read[0].name == "thing_0");
}

TEST_CASE("OBJ holds surfaces, whose points it lists with u running first", "[exchange]") {
  const unsigned seed = GENERATE(range(1u, 20u));
  std::mt19937 random(seed);
  CAPTURE(seed);
  const auto surface = random_surface(random, 2, random_int(random, 1, 3), 2, true, seed % 2 == 0);
  const auto read = round_trip(".obj", scene_of({surface}));
  REQUIRE(read.size() == 1);
  const auto& back = std::get<Surface<Exact>>(read[0].geometry);
  CHECK(back.degree == surface.degree);
  CHECK((back.rows == surface.rows && back.columns == surface.columns));
  CHECK(same_points(back, surface));
  const auto written = format(".obj").write(scene_of({surface}), {});
  const auto& next = surface.at(1, 0);  // the second vertex is P_{1,0}
  const std::string x = exchange::decimal(next.x.to_double() / next.w.to_double(), 17);
  const std::size_t second = written->bytes.find("\nv ", written->bytes.find("\nv ") + 1) + 3;
  CHECK(written->bytes.substr(second, x.size()) == x);
}

TEST_CASE("OBJ's Bezier elements become curves with knots", "[exchange]") {
  const auto read = format(".obj").import(
      "bezier.obj",
      "v 0 0 0\nv 1 2 0\nv 2 0 0\nv 3 -2 0\nv 4 0 0\ncstype bezier\ndeg 2\ncurv 0 2 1 2 3 4 -1\nparm u 0 1 2\nend\n");
  INFO(to_string(read.diagnostics));
  REQUIRE(read);
  const auto& curve = std::get<Curve<Exact>>(read->objects.at(0).geometry);
  CHECK(curve.knots == std::vector<Exact>{0, 0, 0, 1, 1, 2, 2, 2});
  CHECK(curve.points.size() == 5);
}

TEST_CASE("OBJ's mistakes are said at their lines, all at once", "[exchange]") {
  const auto read = format(".obj").import("bad.obj", "v 0 0\nv 1 x 2\ncstype bspline\ndeg 1\nv 0 0 0\ncurv 0 1 1 7\n");
  REQUIRE(!read);
  REQUIRE(read.diagnostics.size() == 3);
  CHECK(to_string(read.diagnostics[0]).starts_with("bad.obj:1:"));
  CHECK(to_string(read.diagnostics[1]).starts_with("bad.obj:2:"));
  CHECK(to_string(read.diagnostics[2]).starts_with("bad.obj:6:"));
}

TEST_CASE("geometry in JSON comes back exactly", "[exchange]") {
  std::mt19937 random(7);
  const auto curve = random_curve(random, 3, 2, 3, true, true);
  CHECK(std::get<Curve<Exact>>(round_trip(".json", scene_of({curve})).at(0).geometry) == curve);
  const PointRow<Exact> row{{{Exact::ratio(1, 3), 2, 0, 1}, {0, 1, 0, 1}}, 2};
  CHECK(std::get<PointRow<Exact>>(round_trip(".json", scene_of({row})).at(0).geometry) == row);
  CHECK(!format(".json").write(scene_of({row, row}), {}));
}

TEST_CASE("a table's numbers are what was written: 0.1 is a tenth", "[exchange]") {
  const auto read = format(".csv").import("points.csv", "x;y\n0.1; 2/5\n-3;1e1\n");
  INFO(to_string(read.diagnostics));
  REQUIRE(read);
  const auto& row = std::get<PointRow<Exact>>(read->objects.at(0).geometry);
  REQUIRE(row.points.size() == 2);
  CHECK(row.points[0].x == Exact::ratio(1, 10));
  CHECK(row.points[0].y == Exact::ratio(2, 5));
  CHECK(row.points[1].y == Exact(10));
}

TEST_CASE("rows of equally many points in a table are a net, others are rows", "[exchange]") {
  const auto net = format(".csv").import("net.csv", "0,0,0\n1,0,1\n\n0,1,2\n1,1,3\n");
  REQUIRE(net);
  const auto& points = std::get<PointNet<Exact>>(net->objects.at(0).geometry);
  CHECK((points.rows == 2 && points.columns == 2));
  CHECK(points.at(1, 0).z == Exact(2));
  const auto rows = format(".csv").import("rows.csv", "0,0\n1,0\n\n0,1\n");
  REQUIRE(rows);
  CHECK(rows->objects.size() == 2);
  const auto wrong = format(".csv").import("wrong.csv", "0,0\n1,zwei\n1,2,3\n");
  REQUIRE(!wrong);
  CHECK(wrong.diagnostics.size() == 2);
}

TEST_CASE("SVG holds polynomial plane curves of degree 1 to 3 exactly", "[exchange]") {
  const unsigned seed = GENERATE(range(1u, 20u));
  std::mt19937 random(seed);
  CAPTURE(seed);
  const int p = random_int(random, 1, 3);
  auto curve = random_curve(random, p, random_int(random, 1, 4), p, true, false);
  curve.dimension = 2;
  for (auto& P : curve.points) P.z = Exact(0);
  const auto read = round_trip(".svg", scene_of({curve}));
  REQUIRE(read.size() == 1);
  const auto& back = std::get<Curve<Exact>>(read[0].geometry);
  // The path's parameter runs from 0 to 1 in each span.
  std::vector<Exact> breaks;
  for (std::size_t i = static_cast<std::size_t>(p); i <= curve.points.size(); ++i)
    if (breaks.empty() || breaks.back() != curve.knots[i]) breaks.push_back(curve.knots[i]);
  REQUIRE(back.domain_end() == Exact(static_cast<std::int64_t>(breaks.size()) - 1));
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const Exact t = Exact::ratio(3, 7);
    const auto A = affine_point(homogeneous_point(curve, breaks[k] + t * (breaks[k + 1] - breaks[k])));
    const auto B = affine_point(homogeneous_point(back, Exact(static_cast<std::int64_t>(k)) + t));
    REQUIRE((A && B));
    CHECK(close(A->x.to_double(), B->x.to_double()));
    CHECK(close(A->y.to_double(), B->y.to_double()));
  }
  CHECK(read[0].name == "thing 0");
}

TEST_CASE("every command of an SVG path is read, relative ones and those without blanks too", "[exchange]") {
  const auto read = format(".svg").import(
      "p.svg", R"(<svg><g><path id="a" d="M1-2l3,0h1v-1H0Q1,1 2 2t1 1c0,0,1,1,2.5.5s1 1 2 2z m5 5 L 9 9"/></g></svg>)");
  INFO(to_string(read.diagnostics));
  REQUIRE(read);
  REQUIRE(read->objects.size() == 2);
  const auto& first = std::get<Curve<Exact>>(read->objects[0].geometry);
  CHECK(first.degree == 3);
  CHECK(first.points.front() == HPoint<Exact>(1, 2, 0, 1));
  CHECK(first.points.back() == HPoint<Exact>(1, 2, 0, 1));  // closed
  const auto& second = std::get<Curve<Exact>>(read->objects[1].geometry);
  CHECK(second.points.front() == HPoint<Exact>(6, -3, 0, 1));  // relative to where the closed one began
  CHECK(second.points.back() == HPoint<Exact>(9, -9, 0, 1));
}

TEST_CASE("an arc of a circle in SVG stays a circle", "[exchange]") {
  const auto read = format(".svg").import("arc.svg", R"(<svg><path d="M 5 0 A 5 5 0 1 0 0 5"/></svg>)");
  REQUIRE(read);
  const auto curve = convert<double>(std::get<Curve<Exact>>(read->objects.at(0).geometry));
  CHECK(curve.rational);
  for (int i = 0; i <= 40; ++i) {
    const double u = curve.domain_begin() + (curve.domain_end() - curve.domain_begin()) * i / 40;
    const auto C = affine_point(homogeneous_point(curve, u));
    REQUIRE(C);
    CHECK(std::hypot(C->x, C->y) == Approx(5));
  }
}

TEST_CASE("STL has as many triangles as it says, and those of a closed surface close", "[exchange]") {
  const auto scene = load_scene(std::filesystem::path(BLOSSOM_SOURCE_DIR) / "lessons/scenes/torus.json");
  INFO(to_string(scene.diagnostics));
  REQUIRE(scene);
  const auto written = format(".stl").write(*scene, {});
  REQUIRE(written);
  std::uint32_t count = 0;
  std::memcpy(&count, written->bytes.data() + 80, 4);
  CHECK(written->bytes.size() == 84 + std::size_t{50} * count);
  CHECK(count > 200);
  // The divergence theorem: the volume of a torus is 2 pi^2 R r^2, of a polyhedron inside it a little less.
  double volume = 0;
  for (std::uint32_t t = 0; t < count; ++t) {
    float v[12];
    std::memcpy(v, written->bytes.data() + 84 + std::size_t{50} * t, sizeof v);
    volume += (v[3] * (v[7] * v[11] - v[8] * v[10]) + v[4] * (v[8] * v[9] - v[6] * v[11]) +
               v[5] * (v[6] * v[10] - v[7] * v[9])) /
              6.0;
  }
  const double exact = 2 * M_PI * M_PI * 3 * 1;
  CHECK(std::abs(volume) == Approx(exact).epsilon(0.02));
}

TEST_CASE("a glTF file's parts are where it says", "[exchange]") {
  const auto scene = load_scene(std::filesystem::path(BLOSSOM_SOURCE_DIR) / "lessons/scenes/vase.json");
  REQUIRE(scene);
  const auto written = format(".glb").write(*scene, {});
  REQUIRE(written);
  const std::string& bytes = written->bytes;
  const auto word = [&](std::size_t at) {
    std::uint32_t x = 0;
    std::memcpy(&x, bytes.data() + at, 4);
    return x;
  };
  CHECK(bytes.starts_with("glTF"));
  CHECK(word(4) == 2);
  CHECK(word(8) == bytes.size());
  const auto json = nlohmann::json::parse(bytes.substr(20, word(12)));
  const std::size_t binary = 20 + word(12);
  CHECK(bytes.substr(binary + 4, 4) == std::string("BIN\0", 4));
  CHECK(json["buffers"][0]["byteLength"] == word(binary));
  for (const auto& accessor : json["accessors"]) {
    const auto& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const std::size_t size = accessor["type"] == "VEC3" ? 12 : 4;
    CHECK(view["byteLength"].get<std::size_t>() == accessor["count"].get<std::size_t>() * size);
    CHECK(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>() <= word(binary));
  }
  CHECK(json["nodes"].size() == 2);
}

TEST_CASE("no bytes make a reader crash, hang or take what is not there", "[exchange]") {
  const auto scene = load_scene(std::filesystem::path(BLOSSOM_SOURCE_DIR) / "lessons/scenes/vase.json");
  REQUIRE(scene);
  ExportOptions first;
  first.objects = {0};
  for (const ExchangeFormat* each : exchange_formats()) {
    if (each->import == nullptr || each->write == nullptr) continue;
    const auto good = each->write(*scene, first);
    REQUIRE(good);
    // A process for each, and OpenCASCADE may take its time over one.
    const bool slow = each->id == "step" || each->id == "iges";
    for (unsigned seed = 1; seed <= (slow ? 4u : 300u); ++seed) {
      std::mt19937 random(seed);
      std::string bytes = good->bytes;
      for (int k = random_int(random, 1, 6); k > 0 && !bytes.empty(); --k) {
        const auto at = static_cast<std::size_t>(random_int(random, 0, static_cast<int>(bytes.size()) - 1));
        switch (random_int(random, 0, 3)) {
          case 0:
            bytes[at] = static_cast<char>(random_int(random, 0, 255));
            break;
          case 1:
            bytes.resize(at);
            break;
          case 2:
            bytes.insert(at, bytes.substr(at / 2, 40));
            break;
          default:
            bytes.erase(at, 3);
        }
      }
      CAPTURE(each->id, seed);
      const auto read = each->import("damaged", bytes);
      CHECK((read.value.has_value() || !read.diagnostics.empty()));
    }
  }
}
