// Skinning: every profile is an isoparametric curve of the surface, whatever the profiles are.

#include "kernel/skinning.hpp"
#include "algorithms/curves.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

using Profiles = std::vector<Curve<Exact>>;

// The parameters of the profiles, as the trace has them.
std::vector<Exact> parameters_of(const Trace<Exact>& trace, std::size_t count) {
  std::vector<Exact> v;
  for (std::size_t l = 0; l < count; ++l) v.push_back(trace.numbers(*trace.find("v[" + std::to_string(l) + "]"))[0]);
  return v;
}

struct Skinned {
  Surface<Exact> surface;
  Trace<Exact> trace;
};

Skinned skin_of(const Profiles& profiles, int degree_v, Parametrization parametrization) {
  TraceRecorder<Exact> recorder;
  NoRecorder<Exact> none;
  auto surface = skinning(profiles, degree_v, parametrization, recorder);
  CHECK(surface == skinning(profiles, degree_v, parametrization, none));
  return {std::move(surface), std::move(recorder).take()};
}

std::string message_of(const Profiles& profiles, Parametrization parametrization) {
  NoRecorder<Exact> none;
  try {
    skinning(profiles, 1, parametrization, none);
  } catch (const KernelError& error) {
    return error.input + ": " + error.message;
  }
  return "";
}

// S(u, v_l) = C_l(u): exactly where the parameters are exact, otherwise to rounding.
void check_profiles(const Profiles& profiles, int degree_v, Parametrization parametrization) {
  const auto [surface, trace] = skin_of(profiles, degree_v, parametrization);
  const auto v = parameters_of(trace, profiles.size());
  CHECK(surface.degree[1] == degree_v);
  CHECK(v.front() == Exact(0));
  CHECK(v.back() == Exact(1));
  CHECK(surface.columns == static_cast<int>(profiles.size()));
  REQUIRE(surface.knots[0].size() == static_cast<std::size_t>(surface.rows + surface.degree[0] + 1));
  REQUIRE(surface.knots[1].size() == static_cast<std::size_t>(surface.columns + surface.degree[1] + 1));
  const Exact& begin = surface.knots[0].front();
  const Exact& end = surface.knots[0].back();

  // The same in double, against the profiles in double.
  NoRecorder<double> none;
  std::vector<Curve<double>> rounded_profiles;
  for (const auto& profile : profiles) rounded_profiles.push_back(convert<double>(profile));
  const auto rounded = skinning(rounded_profiles, degree_v, parametrization, none);
  double scale = 1;
  for (const auto& P : rounded.points)
    for (int c = 0; c < 4; ++c) scale = std::max(scale, std::abs(P[c]));

  for (std::size_t l = 0; l < profiles.size(); ++l) {
    const auto& profile = profiles[l];
    INFO("profile " << l << " at v = " << v[l].to_string());
    for (int i = 0; i <= 12; ++i) {
      const Exact t = Exact::ratio(i, 12);
      const Exact u = begin + (end - begin) * t;
      const auto S = homogeneous_point(surface, u, v[l]);
      const auto C =
          homogeneous_point(profile, profile.domain_begin() + (profile.domain_end() - profile.domain_begin()) * t);
      if (!v[l].is_approximate() && trace.approximate_values().empty())
        CHECK(S == C);
      else
        for (int c = 0; c < 4; ++c) CHECK(near(S[c].to_double(), C[c].to_double(), scale));
      // At a jump of the profile the rounded parameter may lie on the other side.
      if (multiplicity<Exact>(surface.knots[0], u) > surface.degree[0] && 0 < i && i < 12) continue;
      const auto D = homogeneous_point(rounded, u.to_double(), v[l].to_double());
      for (int c = 0; c < 4; ++c) CHECK(near(D[c], C[c].to_double(), 1e3 * scale));
    }
  }
}

Profiles random_profiles(std::mt19937& random, int count) {
  Profiles profiles;
  const bool one_domain = random_int(random, 0, 1) == 1;
  for (int l = 0; l < count; ++l) {
    const int p = random_int(random, 1, 3);
    auto profile = random_curve(random, p, random_int(random, 1, 3), p, random_int(random, 0, 2) > 0,
                                random_int(random, 0, 2) == 0);
    if (one_domain) {
      const Exact a = profile.domain_begin();
      const Exact b = profile.domain_end();
      for (Exact& u : profile.knots) u = (u - a) / (b - a);
    }
    for (auto& P : profile.points) P.z = P.w * Exact(3 * l);
    profiles.push_back(std::move(profile));
  }
  return profiles;
}

// A profile moved by (3, 4, 0) each time: all distances are 5.
Profiles moved_by_3_4(int count) {
  Curve<Exact> profile;
  profile.degree = 2;
  profile.dimension = 3;
  profile.knots = bezier_knots<Exact>(2);
  profile.points = {{0, 0, 0, 1}, {1, 0, 2, 1}, {2, 0, 0, 1}};
  Profiles profiles;
  for (int l = 0; l < count; ++l) {
    profiles.push_back(profile);
    for (auto& P : profile.points) P += HPoint<Exact>(3, 4, 0, 0);
  }
  return profiles;
}

}  // namespace

TEST_CASE("two to six profiles of any degrees, knots and domains, clamped or not, rational or not", "[skinning]") {
  for (unsigned seed = 1; seed <= 15; ++seed) {
    std::mt19937 random(seed);
    const int count = 2 + static_cast<int>(seed % 5);
    const auto profiles = random_profiles(random, count);
    std::string text;
    for (const auto& profile : profiles) text += write_curve(profile) + "\n";
    INFO("seed " << seed << "\n" << text);
    for (int degree_v = 1; degree_v < count; ++degree_v) check_profiles(profiles, degree_v, Parametrization::uniform);
    check_profiles(profiles, count - 1, Parametrization::chord);
    check_profiles(profiles, (count + 1) / 2, Parametrization::centripetal);
  }
}

TEST_CASE("whole distances keep the surface exact; others are named", "[skinning]") {
  for (int count = 2; count <= 5; ++count) {
    const auto profiles = moved_by_3_4(count);
    INFO(count << " profiles");
    const auto [surface, trace] = skin_of(profiles, count - 1, Parametrization::chord);
    CHECK(trace.approximate_values().empty());
    for (int l = 0; l < count; ++l)
      CHECK(parameters_of(trace, profiles.size())[static_cast<std::size_t>(l)] == Exact::ratio(l, count - 1));
    check_profiles(profiles, count - 1, Parametrization::chord);

    // The root of 5 is not rational: the square roots of the distances are approximate, and what is made of them.
    const auto rooted = skin_of(profiles, count - 1, Parametrization::centripetal).trace;
    const auto approximate = rooted.approximate_values();
    CHECK(std::ranges::count(approximate, *rooted.find("d[1][0]")) == 1);
    CHECK(std::ranges::count(approximate, *rooted.find("c[1][0]")) == 0);
    if (count > 2) {
      CHECK(std::ranges::count(approximate, *rooted.find("v[1]")) == 1);
      CHECK(std::ranges::count(approximate, *rooted.find("Q[0][1]")) == 1);
    }
  }
}

TEST_CASE("what an approximate value made is approximate, and nothing before it", "[skinning]") {
  std::mt19937 random(4);
  const auto trace = skin_of(random_profiles(random, 4), 2, Parametrization::chord).trace;
  const auto approximate = trace.approximate_values();
  REQUIRE(!approximate.empty());
  for (const ValueId v : approximate) {
    INFO(trace.name(v));
    const bool root = trace.value(v).rule == &rule_info<Distance> || trace.value(v).rule == &rule_info<Root>;
    const bool inherited =
        std::ranges::any_of(trace.operands(v), [&](ValueId o) { return std::ranges::binary_search(approximate, o); });
    CHECK((root || inherited));
  }
}

TEST_CASE("profiles that coincide, and points without a distance, are told", "[skinning]") {
  auto profiles = moved_by_3_4(3);
  profiles[2] = profiles[1];
  for (const auto way : {Parametrization::chord, Parametrization::centripetal})
    CHECK(message_of(profiles, way) ==
          "profiles[2]: coincides with the profile before it: neighbouring profiles must differ");
  profiles[0] = profiles[1];
  CHECK(message_of(profiles, Parametrization::chord) ==
        "profiles: all profiles coincide: there is no surface through them");
  CHECK(message_of({profiles[0], profiles[0]}, Parametrization::chord) ==
        "profiles: all profiles coincide: there is no surface through them");

  profiles = moved_by_3_4(3);
  profiles[1].rational = true;
  profiles[1].points[1] = HPoint<Exact>(0, 0, 0, 0);
  CHECK(message_of(profiles, Parametrization::chord).find("profiles[1]: a control point of weight 0 has no distance") ==
        0);
  check_profiles(profiles, 2, Parametrization::uniform);
}

TEST_CASE("a degree across that is too high for the profiles is refused", "[skinning]") {
  const auto message = [](int degree_v) {
    return to_string(
        inputs_of(
            *find_algorithm("skinning"),
            R"({"profiles": [{"degree": 1, "points": [[0,0],[1,0]]}, {"degree": 1, "points": [[0,1],[1,1]]}], "degree_v": )" +
                std::to_string(degree_v) + "}")
            .diagnostics);
  };
  CHECK(message(1).empty());
  CHECK(message(2).find("degree_v: must be from 1 to 1 (profiles - 1), not 2") != std::string::npos);
}
