// Themes can be read by everyone.
#include "render/theme.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

using namespace blossom;

TEST_CASE("The contrast ratio is WCAG's") {
  CHECK(contrast_ratio({0, 0, 0}, {255, 255, 255}) == Approx(21));
  CHECK(contrast_ratio({255, 255, 255}, {0, 0, 0}) == Approx(21));
  CHECK(contrast_ratio({119, 119, 119}, {255, 255, 255}) == Approx(4.48).margin(0.005));  // the well-known #777
  CHECK(contrast_ratio({255, 0, 0}, {255, 255, 255}) == Approx(3.998).margin(0.001));
}

TEST_CASE("Text of every role is readable on the background and on panels, in every theme") {
  for (const auto& name : theme_names()) {
    const Theme& theme = **find_theme(name);
    for (int i = 0; i < role_count; ++i) {
      const auto role = static_cast<Role>(i);
      INFO(name << ", role " << i);
      CHECK(contrast_ratio(theme[role].ink, theme.background) >= 4.5);
      CHECK(contrast_ratio(theme[role].ink, theme[Role::panel].color) >= 4.5);
      if (name == "contrast") CHECK(contrast_ratio(theme[role].ink, theme.background) >= 7);
    }
  }
}

TEST_CASE("What a picture must tell apart differs by more than its colour") {
  const auto same_form = [](const RoleStyle& a, const RoleStyle& b, bool lines) {
    const bool lines_same = a.line_width == b.line_width && a.dash == b.dash && a.gap == b.gap;
    const bool markers_same = a.marker_shape == b.marker_shape && std::abs(a.marker_size - b.marker_size) < 1.9;
    return lines ? lines_same : markers_same;
  };
  const std::vector<Role> lines = {Role::curve,     Role::curve_result, Role::polygon,    Role::level_a, Role::level_b,
                                   Role::level_c,   Role::current,      Role::ratio_near, Role::earlier, Role::retired,
                                   Role::highlight, Role::right,        Role::mistake,    Role::focus};
  const std::vector<Role> markers = {Role::control_point, Role::level_b, Role::level_c, Role::operand,
                                     Role::current,       Role::result,  Role::earlier, Role::retired,
                                     Role::highlight,     Role::right,   Role::mistake, Role::focus};
  for (const auto& name : theme_names()) {
    const Theme& theme = **find_theme(name);
    for (const bool of_lines : {true, false}) {
      const auto& roles = of_lines ? lines : markers;
      for (std::size_t i = 0; i < roles.size(); ++i) {
        for (std::size_t j = i + 1; j < roles.size(); ++j) {
          INFO(name << ", roles " << static_cast<int>(roles[i]) << " and " << static_cast<int>(roles[j]));
          CHECK_FALSE(same_form(theme[roles[i]], theme[roles[j]], of_lines));
        }
      }
    }
    CHECK_FALSE(same_form(theme[Role::ratio_near], theme[Role::ratio_far], true));
    CHECK_FALSE(same_form(theme[Role::level_a], theme[Role::level_b], false));
  }
}

TEST_CASE("A highlight stands out: ringed, larger and wider than what it may lie on") {
  for (const auto& name : theme_names()) {
    const Theme& theme = **find_theme(name);
    const RoleStyle& highlight = theme[Role::highlight];
    INFO(name);
    CHECK(highlight.marker_shape == Marker::Shape::ring);
    for (int i = 0; i < role_count; ++i) {
      const auto role = static_cast<Role>(i);
      INFO("role " << i);
      if (role == Role::highlight) continue;
      CHECK(highlight.marker_size > 1.3 * theme[role].marker_size);
      if (role != Role::ratio_near) CHECK(highlight.line_width > 1.1 * theme[role].line_width);
    }
  }
}

namespace {

// Linear light, as the eye of a dichromat has it: Machado, Oliveira and Fernandes, "A physiologically-based model for
// simulation of color vision deficiency" (2009), severity 1.
using Matrix = std::array<std::array<double, 3>, 3>;
constexpr Matrix normal_sight = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Matrix protanopia = {
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix deuteranopia = {
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix tritanopia = {
    {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}};

// CIE L*a*b* under D65 of the colour as seen.
std::array<double, 3> lab(Color color, const Matrix& sight) {
  const auto linear = [](std::uint8_t channel) {
    const double v = channel / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  const auto times = [](const Matrix& m, const std::array<double, 3>& v) {
    std::array<double, 3> result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return result;
  };
  auto seen = times(sight, {linear(color.r), linear(color.g), linear(color.b)});
  for (double& v : seen) v = std::clamp(v, 0.0, 1.0);
  constexpr Matrix to_xyz = {
      {{0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041}}};
  auto xyz = times(to_xyz, seen);
  constexpr std::array<double, 3> white = {0.95047, 1.0, 1.08883};
  for (std::size_t i = 0; i < 3; ++i) {
    const double t = xyz[i] / white[i];
    xyz[i] = t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
  }
  return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

double distance(Color a, Color b, const Matrix& sight) {
  const auto p = lab(a, sight), q = lab(b, sight);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

}  // namespace

TEST_CASE("The model of colour blindness confuses what the colour blind confuse") {
  CHECK(distance({255, 255, 255}, {0, 0, 0}, normal_sight) == Approx(100).margin(0.01));
  CHECK(distance({255, 0, 0}, {0, 255, 0}, normal_sight) == Approx(170.6).margin(0.5));  // CIE76, well known
  CHECK(distance({190, 60, 60}, {105, 105, 60}, normal_sight) > 50);
  CHECK(distance({190, 60, 60}, {105, 105, 60}, deuteranopia) < 20);
}

TEST_CASE("Right, mistake, highlight and focus are told apart by every eye, and from the background") {
  const std::vector<Role> roles = {Role::right, Role::mistake, Role::highlight, Role::focus};
  for (const auto& name : theme_names()) {
    const Theme& theme = **find_theme(name);
    for (const Role a : roles) {
      INFO(name << ", role " << static_cast<int>(a));
      CHECK(contrast_ratio(theme[a].color, theme.background) >= 3);
      CHECK(contrast_ratio(theme[a].color, theme[Role::panel].color) >= 3);
      for (const Role b : roles) {
        if (a >= b) continue;
        for (const auto& [sight, matrix] :
             {std::pair{"normal", normal_sight}, std::pair{"protanopia", protanopia},
              std::pair{"deuteranopia", deuteranopia}, std::pair{"tritanopia", tritanopia}}) {
          INFO("against role " << static_cast<int>(b) << ", " << sight << ": "
                               << distance(theme[a].color, theme[b].color, matrix));
          CHECK(distance(theme[a].color, theme[b].color, matrix) > 12);
        }
      }
    }
  }
}

TEST_CASE("The things of a scene are seen on the background, and their colours differ for normal sight") {
  for (const auto& name : theme_names()) {
    const Theme& theme = **find_theme(name);
    for (int i = 0; i < 8; ++i) {
      INFO(name << ", object " << i);
      CHECK(contrast_ratio(theme[object_role(i)].color, theme.background) >= 2.5);
      for (int j = 0; j < i; ++j) {
        INFO("and " << j);
        CHECK(distance(theme[object_role(i)].color, theme[object_role(j)].color, normal_sight) > 18);
      }
    }
  }
}

TEST_CASE("The colours of maps are read by every eye") {
  for (const auto& [name, sight] : {std::pair{"normal", normal_sight}, std::pair{"protanopia", protanopia},
                                    std::pair{"deuteranopia", deuteranopia}, std::pair{"tritanopia", tritanopia}}) {
    INFO(name);
    // One sign is not taken for the other, nor for zero, from a fifth of the range on.
    for (const double share : {0.2, 0.5, 1.0}) {
      const Color less = map_color(ColorMap::diverging, 0.5 - share / 2),
                  more = map_color(ColorMap::diverging, 0.5 + share / 2);
      CHECK(distance(less, more, sight) > 12);
      CHECK(distance(less, map_color(ColorMap::diverging, 0.5), sight) > 8);
      CHECK(distance(more, map_color(ColorMap::diverging, 0.5), sight) > 8);
    }
    // Lightness tells the order.
    for (int i = 1; i <= 20; ++i) {
      CHECK(lab(map_color(ColorMap::sequential, i / 20.0), sight)[0] >
            lab(map_color(ColorMap::sequential, (i - 1) / 20.0), sight)[0]);
      if (i <= 10) {
        CHECK(lab(map_color(ColorMap::diverging, i / 20.0), sight)[0] >
              lab(map_color(ColorMap::diverging, (i - 1) / 20.0), sight)[0]);
        CHECK(lab(map_color(ColorMap::diverging, 1 - i / 20.0), sight)[0] >
              lab(map_color(ColorMap::diverging, 1 - (i - 1) / 20.0), sight)[0]);
      }
    }
  }
  CHECK(contrast_ratio(map_color(ColorMap::bands, 0), map_color(ColorMap::bands, 1)) > 7);
  CHECK(map_color(ColorMap::diverging, std::nan("")) == map_color(ColorMap::diverging, 0.5));
  CHECK(map_color(ColorMap::sequential, -3) == map_color(ColorMap::sequential, 0));
}

TEST_CASE("Themes are found by name; an unknown one names those there are") {
  CHECK(theme_names() == std::vector<std::string>{"light", "dark", "contrast"});
  for (const auto& name : theme_names()) CHECK((*find_theme(name))->name == name);
  const auto unknown = find_theme("drak");
  REQUIRE(unknown.diagnostics.size() == 1);
  for (const auto& part : {"\"drak\"", "light, dark, contrast", "did you mean \"dark\""}) {
    CHECK(unknown.diagnostics[0].message.find(part) != std::string::npos);
  }
}
