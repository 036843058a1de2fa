// Themes can be read by everyone.
#include "render/theme.hpp"

#include <algorithm>
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
  const std::vector<Role> lines = {Role::curve,   Role::curve_result, Role::polygon,    Role::level_a, Role::level_b,
                                   Role::level_c, Role::current,      Role::ratio_near, Role::earlier, Role::retired};
  const std::vector<Role> markers = {Role::control_point, Role::level_b, Role::level_c, Role::operand,
                                     Role::current,       Role::result,  Role::earlier, Role::retired};
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

TEST_CASE("Themes are found by name; an unknown one names those there are") {
  CHECK(theme_names() == std::vector<std::string>{"light", "dark", "contrast"});
  for (const auto& name : theme_names()) CHECK((*find_theme(name))->name == name);
  const auto unknown = find_theme("drak");
  REQUIRE(unknown.diagnostics.size() == 1);
  for (const auto& part : {"\"drak\"", "light, dark, contrast", "did you mean \"dark\""}) {
    CHECK(unknown.diagnostics[0].message.find(part) != std::string::npos);
  }
}
