#include "app/page_look.hpp"

#include <algorithm>
#include <charconv>

#include "base/scalar.hpp"

namespace blossom {
namespace {

constexpr double most_pixels = 64e6;
constexpr int longest_side = 16384;

bool parse_size(const std::string& text, double& width, double& height) {
  const auto x = text.find('x');
  if (x == std::string::npos) return false;
  int w = 0, h = 0;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), text.data() + x, w);
  const auto second = std::from_chars(text.data() + x + 1, end, h);
  if (first.ec != std::errc() || first.ptr != text.data() + x || second.ec != std::errc() || second.ptr != end)
    return false;
  const bool fits = w >= 480 && h >= 360 && w <= longest_side && h <= longest_side;
  if (fits) {
    width = w;
    height = h;
  }
  return fits;
}

}  // namespace

void add_page_look_options(CLI::App& app, PageLookOptions& options) {
  app.add_option("--size", options.size,
                 "Width and height of the page, from 480x360; times --scale at most 64 million pixels")
      ->capture_default_str();
  app.add_option("--scale", options.scale, "Pixels for each unit of the page, 0.25 to 8: 2 for high-resolution screens")
      ->capture_default_str();
  app.add_option("--theme", options.theme, "light, dark or contrast")->capture_default_str();
}

PageLook read_page_look(const PageLookOptions& options, bool pixels, Diagnostics& mistakes) {
  PageLook look;
  if (!parse_size(options.size, look.width, look.height))
    mistakes.push_back({"", 0, 0, "--size",
                        "must be WIDTHxHEIGHT, at least 480x360 and no side above " + std::to_string(longest_side) +
                            ", not " + excerpt(options.size)});
  if (const auto scale = parse_number<double>(options.scale); scale && 0.25 <= *scale && *scale <= 8)
    look.scale = *scale;
  else
    mistakes.push_back({"", 0, 0, "--scale", "must be a number from 0.25 to 8, not " + excerpt(options.scale)});
  const double scale = pixels ? look.scale : 1;
  const double width = look.width * scale, height = look.height * scale;
  if (width * height > most_pixels || std::max(width, height) > longest_side)
    mistakes.push_back({"", 0, 0, "--size",
                        "times --scale makes " + format_short(width, 0) + "x" + format_short(height, 0) +
                            " pixels; they must be at most 64 million, and " + std::to_string(longest_side) +
                            " along a side"});
  const auto theme = find_theme(options.theme);
  for (const auto& mistake : theme.diagnostics) mistakes.push_back({"", 0, 0, "--theme", mistake.message});
  if (theme) look.theme = *theme;
  return look;
}

}  // namespace blossom
