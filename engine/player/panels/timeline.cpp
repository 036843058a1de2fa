// Where one is and how to move: a scrubber with the parts of the run, the lesson's beats and one's own bookmarks on it,
// and the buttons.
#include <algorithm>
#include <cmath>

#include "algorithms/typeset.hpp"
#include "player/ui/panel.hpp"
#include "player/ui/ui.hpp"

namespace blossom {
namespace {

struct Track {  // pixels
  float left, right, y;
  std::uint32_t last;
  float place(double step) const { return last == 0 ? left : left + static_cast<float>(step / last) * (right - left); }
  std::uint32_t step(float x) const {
    const double share = std::clamp((x - left) / std::max(right - left, 1.0f), 0.0f, 1.0f);
    return static_cast<std::uint32_t>(std::lround(share * last));
  }
};

// A title as far as it has room; nothing where hardly any of it has.
std::string cut(const std::string& title, float room) {
  if (ImGui::CalcTextSize(title.c_str()).x <= room) return title;
  constexpr std::size_t fewest = 6;
  for (std::size_t kept = title.size(); kept-- > fewest;) {
    if ((static_cast<unsigned char>(title[kept]) & 0xC0u) == 0x80u) continue;  // inside a letter
    std::string shorter = title.substr(0, title.find_last_not_of(' ', kept - 1) + 1) + "…";
    if (ImGui::CalcTextSize(shorter.c_str()).x <= room) return shorter;
  }
  return "";
}

// The parts of the run as bands below the line: the outermost phases, with their titles where they have room.
void draw_phases(Ui& ui, const Session& session, const Track& track) {
  const StepSource& source = session.recording().source();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  bool odd = false;
  for (std::uint32_t i = 0; i < source.graph->phases().size(); ++i) {
    const PhaseRecord& phase = source.graph->phases()[i];
    if (phase.parent != absent) continue;
    const float from = track.place(phase.first_step), to = std::min(track.place(phase.last_step + 1.0), track.right);
    const float top = track.y + ui.px(7), bottom = top + ui.px(15);
    // Little more than the background, so that text on it keeps its contrast in every theme.
    list.AddRectFilled({from, top}, {to, bottom}, ImGui::GetColorU32(odd ? ImGuiCol_ButtonHovered : ImGuiCol_Button),
                       ui.px(3));
    if (to - from > ui.px(4)) list.AddRectFilled({from, top}, {from + ui.px(2), bottom}, ui.color(Role::polygon));
    odd = !odd;
    ImGui::PushFont(ui.small());
    if (const std::string title = cut(source.phase_title(i), to - from - ui.px(10)); !title.empty())
      list.AddText({from + ui.px(6), top}, ui.ink(Role::text), title.c_str());
    ImGui::PopFont();
  }
}

void diamond(ImDrawList& list, ImVec2 c, float r, ImU32 color, bool filled) {
  const ImVec2 corners[] = {{c.x, c.y - r}, {c.x + r, c.y}, {c.x, c.y + r}, {c.x - r, c.y}};
  if (filled)
    list.AddConvexPolyFilled(corners, 4, color);
  else
    list.AddPolyline(corners, 4, color, ImDrawFlags_Closed, r * 0.35f);
}

void draw_track(Ui& ui, const Session& session, const Track& track) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Timeline& timeline = session.timeline();
  const float y = track.y;
  if (const auto loop = timeline.loop())
    list.AddRectFilled({track.place(loop->first), y - ui.px(8)}, {track.place(loop->second), y + ui.px(4)},
                       ui.color(Role::level_b, 0.28), ui.px(3));
  list.AddRectFilled({track.left, y - ui.px(2)}, {track.right, y + ui.px(2)}, ui.color(Role::rule_line), ui.px(2));
  const float here = track.place(session.step() + (timeline.playing() ? timeline.fraction() : 0));
  list.AddRectFilled({track.left, y - ui.px(2)}, {here, y + ui.px(2)}, ui.color(Role::current), ui.px(2));
  // A tick for every step while they can be told apart.
  if (track.last > 0 && (track.right - track.left) / static_cast<float>(track.last) > ui.px(7))
    for (std::uint32_t k = 0; k <= track.last; ++k)
      list.AddLine({track.place(k), y - ui.px(4)}, {track.place(k), y + ui.px(4)}, ui.color(Role::polygon, 0.55), 1);
  for (const Beat& beat : session.beats()) {
    const ImVec2 at{track.place(beat.step), y};
    if (!beat.checkpoint) {
      diamond(list, at, ui.px(4.5), ui.color(Role::polygon), true);
      continue;
    }
    // A question: larger, open until it is answered.
    const auto item = ui.player().checkpoints().find(beat.checkpoint->id);
    const bool open = item && ui.player().checkpoints().item(*item).first == std::nullopt;
    diamond(list, at, ui.px(7), ImGui::ColorConvertFloat4ToU32(ImGui::GetStyleColorVec4(ImGuiCol_WindowBg)), true);
    diamond(list, at, ui.px(6.5), ui.color(Role::result), !open);
  }
  for (const std::uint32_t step : session.bookmarks()) {
    const float x = track.place(step);
    list.AddLine({x, y - ui.px(13)}, {x, y}, ui.color(Role::result), ui.px(1.6));
    list.AddTriangleFilled({x, y - ui.px(13)}, {x + ui.px(9), y - ui.px(10)}, {x, y - ui.px(7)},
                           ui.color(Role::result));
  }
  list.AddCircleFilled({here, y}, ui.px(8), ui.color(Role::current), 24);
  list.AddCircle({here, y}, ui.px(8), ImGui::ColorConvertFloat4ToU32(ImGui::GetStyleColorVec4(ImGuiCol_WindowBg)), 24,
                 ui.px(2));
}

std::string describe(const Session& session, std::uint32_t step) {
  const TraceGraph& graph = session.recording().graph();
  std::string text = "step " + std::to_string(step);
  for (const std::uint32_t phase : graph.phase_path(graph.step(step).phase))
    text += "\n" + session.recording().source().phase_title(phase);
  if (const ValueId v = graph.main_value(step); v != absent && !graph.is_input(v))
    text += "\nmakes " + plain_name(graph.value(v).name, session.recording().source().algorithm_at(step));
  const auto& marks = session.beats();
  if (std::any_of(marks.begin(), marks.end(), [&](const Beat& b) { return b.step == step; }))
    text += "\na beat of the lesson";
  if (std::any_of(marks.begin(), marks.end(), [&](const Beat& b) { return b.step == step && b.checkpoint; }))
    text += ", which asks something";
  return text;
}

// Where there is hardly any height, the scrubber stands beside the buttons.
bool in_one_row(const Ui& ui) { return ui.height() < 330; }

void scrubber(Ui& ui, const Session& session) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const bool phases = !session.recording().graph().phases().empty();
  const float height = ui.px(phases && !in_one_row(ui) ? 38 : 26);
  if (width < ui.px(40)) return;
  ImGui::InvisibleButton("slider", {width, height});
  ui.thing("timeline slider");
  const Track track{at.x + ui.px(10), at.x + width - ui.px(10), at.y + ui.px(14), session.last()};
  const float mouse = ImGui::GetIO().MousePos.x;
  if (ImGui::IsItemActive()) {
    const std::uint32_t step = track.step(mouse);
    if (ImGui::GetIO().KeyShift) {  // a range to repeat: from where the button went down
      const std::uint32_t from = track.step(ImGui::GetIO().MouseClickedPos[0].x);
      ui.send([from, step](Player& p) {
        p.session()->move([=](Timeline& t) { return t.set_loop(std::min(from, step), std::max(from, step)), false; });
      });
    } else {
      ui.send([step](Player& p) { p.scrub(step); });
    }
  } else if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("%s", describe(session, track.step(mouse)).c_str());
  }
  if (phases && !in_one_row(ui)) draw_phases(ui, session, track);
  draw_track(ui, session, track);
}

void buttons(Ui& ui, const Session& session) {
  const Timeline& timeline = session.timeline();
  const auto next = [&](const char* action, const char* icon, bool on = false) {
    ui.icon_button(action, icon, on);
    ImGui::SameLine(0, ui.px(4));
  };
  const bool all = !in_one_row(ui);  // keys and menus have the others
  next("step.first", "first");
  if (all) next("step.previous_mark", "previous-beat");
  next("step.back", "back");
  next("step.play", timeline.playing() ? "pause" : "play", timeline.playing());
  next("step.forward", "forward");
  if (all) next("step.next_mark", "next-beat");
  next("step.last", "last");
  if (all && !session.recording().graph().phases().empty()) {
    next("step.over", "over");
    next("step.out", "out");
  }
  ImGui::SameLine(0, ui.px(10));
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(ui.bold());
  ImGui::Text("%u / %u", session.step(), session.last());
  ImGui::PopFont();
  ui.thing("timeline position");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("the step one is at, of all\nG goes to a step or a value");

  if (ui.player().waits_here()) {
    ImGui::SameLine(0, ui.px(14));
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(ui.ink(Role::text_current)), "\u25B6 Space goes on");
    ui.thing("timeline waits");
  }
  if (in_one_row(ui)) {
    ImGui::SameLine(0, ui.px(8));
    scrubber(ui, session);
    return;
  }
  // At the right, if there is room: bookmark, loop, speed.
  char speed[32];
  std::snprintf(speed, sizeof speed, "%gx", ui.player().settings.speed);
  const float square = ImGui::GetFrameHeight() * 1.12f, room = ImGui::CalcTextSize("0.0x").x + ui.px(12);
  const float wanted = 4 * (square + ui.px(4)) + room + ui.px(24);
  ImGui::SameLine();
  if (ImGui::GetContentRegionAvail().x < wanted) return;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - wanted);
  const auto marks = session.bookmarks();
  const bool marked = std::find(marks.begin(), marks.end(), session.step()) != marks.end();
  next("step.bookmark", marked ? "bookmarked" : "bookmark", marked);
  next("step.loop", "loop", timeline.loop().has_value());
  ImGui::SameLine(0, ui.px(16));
  next("step.slower", "minus");
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::AlignTextToFramePadding();
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + (room - ImGui::CalcTextSize(speed).x) / 2);
  ImGui::TextUnformatted(speed);
  ui.thing("timeline speed");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("steps a second while it plays");
  ImGui::SameLine();
  ImGui::SetCursorScreenPos({at.x + room, at.y});
  next("step.faster", "plus");
}

void draw(Ui& ui) {
  const Session& session = *ui.player().session();
  if (in_one_row(ui)) return buttons(ui, session);
  ImGui::SetCursorPosY(ui.px(2));
  scrubber(ui, session);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ui.px(2));
  buttons(ui, session);
}

double wanted(const Ui& ui, double) {
  if (in_one_row(ui)) return 50;
  const bool phases = !ui.player().session()->recording().graph().phases().empty();
  return phases ? 86 : 74;
}

}  // namespace

const Panel& panel_timeline() {
  static const Panel panel{"timeline", "Timeline", Slot::foot, 20, draw, nullptr, wanted};
  return panel;
}

}  // namespace blossom
