// Dear ImGui's looks from our themes, and its fonts.
#include <imgui_freetype.h>

#include "player/ui/ui.hpp"

namespace blossom {
namespace {

constexpr double text_size = 15, small_size = 12.5;  // units

ImVec4 to_imgui(Color c, double opacity = 1) {
  const float a = static_cast<float>(c.a / 255.0 * opacity);
  return {static_cast<float>(c.r) / 255, static_cast<float>(c.g) / 255, static_cast<float>(c.b) / 255, a};
}

Color mix(Color a, Color b, double t) {
  const auto channel = [&](std::uint8_t x, std::uint8_t y) {
    return static_cast<std::uint8_t>(static_cast<double>(x) + t * (static_cast<double>(y) - static_cast<double>(x)) +
                                     0.5);
  };
  return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b), 255};
}

// Letters of the languages of Europe, Greek, arrows, mathematics, geometric shapes.
constexpr ImWchar ranges[] = {0x20,   0x17F,  0x370,  0x3FF,  0x2010, 0x2027, 0x2030, 0x205E, 0x2070,
                              0x209F, 0x2190, 0x21FF, 0x2200, 0x22FF, 0x2318, 0x2318, 0x25A0, 0x25FF,
                              0x2605, 0x2606, 0x2610, 0x2612, 0x2713, 0x2717, 0};
// Every glyph is made before the first frame, and that took a sixth of the time to it. What is bold, small or of equal
// widths is set by us, but for titles: letters, and of the symbols the usual ones.
constexpr ImWchar fewer_ranges[] = {0x20,   0x17F,  0x391,  0x3C9,  0x2010, 0x2027, 0x2030, 0x203A, 0x2070, 0x209C,
                                    0x2190, 0x2195, 0x21D0, 0x21D4, 0x2200, 0x221E, 0x2227, 0x222B, 0x2248, 0x2248,
                                    0x2260, 0x2265, 0x2282, 0x2287, 0x22C5, 0x22C5, 0x25A0, 0x25A1, 0x25B2, 0x25C6,
                                    0x25CB, 0x25CF, 0x2605, 0x2606, 0x2713, 0x2717, 0};

}  // namespace

ImU32 Ui::color(Role role, double opacity) const {
  return ImGui::ColorConvertFloat4ToU32(to_imgui(theme_[role].color, opacity));
}
ImU32 Ui::ink(Role role, double opacity) const {
  return ImGui::ColorConvertFloat4ToU32(to_imgui(theme_[role].ink, opacity));
}

void Ui::make_fonts() {
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  io.Fonts->FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  io.Fonts->FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  const auto add = [&](FontStyle style, double size, const ImWchar* glyphs) {
    return io.Fonts->AddFontFromFileTTF(Fonts::file(style).c_str(), static_cast<float>(std::round(size * scale_)),
                                        nullptr, glyphs);
  };
  regular_ = add({}, text_size, ranges);
  bold_ = add({.bold = true}, text_size, fewer_ranges);
  mono_ = add({.monospace = true}, text_size * 0.93, fewer_ranges);
  small_ = add({}, small_size, fewer_ranges);
  io.FontDefault = regular_;
  unsigned char* coverage = nullptr;
  int width = 0, height = 0;
  io.Fonts->GetTexDataAsAlpha8(&coverage, &width, &height);
  canvas_->set_texture(width, height, {coverage, static_cast<std::size_t>(width) * static_cast<std::size_t>(height)});
  io.Fonts->SetTexID(reinterpret_cast<ImTextureID>(1));
  io.Fonts->ClearTexData();
  fonts_scale_ = scale_;
}

void Ui::make_style() {
  const auto role = [&](Role r) { return theme_[r]; };
  const Color background = theme_.background, text = role(Role::text).ink, panel = role(Role::panel).color;
  const Color accent = role(Role::current).color, line = role(Role::rule_line).color;
  ImGuiStyle style;
  style.WindowPadding = {10, 8};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 6};
  style.ItemInnerSpacing = {6, 4};
  style.ScrollbarSize = 12;
  style.GrabMinSize = 12;
  style.WindowRounding = 6;
  style.ChildRounding = 4;
  style.FrameRounding = 4;
  style.PopupRounding = 6;
  style.ScrollbarRounding = 6;
  style.GrabRounding = 4;
  style.TabRounding = 4;
  style.WindowBorderSize = 1;
  style.FrameBorderSize = theme_.name == "contrast" ? 1.0f : 0.0f;
  style.AntiAliasedLinesUseTex = false;
  style.ScaleAllSizes(static_cast<float>(scale_));
  style.WindowBorderSize = style.PopupBorderSize = std::max(1.0f, std::round(px(1)));

  const auto set = [&](ImGuiCol which, Color c, double opacity = 1) { style.Colors[which] = to_imgui(c, opacity); };
  const Color soft = mix(background, text, 0.08), softer = mix(background, text, 0.16),
              strong = mix(background, text, 0.26);
  set(ImGuiCol_Text, text);
  set(ImGuiCol_TextDisabled, role(Role::text_quiet).ink);
  set(ImGuiCol_WindowBg, background);
  set(ImGuiCol_ChildBg, background, 0);
  set(ImGuiCol_PopupBg, background);
  set(ImGuiCol_Border, line);
  set(ImGuiCol_BorderShadow, background, 0);
  set(ImGuiCol_FrameBg, soft);
  set(ImGuiCol_FrameBgHovered, softer);
  set(ImGuiCol_FrameBgActive, strong);
  set(ImGuiCol_TitleBg, panel);
  set(ImGuiCol_TitleBgActive, panel);
  set(ImGuiCol_TitleBgCollapsed, panel);
  set(ImGuiCol_MenuBarBg, panel);
  set(ImGuiCol_ScrollbarBg, background, 0);
  set(ImGuiCol_ScrollbarGrab, softer);
  set(ImGuiCol_ScrollbarGrabHovered, strong);
  set(ImGuiCol_ScrollbarGrabActive, accent);
  set(ImGuiCol_CheckMark, accent);
  set(ImGuiCol_SliderGrab, accent);
  set(ImGuiCol_SliderGrabActive, accent);
  set(ImGuiCol_PlotHistogram, mix(background, accent, 0.45));
  set(ImGuiCol_PlotHistogramHovered, mix(background, accent, 0.45));
  set(ImGuiCol_Button, soft);
  set(ImGuiCol_ButtonHovered, softer);
  set(ImGuiCol_ButtonActive, strong);
  set(ImGuiCol_Header, accent, 0.18);
  set(ImGuiCol_HeaderHovered, accent, 0.26);
  set(ImGuiCol_HeaderActive, accent, 0.34);
  set(ImGuiCol_Separator, line);
  set(ImGuiCol_SeparatorHovered, accent, 0.6);
  set(ImGuiCol_SeparatorActive, accent);
  set(ImGuiCol_ResizeGrip, line, 0);
  set(ImGuiCol_ResizeGripHovered, accent, 0.6);
  set(ImGuiCol_ResizeGripActive, accent);
  set(ImGuiCol_Tab, panel);
  set(ImGuiCol_TabHovered, softer);
  set(ImGuiCol_TabActive, mix(background, accent, 0.2));
  set(ImGuiCol_TabUnfocused, panel);
  set(ImGuiCol_TabUnfocusedActive, mix(background, accent, 0.2));
  set(ImGuiCol_TableHeaderBg, panel);
  set(ImGuiCol_TableBorderStrong, line);
  set(ImGuiCol_TableBorderLight, line, 0.6);
  set(ImGuiCol_TableRowBg, background, 0);
  set(ImGuiCol_TableRowBgAlt, text, 0.03);
  set(ImGuiCol_TextSelectedBg, role(Role::level_a).color, 0.35);
  set(ImGuiCol_DragDropTarget, accent);
  set(ImGuiCol_NavHighlight, role(Role::focus).color);
  set(ImGuiCol_NavWindowingHighlight, role(Role::focus).color);
  set(ImGuiCol_NavWindowingDimBg, text, 0.2);
  set(ImGuiCol_ModalWindowDimBg, mix(background, text, 0.6), 0.45);
  ImGui::GetStyle() = style;
}

}  // namespace blossom
