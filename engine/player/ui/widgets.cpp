// What panels are made of besides Dear ImGui's own widgets.
#include <algorithm>
#include <cmath>

#include "algorithms/typeset.hpp"
#include "player/action.hpp"
#include "player/ui/ui.hpp"
#include "render/rich_text.hpp"

namespace blossom {

bool Ui::button(const char* label, const std::string& name, bool enabled, const char* tooltip) {
  ImGui::BeginDisabled(!enabled);
  const bool pressed = ImGui::Button(label);
  ImGui::EndDisabled();
  thing(name);
  if (tooltip != nullptr && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s", tooltip);
  return pressed;
}

namespace {

std::string tooltip_of(const Action& action) {
  std::string text(action.title);
  if (!action.keys.empty()) text += "   " + std::string(action.keys.front());
  return text;
}

}  // namespace

bool Ui::action_button(std::string_view id, const char* label) {
  const Action* action = find_action(id);
  IM_ASSERT(action != nullptr);
  const bool enabled = action->enabled == nullptr || action->enabled(*player_);
  const bool on = action->checked != nullptr && action->checked(*player_);
  if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_TabActive));
  const bool pressed = button(label, std::string(id), enabled, tooltip_of(*action).c_str());
  if (on) ImGui::PopStyleColor();
  if (pressed) act(id);
  return pressed;
}

namespace {

// Icons in a square from (-1, -1) to (1, 1), y down.
void draw_icon(ImDrawList& list, std::string_view icon, ImVec2 c, float r, ImU32 color) {
  const auto at = [&](double x, double y) {
    return ImVec2{c.x + static_cast<float>(x) * r, c.y + static_cast<float>(y) * r};
  };
  const float line = std::max(1.5f, r * 0.28f);
  // Dear ImGui smooths the edges of what runs clockwise.
  const auto solid = [&](ImVec2 p, ImVec2 q, ImVec2 s) {
    if ((q.x - p.x) * (s.y - p.y) < (q.y - p.y) * (s.x - p.x)) std::swap(q, s);
    list.AddTriangleFilled(p, q, s, color);
  };
  const auto triangle = [&](double x, double w) { solid(at(x, -0.9), at(x, 0.9), at(x + w, 0)); };
  const auto bar = [&](double x, double w) { list.AddRectFilled(at(x, -0.9), at(x + w, 0.9), color); };
  const auto stroke = [&](std::initializer_list<ImVec2> points, bool closed = false) {
    list.AddPolyline(std::data(points), static_cast<int>(points.size()), color, closed ? ImDrawFlags_Closed : 0, line);
  };
  if (icon == "first") bar(-0.95, 0.3), triangle(0.85, -1.4);
  if (icon == "back") triangle(0.6, -1.3);
  if (icon == "play") solid(at(-0.7, -1), at(-0.7, 1), at(1.05, 0));
  if (icon == "pause") bar(-0.7, 0.45), bar(0.25, 0.45);
  if (icon == "forward") triangle(-0.6, 1.3);
  if (icon == "last") triangle(-0.85, 1.4), bar(0.65, 0.3);
  if (icon == "over") {  // an arc above a dot
    list.PathArcTo(at(0, 0.25), r * 0.75f, 3.35f, 6.0f, 16);
    list.PathStroke(color, 0, line);
    solid(at(0.35, -0.05), at(1.05, -0.15), at(0.8, 0.5));
    list.AddCircleFilled(at(0, 0.7), r * 0.26f, color);
  }
  if (icon == "out") {  // up and out
    stroke({at(0, 0.9), at(0, -0.3)});
    solid(at(-0.6, -0.2), at(0.6, -0.2), at(0, -0.95));
    stroke({at(-0.8, 0.9), at(0.8, 0.9)});
  }
  if (icon == "next-beat" || icon == "previous-beat") {
    const double s = icon == "next-beat" ? 1 : -1;
    stroke({at(-0.75 * s, -0.7), at(-0.05 * s, 0), at(-0.75 * s, 0.7)});
    stroke({at(0.05 * s, -0.7), at(0.75 * s, 0), at(0.05 * s, 0.7)});
  }
  if (icon == "loop") {
    list.AddRect(at(-0.9, -0.55), at(0.9, 0.6), color, r * 0.5f, 0, line);
    solid(at(-0.1, -1.05), at(-0.1, 0.0), at(0.5, -0.52));
  }
  if (icon == "bookmark") {
    const ImVec2 flag[] = {at(-0.6, -0.95), at(0.6, -0.95), at(0.6, 0.95), at(0, 0.4), at(-0.6, 0.95)};
    list.AddPolyline(flag, 5, color, ImDrawFlags_Closed, line);
  }
  if (icon == "bookmarked") {
    list.AddRectFilled(at(-0.6, -0.95), at(0.6, 0.4), color);
    solid(at(-0.6, 0.35), at(0, 0.35), at(-0.6, 0.95));
    solid(at(0.6, 0.35), at(0, 0.35), at(0.6, 0.95));
  }
  if (icon == "undo" || icon == "redo") {
    const double s = icon == "undo" ? 1 : -1;
    list.PathArcTo(at(0.1 * s, 0.15), r * 0.68f, s > 0 ? -2.3f : 3.14f + 2.3f, s > 0 ? 1.6f : 3.14f - 1.6f, 18);
    list.PathStroke(color, 0, line);
    solid(at(-0.95 * s, -0.35), at(-0.15 * s, -0.85), at(-0.1 * s, 0.1));
  }
  if (icon == "fit")
    for (const double x : {-1.0, 1.0})
      for (const double y : {-1.0, 1.0}) stroke({at(0.85 * x, 0.3 * y), at(0.85 * x, 0.85 * y), at(0.3 * x, 0.85 * y)});
  if (icon == "minus" || icon == "plus") stroke({at(-0.7, 0), at(0.7, 0)});
  if (icon == "plus") stroke({at(0, -0.7), at(0, 0.7)});
  if (icon == "close") stroke({at(-0.7, -0.7), at(0.7, 0.7)}), stroke({at(0.7, -0.7), at(-0.7, 0.7)});
}

}  // namespace

bool Ui::icon_button(std::string_view id, std::string_view icon, bool pressed_in) {
  const Action* action = find_action(id);
  IM_ASSERT(action != nullptr);
  const bool enabled = action->enabled == nullptr || action->enabled(*player_);
  const float side = ImGui::GetFrameHeight() * 1.12f;
  if (pressed_in) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_TabActive));
  ImGui::PushID(id.data(), id.data() + id.size());
  ImGui::BeginDisabled(!enabled);
  const bool pressed = ImGui::Button("##icon", {side, side});
  ImGui::EndDisabled();
  ImGui::PopID();
  if (pressed_in) ImGui::PopStyleColor();
  thing(std::string(id));
  const ImVec2 low = ImGui::GetItemRectMin();
  draw_icon(*ImGui::GetWindowDrawList(), icon, {std::round(low.x + side / 2), std::round(low.y + side / 2)},
            side * 0.27f, enabled ? ink(Role::text) : color(Role::earlier));
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s", tooltip_of(*action).c_str());
  if (pressed) act(id);
  return pressed;
}

bool Ui::step_is_new_to(const std::string& panel) {
  const std::pair now{player_->session()->version(), player_->session()->step()};
  return std::exchange(seen_steps_[panel], now) != now;
}

void Ui::heading(const char* text) {
  ImGui::PushFont(bold_);
  ImGui::PushStyleColor(ImGuiCol_Text, ink(Role::text_quiet));
  ImGui::TextUnformatted(text);
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

// ---- running text with names in it ----------------------------------------------------------------------------------

namespace {

// A word of running text: letters between blanks, or a value's name with its indices ("P[1][4]", "raise[1].Q[2]").
struct Word {
  std::string text;
  std::optional<ValueId> value;
  bool blank_before = false;
  bool line_before = false;
};

bool is_name_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.'; }

// The length of what looks like a value's name at the front of the text: letters, dots and bracketed indices.
std::size_t name_length(std::string_view text) {
  if (text.empty() || std::isalpha(static_cast<unsigned char>(text[0])) == 0) return 0;
  std::size_t i = 0;
  while (i < text.size() && (is_name_letter(text[i]) || text[i] == '[')) {
    if (text[i] == '[') {
      const std::size_t end = text.find(']', i);
      if (end == std::string_view::npos || end == i + 1) break;
      i = end;
    } else if (text[i] == '_' && i + 1 < text.size() && (text[i + 1] == '{' || text[i + 1] == '(')) {
      // u_{k+1}, N_(3,2)
      const std::size_t end = text.find(text[i + 1] == '{' ? '}' : ')', i);
      return end == std::string_view::npos || end > i + 16 ? i + 1 : end + 1;
    }
    ++i;
  }
  while (i > 0 && text[i - 1] == '.') --i;
  return i;
}

// The value of a name as it is written within a phase: looked up there first, then further out.
std::optional<ValueId> value_named(std::string_view name, const TraceGraph& graph, std::string scope) {
  const std::size_t local = name.rfind('.') == std::string_view::npos ? 0 : name.rfind('.') + 1;
  std::string full(name);
  // Only what has indices is surely meant: "a" is also an article. u_3 is the knot U[3].
  if (name.substr(local).starts_with("u_"))
    full = std::string(name.substr(0, local)) + "U[" + std::string(name.substr(local + 2)) + "]";
  else if (name.find('[') == std::string_view::npos)
    return std::nullopt;
  for (;;) {
    if (const auto value = graph.find(scope + full)) return value;
    if (scope.empty()) return std::nullopt;
    scope.pop_back();
    const auto dot = scope.rfind('.');
    scope.erase(dot == std::string::npos ? 0 : dot + 1);
  }
}

std::vector<Word> words_of(const std::string& text, const TraceGraph& graph, std::uint32_t step,
                           const std::string& scope) {
  std::vector<Word> words;
  bool blank = false, line = false;
  std::size_t i = 0;
  const auto add = [&](std::string piece, std::optional<ValueId> value) {
    words.push_back({std::move(piece), value, blank, line});
    blank = line = false;
  };
  while (i < text.size()) {
    if (text[i] == ' ' || text[i] == '\n') {
      (text[i] == ' ' ? blank : line) = true;
      ++i;
      continue;
    }
    const std::string_view rest = std::string_view(text).substr(i);
    const bool at_word = i == 0 || (!is_name_letter(text[i - 1]) && text[i - 1] != '\'');
    if (const std::size_t length = at_word ? name_length(rest) : 0; length > 0) {
      const std::string name(rest.substr(0, length));
      std::optional<ValueId> value = value_named(name, graph, scope);
      if (value && graph.value(*value).step > step) value.reset();
      add(name, value);
      i += length;
      continue;
    }
    std::size_t end = i + 1;
    while (end < text.size() && text[end] != ' ' && text[end] != '\n' &&
           !(std::isalpha(static_cast<unsigned char>(text[end])) != 0 && !is_name_letter(text[end - 1]) &&
             text[end - 1] != '\''))
      ++end;
    add(text.substr(i, end - i), std::nullopt);
    i = end;
  }
  return words;
}

// Behind the last word of the cluster that begins here. A line breaks at blanks only: what follows without one (a
// bracket, a full stop) comes along, and so does what stands in short parentheses, "(1/2 - 1/5)".
std::size_t end_of_cluster(const std::vector<Word>& words, std::size_t begin) {
  constexpr std::size_t most = 24;
  const auto joined = [&](std::size_t end) {
    do ++end;
    while (end < words.size() && !words[end].blank_before && !words[end].line_before);
    return end;
  };
  const auto open_in = [&](std::size_t from, std::size_t to, std::size_t& letters) {
    std::ptrdiff_t open = 0;
    for (std::size_t i = from; i < to; ++i) {
      open += std::ranges::count(words[i].text, '(') - std::ranges::count(words[i].text, ')');
      letters += words[i].text.size() + (words[i].blank_before ? 1 : 0);
    }
    return open;
  };
  const std::size_t first = joined(begin);
  std::size_t end = first, letters = 0;
  std::ptrdiff_t open = open_in(begin, end, letters);
  while (open > 0 && letters <= most && end < words.size() && !words[end].line_before) {
    const std::size_t next = joined(end);
    open += open_in(end, next, letters);
    end = next;
  }
  return open <= 0 && letters <= most ? end : first;
}

struct Piece {  // a word, set
  RichText text;
  double width = 0;
  bool lit = false;
};

}  // namespace

Sheet Ui::flow(const std::string& text, double width, double size, Role role, double& height, bool values,
               std::optional<ValueId> about) const {
  Sheet sheet;
  const Session& session = *player_->session();
  const StepSource& source = session.recording().source();
  const std::uint32_t step = about ? source.graph->value(*about).step : session.step();
  const Algorithm& algorithm = source.algorithm_at(step);
  const Emphasis& emphasis = player_->emphasis();
  const double em = (*theme_)[role].text_size * size;
  const double line = em * 1.5, blank = fonts_->width({}, " ") * em;
  const auto set_word = [&](const Word& word) {
    // The s of "Boor's" is not the multiplicity.
    const bool plain = word.text.starts_with('\'') && !word.blank_before;
    Piece piece{plain ? RichText{{word.text}} : typeset_text(word.text, algorithm), 0,
                word.value && emphasis.lights(*word.value)};
    if (piece.lit)
      for (TextRun& run : piece.text) run.bold = true;
    piece.width = set_text(*fonts_, piece.text, em, TextAlign::left).width;
    return piece;
  };
  double x = 0, baseline = em * 1.05;
  std::string scope;
  for (const std::uint32_t phase : source.graph->phase_path(source.graph->step(step).phase))
    if (source.graph->phases()[phase].scoped) scope += source.graph->phases()[phase].label() + ".";
  const std::vector<Word> words = words_of(text, *source.graph, values ? session.step() : 0, scope);
  for (std::size_t begin = 0, end = 0; begin < words.size(); begin = end) {
    end = end_of_cluster(words, begin);
    std::vector<Piece> pieces;
    double cluster = 0;
    for (std::size_t i = begin; i < end; ++i) {
      pieces.push_back(set_word(words[i]));
      cluster += pieces.back().width + (i > begin && words[i].blank_before ? blank : 0);
    }
    if (words[begin].line_before) x = 0, baseline += line;
    if (words[begin].blank_before && x > 0) x += blank;
    if (x > 0 && x + cluster > width) x = 0, baseline += line;
    for (std::size_t i = begin; i < end; ++i) {
      Piece& piece = pieces[i - begin];
      if (i > begin && words[i].blank_before) x += blank;
      if (x > 0 && x + piece.width > width) x = 0, baseline += line;  // wider than a line by itself
      if (const auto& value = words[i].value) {
        const double top = baseline - em * 1.0, bottom = baseline + em * 0.42, right = x + piece.width + 2;
        if (piece.lit || emphasis.share(*value) != 0)
          sheet.view.polygons.push_back({{{x - 2, top, 0}, {right, top, 0}, {right, bottom, 0}, {x - 2, bottom, 0}},
                                         Role::highlight,
                                         piece.lit ? 0.22 : 0.1});
        if (values)
          sheet.spots.push_back(
              {{Link::Kind::value, *value}, x - 2, top, piece.width + 4, bottom - top, source.graph->name(*value)});
      }
      Label label;
      label.anchor = {x, baseline, 0};
      label.text = std::move(piece.text);
      label.role = piece.lit ? Role::highlight : role;
      label.size_scale = size;
      sheet.view.labels.push_back(std::move(label));
      x += piece.width;
    }
  }
  height = baseline + em * 0.5;
  return sheet;
}

// ---- the menu of a value --------------------------------------------------------------------------------------------

void Ui::draw_menu() {
  if (std::exchange(menu_requested_, false)) ImGui::OpenPopup("value menu");
  if (!ImGui::BeginPopup("value menu")) return;
  const Session* session = player_->session();
  const bool is_value = session != nullptr && menu_link_.kind == Link::Kind::value &&
                        menu_link_.id < session->recording().graph().value_count();
  const auto item = [&](const char* label, auto&& what) {
    if (ImGui::MenuItem(label)) send(what);
    thing("menu " + std::string(label));
  };
  if (is_value) {
    const StepSource& source = session->recording().source();
    const ValueId v = menu_link_.id;
    const ValueRecord& record = source.graph->value(v);
    ImGui::TextDisabled("%s", plain_name(record.name, source.algorithm_at(record.step)).c_str());
    item("Why?", [v](Player& player) { player.ask_why(v); });
    item("Go to its step", [v](Player& player) { player.seek_value(v); });
    if (!player_->veils(v)) {
      item("Copy value", [text = source.value_text(v)](Player& player) {
        player.desk().set_clipboard(text);
        player.notice("Copied: " + text);
      });
      item("Copy as LaTeX", [text = latex_value(source, v)](Player& player) {
        player.desk().set_clipboard(text);
        player.notice("Copied: " + text);
      });
    }
    if (const auto point = address_of(*source.graph, session->inputs(), v)) {
      item("Add a point behind", [at = *point](Player& player) { player.add_point_behind(at); });
      item("Delete this point", [at = *point](Player& player) { player.remove_point(at); });
    }
    ImGui::Separator();
  }
  const bool pinned = player_->is_pinned(menu_link_);
  item(pinned ? "Unpin" : "Pin", [link = menu_link_](Player& player) { player.pin(link); });
  ImGui::EndPopup();
}

}  // namespace blossom
