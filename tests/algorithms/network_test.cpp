// Coons patches and Gordon surfaces: they hold every curve they are made of.

#include "algorithms/construction.hpp"
#include "algorithms/networks.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

std::string shown(const Network& network) {
  std::string text;
  for (const auto* curves : {&network.u_curves, &network.v_curves})
    for (const auto& curve : *curves) text += write_curve(curve) + "\n";
  return text;
}

Inputs<Exact> inputs_from(const Network& network, bool with_parameters) {
  Inputs<Exact> inputs;
  inputs.values.emplace("u_curves", network.u_curves);
  inputs.values.emplace("v_curves", network.v_curves);
  if (with_parameters) {
    inputs.values.emplace("u_parameters", network.u_parameters);
    inputs.values.emplace("v_parameters", network.v_parameters);
  }
  return inputs;
}

// S(u, v) where u and v are the shares t and s of the surface's domain.
HPoint<Exact> at(const Surface<Exact>& surface, const Exact& t, const Exact& s) {
  const auto &U = surface.knots[0], &V = surface.knots[1];
  return homogeneous_point(surface, U.front() + (U.back() - U.front()) * t, V.front() + (V.back() - V.front()) * s);
}

// How far v lies in the domain of a curve.
Exact share(const Curve<Exact>& curve, const Exact& v) {
  return (v - curve.domain_begin()) / (curve.domain_end() - curve.domain_begin());
}

const char* bowl = R"({
  "u_curves":
    [{"degree": 2, "points": [[0, 0, 0], [3, 0, 4], [6, 0, 0]]}, {"degree": 1, "points": [[0, 6, 0], [6, 6, 0]]}],
  "v_curves":
    [{"degree": 1, "points": [[0, 0, 0], [0, 6, 0]]}, {"degree": 2, "points": [[6, 0, 0], [6, 3, -2], [6, 6, 0]]}]
})";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST_CASE("a Coons patch has the four curves as its boundary", "[coons]") {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    std::mt19937 random(seed);
    const auto network = any_network(random, *find_algorithm("coons"));
    INFO("seed " << seed << "\n" << shown(network));
    const auto surface = construct("coons", inputs_from(network, false));
    for (int i = 0; i <= 12; ++i) {
      const Exact t = Exact::ratio(i, 12);
      for (std::size_t l = 0; l < 2; ++l) {
        const auto end = Exact(static_cast<int>(l));
        CHECK(at(surface, t, end) == homogeneous_point(network.u_curves[l], at_share(network.u_curves[l], t)));
        CHECK(at(surface, end, t) == homogeneous_point(network.v_curves[l], at_share(network.v_curves[l], t)));
      }
    }
  }
}

TEST_CASE("inside, a Coons patch is ruled plus ruled minus bilinear", "[coons]") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    const auto network = any_network(random, *find_algorithm("coons"));
    INFO("seed " << seed << "\n" << shown(network));
    const auto surface = construct("coons", inputs_from(network, false));
    const auto A = [&](std::size_t l, const Exact& t) {
      return *point(network.u_curves[l], at_share(network.u_curves[l], t));
    };
    const auto B = [&](std::size_t k, const Exact& t) {
      return *point(network.v_curves[k], at_share(network.v_curves[k], t));
    };
    const auto mix = [](const Exact& t, const Point<Exact>& P, const Point<Exact>& Q) {
      return P * (Exact(1) - t) + Q * t;
    };
    for (int i = 0; i < 12; ++i) {
      const Exact u = random_ratio(random, 0, 1, 24), v = random_ratio(random, 0, 1, 24);
      const auto bilinear = mix(v, mix(u, A(0, 0), A(0, 1)), mix(u, A(1, 0), A(1, 1)));
      CHECK(*affine_point(at(surface, u, v)) == mix(v, A(0, u), A(1, u)) + mix(u, B(0, v), B(1, v)) - bilinear);
    }
  }
}

TEST_CASE("equal weights may be any number; others are refused", "[coons]") {
  CHECK(refusal("coons", bowl).empty());
  CHECK(refusal("coons", replaced(bowl, "[6, 0, 0]]}, {", R"([6, 0, 0]], "weights": [1, 2, 1]}, {)"))
            .find("u_curves: must be polynomial, or all curves must have the same weight everywhere: number 0 has the "
                  "weight 2, the first curve 1") != std::string::npos);
  std::string heavy = bowl;
  for (const auto& [from, to] :
       std::vector<std::pair<std::string, std::string>>{{"[6, 0, 0]]}, {", R"([6, 0, 0]], "weights": [2, 2, 2]}, {)"},
                                                        {"[6, 6, 0]]}],", R"([6, 6, 0]], "weights": [2, 2]}],)"},
                                                        {"[0, 6, 0]]}, {", R"([0, 6, 0]], "weights": [2, 2]}, {)"},
                                                        {"[6, 6, 0]]}]\n", R"([6, 6, 0]], "weights": [2, 2, 2]}])"}})
    heavy = replaced(heavy, from, to);
  const auto plain = surface_from("coons", bowl), weighted = surface_from("coons", heavy);
  CHECK(weighted.rational);
  CHECK(*point(weighted, Exact::ratio(1, 3), Exact::ratio(2, 5)) ==
        *point(plain, Exact::ratio(1, 3), Exact::ratio(2, 5)));
}

TEST_CASE("corners that do not meet are told with their places", "[coons]") {
  const auto message = refusal("coons", replaced(bowl, "[6, 6, 0]]}]\n", "[6, 6, 1]]}]\n"));
  CHECK(message.find(
            "v_curves: must meet the curves along u: number 1 is at (6, 6, 1) for v = 1, but number 1 of u_curves "
            "is at (6, 6, 0) for u = 1") != std::string::npos);
  CHECK(refusal("coons", replaced(bowl, R"("v_curves":
    [)",
                                  R"("v_curves": [{"degree": 1, "points": [[0, 0], [1, 1]]}, )"))
            .find("v_curves: must be two curves, not 3") != std::string::npos);
}

TEST_CASE("a Gordon surface holds every curve of its network", "[gordon]") {
  for (unsigned seed = 1; seed <= 24; ++seed) {
    std::mt19937 random(seed);
    const bool evenly = seed % 2 == 0;
    const auto network =
        random_network(random, 2 + static_cast<int>(seed % 4), 2 + static_cast<int>(seed / 4 % 4), evenly);
    INFO("seed " << seed << "\n" << shown(network));
    auto inputs = inputs_from(network, !evenly);
    if (evenly)
      for (const char* name : {"u_parameters", "v_parameters"}) inputs.values.emplace(name, std::vector<Exact>());
    const auto surface = construct("gordon", inputs);
    for (int i = 0; i <= 8; ++i) {
      const Exact t = Exact::ratio(i, 8);
      for (std::size_t l = 0; l < network.u_curves.size(); ++l) {
        const auto& C = network.u_curves[l];
        CHECK(at(surface, t, share(network.v_curves[0], network.v_parameters[l])) ==
              homogeneous_point(C, at_share(C, t)));
      }
      for (std::size_t k = 0; k < network.v_curves.size(); ++k) {
        const auto& D = network.v_curves[k];
        CHECK(at(surface, share(network.u_curves[0], network.u_parameters[k]), t) ==
              homogeneous_point(D, at_share(D, t)));
      }
    }
  }
}

TEST_CASE("a Gordon surface through four boundary curves is their Coons patch", "[gordon]") {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    std::mt19937 random(seed);
    const auto network = any_network(random, *find_algorithm("coons"));
    INFO("seed " << seed << "\n" << shown(network));
    const auto coons = construct("coons", inputs_from(network, false));
    const auto gordon = construct("gordon", inputs_from(network, true));
    for (int i = 0; i < 20; ++i) {
      const Exact u = random_ratio(random, 0, 1, 24), v = random_ratio(random, 0, 1, 24);
      CHECK(at(coons, u, v) == at(gordon, u, v));
    }
  }
}

TEST_CASE("networks that do not cross at common parameters are told", "[gordon]") {
  CHECK(refusal("gordon", bowl).empty());
  const auto with = [](const char* more) {
    return refusal("gordon", replaced(bowl, "]}]\n}", std::string("]}],") + more + "}"));
  };
  CHECK(with(R"("u_parameters": [0, 1, 2])")
            .find("u_parameters: must be 2, one for each curve that crosses, or none: not 3") != std::string::npos);
  CHECK(with(R"("v_parameters": [0, 2])").find("v_parameters: must begin at 0 and end at 1") != std::string::npos);
  const std::string other_domain = replaced(bowl, R"({"degree": 1, "points": [[0, 6, 0])",
                                            R"({"degree": 1, "knots": [0, 0, 2, 2], "points": [[0, 6, 0])");
  CHECK(refusal("gordon", other_domain).find("u_curves: must all have one domain") != std::string::npos);
  CHECK(refusal("gordon", replaced(bowl, "[6, 6, 0]]}]\n", "[6, 6, 1]]}]\n"))
            .find("v_curves: must meet the curves along u") != std::string::npos);
}
