// Predicting: what will the next step make? Typed here, clicked in the picture, or picked from the spans or the lines.
#include <imgui.h>
#include <imgui_stdlib.h>

#include "player/ui/panel.hpp"
#include "player/ui/ui.hpp"

namespace blossom {
namespace {

void say(Ui& ui, const std::string& text, double size, Role role) {
  double height = 0;
  const double width = ui.units(ImGui::GetContentRegionAvail().x);
  Sheet sheet = ui.flow(text, width, size, role, height, false);
  ui.sheet("predict text", std::move(sheet), width, height);
}

// ---- before -----------------------------------------------------------------------------------------------------

void invite(Ui& ui) {
  ImGui::TextWrapped(
      "Say what each step makes before you see it: type it, or click the place in the picture. Your answers can be "
      "saved "
      "as a file to hand in.");
  ImGui::Spacing();
  if (ui.button("Predict the steps", "predict start")) ui.act("predict.toggle");
}

// ---- the questions as a row of marks ----------------------------------------------------------------------------

enum class Mark { open, answered, shown, right, partly, wrong };

Mark mark_of(const Prediction& prediction, std::size_t question) {
  const auto& attempt = prediction.attempt(question);
  if (attempt && attempt->shown) return Mark::shown;
  if (const auto mark = prediction.mark(question)) {
    if (mark->verdict == Verdict::correct) return Mark::right;
    return mark->verdict == Verdict::carried ? Mark::partly : Mark::wrong;
  }
  return attempt ? Mark::answered : Mark::open;
}

// Told apart by shape: a ring, a disc, a dotted disc, a tick, a tick in a ring, a cross.
void draw_mark(Ui& ui, Mark mark, ImVec2 c, float r) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto tick = [&](ImU32 color) {
    const ImVec2 points[] = {
        {c.x - 0.8f * r, c.y + 0.05f * r}, {c.x - 0.2f * r, c.y + 0.65f * r}, {c.x + 0.85f * r, c.y - 0.65f * r}};
    list.AddPolyline(points, 3, color, 0, r * 0.4f);
  };
  switch (mark) {
    case Mark::open:
      list.AddCircle(c, r * 0.8f, ui.color(Role::polygon), 20, r * 0.22f);
      break;
    case Mark::answered:
      list.AddCircleFilled(c, r * 0.8f, ui.color(Role::polygon), 20);
      break;
    case Mark::shown:
      list.AddCircle(c, r * 0.8f, ui.color(Role::polygon), 20, r * 0.22f);
      list.AddCircleFilled(c, r * 0.3f, ui.color(Role::polygon), 12);
      break;
    case Mark::right:
      tick(ui.color(Role::right));
      break;
    case Mark::partly:
      list.AddCircle(c, r * 1.05f, ui.color(Role::right), 20, r * 0.18f);
      tick(ui.color(Role::right));
      break;
    case Mark::wrong:
      list.AddLine({c.x - 0.65f * r, c.y - 0.65f * r}, {c.x + 0.65f * r, c.y + 0.65f * r}, ui.color(Role::mistake),
                   r * 0.4f);
      list.AddLine({c.x + 0.65f * r, c.y - 0.65f * r}, {c.x - 0.65f * r, c.y + 0.65f * r}, ui.color(Role::mistake),
                   r * 0.4f);
      break;
  }
}

const char* mark_text(Mark mark) {
  switch (mark) {
    case Mark::open:
      return "not answered yet";
    case Mark::answered:
      return "answered";
    case Mark::shown:
      return "shown: earns nothing";
    case Mark::right:
      return "right";
    case Mark::partly:
      return "right rule, on an earlier mistake";
    case Mark::wrong:
      return "wrong";
  }
  return "";
}

void draw_marks(Ui& ui, const Prediction& prediction, std::optional<std::size_t> asked) {
  const float side = ui.px(22);
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(2), ui.px(2)});
  for (std::size_t q = 0; q < prediction.questions().size(); ++q) {
    const Question& question = prediction.questions()[q];
    if (q > 0) {
      ImGui::SameLine();
      if (ImGui::GetCursorScreenPos().x + side > right) ImGui::NewLine();
    }
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushID(static_cast<int>(q));
    if (ImGui::InvisibleButton("mark", {side, side})) ui.send([q](Player& p) { p.choose_question(q); });
    ImGui::PopID();
    ui.thing("predict question " + question.name);
    const Mark mark = mark_of(prediction, q);
    if (ImGui::IsItemHovered() || ImGui::IsItemFocused()) {
      ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + side, at.y + side}, ui.color(Role::rule_line, 0.5),
                                                ui.px(4));
      ImGui::SetTooltip("%s: %s", question.name.c_str(), mark_text(mark));
    }
    if (asked == q)
      ImGui::GetWindowDrawList()->AddRect(at, {at.x + side, at.y + side}, ui.color(Role::current), ui.px(4), 0,
                                          ui.px(2));
    draw_mark(ui, mark, {at.x + side / 2, at.y + side / 2}, side * 0.3f);
  }
  ImGui::PopStyleVar();
}

// ---- one question -----------------------------------------------------------------------------------------------

std::vector<std::string> labels_of(const Question& question, int dimension) {
  if (question.kind != ValueKind::point && question.kind != ValueKind::vector) return {""};
  std::vector<std::string> labels;
  const char* const names[] = {"x", "y", "z"};
  const bool homogeneous = question.form == Form::homogeneous;
  if (question.form == Form::weight) return {"w"};
  for (int i = 0; i < dimension; ++i) labels.push_back(std::string(homogeneous ? "w" : "") + names[i]);
  if (homogeneous) labels.emplace_back("w");
  return labels;
}

std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> elements;
  std::string element;
  for (const char c : text + ",") {
    if (c != ',' && c != ';' && c != ' ') {
      element += c;
    } else if (!element.empty()) {
      elements.push_back(std::exchange(element, {}));
    }
  }
  return elements;
}

// The spans one can pick for k: the nonempty ones of the domain.
void draw_spans(Ui& ui, const Session& session) {
  const auto& curves = session.recording().source().curves;
  if (curves.empty()) return;
  const auto& curve = curves.front();
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  bool first = true;
  for (int i = curve.degree; i <= curve.n(); ++i) {
    const double a = curve.knots[static_cast<std::size_t>(i)], b = curve.knots[static_cast<std::size_t>(i) + 1];
    if (!(a < b)) continue;
    const std::string label = "[" + format_short(a, 3) + ", " + format_short(b, 3) + (i == curve.n() ? "]" : ")");
    const float width = ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
    if (!std::exchange(first, false)) {
      ImGui::SameLine();
      if (ImGui::GetCursorScreenPos().x + width > right) ImGui::NewLine();
    }
    if (ui.button(label.c_str(), "predict span " + std::to_string(i), true,
                  ("the span of index " + std::to_string(i)).c_str()))
      ui.send([i](Player& p) { p.set_draft(0, std::to_string(i)); });
  }
}

void draw_lines(Ui& ui, const Session& session, const Prediction& prediction, std::size_t q) {
  const Question& question = prediction.questions()[q];
  const StepSource& source = session.recording().source();
  const int right_line = source.line(question.step);
  if (right_line == 0) return;
  ImGui::TextUnformatted("Which line of the code makes it?");
  const auto& guess = prediction.line_guess(q);
  const auto count = static_cast<int>(source.algorithm_at(question.step).pseudo_code.size());
  for (int line = 1; line <= count; ++line) {
    ImGui::SameLine(0, ui.px(line == 1 ? 8 : 3));
    if (ImGui::GetContentRegionAvail().x < ui.px(24)) ImGui::NewLine();
    if (ui.button(std::to_string(line).c_str(), "predict line " + std::to_string(line)))
      ui.send([q, line, right_line](Player& p) { p.session()->prediction()->guess_line(q, line, right_line); });
    if (guess && guess->picked == line) {
      const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
      const bool told = prediction.marking() == Marking::at_once;
      const Role role = !told ? Role::focus : (guess->picked == guess->right ? Role::right : Role::mistake);
      ImGui::GetWindowDrawList()->AddRect(low, high, ui.color(role), ui.px(4), 0, ui.px(2));
      if (told) draw_mark(ui, guess->picked == guess->right ? Mark::right : Mark::wrong, {high.x, low.y}, ui.px(5));
    }
  }
}

void draw_fields(Ui& ui, const Session& session, const Question& question, std::size_t q) {
  const auto labels = labels_of(question, session.recording().source().dimension);
  const auto& draft = ui.player().draft();
  const bool list = question.size == 0;
  const float width =
      list ? ImGui::GetContentRegionAvail().x - ui.px(100)
           : std::min(ui.px(110),
                      (ImGui::GetContentRegionAvail().x - ui.px(20)) / static_cast<float>(labels.size()) - ui.px(26));
  bool entered = false;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    std::string text;
    if (draft.question == q) {
      if (list)
        for (const std::string& element : draft.numbers) text += (text.empty() ? "" : ", ") + element;
      else if (i < draft.numbers.size())
        text = draft.numbers[i];
    }
    if (i > 0) ImGui::SameLine();
    if (!labels[i].empty()) {
      ImGui::AlignTextToFramePadding();
      ImGui::TextUnformatted(labels[i].c_str());
      ImGui::SameLine(0, ui.px(4));
    }
    ImGui::PushID(static_cast<int>(q * 8 + i));
    ImGui::SetNextItemWidth(width);
    if (i == 0 && draft.wants_keyboard) {
      ImGui::SetKeyboardFocusHere();
      ui.send([](Player& p) { p.keyboard_given(); });
    }
    if (ImGui::InputTextWithHint("##number", list ? "0, 0, 1/2, 1, 1" : "2/5", &text,
                                 ImGuiInputTextFlags_EnterReturnsTrue))
      entered = true;
    if (ImGui::IsItemEdited()) {
      if (list)
        ui.send([elements = split_list(text)](Player& p) {
          for (std::size_t k = 0; k < elements.size(); ++k) p.set_draft(k, elements[k]);
        });
      else
        ui.send([i, text](Player& p) { p.set_draft(i, text); });
    }
    ImGui::PopID();
    ui.thing("predict " + (labels[i].empty() ? "number" : labels[i]));
  }
  ImGui::SameLine();
  const bool pressed = ui.button("Answer", "predict answer", true, "Enter");
  if (pressed || entered) ui.send([](Player& p) { p.submit_draft(); });
  if (draft.question == q && !draft.problem.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, ui.ink(Role::mistake));
    ImGui::TextWrapped("! %s", draft.problem.c_str());
    ImGui::PopStyleColor();
    ui.thing("predict problem");
  }
}

std::string prompt_of(const Session& session, const Question& question) {
  const ValueSpec* spec = session.recording().source().spec(question.value);
  std::string text = "What is " + question.name + "?";
  if (spec != nullptr && !spec->meaning.empty()) text += " It is " + std::string(spec->meaning) + ".";
  return text;
}

void draw_question(Ui& ui, const Session& session, const Prediction& prediction, std::size_t q) {
  const Question& question = prediction.questions()[q];
  say(ui, prompt_of(session, question), 1.05, Role::text);
  if (question.name == "k") draw_spans(ui, session);
  draw_fields(ui, session, question, q);
  if (question.kind == ValueKind::point && question.form == Form::affine) {
    ImGui::SameLine();
    ImGui::TextDisabled("or click the place");
  }
}

// ---- what was said of the last answer ---------------------------------------------------------------------------

void draw_feedback(Ui& ui, const Prediction& prediction, std::size_t q) {
  const auto mark = prediction.mark(q);
  const auto& attempt = prediction.attempt(q);
  if (!mark || !attempt) return;
  const Mark shape = mark_of(prediction, q);
  std::string said = prediction.questions()[q].name + " = ";
  for (std::size_t i = 0; i < attempt->numbers.size(); ++i) said += (i > 0 ? ", " : "") + attempt->numbers[i];
  said += std::string(": ") + mark_text(shape) + ".";
  if (!mark->feedback.empty()) said += " " + mark->feedback;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_mark(ui, shape, {at.x + ui.px(8), at.y + ui.px(11)}, ui.px(7));
  ImGui::Indent(ui.px(22));
  say(ui, said, 0.92, shape == Mark::wrong ? Role::mistake : Role::right);
  ImGui::Unindent(ui.px(22));
}

void draw_end(Ui& ui, const Prediction& prediction) {
  if (const auto grade = prediction.grade()) {
    ImGui::PushFont(ui.bold());
    ImGui::Text("%s of %s points", grade->points.to_string().c_str(),
                prediction.exercise().max_points.to_string().c_str());
    ImGui::PopFont();
    ui.thing("predict score");
  } else {
    ImGui::TextUnformatted("All is answered.");
  }
}

void draw_buttons(Ui& ui, const Prediction& prediction) {
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  const auto next = [&](std::string_view action, const char* label) {
    const float width = ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
    ImGui::SameLine(0, ui.px(6));
    if (ImGui::GetCursorScreenPos().x + width > right) ImGui::NewLine();
    ui.action_button(action, label);
  };
  ui.action_button("edit.undo", "Undo");
  next("predict.show_me", "Show me");
  if (!prediction.finished()) next("predict.finish", "Finish");
  next("file.save_answers", "Save ...");
  next("predict.toggle", "Stop");
}

void draw(Ui& ui) {
  const Session& session = *ui.player().session();
  const Prediction* prediction = session.prediction();
  ImGui::BeginChild("questions", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
  if (prediction == nullptr) {
    invite(ui);
    ImGui::EndChild();
    return;
  }
  const auto asked = ui.player().asked();
  draw_marks(ui, *prediction, asked);
  if (prediction->finished()) draw_end(ui, *prediction);
  const bool puts = asked && (!prediction->finished() || prediction->attempt(*asked));
  if (puts) draw_question(ui, session, *prediction, *asked);
  draw_buttons(ui, *prediction);

  // What the last answer was worth, or at the end all of them.
  std::optional<std::size_t> last;
  for (std::size_t q = 0; q < prediction->questions().size(); ++q)
    if (prediction->attempt(q) && (!asked || q < *asked)) last = q;
  if (asked && prediction->attempt(*asked)) last = asked;
  if (prediction->finished() && !asked) {
    for (std::size_t q = 0; q < prediction->questions().size(); ++q) draw_feedback(ui, *prediction, q);
  } else if (last) {
    draw_feedback(ui, *prediction, *last);
  }
  if (puts) draw_lines(ui, session, *prediction, *asked);
  if (prediction->undos() + prediction->shown() > 0)
    ImGui::TextDisabled("helps: %d taken back, %d shown", prediction->undos(), prediction->shown());
  ImGui::EndChild();
}

}  // namespace

const Panel& panel_predict() {
  static const Panel panel{"predict", "Predict", Slot::tabs, 50, draw, nullptr, nullptr, 0, true};
  return panel;
}

}  // namespace blossom
