#pragma once
// How pages look that are drawn into files: the options --size, --scale and --theme of render and export.

#include <string>

#include "app/command.hpp"
#include "base/diagnostics.hpp"
#include "render/theme.hpp"

namespace blossom {

struct PageLookOptions {
  std::string size = "1120x700";
  std::string scale = "1";
  std::string theme = "light";
};
void add_page_look_options(CLI::App&, PageLookOptions&);

struct PageLook {
  double width = 1120, height = 700;
  double scale = 1;
  const Theme* theme = nullptr;
};
// Adds all that is wrong. `pixels`: the pages become pixels; others keep to the same bounds, at scale 1.
PageLook read_page_look(const PageLookOptions&, bool pixels, Diagnostics&);

}  // namespace blossom
