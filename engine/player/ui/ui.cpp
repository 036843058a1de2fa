#include "player/ui/ui.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "player/action.hpp"
#include "render/painter.hpp"
#include "render/picture.hpp"

namespace blossom {

Ui::Ui(Player& player, std::unique_ptr<GlCanvas> canvas, std::shared_ptr<const Fonts> fonts)
    : player_(&player), canvas_(std::move(canvas)), fonts_(std::move(fonts)) {
  context_ = ImGui::CreateContext();
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // where panels stand is computed, not remembered
  io.LogFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;  // lists of more vertices than 16 bits number
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  io.ConfigInputTextCursorBlink = false;  // a blinking cursor would be a reason to draw twice a second
  io.KeyRepeatDelay = 0.3f;
  set_key_map(io);
  // Only through us: ImGui's own clipboard talks to no window.
  io.ClipboardUserData = this;
  io.SetClipboardTextFn = [](void* ui, const char* text) { static_cast<Ui*>(ui)->player_->desk().set_clipboard(text); };
  io.GetClipboardTextFn = [](void* ui) {
    static thread_local std::string text;
    text = static_cast<Ui*>(ui)->player_->desk().clipboard();
    return text.c_str();
  };
}

Checked<std::unique_ptr<Ui>> Ui::create(Player& player, const GlFunctions& gl, bool is_es,
                                        std::shared_ptr<const Fonts> fonts) {
  auto canvas = GlCanvas::create(gl, is_es, fonts);
  if (!canvas) return canvas.diagnostics;
  return std::unique_ptr<Ui>(new Ui(player, std::move(*canvas), std::move(fonts)));
}

Ui::~Ui() {
  ImGui::SetCurrentContext(context_);
  ImGui::DestroyContext(context_);
}

void Ui::resize(int width, int height, double pixels_per_unit) {
  width_ = std::max(width, 1);
  height_ = std::max(height, 1);
  pixels_per_unit_ = pixels_per_unit;
  redraw();
}

bool Ui::wants_frame() const { return frames_wanted_ > 0 || !events_.empty() || player_->animating(); }

bool Ui::wants_text() const { return context_->IO.WantTextInput; }

void Ui::act(std::string_view action) { run_action(action, false); }

// ---- a frame --------------------------------------------------------------------------------------------------------

void Ui::frame(double seconds, bool drawn) {
  Stopwatch watch;
  frame_parts_ = {};
  ImGui::SetCurrentContext(context_);
  const auto theme = find_theme(player_->settings.theme);
  const Theme* wanted = theme ? *theme : &light_theme();
  const auto* session = std::as_const(*player_).session();
  const LessonColors colors =
      session != nullptr && session->document().lesson ? session->document().lesson->colors : LessonColors();
  const double scale = pixels_per_unit_ * player_->settings.text_scale;
  if (fonts_scale_ != scale || plain_theme_ != wanted || colors_ != colors) {
    scale_ = scale;
    plain_theme_ = wanted;
    colors_ = colors;
    theme_ = with_colors(*wanted, colors);
    if (fonts_scale_ != scale) make_fonts();
    make_style();
  }
  if (frames_wanted_ > 0) --frames_wanted_;
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width_), static_cast<float>(height_)};
  io.DeltaTime = static_cast<float>(std::clamp(seconds, 1e-4, 0.2));
  take_events();
  ImGui::NewFrame();
  if (io.WantTextInput && !covered()) {
    text_panel_ = player_->focus;
    text_field_ = context_->ActiveId != 0 ? context_->ActiveId : text_field_;
  }
  things_.clear();
  tabs_.clear();
  sheet_spots_.clear();
  pictures_.clear();
  hovered_ = {};
  draw_panels();
  draw_menu();
  ImGui::Render();
  cursor_ = ImGui::GetMouseCursor();
  if (hovered_ != player_->hovered()) {
    send([link = hovered_](Player& player) { player.hover(link); });
    redraw();
  }
  frame_parts_.panels = watch.lap();
  if (drawn) paint();
  watch.lap();
  // What was sent is seen in the next frame.
  if (!sent_.empty()) redraw();
  const Session* about = player_->session();
  const Studio* studio = player_->studio();
  for (const auto& what : std::exchange(sent_, {})) {
    if (player_->session() != about || player_->studio() != studio)
      break;  // the others were about what is open no more
    what(*player_);
    player_->settle();
  }
  if (std::exchange(picture_saved_, false) && drawn) paint();  // the window again, where the saved page was drawn
  frame_parts_.changes = watch.lap();
}

void Ui::paint() {
  Stopwatch watch;
  const ImDrawData& data = *ImGui::GetDrawData();
  Frame frame;
  frame.width = width_;
  frame.height = height_;
  frame.background = theme_[Role::panel].color;
  frame.title = "Blossom";
  canvas_->begin(frame);
  std::vector<ImageVertex> vertices;
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    vertices.clear();
    for (const ImDrawVert& v : list.VtxBuffer) {
      const auto channel = [&](int shift) { return static_cast<std::uint8_t>(v.col >> shift); };
      vertices.push_back({v.pos.x,
                          v.pos.y,
                          v.uv.x,
                          v.uv.y,
                          {channel(IM_COL32_R_SHIFT), channel(IM_COL32_G_SHIFT), channel(IM_COL32_B_SHIFT),
                           channel(IM_COL32_A_SHIFT)}});
    }
    for (const ImDrawCmd& command : list.CmdBuffer) {
      const PixelRect clip{command.ClipRect.x, command.ClipRect.y, command.ClipRect.z - command.ClipRect.x,
                           command.ClipRect.w - command.ClipRect.y};
      if (command.UserCallback != nullptr) {
        const auto number = reinterpret_cast<std::uintptr_t>(command.UserCallbackData);
        if (number >= pictures_.size()) continue;
        const Placement& picture = pictures_[number];
        paint_view(picture.view, theme_, *fonts_, *canvas_, scale_ * picture.zoom, picture.origin, clip);
        continue;
      }
      // The vertices of a list are few enough for 16-bit indices from its first one on.
      canvas_->image_triangles(std::span<const ImageVertex>(vertices).subspan(command.VtxOffset),
                               {list.IdxBuffer.Data + command.IdxOffset, command.ElemCount}, clip);
    }
  }
  frame_parts_.painting = watch.lap();
  Stopwatch clock(CLOCK_MONOTONIC);
  canvas_->finish();
  frame_parts_.drawing = clock.lap();
}

Checked<bool> Ui::save_picture(const Scene& scene, const std::filesystem::path& file) {
  if (file.extension() == ".svg") {
    const auto text = draw_svg(scene, theme_);
    return text ? write_file(file, *text) : Checked<bool>(text.diagnostics);
  }
  if (file.extension() != ".png")
    return Diagnostics{{file.string(), 0, 0, "", "a picture's name must end in .png or .svg"}};
  const double scale = 2;  // sharp on paper and on dense screens
  if (const auto frame = frame_of(scene, theme_, scale, canvas_->max_size()); !frame) return frame.diagnostics;
  blossom::paint(scene, theme_, *fonts_, *canvas_, scale);
  const auto image = canvas_->read();
  picture_saved_ = true;
  return image ? write_png(file, *image, scene.title, scene.description) : Checked<bool>(image.diagnostics);
}

// ---- windows of panels ----------------------------------------------------------------------------------------------

constexpr double share_of_widgets = 0.62;  // of the side's height, unless one has chosen another

void Ui::draw_panels() {
  const bool in_studio = player_->in_studio(), open = player_->session() != nullptr || in_studio;
  const auto relevant = [&](const Panel& panel) {
    const bool anywhere = panel.slot == Slot::bar || panel.slot == Slot::page || panel.slot == Slot::float_;
    if (!anywhere && (!open || panel.studio != in_studio)) return false;
    return panel.relevant == nullptr || panel.relevant(*player_);
  };
  const auto wanted = [&](const Panel& panel, double at_width) {
    return panel.height != nullptr ? panel.height(*this, at_width) : 200.0;
  };
  const auto tight = [&](const Panel& panel, double at_width) {
    return panel.tight != nullptr ? panel.tight(*this, at_width) : wanted(panel, at_width);
  };
  const double lower_share = player_->settings.lower_share;
  LayoutWish wish{width(),     height(), player_->settings.side_share,
                  lower_share, !open,    lower_share != Settings{}.lower_share,
                  player_->tab};
  // What one fills in has more room than what one looks at.
  for (const Panel* panel : panels())
    if (!wish.lower_fixed && panel->slot == Slot::tabs && panel->id == player_->tab && panel->widgets)
      wish.lower_share = share_of_widgets;
  // In a window with room for one panel only, a lesson begins with its picture.
  const bool other = std::exchange(seen_session_, player_->session()) != player_->session();
  const Layout layout = lay_out(wish, panels(), relevant, wanted, tight);
  const auto picture = std::ranges::find(layout.tabbed, "viewport", &Panel::id);
  if (other && player_->session() != nullptr && picture != layout.tabbed.end())
    send([](Player& player) { player.tab = "viewport"; });
  for (const Placed& placed : layout.placed) draw_window(*placed.panel, placed.rect);
  if (!layout.tabbed.empty() && layout.tabs.height > 0) draw_tabs(layout);
  focus_request_.clear();  // of a panel that is not on the screen
  if (open) draw_splitters(layout);
  for (const Panel* panel : panels())
    if (panel->slot == Slot::float_ && relevant(*panel)) panel->draw(*this);
  // A dialog that is not wanted any more goes at once, or it would hold the keyboard for another frame.
  if (player_->dialog == Dialog::none && ImGui::GetTopMostPopupModal() != nullptr) ImGui::ClosePopupToLevel(0, true);
}

namespace {

constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                   ImGuiWindowFlags_NoBringToFrontOnFocus;

}  // namespace

void Ui::draw_window(const Panel& panel, const PixelRect& rect) {
  ImGui::SetNextWindowPos({std::round(px(rect.x)), std::round(px(rect.y))});
  ImGui::SetNextWindowSize({std::round(px(rect.width)), std::round(px(rect.height))});
  const bool edge = panel.slot == Slot::bar || panel.slot == Slot::foot || panel.slot == Slot::page;
  ImGuiWindowFlags flags = fixed;
  if (!panel.widgets) flags |= ImGuiWindowFlags_NoNavInputs;
  if (edge) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    if (panel.slot != Slot::page) ImGui::PushStyleColor(ImGuiCol_WindowBg, color(Role::panel));
  }
  const bool bare = panel.slot == Slot::main || panel.slot == Slot::strip;
  if (bare) ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  const std::string id(panel.id);
  const bool arrives = keyboard_arrives(id);
  if (ImGui::Begin(id.c_str(), nullptr, flags)) {
    if (ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows) && ImGui::IsMouseClicked(0) && player_->focus != id)
      send([id](Player& player) { player.focus = id; });
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    thing("panel " + id, low, {low.x + size.x, low.y + size.y});
    if (arrives) welcome_keyboard(panel);
    panel.draw(*this);
    draw_focus_ring(id);
  }
  ImGui::End();
  if (bare) ImGui::PopStyleVar();
  if (edge) {
    ImGui::PopStyleVar(2);
    if (panel.slot != Slot::page) ImGui::PopStyleColor();
  }
}

// Our own tabs: Dear ImGui's remember which is active, and that is the player's to know. They wrap; where a second row
// would take what little height there is, they are a list that folds.
void Ui::draw_tab_bar(const Layout& layout, const Panel& active) {
  const auto choose = [&](const Panel& panel) {
    send([id = std::string(panel.id)](Player& player) { player.tab = player.focus = id; });
  };
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  const auto width_of = [&](const Panel& panel) {
    return ImGui::CalcTextSize(std::string(panel.title).c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
  };
  float all = 0;
  for (const Panel* panel : layout.tabbed) all += width_of(*panel) + px(4);
  if (ImGui::GetCursorScreenPos().x + all > right + px(4) && layout.tabs.height < 200) {
    ImGui::SetNextItemWidth(px(180));
    if (ImGui::BeginCombo("##tabs", std::string(active.title).c_str(), ImGuiComboFlags_HeightLargest)) {
      for (const Panel* panel : layout.tabbed) {
        if (ImGui::Selectable(std::string(panel->title).c_str(), panel == &active)) choose(*panel);
        thing("tab " + std::string(panel->id));
      }
      ImGui::EndCombo();
    } else {
      thing("tab list");
    }
    return;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {px(4), px(4)});
  for (const Panel* panel : layout.tabbed) {
    const float width = width_of(*panel);
    if (panel != layout.tabbed.front()) {
      ImGui::SameLine();
      if (ImGui::GetCursorScreenPos().x + width > right) ImGui::NewLine();
    }
    const bool is_active = panel == &active;
    if (is_active) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_TabActive));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (button(std::string(panel->title).c_str(), "tab " + std::string(panel->id))) choose(*panel);
    if (is_active) {
      ImGui::PopStyleColor();
      const float bottom = at.y + ImGui::GetFrameHeight();
      ImGui::GetWindowDrawList()->AddRectFilled({at.x, bottom - px(2.5)}, {at.x + width, bottom}, color(Role::current));
    }
  }
  ImGui::PopStyleVar();
}

void Ui::draw_tabs(const Layout& layout) {
  const PixelRect& rect = layout.tabs;
  ImGui::SetNextWindowPos({std::round(px(rect.x)), std::round(px(rect.y))});
  ImGui::SetNextWindowSize({std::round(px(rect.width)), std::round(px(rect.height))});
  const Panel* active = layout.tabbed.front();
  for (const Panel* panel : layout.tabbed)
    if (panel->id == player_->tab) active = panel;
  ImGuiWindowFlags flags = fixed;
  if (!active->widgets) flags |= ImGuiWindowFlags_NoNavInputs;
  tabs_.clear();
  for (const Panel* panel : layout.tabbed) tabs_.emplace_back(panel->id);
  const bool arrives = keyboard_arrives(std::string(active->id));
  if (ImGui::Begin("tabs", nullptr, flags)) {
    if (ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows) && ImGui::IsMouseClicked(0) &&
        player_->focus != active->id)
      send([id = std::string(active->id)](Player& player) { player.focus = id; });
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    thing("panel " + std::string(active->id), low, {low.x + size.x, low.y + size.y});
    // The keyboard comes to what the tab holds, not to the tabs.
    ImGui::PushItemFlag(ImGuiItemFlags_NoNavDefaultFocus, true);
    draw_tab_bar(layout, *active);
    ImGui::PopItemFlag();
    if (arrives) welcome_keyboard(*active);
    field_ready_ = !arrives;  // a frame later: the fields of a new tab are there only then
    active->draw(*this);
    draw_focus_ring(std::string(active->id));
  }
  ImGui::End();
}

bool Ui::keyboard_arrives(const std::string& panel) {
  if (focus_request_ != panel) return false;
  focus_request_.clear();
  ImGui::SetNextWindowFocus();
  return true;
}

// To the first of its widgets.
void Ui::welcome_keyboard(const Panel& panel) {
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  if (!panel.widgets || context_->NavWindow != window) return;
  // A window without widgets, where the keyboard comes from, has put it out.
  if (ring_) context_->NavDisableHighlight = false;
  ImGui::NavInitWindow(window, true);
}

// In the window's own list: what stands over the window stands over its ring, too.
void Ui::draw_focus_ring(const std::string& panel) {
  if (!ring_ || player_->focus != panel || covered()) return;
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  const float in = px(1.5);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(low, {low.x + size.x, low.y + size.y});
  list.AddRect({low.x + in, low.y + in}, {low.x + size.x - in, low.y + size.y - in}, color(Role::focus), px(6), 0,
               px(3));
  list.PopClipRect();
}

void Ui::draw_splitters(const Layout& layout) {
  const auto splitter = [&](const char* name, ImVec2 low, ImVec2 high, ImGuiMouseCursor shape, auto&& moved) {
    ImGui::SetNextWindowPos(low);
    ImGui::SetNextWindowSize({high.x - low.x, high.y - low.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    if (ImGui::Begin(name, nullptr, fixed | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav)) {
      ImGui::InvisibleButton("grip", {high.x - low.x, high.y - low.y});
      thing(name);
      const bool held = ImGui::IsItemActive();
      if (held || ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(shape);
        ImGui::GetForegroundDrawList()->AddRectFilled(low, high, color(Role::current, held ? 0.8 : 0.4), px(3));
      }
      if (held) moved(ImGui::GetIO().MousePos);
    }
    ImGui::End();
    ImGui::PopStyleVar(3);
  };
  if (layout.side.width <= 0) return;
  const PixelRect side = layout.side;
  splitter("splitter side", {px(side.x - 6), px(side.y)}, {px(side.x), px(side.bottom())}, ImGuiMouseCursor_ResizeEW,
           [&](ImVec2 at) {
             const double share = (side.right() - units(at.x)) / std::max(width() - 18, 1.0);
             send([share](Player& player) {
               player.settings.side_share = share;
               player.settings = sane(player.settings);
             });
           });
  if (layout.lower_y > side.y)
    splitter("splitter tabs", {px(side.x), px(layout.lower_y - 6)}, {px(side.right()), px(layout.lower_y)},
             ImGuiMouseCursor_ResizeNS, [&](ImVec2 at) {
               const double share = (side.bottom() - units(at.y)) / side.height;
               send([share](Player& player) {
                 player.settings.lower_share = share;
                 player.settings = sane(player.settings);
               });
             });
}

// ---- sheets ---------------------------------------------------------------------------------------------------------

ImVec2 Ui::picture(View view, double width, double height, std::string_view name, double zoom) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 origin{std::round(at.x), std::round(at.y)};
  ImGui::Dummy({px(width * zoom), px(height * zoom)});
  if (!name.empty()) thing(std::string(name));
  if (!ImGui::IsItemVisible()) return origin;
  // The callback of ImGui's list is only a mark with the picture's number: paint() finds it.
  const auto mark = [](const ImDrawList*, const ImDrawCmd*) {};
  ImGui::GetWindowDrawList()->AddCallback(mark, reinterpret_cast<void*>(static_cast<std::uintptr_t>(pictures_.size())));
  pictures_.push_back({std::move(view), {origin.x, origin.y}, zoom});
  return origin;
}

const Spot* Ui::sheet(std::string_view panel, Sheet sheet, double width, double height, const SheetOptions& options) {
  sheet.view.width = width;
  sheet.view.height = height;
  kept_spots_ = std::move(sheet.spots);
  const ImVec2 at = picture(std::move(sheet.view), width, height, "", options.zoom);
  const auto pixels = [&](double length) { return px(length * options.zoom); };
  const bool over = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) && ImGui::IsWindowHovered();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Spot* found = nullptr;
  std::vector<Spot>& in_pixels = sheet_spots_[std::string(panel)];  // of all sheets of the panel
  for (const Spot& spot : kept_spots_) {
    const ImVec2 low{at.x + pixels(spot.x), at.y + pixels(spot.y)};
    const ImVec2 high{low.x + pixels(spot.width), low.y + pixels(spot.height)};
    if (!spot.name.empty() && ImGui::IsRectVisible(low, high)) thing(std::string(panel) + " " + spot.name, low, high);
    if (over && mouse.x >= low.x && mouse.x < high.x && mouse.y >= low.y && mouse.y < high.y) found = &spot;
    in_pixels.push_back({spot.link, low.x, low.y, high.x - low.x, high.y - low.y, spot.name});
    if (keyboard_in(panel) && spot.link == player_->focused && player_->focused && !covered())
      ImGui::GetWindowDrawList()->AddRect({low.x - px(2), low.y - px(2)}, {high.x + px(2), high.y + px(2)},
                                          color(Role::focus), px(4), 0, px(2));
  }
  if (found == nullptr) return nullptr;
  hovered_ = found->link;
  if (!options.clickable) return found;
  if (ImGui::IsMouseClicked(1)) {
    open_menu(found->link);
  } else if (ImGui::IsMouseDoubleClicked(0) && found->link.kind == Link::Kind::value) {
    send([v = found->link.id](Player& player) { player.seek_value(v); });
  } else if (ImGui::IsMouseReleased(0) && ImGui::GetIO().MouseDragMaxDistanceSqr[0] < 9 * scale_ * scale_) {
    send([link = found->link](Player& player) { player.pin(link); });
  }
  return found;
}

void Ui::open_menu(const Link& link) {
  menu_link_ = link;
  menu_requested_ = true;
}

// What is scrolled away is not on the screen; of what is cut off, the part that can be seen.
void Ui::thing(const std::string& name) {
  ImRect seen(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  seen.ClipWith(ImGui::GetCurrentWindow()->ClipRect);
  if (seen.Min.x < seen.Max.x && seen.Min.y < seen.Max.y) thing(name, seen.Min, seen.Max);
}

void Ui::thing(const std::string& name, const ImVec2& low, const ImVec2& high) {
  things_[name] = {low.x, low.y, static_cast<double>(high.x) - low.x, static_cast<double>(high.y) - low.y};
}

}  // namespace blossom
