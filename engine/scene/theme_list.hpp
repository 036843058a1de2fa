#pragma once
// Which looks there are, by name and as menus call them. The looks themselves are render/theme.cpp's; their names stand
// here because settings are read, and themes chosen, where nothing draws.

#include <array>
#include <string_view>

namespace blossom {

struct ThemeName {
  std::string_view name, title;
};
inline constexpr std::array<ThemeName, 3> theme_list{
    {{"light", "Light"}, {"dark", "Dark"}, {"contrast", "High contrast"}}};

}  // namespace blossom
