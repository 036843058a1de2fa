// How things are looked at.
#include <algorithm>

#include "player/action.hpp"
#include "player/player.hpp"

namespace blossom {
namespace {

bool is_open(const Player& p) { return p.session() != nullptr; }
bool has_view(const Player& p) { return is_open(p) || p.in_studio(); }
bool is_spatial(const Player& p) { return is_open(p) && p.session()->recording().source().spatial(); }

void face(Player& p, Plane plane) {
  const Camera from = p.shown_camera();
  Camera to = p.session()->recording().scenes().fitted(p.view_size().width, p.view_size().height, facing(from, plane));
  p.glide_to(to);
}

void zoom(Player& p, double factor) {
  if (p.in_studio()) return p.studio()->zoom(factor);
  const ViewSize size = p.view_size();
  p.glide_to(zoomed(p.shown_camera(), size, {size.width / 2, size.height / 2}, factor));
}

void fit(Player& p) {
  if (p.in_studio())
    p.studio()->fit();
  else
    p.glide_to(std::nullopt);
}

void scale_text(Player& p, double factor) {
  constexpr double sizes[] = {0.75, 0.9, 1, 1.1, 1.25, 1.5, 1.75, 2, 2.5, 3};
  const double now = p.settings.text_scale;
  double chosen = now;
  if (factor > 1) {
    for (auto s = std::rbegin(sizes); s != std::rend(sizes) && *s > now * 1.001; ++s) chosen = *s;
  } else {
    for (const double s : sizes)
      if (s < now * 0.999) chosen = s;
  }
  p.settings.text_scale = chosen;
}

void theme(Player& p, const char* name) { p.settings.theme = name; }

}  // namespace

const ActionGroup& actions_view() {
  static const ActionGroup group{
      "View",
      40,
      {
          {"view.fit", "Fit all into the view", {"F"}, fit, has_view, nullptr, Where::both},
          {"view.closer", "Closer", {"Z"}, [](Player& p) { zoom(p, 1.25); }, has_view, nullptr, Where::both},
          {"view.farther", "Farther", {"Shift+Z"}, [](Player& p) { zoom(p, 0.8); }, has_view, nullptr, Where::both},
          {"view.perspective",
           "Perspective",
           {"P"},
           [](Player& p) {
             p.settings.perspective = !p.settings.perspective;
             if (p.camera()) {
               Camera camera = *p.camera();
               camera.perspective = p.settings.perspective;
               p.set_camera(camera);
             }
           },
           is_spatial,
           [](const Player& p) { return p.settings.perspective; }},
          {"view.xy", "From above (xy)", {"1"}, [](Player& p) { face(p, Plane::xy); }, is_spatial},
          {"view.xz", "From the front (xz)", {"2"}, [](Player& p) { face(p, Plane::xz); }, is_spatial},
          {"view.yz", "From the side (yz)", {"3"}, [](Player& p) { face(p, Plane::yz); }, is_spatial},
          {"view.grid",
           "Grid and axes",
           {"#"},
           [](Player& p) { p.settings.grid = !p.settings.grid; },
           nullptr,
           [](const Player& p) { return p.settings.grid; },
           Where::both},
          {"view.exact",
           "Exact fractions",
           {"X"},
           [](Player& p) {
             p.settings.exact = !p.settings.exact;
             if (p.session() != nullptr) p.session()->set_exact(p.settings.exact);
           },
           nullptr,
           [](const Player& p) { return p.settings.exact; },
           Where::both},
          {"view.motion",
           "Reduced motion",
           {},
           [](Player& p) { p.settings.reduced_motion = !p.settings.reduced_motion; },
           nullptr,
           [](const Player& p) { return p.settings.reduced_motion; },
           Where::both},
          {"view.larger",
           "Larger text",
           {"Ctrl++", "Ctrl+="},
           [](Player& p) { scale_text(p, 2); },
           nullptr,
           nullptr,
           Where::both},
          {"view.smaller",
           "Smaller text",
           {"Ctrl+-"},
           [](Player& p) { scale_text(p, 0.5); },
           nullptr,
           nullptr,
           Where::both},
          {"view.normal_text",
           "Normal text size",
           {"Ctrl+0"},
           [](Player& p) { p.settings.text_scale = 1; },
           nullptr,
           nullptr,
           Where::both},
          {"view.light",
           "Light theme",
           {},
           [](Player& p) { theme(p, "light"); },
           nullptr,
           [](const Player& p) { return p.settings.theme == "light"; },
           Where::both},
          {"view.dark",
           "Dark theme",
           {},
           [](Player& p) { theme(p, "dark"); },
           nullptr,
           [](const Player& p) { return p.settings.theme == "dark"; },
           Where::both},
          {"view.contrast",
           "High-contrast theme",
           {},
           [](Player& p) { theme(p, "contrast"); },
           nullptr,
           [](const Player& p) { return p.settings.theme == "contrast"; },
           Where::both},
          {"view.next_theme",
           "Next theme",
           {"T"},
           [](Player& p) {
             const auto now = std::ranges::find(theme_list, p.settings.theme, &ThemeName::name);
             p.settings.theme =
                 (now == theme_list.end() || now + 1 == theme_list.end() ? theme_list.front() : now[1]).name;
           },
           nullptr,
           nullptr,
           Where::both},
          {"view.settings",
           "Settings ...",
           {"Ctrl+,"},
           [](Player& p) { p.dialog = Dialog::settings; },
           nullptr,
           nullptr,
           Where::both},
      }};
  return group;
}

}  // namespace blossom
