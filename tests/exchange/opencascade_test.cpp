// STEP and IGES, where Blossom was built with OpenCASCADE: the same splines come back.

#include <catch2/catch.hpp>
#include <random>

#include "exchange/format.hpp"
#include "kernel/evaluate.hpp"
#include "kernel/splines.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

SceneObject object_of(Geometry geometry) {
  SceneObject object;
  object.name = "thing";
  object.geometry = std::move(geometry);
  return object;
}

}  // namespace

TEST_CASE("STEP and IGES bring curves and surfaces back as the splines they were", "[exchange]") {
  for (const char* extension : {".step", ".igs"}) {
    const ExchangeFormat* format = format_of(std::string("file") + extension);
    if (format == nullptr) {
      WARN("built without OpenCASCADE: no " << extension);
      continue;
    }
    for (unsigned seed = 1; seed <= 6; ++seed) {
      std::mt19937 random(seed);
      CAPTURE(extension, seed);
      Workspace scene;
      const auto curve = random_curve(random, 3, 3, 2, true, seed % 2 == 0);
      const auto surface = random_surface(random, 2, 3, 2, true, seed % 2 == 1);
      scene.objects = {object_of(curve), object_of(surface)};
      const auto written = format->write(scene, {});
      INFO(to_string(written.diagnostics));
      REQUIRE(written);
      const auto read = format->import("back", written->bytes);
      INFO(to_string(read.diagnostics));
      REQUIRE(read);
      REQUIRE(read->objects.size() == 2);
      for (const SceneObject& object : read->objects) {
        if (const auto* back = std::get_if<Curve<Exact>>(&object.geometry)) {
          CHECK(back->degree == curve.degree);
          CHECK(back->points.size() == curve.points.size());
          const auto u = (curve.domain_begin() + curve.domain_end()).to_double() / 2;
          const auto A = affine_point(homogeneous_point(convert<double>(curve), u));
          const auto B = affine_point(homogeneous_point(convert<double>(*back), u));
          REQUIRE((A && B));
          for (int k = 0; k < 3; ++k) CHECK((*A)[k] == Approx((*B)[k]).margin(1e-9));
        } else {
          const auto& net = std::get<Surface<Exact>>(object.geometry);
          CHECK((net.rows == surface.rows && net.columns == surface.columns));
          for (std::size_t i = 0; i < net.points.size(); ++i)
            CHECK((net.points[i].x / net.points[i].w).to_double() ==
                  Approx((surface.points[i].x / surface.points[i].w).to_double()).margin(1e-9));
        }
      }
    }
  }
}

TEST_CASE("what is no STEP or IGES file is said", "[exchange]") {
  for (const char* extension : {".step", ".igs"})
    if (const ExchangeFormat* format = format_of(std::string("file") + extension)) {
      const auto read = format->import("nothing", "this is not such a file\n");
      CHECK((!read || read->objects.empty()));
    }
}
