// What a lesson asks at this step, and how the answers stand.
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <utility>

#include "algorithms/typeset.hpp"
#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"
#include "player/ui/predict_parts.hpp"

namespace blossom {
namespace {

using Item = Checkpoints::Item;

Mark mark_of(const Item& item) {
  if (item.first) return item.first->right ? Mark::right : Mark::wrong;
  return item.skipped ? Mark::missing : Mark::open;
}

const char* mark_words(const Item& item) {
  if (item.first && item.again && !item.first->right && item.again->right) return "right at a later try";
  if (item.first) return item.first->right ? "right" : "wrong";
  return item.skipped ? "skipped" : "not answered yet";
}

void prose(Ui& ui, const std::string& text, double size, Role role) {
  double height = 0;
  const double width = ui.units(ImGui::GetContentRegionAvail().x);
  Sheet sheet = ui.flow(read_prose(text), width, size, role, height, false);
  ui.sheet("checkpoint text", std::move(sheet), width, height);
}

// ---- the questions in a row -----------------------------------------------------------------------------------------

void draw_row(Ui& ui, const Checkpoints& checkpoints, std::optional<std::size_t> here) {
  const float side = ui.px(22);
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(2), ui.px(2)});
  for (std::size_t i = 0; i < checkpoints.items().size(); ++i) {
    const Item& item = checkpoints.item(i);
    if (i > 0) ImGui::SameLine();
    if (i > 0 && ImGui::GetCursorScreenPos().x + side > right) ImGui::NewLine();
    const ImVec2 at = ImGui::GetCursorScreenPos(), to{at.x + side, at.y + side};
    ImGui::PushID(static_cast<int>(i));
    ImGui::PushItemFlag(ImGuiItemFlags_Inputable, here ? here == i : i == 0);  // Tab comes to the row once
    if (ImGui::InvisibleButton("mark", {side, side})) ui.send([i](Player& p) { p.go_to_checkpoint(i); });
    ImGui::PopItemFlag();
    ImGui::PopID();
    ui.thing("checkpoint mark " + item.checkpoint.id);
    if (ImGui::IsItemHovered() || (ImGui::IsItemFocused() && ImGui::GetIO().NavVisible)) {
      ImGui::GetWindowDrawList()->AddRectFilled(at, to, ui.color(Role::rule_line, 0.5), ui.px(4));
      predict_tip(ui, "Question " + std::to_string(i + 1) + ": " + mark_words(item));
    }
    if (here == i) ImGui::GetWindowDrawList()->AddRect(at, to, ui.color(Role::current), ui.px(4), 0, ui.px(2));
    draw_mark(ui, mark_of(item), {at.x + side / 2, at.y + side / 2}, side * 0.3f);
  }
  ImGui::PopStyleVar();
}

// ---- answers --------------------------------------------------------------------------------------------------------

void skip_button(Ui& ui, const Item& item) {
  if (!item.open() || ui.player().asks_to_skip()) return;
  if (predict_button(ui, "Skip", "checkpoint skip", "One can come back to it   Ctrl+Right"))
    ui.send([](Player& p) { p.skip_checkpoint(); });
}

void answer_button(Ui& ui, const Item& item) {
  ImGui::Dummy({0, ui.px(1)});
  if (predict_button(ui, "Answer", "checkpoint answer", "Enter")) ui.send([](Player& p) { p.submit_checkpoint(); });
  ImGui::SameLine();
  skip_button(ui, item);
  if (!item.open() || ui.player().asks_to_skip()) ImGui::NewLine();
}

// What is to be typed.
const char* hint_of(const Player& player, const Item& item, const Checkpoints::Reply& reply) {
  if (reply.size == 0) return "e.g. 0, 0, 1/2, 1, 1";
  const TraceGraph& graph = player.session()->recording().graph();
  const auto value = graph.find(item.checkpoint.value);
  const bool whole =
      item.checkpoint.kind == Checkpoint::Kind::span || (value && graph.value(*value).kind == ValueKind::integer);
  return whole ? "a whole number" : "e.g. 3/4";
}

void draw_fields(Ui& ui, const Item& item, const Checkpoints::Reply& reply) {
  static constexpr const char* axes[] = {"x", "y", "z"};
  const std::size_t count = std::max<std::size_t>(reply.size, 1);
  const float beside = reply.size > 1 ? ui.px(20) : 0;
  const float room = ImGui::GetContentRegionAvail().x - ui.px(90);
  const float width = std::min(ui.px(reply.size == 0   ? 320
                                     : reply.size == 1 ? 130
                                                       : 110),
                               room / static_cast<float>(count) - beside);
  bool entered = false;
  for (std::size_t i = 0; i < count; ++i) {
    std::string text;
    if (reply.size == 0)
      for (const std::string& number : reply.numbers) text += (text.empty() ? "" : ", ") + number;
    else if (i < reply.numbers.size())
      text = reply.numbers[i];
    if (i > 0) ImGui::SameLine();
    if (reply.size > 1) {
      ImGui::AlignTextToFramePadding();
      ImGui::TextUnformatted(axes[std::min<std::size_t>(i, 2)]);
      ImGui::SameLine(0, ui.px(4));
    }
    ImGui::PushID(static_cast<int>(i));
    ImGui::SetNextItemWidth(width);
    if (i == 0 && reply.wants_keyboard) {
      ImGui::SetKeyboardFocusHere();
      ui.send([](Player& p) { p.checkpoints().keyboard_given(); });
    }
    entered |= ImGui::InputTextWithHint("##number", i == 0 ? hint_of(ui.player(), item, reply) : "", &text,
                                        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    if (ImGui::IsItemEdited()) {
      const auto pieces = split_numbers(text);  // a point that is copied from elsewhere comes in one piece
      if (reply.size == 0 || (i == 0 && pieces.size() == count && count > 1))
        ui.send([pieces](Player& p) { p.checkpoints().type(pieces); });
      else
        ui.send([i, text](Player& p) { p.checkpoints().type(i, text); });
    }
    ImGui::PopID();
    ui.thing("checkpoint " + std::string(reply.size > 1 ? axes[std::min<std::size_t>(i, 2)] : "number"));
  }
  ImGui::SameLine();
  const bool pressed = predict_button(ui, "Answer", "checkpoint answer", "Enter");
  if (pressed || entered) ui.send([](Player& p) { p.submit_checkpoint(); });
  if (ui.player().checkpoint_asks_place()) ImGui::TextDisabled("or click the place in the picture");
}

// All of the code, for the panel of the code may show only a part of it.
void draw_lines(Ui& ui, const Session& session) {
  ImGui::TextDisabled("Click the line, here or in the code:");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, ui.px(1)});
  int line = 0;
  for (const auto& code : session.recording().source().algorithm_at(session.step()).pseudo_code) {
    const std::string number = std::to_string(++line);
    const ImVec2 at = ImGui::GetCursorScreenPos(), size{ImGui::GetContentRegionAvail().x, ui.px(21)};
    if (ImGui::InvisibleButton(("line" + number).c_str(), size))
      ui.send([line](Player& p) { p.submit_checkpoint_line(line); });
    ui.thing("checkpoint line " + number);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (ImGui::IsItemHovered() || (ImGui::IsItemFocused() && ImGui::GetIO().NavVisible))
      list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, ui.color(Role::rule_line, 0.6), ui.px(4));
    ImGui::PushFont(ui.mono());
    const float y = at.y + (size.y - ImGui::GetFontSize()) / 2;
    list.AddText({at.x + ui.px(6), y}, ui.ink(Role::text_quiet), number.c_str());
    list.AddText({at.x + ui.px(30), y}, ui.ink(Role::text), shortened(std::string(code), size.x - ui.px(34)).c_str());
    ImGui::PopFont();
  }
  ImGui::PopStyleVar();
}

// A row one can click: a sign or what stands for it, the letter, the text. Its height in pixels.
bool option_row(Ui& ui, const std::string& name, std::size_t letter, const std::string& text, float width, bool chosen,
                Mark mark, bool marked, bool round) {
  const float left = ui.px(46), pad = ui.px(4);
  double height = 0;
  const double text_width = ui.units(width - left - pad);
  Sheet sheet = ui.flow(read_prose(text), text_width, 1, Role::text, height, false);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 to{at.x + width, at.y + ui.px(height) + 2 * pad};
  ImGui::SetItemAllowOverlap();
  const bool pressed = ImGui::InvisibleButton(name.c_str(), {to.x - at.x, to.y - at.y});
  ui.thing(name);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool hot = ImGui::IsItemHovered() || (ImGui::IsItemFocused() && ImGui::GetIO().NavVisible);
  if (hot || chosen) list.AddRectFilled(at, to, ui.color(Role::rule_line, hot ? 0.6 : 0.35), ui.px(4));
  const float middle = at.y + pad + ui.px(9.5);
  if (marked) {
    draw_mark(ui, mark, {at.x + ui.px(12), middle}, ui.px(7));
  } else if (round) {
    list.AddCircle({at.x + ui.px(12), middle}, ui.px(6.5), ui.ink(Role::text), 24, ui.px(1.5));
    if (chosen) list.AddCircleFilled({at.x + ui.px(12), middle}, ui.px(3.5), ui.color(Role::current), 20);
  } else if (chosen) {
    list.AddRectFilled({at.x, at.y + ui.px(3)}, {at.x + ui.px(3), to.y - ui.px(3)}, ui.color(Role::current));
  }
  ImGui::PushFont(ui.bold());
  list.AddText({at.x + ui.px(26), middle - ImGui::GetFontSize() / 2}, ui.ink(Role::text), letter_of(letter).c_str());
  ImGui::PopFont();
  const ImVec2 next = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({at.x + left, at.y + pad});
  ui.sheet("checkpoint option", std::move(sheet), text_width, height);
  ImGui::SetCursorScreenPos(next);
  return pressed;
}

void draw_choices(Ui& ui, const Item& item, const Checkpoints::Reply& reply, bool takes) {
  const Player& player = ui.player();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, ui.px(1)});
  const float width = ImGui::GetContentRegionAvail().x;
  const Checkpoints::Marked* last = item.last();
  for (std::size_t i = 0; i < item.checkpoint.choices.size(); ++i) {
    const auto& choice = item.checkpoint.choices[i];
    const bool told = !takes && last != nullptr && last->answer == "\"" + letter_of(i) + "\"";
    const std::string name = "checkpoint choice " + letter_of(i);
    if (option_row(ui, name, i, player.beat_text(choice.text), width, takes ? reply.choice == i : told,
                   told && last->right ? Mark::right : Mark::wrong, told, true) &&
        takes)
      ui.send([i](Player& p) { p.checkpoints().choose(i); });
  }
  ImGui::PopStyleVar();
  if (takes) answer_button(ui, item);
}

void draw_order(Ui& ui, const Item& item, const Checkpoints::Reply& reply, bool takes) {
  const Player& player = ui.player();
  const auto shown = shown_order(item.checkpoint);
  const float side = ImGui::GetFrameHeight(), gap = ui.px(3);
  const float width = ImGui::GetContentRegionAvail().x - (takes ? 2 * (side + gap) : 0);
  for (std::size_t place = 0; place < reply.order.size(); ++place) {
    const std::size_t letter = reply.order[place];
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const std::string name = "checkpoint item " + letter_of(letter);
    if (option_row(ui, name, letter, player.beat_text(item.checkpoint.items[shown[letter]]), width,
                   takes && reply.choice == letter, Mark::open, false, false) &&
        takes)
      ui.send([letter](Player& p) { p.checkpoints().choose(letter); });
    if (!takes) continue;
    const ImVec2 next = ImGui::GetCursorScreenPos();
    ImGui::PushID(static_cast<int>(place));
    for (const int by : {-1, 1}) {
      ImGui::SetCursorScreenPos({at.x + width + gap + (by > 0 ? side + gap : 0), at.y});
      const bool can = by < 0 ? place > 0 : place + 1 < reply.order.size();
      ImGui::BeginDisabled(!can);
      if (ImGui::Button(by < 0 ? "\u25B2" : "\u25BC", {side, side}))
        ui.send([place, by](Player& p) { p.checkpoints().move(place, by); });
      ImGui::EndDisabled();
      ui.thing(std::string("checkpoint ") + (by < 0 ? "up " : "down ") + letter_of(letter));
    }
    ImGui::PopID();
    ImGui::SetCursorScreenPos(next);
  }
  if (!takes) return;
  ImGui::TextDisabled("Its letter takes an item, the arrow keys move it.");
  answer_button(ui, item);
}

// ---- what is said to it ---------------------------------------------------------------------------------------------

void draw_mark_of(Ui& ui, const Item& item) {
  const Checkpoints::Marked* last = item.last();
  if (last == nullptr) return;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_mark(ui, last->right ? Mark::right : Mark::wrong, {at.x + ui.px(8), at.y + ui.px(11)}, ui.px(7));
  ImGui::Indent(ui.px(22));
  std::string said = last->right ? "**Right.**" : "**Not right.**";
  if (!last->words.empty()) said += " " + last->words;
  prose(ui, said, 1, Role::text);
  ui.thing("checkpoint feedback");
  if (!last->note.empty()) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(printable(last->note).c_str());
    ImGui::PopTextWrapPos();
  }
  if (item.again) quiet_text(ui, item.first->right ? "" : "Your first answer is the one that counts.");
  ImGui::Unindent(ui.px(22));
  if (!last->right) {
    if (predict_button(ui, "Try again", "checkpoint again", "For practice: the first answer counts"))
      ui.send([](Player& p) { p.checkpoints().try_again(); });
    ImGui::SameLine();
  }
  const Session& session = *ui.player().session();
  if (!session.timeline().at_end())
    predict_action(ui, "step.forward", "Go on");
  else if (ui.player().scene() + 1 < ui.player().scene_count())
    predict_action(ui, "lesson.next_scene", "Next scene");
  else
    ImGui::NewLine();
  // What is said to an answer is to be seen.
  float& seen = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("seen"), 0);
  const auto now = static_cast<float>(ImGui::GetID(item.checkpoint.id.c_str()) % 65536 + (item.again ? 65536 : 0));
  if (std::exchange(seen, now) != now) {
    ImGui::SetScrollHereY(1);
    ui.redraw();
  }
}

bool skip_seen = false;  // in the frame before

// Above the question, where it is seen.
void draw_skip(Ui& ui) {
  if (!skip_seen) ImGui::SetScrollY(0);
  ImGui::PushStyleColor(ImGuiCol_Text, ui.ink(Role::text_current));
  ImGui::TextWrapped("This question is still open. Skip it? The same key again skips it, too.");
  ImGui::PopStyleColor();
  if (predict_button(ui, "Skip it", "checkpoint skip it")) ui.send([](Player& p) { p.skip_checkpoint(); });
  ImGui::SameLine();
  if (predict_button(ui, "Stay", "checkpoint stay")) ui.send([](Player& p) { p.stay_at_checkpoint(); });
  ImGui::Separator();
}

// The answer as one would write it: "(12, 0)" and "3/4", not [12, 0] and "3/4" in quotes.
std::string answer_words(const Item& item) {
  std::string words = item.checkpoint.kind == Checkpoint::Kind::line ? "line " : "";
  for (const char c : item.last()->answer)
    if (c != '"') words += c == '[' ? '(' : c == ']' ? ')' : c;
  return words;
}

void draw_answer(Ui& ui, const Session& session, const Item& item) {
  const Checkpoints& checkpoints = ui.player().checkpoints();
  const Checkpoints::Reply& reply = checkpoints.reply();
  const bool takes = checkpoints.takes();
  switch (item.checkpoint.kind) {
    case Checkpoint::Kind::choice:
      draw_choices(ui, item, reply, takes);
      break;
    case Checkpoint::Kind::order:
      draw_order(ui, item, reply, takes);
      break;
    case Checkpoint::Kind::line:
      if (takes) draw_lines(ui, session);
      break;
    case Checkpoint::Kind::span:
      if (takes) {
        ImGui::TextDisabled("Click it on the knot line, or here:");
        draw_spans(ui, session, "checkpoint span ", [](Player& player, const std::string& index) {
          player.checkpoints().type({index});
          player.submit_checkpoint();
        });
      }
      [[fallthrough]];
    case Checkpoint::Kind::predict:
      if (takes) draw_fields(ui, item, reply);
      break;
  }
  if (!takes && item.last() != nullptr && item.checkpoint.choices.empty() && item.checkpoint.items.empty())
    quiet_text(ui, "Your answer: " + printable(answer_words(item)));
  if (!reply.problem.empty()) {
    dialog_warning(ui, reply.problem);
    ui.thing("checkpoint problem");
  }
}

void draw_question(Ui& ui, const Session& session, std::size_t which) {
  const Item& item = ui.player().checkpoints().item(which);
  if (ui.player().asks_to_skip()) draw_skip(ui);
  skip_seen = ui.player().asks_to_skip();
  prose(ui, ui.player().beat_text(item.checkpoint.ask), 1.08, Role::text_strong);
  if (session.edited()) {
    quiet_text(ui, "It is asked of the lesson's own numbers, and these were changed.");
    if (predict_button(ui, "Back to the lesson's numbers", "checkpoint revert")) ui.act("edit.revert");
    return;
  }
  draw_answer(ui, session, item);
  if (!ui.player().checkpoints().takes()) draw_mark_of(ui, item);
  if (item.checkpoint.choices.empty() && item.checkpoint.items.empty()) skip_button(ui, item);
}

// ---- between the questions and at the end ---------------------------------------------------------------------------

// What is asked, on one line. The numbers in it are known of the scene one is in.
std::string ask_in_short(const Player& player, const Item& item) {
  const std::string& words = item.checkpoint.ask.in(player.language());
  const auto filled =
      item.scene == player.scene() ? player.session()->recording().fill(words, item.step) : std::nullopt;
  if (!filled && words.find('{') != std::string::npos) return player.scene_heading(item.scene);
  std::string text = plain_text(read_prose(filled.value_or(words)));
  std::ranges::replace(text, '\n', ' ');
  // Names as they are set elsewhere: P₁⁽¹⁾ for P[1][1].
  const Algorithm& algorithm = *player.session()->document().lesson->scene_at(item.scene).algorithm;
  return unicode_text(typeset_text(text, algorithm));
}

void draw_summary(Ui& ui) {
  const Player& player = ui.player();
  const Checkpoints& checkpoints = player.checkpoints();
  const std::size_t count = checkpoints.items().size();
  ImGui::PushFont(ui.bold());
  if (player.has_all_been_said())
    ImGui::Text("%zu of %zu right", checkpoints.right(), count);
  else
    ImGui::Text("%zu of %zu answered", checkpoints.answered(), count);
  ImGui::PopFont();
  ui.thing("checkpoint summary");
  for (std::size_t i = 0; i < count; ++i) {
    const Item& item = checkpoints.item(i);
    const std::string ask = ask_in_short(player, item);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::Indent(ui.px(22));
    if (choice(ui, std::to_string(i + 1) + ".  " + ask, mark_words(item), "checkpoint go to " + item.checkpoint.id,
               false))
      ui.send([i](Player& p) { p.go_to_checkpoint(i); });
    ImGui::Unindent(ui.px(22));
    draw_mark(ui, mark_of(item), {at.x + ui.px(10), at.y + ImGui::GetFrameHeight() / 2}, ui.px(7));
  }
  ImGui::Spacing();
  predict_action(ui, "lesson.save_checkpoints", "Save the answers ...");
}

double content_height = 0;

// With the tabs above it.
double tight(const Ui&, double) { return content_height + 60; }

void draw(Ui& ui) {
  const Session& session = *ui.player().session();
  const auto here = ui.player().checkpoint();
  ImGui::BeginChild("checkpoint", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
  const float top = ImGui::GetCursorPosY();
  ImGui::PushItemFlag(ImGuiItemFlags_Inputable, true);  // Tab is to come to buttons, too
  if (here) {
    draw_row(ui, ui.player().checkpoints(), here);
    draw_question(ui, session, *here);
  } else {
    draw_summary(ui);
  }
  ImGui::PopItemFlag();
  // What it takes, for the next frame.
  if (const double now = ui.units(ImGui::GetCursorPosY() - top); std::exchange(content_height, now) != now) ui.redraw();
  ImGui::EndChild();
}

bool relevant(const Player& player) {
  return !player.checkpoints().items().empty() && player.session()->prediction() == nullptr;
}

}  // namespace

const Panel& panel_checkpoint() {
  static const Panel panel{"checkpoint", "Questions", Slot::tabs, 5, draw, relevant, nullptr, 0, true, false, tight};
  return panel;
}

}  // namespace blossom
