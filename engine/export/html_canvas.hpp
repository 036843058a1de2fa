#pragma once
// Pictures for the page of a lesson: elements of SVG as JSON, each on its own, so that what successive steps share is
// stored once. Colours are classes that follow the theme of the page.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "render/canvas.hpp"
#include "render/hidden.hpp"
#include "render/lesson_theme.hpp"

namespace blossom {

// The looks that the pictures of one page use, as classes of a style sheet. Pictures are painted in probe(), whose
// colours tell which role they stand for; shades of faces are known by what the light does to two channels of a probe.
class HtmlLooks {
 public:
  static const Theme& probe();

  // What a class paints with, "--current" or "--m3", as the custom property that themes() defines.
  std::string variable(Color);
  // The class with these declarations.
  std::string style(const std::string& declarations);

  std::string rules() const;  // of all classes
  // :root of light, dark and contrast, with the lesson's colours, and what the reader's system prefers.
  std::string themes(const LessonColors&) const;

 private:
  struct Shade {  // of a face: times `share`, plus `gloss`
    int role = 0, share = 0, gloss = 0;
    auto operator<=>(const Shade&) const = default;
  };
  std::string properties(const Theme&) const;

  std::map<std::string, std::size_t> styles_;
  std::vector<std::string> in_order_;
  std::map<Shade, std::size_t> shades_;
};

// An element is a JSON array:
//   ["s1", "M0 0l1 1"]                        a path of this class
//   ["s1", x, y, radius]                      a circle
//   ["s1", [[x, y, size, "text", flags], ...]] text, run by run; flags: 1 bold, 2 italic, 4 monospace
//   [opacity, [["m1", "M..."], ...]]          a group of paths
class HtmlCanvas final : public Canvas {
 public:
  explicit HtmlCanvas(HtmlLooks& looks) : looks_(looks) {}

  void begin(const Frame&) override {}
  void begin_view(const PixelRect& clip, bool depth) override { cells_.begin_view(clip, depth); }
  void polyline(std::span<const PixelPoint>, bool closed, const Stroke&) override;
  void polygon(std::span<const PixelPoint>, Color) override;
  void marker(const PixelPoint&, Marker::Shape, const MarkerPaint&) override;
  void triangles(std::span<const PixelPoint>, std::span<const Color>, std::span<const std::uint32_t> indices,
                 double opacity) override;
  void text(std::span<const GlyphRun>, const TextPaint&) override;
  void finish() override {}

  std::vector<std::string> take() && { return std::move(elements_); }

 private:
  void add(const std::string& style, const std::string& path);

  HtmlLooks& looks_;
  DepthCells cells_;
  std::vector<std::string> elements_;
};

// "--current" without the dashes: the name of a role in the page's style sheets.
std::string_view role_name(Role);

}  // namespace blossom
