// What one sees while nothing is open: where one was, and the lessons and exercises with pictures of what they are
// about.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <cmath>
#include <map>
#include <set>

#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {

namespace fs = std::filesystem;

namespace {

constexpr double widest = 1180, card_width = 250, gap = 14, pad = 10, thumbnail_height = 124;  // units
constexpr double chips_height = 30;
constexpr std::size_t most_titles = 2, most_summary = 3, most_recent_shown = 4;

using Item = std::shared_ptr<const ShelfItem>;

// ---- pictures -------------------------------------------------------------------------------------------------------

// A thumbnail costs as much as a picture, so it is made once for every size.
const View& thumbnail(const ShelfItem& item, double width, double height) {
  struct Kept {
    std::shared_ptr<const Recording> recording;
    double width = 0, height = 0;
    View view;
  };
  static std::map<fs::path, Kept> kept;
  Kept& one = kept[item.file];
  if (one.recording != item.recording || one.width != width || one.height != height) {
    ViewportOptions options;
    options.grid = options.labels = false;
    // Rings and what has been moved aside reach beyond the curve.
    Camera camera = item.recording->scenes().fitted(width, height);
    camera.height *= 1.22;
    options.camera = camera;
    one = {item.recording, width, height,
           item.recording->scenes().viewport(item.telling_step, width, height, options).view};
    one.view.width = width;
    one.view.height = height;
  }
  return one.view;
}

void large_text(Ui& ui, const char* text, double size) {
  View view;
  view.width = ui.units(ImGui::GetContentRegionAvail().x);
  view.height = 14 * size * 1.35;
  Label label;
  label.anchor = {0, 14 * size, 0};
  TextRun run;
  run.text = text;
  run.bold = true;
  label.text = {run};
  label.role = Role::text_strong;
  label.size_scale = size;
  view.labels.push_back(std::move(label));
  const double width = view.width, height = view.height;
  ui.picture(std::move(view), width, height, "");
}

// ---- a card ---------------------------------------------------------------------------------------------------------

std::string card_name(const ShelfItem& item) {
  // A lesson and an exercise may have files of one name.
  return (item.kind == Document::Kind::exercise ? "card exercise " : "card ") + item.file.stem().string();
}

float line_height(ImFont* font) { return std::round(font->FontSize * 1.22f); }

float card_height(const Ui& ui) {
  return ui.px(2 * pad + thumbnail_height + 8 + 6 + 8) + static_cast<float>(most_titles) * line_height(ui.bold()) +
         static_cast<float>(most_summary) * line_height(ui.small()) + line_height(ui.small());
}

float draw_lines(ImFont* font, ImU32 color, ImVec2 at, float width, std::size_t most, const std::string& text) {
  ImGui::PushFont(font);
  for (const std::string& line : wrapped(text, width, most)) {
    ImGui::GetWindowDrawList()->AddText(at, color, line.c_str());
    at.y += line_height(font);
  }
  ImGui::PopFont();
  return at.y;
}

std::string what_was_done(const ShelfItem& item, const Progress* progress) {
  if (progress == nullptr) return item.minutes > 0 ? std::to_string(item.minutes) + " min" : "";
  std::string text;
  if (progress->share() >= 1)
    text = "\u2713 seen to the end";
  else if (progress->scene_count > 0)
    text = std::to_string(std::lround(100 * progress->share())) + " % of " + std::to_string(progress->scene_count) +
           " scenes";
  else if (progress->furthest > 0)
    text = "step " + std::to_string(progress->furthest) + " of " + std::to_string(progress->last);
  if (progress->asked > 0 && !progress->answers.empty())
    text += (text.empty() ? "" : ", ") + std::to_string(progress->right) + " of " + std::to_string(progress->asked) +
            " right";
  if (progress->best_score >= 0)
    text += (text.empty() ? "best " : ", best ") + std::to_string(std::lround(100 * progress->best_score)) + " %";
  return text;
}

void draw_foot(Ui& ui, const ShelfItem& item, ImVec2 low, ImVec2 high) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Progress* progress = ui.player().progress(item.file);
  ImGui::PushFont(ui.small());
  list.AddText(low, ui.ink(Role::text_quiet), what_was_done(item, progress).c_str());
  ImGui::PopFont();
  if (progress == nullptr || progress->last == 0) return;
  const float y = high.y - ui.px(4);
  const auto share = static_cast<float>(progress->share());
  list.AddRectFilled({low.x, y}, high, ui.color(Role::rule_line), ui.px(2));
  list.AddRectFilled({low.x, y}, {low.x + share * (high.x - low.x), high.y}, ui.color(Role::current), ui.px(2));
}

// All of what a card has room for a part of.
void tooltip(Ui& ui, const ShelfItem& item) {
  ImGui::BeginTooltip();
  ImGui::PushFont(ui.regular());
  ImGui::PushTextWrapPos(ui.px(380));
  ImGui::TextUnformatted(item.title.c_str());
  ImGui::PushStyleColor(ImGuiCol_Text, ui.ink(Role::text_quiet));
  if (!item.summary.empty()) ImGui::TextUnformatted(item.summary.c_str());
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
  ImGui::EndTooltip();
}

void draw_card(Ui& ui, const ShelfItem& item, ImVec2 at, ImVec2 size) {
  ImGui::SetCursorScreenPos(at);
  const std::string name = card_name(item);
  if (ImGui::InvisibleButton(name.c_str(), size)) ui.send([file = item.file](Player& player) { player.open(file); });
  const ImVec2 high{at.x + size.x, at.y + size.y};
  if (!ImGui::IsRectVisible(at, high)) return;
  // The part of it that one can click.
  const ImVec2 clip_low = ImGui::GetWindowDrawList()->GetClipRectMin(),
               clip_high = ImGui::GetWindowDrawList()->GetClipRectMax();
  ui.thing(name, {std::max(at.x, clip_low.x), std::max(at.y, clip_low.y)},
           {std::min(high.x, clip_high.x), std::min(high.y, clip_high.y)});
  const bool hovered = ImGui::IsItemHovered(), focused = ImGui::IsItemFocused() && ImGui::GetIO().NavVisible;
  if (hovered && item.kind == Document::Kind::exercise) tooltip(ui, item);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, high, ui.color(Role::panel), ui.px(8));
  const ImVec2 inner{at.x + ui.px(pad), at.y + ui.px(pad)};
  const float width = size.x - 2 * ui.px(pad);
  const ImVec2 picture_high{inner.x + width, inner.y + ui.px(thumbnail_height)};
  list.AddRectFilled(inner, picture_high, ImGui::GetColorU32(ImGuiCol_WindowBg), ui.px(5));
  ImGui::SetCursorScreenPos(inner);
  const double picture_width = std::floor(ui.units(width));
  ui.picture(thumbnail(item, picture_width, thumbnail_height), picture_width, thumbnail_height, "");
  if (item.kind == Document::Kind::exercise) {
    ImGui::PushFont(ui.small());
    const char* mark = "? Exercise";
    const ImVec2 text = ImGui::CalcTextSize(mark);
    const ImVec2 from{inner.x + ui.px(5), inner.y + ui.px(5)};
    const ImVec2 to{from.x + text.x + ui.px(12), from.y + text.y + ui.px(4)};
    list.AddRectFilled(from, to, ui.color(Role::panel), ui.px(9));
    list.AddRect(from, to, ui.color(Role::rule_line), ui.px(9));
    list.AddText({from.x + ui.px(6), from.y + ui.px(2)}, ui.ink(Role::text), mark);
    ImGui::PopFont();
  }
  const bool numbered = item.kind == Document::Kind::lesson && !item.number.empty();
  const std::string title = (numbered ? item.number + "  " : "") + item.title;
  const float below_title =
      draw_lines(ui.bold(), ui.ink(Role::text), {inner.x, picture_high.y + ui.px(8)}, width, most_titles, title);
  draw_lines(ui.small(), ui.ink(Role::text_quiet), {inner.x, below_title + ui.px(4)}, width, most_summary,
             item.summary);
  draw_foot(ui, item, {inner.x, high.y - ui.px(pad) - ui.px(6) - line_height(ui.small())},
            {inner.x + width, high.y - ui.px(pad)});
  const Role edge = focused ? Role::focus : (hovered ? Role::current : Role::rule_line);
  list.AddRect(at, high, ui.color(edge), ui.px(8), 0, ui.px(focused ? 2.5 : (hovered ? 1.5 : 1)));
}

// ---- exercises of a lesson ------------------------------------------------------------------------------------------

using ById = std::map<std::string, Item>;

std::string chip_label(const Ui& ui, const ShelfItem& exercise, std::size_t number) {
  const Progress* progress = ui.player().progress(exercise.file);
  std::string label = std::to_string(number);
  if (progress != nullptr && progress->best_score >= 0)
    label +=
        progress->best_score >= 1 ? " \u2713" : ": " + std::to_string(std::lround(100 * progress->best_score)) + " %";
  return label;
}

// Below the lesson's card, by numbers; their titles are what one sees when pointing at them.
void draw_chips(Ui& ui, const ShelfItem& lesson, const ById& exercises, ImVec2 at, float width) {
  std::vector<Item> own;
  for (const std::string& id : lesson.exercises)
    if (const auto found = exercises.find(id); found != exercises.end()) own.push_back(found->second);
  if (own.empty() || !ImGui::IsRectVisible(at, {at.x + width, at.y + ui.px(chips_height)})) return;
  ImGui::PushFont(ui.small());
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(7), ui.px(2)});
  const float height = ImGui::GetFrameHeight(), y = at.y + ui.px(5);
  const char* what = own.size() == 1 ? "Exercise" : "Exercises";
  ImGui::GetWindowDrawList()->AddText({at.x + ui.px(4), y + ui.px(2)}, ui.ink(Role::text_quiet), what);
  float x = at.x + ui.px(4) + ImGui::CalcTextSize(what).x + ui.px(8);
  for (std::size_t i = 0; i < own.size(); ++i) {
    const std::string label = chip_label(ui, *own[i], i + 1);
    const float wide = ImGui::CalcTextSize(label.c_str()).x + 2 * ui.px(7);
    if (x + wide > at.x + width) break;
    ImGui::SetCursorScreenPos({x, y});
    ImGui::PushID(own[i].get());
    if (ImGui::Button(label.c_str(), {wide, height}))
      ui.send([file = own[i]->file](Player& player) { player.open(file); });
    ImGui::PopID();
    ui.thing(card_name(*own[i]));
    if (ImGui::IsItemHovered()) tooltip(ui, *own[i]);
    x += wide + ui.px(4);
  }
  ImGui::PopStyleVar();
  ImGui::PopFont();
}

// ---- cards in rows --------------------------------------------------------------------------------------------------

// By unit, in the order in which the units come first.
std::vector<Item> by_unit(const std::vector<Item>& items) {
  std::vector<std::string> units;
  for (const Item& item : items)
    if (std::ranges::find(units, item->unit) == units.end()) units.push_back(item->unit);
  std::vector<Item> sorted;
  for (const std::string& unit : units)
    for (const Item& item : items)
      if (item->unit == unit) sorted.push_back(item);
  return sorted;
}

// Units share rows: each stands above its first card of a row, with a line over all of them.
void draw_cards(Ui& ui, const std::vector<Item>& items, const ById& exercises, std::string* unit_wanted = nullptr) {
  const float room = ImGui::GetContentRegionAvail().x, between = ui.px(gap);
  const int columns = std::clamp(static_cast<int>((room + between) / (ui.px(card_width) + between)), 1, 4);
  const float width = std::floor((room - static_cast<float>(columns - 1) * between) / static_cast<float>(columns));
  const float card = card_height(ui), heading = line_height(ui.bold()) + ui.px(8);
  const float height = card + (exercises.empty() ? 0 : ui.px(chips_height));
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const auto count = static_cast<int>(items.size());
  const auto unit_at = [&](int i) -> const std::string& { return items[static_cast<std::size_t>(i)]->unit; };
  for (int i = 0; i < count; ++i) {
    const int column = i % columns, row = i / columns;
    const ImVec2 at{origin.x + static_cast<float>(column) * (width + between),
                    origin.y + static_cast<float>(row) * (height + heading + between)};
    if (column == 0 || unit_at(i) != unit_at(i - 1)) {
      if (unit_wanted != nullptr && *unit_wanted == unit_at(i) && (i == 0 || unit_at(i) != unit_at(i - 1))) {
        ImGui::SetScrollY(at.y - ImGui::GetWindowPos().y + ImGui::GetScrollY() - ui.px(8));
        unit_wanted->clear();
      }
      int end = i + 1;
      while (end < count && end % columns != 0 && unit_at(end) == unit_at(i)) ++end;
      const float wide = static_cast<float>(end - i) * (width + between) - between;
      ImGui::PushFont(ui.bold());
      ImGui::GetWindowDrawList()->AddText(at, ui.ink(Role::text_quiet), shortened(unit_at(i), wide).c_str());
      ImGui::PopFont();
      ImGui::GetWindowDrawList()->AddLine({at.x, at.y + heading - ui.px(5)}, {at.x + wide, at.y + heading - ui.px(5)},
                                          ui.color(Role::rule_line), ui.px(1));
    }
    const ShelfItem& item = *items[static_cast<std::size_t>(i)];
    draw_card(ui, item, {at.x, at.y + heading}, {width, card});
    draw_chips(ui, item, exercises, {at.x, at.y + heading + card}, width);
  }
  const int rows = (count + columns - 1) / columns;
  ImGui::SetCursorScreenPos(origin);
  ImGui::Dummy({room, static_cast<float>(rows) * (height + heading + between)});
}

bool is_found(const ShelfItem& item, const std::string& search) {
  return contains(item.title, search) || contains(item.elsewhere, search) || contains(item.unit, search) ||
         contains(item.summary, search) || contains(item.file.stem().string(), search);
}

// The way to each unit, where there are so many lessons that one would have to look for it.
void draw_units(Ui& ui, const std::vector<Item>& lessons, std::string& wanted) {
  constexpr std::size_t few = 12;
  if (lessons.size() <= few) return;
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  ImGui::PushFont(ui.small());
  const std::string* before = nullptr;
  for (const Item& item : lessons) {
    if (before != nullptr && *before == item->unit) continue;
    const std::string label = item->unit.empty() ? "Other" : item->unit;
    const float width = ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
    if (before != nullptr) ImGui::SameLine(0, ui.px(4));
    if (before != nullptr && ImGui::GetCursorScreenPos().x + width > right) ImGui::NewLine();
    before = &item->unit;
    if (ui.button((label + "##unit").c_str(), "start unit " + label)) wanted = item->unit;
  }
  ImGui::PopFont();
  ImGui::Dummy({0, ui.px(4)});
}

// Lessons by unit, each with its exercises below it; then those that belong to none, or what is searched for.
void draw_course(Ui& ui, const std::vector<Item>& items, const std::string& search) {
  static std::string unit_wanted;
  std::vector<Item> lessons, alone;
  ById exercises;
  for (const Item& item : items)
    if (item->kind == Document::Kind::exercise) exercises.emplace(item->id, item);
  std::set<std::string> with_lesson;
  for (const Item& item : items) {
    if (item->kind != Document::Kind::lesson) continue;
    with_lesson.insert(item->exercises.begin(), item->exercises.end());
    if (is_found(*item, search)) lessons.push_back(item);
  }
  for (const Item& item : items)
    if (item->kind == Document::Kind::exercise && is_found(*item, search) &&
        (!search.empty() || !with_lesson.contains(item->id)))
      alone.push_back(item);
  if (!lessons.empty()) {
    large_text(ui, "Lessons", 1.35);
    lessons = by_unit(lessons);
    draw_units(ui, lessons, unit_wanted);
    draw_cards(ui, lessons, exercises, &unit_wanted);
  }
  if (alone.empty()) return;
  large_text(ui, search.empty() && !lessons.empty() ? "More exercises" : "Exercises", 1.35);
  draw_cards(ui, by_unit(alone), {});
}

// ---- scenes of the studio -------------------------------------------------------------------------------------------

constexpr double scene_width = 176, scene_thumbnail = 92;  // units

const View& scene_thumbnail_of(const ShelfScene& scene, double width, double height) {
  struct Kept {
    std::shared_ptr<const Workspace> workspace;
    double width = 0;
    View view;
  };
  static std::map<fs::path, Kept> kept;
  Kept& one = kept[scene.file];
  if (one.workspace != scene.workspace || one.width != width) {
    WorkspaceLook look;
    look.grid = look.axes = look.handles = false;
    const WorkspaceScenes scenes;
    one = {scene.workspace, width, scenes.view(*scene.workspace, width, height, look).view};
    one.view.width = width;
    one.view.height = height;
  }
  return one.view;
}

// A picture with a title below it; without a scene: an empty sheet with a plus.
void draw_scene_card(Ui& ui, const ShelfScene* scene, ImVec2 at, ImVec2 size) {
  const std::string name = scene == nullptr ? "card new-scene" : "card scene " + scene->file.stem().string();
  const std::string title = scene == nullptr ? "New scene" : printable(scene->workspace->title);
  ImGui::SetCursorScreenPos(at);
  if (ImGui::InvisibleButton(name.c_str(), size)) {
    if (scene == nullptr)
      ui.act("file.new_scene");
    else
      ui.send([file = scene->file](Player& player) { player.open(file); });
  }
  const ImVec2 high{at.x + size.x, at.y + size.y};
  if (!ImGui::IsRectVisible(at, high)) return;
  ui.thing(name);
  const bool hovered = ImGui::IsItemHovered(), focused = ImGui::IsItemFocused() && ImGui::GetIO().NavVisible;
  if (hovered && scene != nullptr && !scene->workspace->summary.empty())
    ImGui::SetTooltip("%s", printable(scene->workspace->summary).c_str());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, high, ui.color(Role::panel), ui.px(8));
  const float edge_gap = ui.px(6), width = size.x - 2 * edge_gap;
  const ImVec2 inner{at.x + edge_gap, at.y + edge_gap};
  const ImVec2 picture_high{inner.x + width, inner.y + ui.px(scene_thumbnail)};
  list.AddRectFilled(inner, picture_high, ImGui::GetColorU32(ImGuiCol_WindowBg), ui.px(5));
  if (scene != nullptr) {
    ImGui::SetCursorScreenPos(inner);
    const double wide = std::floor(ui.units(width));
    ui.picture(scene_thumbnail_of(*scene, wide, scene_thumbnail), wide, scene_thumbnail, "");
  } else {
    const ImVec2 middle{(inner.x + picture_high.x) / 2, (inner.y + picture_high.y) / 2};
    const float arm = ui.px(16);
    list.AddLine({middle.x - arm, middle.y}, {middle.x + arm, middle.y}, ui.color(Role::current), ui.px(3));
    list.AddLine({middle.x, middle.y - arm}, {middle.x, middle.y + arm}, ui.color(Role::current), ui.px(3));
  }
  draw_lines(ui.bold(), ui.ink(Role::text), {inner.x, picture_high.y + ui.px(5)}, width, 2, title);
  const Role edge = focused ? Role::focus : (hovered ? Role::current : Role::rule_line);
  list.AddRect(at, high, ui.color(edge), ui.px(8), 0, ui.px(focused ? 2.5 : (hovered ? 1.5 : 1)));
}

bool is_found(const ShelfScene& scene, const std::string& search) {
  return contains(scene.workspace->title, search) || contains(scene.workspace->summary, search) ||
         contains(scene.file.stem().string(), search);
}

// One row above the lessons, with the new one first; the others below the exercises. What is searched for is all there.
void draw_scenes(Ui& ui, const std::vector<ShelfScene>& scenes, const std::string& search, bool above) {
  if (above && !search.empty()) return;
  const float room = ImGui::GetContentRegionAvail().x, between = ui.px(gap);
  const int columns = std::max(2, static_cast<int>((room + between) / (ui.px(scene_width) + between)));
  const float width = std::floor((room - static_cast<float>(columns - 1) * between) / static_cast<float>(columns));
  const float height = ui.px(scene_thumbnail + 6 + 5 + 8) + 2 * line_height(ui.bold());
  const std::size_t in_row = std::min(scenes.size(), static_cast<std::size_t>(columns - 1));
  std::vector<const ShelfScene*> shown;
  if (above) shown.push_back(nullptr);
  for (std::size_t i = above || !search.empty() ? 0 : in_row; i < (above ? in_row : scenes.size()); ++i)
    if (is_found(scenes[i], search)) shown.push_back(&scenes[i]);
  if (shown.empty()) return;
  large_text(ui, above ? "Studio" : search.empty() ? "More scenes of the studio" : "Scenes of the studio", 1.35);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const auto count = static_cast<int>(shown.size());
  for (int i = 0; i < count; ++i)
    draw_scene_card(ui, shown[static_cast<std::size_t>(i)],
                    {origin.x + static_cast<float>(i % columns) * (width + between),
                     origin.y + static_cast<float>(i / columns) * (height + between)},
                    {width, height});
  const int rows = (count + columns - 1) / columns;
  ImGui::SetCursorScreenPos(origin);
  ImGui::Dummy({room, static_cast<float>(rows) * (height + between)});
}

// ---- above the cards ------------------------------------------------------------------------------------------------

void draw_lost_work(Ui& ui) {
  const auto& lost = ui.player().lost_work();
  if (lost.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ui.color(Role::panel));
  ImGui::PushStyleColor(ImGuiCol_Border, ui.color(Role::current));
  const float height = ImGui::GetTextLineHeightWithSpacing() + ImGui::GetFrameHeight() + ui.px(18);
  if (ImGui::BeginChild("lost", {0, height}, true, ImGuiWindowFlags_NoScrollbar)) {
    const std::string title = lost.front().title.empty() ? "a lesson" : printable(lost.front().title);
    std::string text = "\u25B2 Edits of \u201C" + title + "\u201D were not saved when the window closed.";
    if (lost.size() > 1) text += " There are " + std::to_string(lost.size() - 1) + " more.";
    ImGui::TextUnformatted(shortened(text, ImGui::GetContentRegionAvail().x).c_str());
    if (ui.button("Recover them", "start recover")) ui.send([](Player& player) { player.recover(0); });
    ImGui::SameLine();
    if (lost.size() > 1) {
      if (ui.button("Look at all ...", "start lost")) ui.act("file.recover");
    } else if (ui.button("Discard them", "start discard")) {
      ui.send([](Player& player) { player.forget_lost(0); });
    }
  }
  ImGui::EndChild();
  ui.thing("start banner");
  ImGui::PopStyleColor(2);
  ImGui::Dummy({0, ui.px(4)});
}

void draw_recent(Ui& ui, const std::vector<Item>& items) {
  struct Recent {
    fs::path file;
    std::string label;
  };
  std::vector<Recent> shown;
  std::error_code error;
  const Shelf* shelf = ui.player().shelf();
  const std::vector<ShelfScene> scenes = shelf != nullptr ? shelf->scenes() : std::vector<ShelfScene>();
  for (const fs::path& file : ui.player().settings.recent) {
    if (shown.size() == most_recent_shown) break;
    if (!fs::exists(file, error)) continue;
    const auto known = std::ranges::find(items, file, [](const Item& item) { return item->file; });
    std::string label = known != items.end() ? (*known)->title : printable(file.filename().string());
    const auto scene = std::ranges::find(scenes, file, &ShelfScene::file);
    if (scene != scenes.end()) label = "Scene: " + printable(scene->workspace->title);
    if (known != items.end() && (*known)->kind == Document::Kind::exercise) label = "Exercise: " + label;
    if (const Progress* progress = ui.player().progress(file); progress != nullptr && progress->step > 0)
      label = shortened(label, ui.px(220)) + ", step " + std::to_string(progress->step);
    shown.push_back({file, label});
  }
  if (shown.empty()) return;
  ui.heading("Go on with");
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const std::string label = shortened(shown[i].label, ImGui::GetWindowContentRegionMax().x - ui.px(60));
    const float width = ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
    if (i > 0) ImGui::SameLine();
    if (i > 0 && ImGui::GetCursorScreenPos().x + width > right) ImGui::NewLine();
    ImGui::PushID(static_cast<int>(i));
    if (ui.button(label.c_str(), "recent " + shown[i].file.stem().string(), true, shown[i].file.c_str()))
      ui.send([file = shown[i].file](Player& player) { player.open(file); });
    ImGui::PopID();
  }
  ImGui::Dummy({0, ui.px(4)});
}

void draw_tools(Ui& ui, std::string& search) {
  const float gap_x = ImGui::GetStyle().ItemSpacing.x;
  float buttons = 0;
  for (const char* label : {"Studio", "Open file ...", "Settings", "Shortcuts"})
    buttons += ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x + gap_x;
  const float room = ImGui::GetContentRegionAvail().x;
  const bool one_row = room - buttons >= ui.px(180);
  ImGui::SetNextItemWidth(one_row ? std::min(room - buttons, ui.px(420)) : room);
  ImGui::InputTextWithHint("##search", "Search the lessons, exercises and scenes", &search);
  ui.thing("start search");
  if (one_row) ImGui::SameLine();
  if (one_row) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - buttons + gap_x);
  const std::pair<const char*, const char*> tools[] = {{"Studio", "file.new_scene"},
                                                       {"Open file ...", "file.open"},
                                                       {"Settings", "view.settings"},
                                                       {"Shortcuts", "help.shortcuts"}};
  for (const auto& [label, action] : tools) {
    if (ui.button(label, "start " + std::string(action))) ui.act(action);
    ImGui::SameLine();
  }
  ImGui::NewLine();
  ImGui::Dummy({0, ui.px(2)});
}

void draw(Ui& ui) {
  static std::string search;
  if (ImGui::IsWindowAppearing()) search.clear();
  const Shelf* shelf = ui.player().shelf();
  const std::vector<Item> items = shelf != nullptr ? shelf->items() : std::vector<Item>();
  const float room = ImGui::GetContentRegionAvail().x;
  const float width = std::min(room - 2 * ui.px(8), ui.px(widest));
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::round((room - width) / 2));
  ImGui::BeginChild("page", {width, 0}, false, ImGuiWindowFlags_NavFlattened);
  ImGui::Dummy({0, ui.px(6)});
  large_text(ui, "Blossom", 2.1);
  quiet_text(ui, "Watch an algorithm for curves and surfaces work, step by step, on points that you can move.");
  ImGui::Dummy({0, ui.px(6)});
  draw_lost_work(ui);
  draw_recent(ui, items);
  draw_tools(ui, search);
  const std::vector<ShelfScene> scenes = shelf != nullptr ? shelf->scenes() : std::vector<ShelfScene>();
  draw_scenes(ui, scenes, search, true);
  draw_course(ui, items, search);
  draw_scenes(ui, scenes, search, false);
  if (shelf == nullptr || !shelf->done()) {
    quiet_text(ui, "Loading ... " + std::to_string(items.size()) + " so far");
  } else if (items.empty()) {
    quiet_text(ui, "No lessons were found here. Open a file, or drop one onto this window.");
  } else if (std::ranges::none_of(items, [](const Item& item) { return is_found(*item, search); }) &&
             std::ranges::none_of(scenes, [](const ShelfScene& scene) { return is_found(scene, search); })) {
    quiet_text(ui, "Nothing found.");
  }
  if (shelf != nullptr && !shelf->diagnostics().empty()) {
    ImGui::Dummy({0, ui.px(6)});
    ui.heading("Files that could not be read");
    quiet_text(ui, to_string(shelf->diagnostics()));
  }
  ImGui::Dummy({0, ui.px(10)});
  ImGui::EndChild();
}

bool is_relevant(const Player& player) { return player.session() == nullptr && !player.in_studio(); }

}  // namespace

const Panel& panel_start() {
  static const Panel panel{.id = "start",
                           .title = "Start",
                           .slot = Slot::page,
                           .order = 0,
                           .draw = draw,
                           .relevant = is_relevant,
                           .widgets = true};
  return panel;
}

}  // namespace blossom
