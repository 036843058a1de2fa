// Predicting: what will the next step make? Typed here, clicked in the picture, or picked from the spans or the lines.
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "player/ui/panel.hpp"
#include "player/ui/predict_parts.hpp"

namespace blossom {
namespace {

// ---- before -----------------------------------------------------------------------------------------------------

void invite(Ui& ui) {
  ImGui::TextWrapped(
      "Say what each step makes before you see it: type it, or click the place in the picture. Your answers can be "
      "saved as a file to hand in.");
  ImGui::Spacing();
  if (predict_button(ui, "Predict the steps", "predict start")) ui.act("predict.toggle");
}

// ---- one question -----------------------------------------------------------------------------------------------

std::vector<std::string> labels_of(const AskedValue& question, int dimension) {
  if (question.kind != ValueKind::point && question.kind != ValueKind::vector) return {""};
  std::vector<std::string> labels;
  const char* const names[] = {"x", "y", "z"};
  const bool homogeneous = question.form == Form::homogeneous;
  if (question.form == Form::weight) return {"w"};
  for (int i = 0; i < dimension; ++i) labels.push_back(std::string(homogeneous ? "w" : "") + names[i]);
  if (homogeneous) labels.emplace_back("w");
  return labels;
}

void draw_lines(Ui& ui, const Session& session, const Prediction& prediction, std::size_t q) {
  const AskedValue& question = prediction.questions()[q];
  const StepSource& source = session.recording().source();
  const int right_line = source.line(question.step);
  if (right_line == 0) return;
  ImGui::TextUnformatted("Which line of the code makes it?");
  ImGui::SameLine();
  if (ImGui::GetContentRegionAvail().x < ImGui::CalcTextSize("(practice, not handed in)").x) ImGui::NewLine();
  ImGui::TextDisabled("(practice, not handed in)");
  const auto& guess = prediction.line_guess(q);
  const auto count = static_cast<int>(source.algorithm_at(question.step).pseudo_code.size());
  for (int line = 1; line <= count; ++line) {
    if (line > 1) ImGui::SameLine(0, ui.px(3));
    if (ImGui::GetContentRegionAvail().x < ui.px(24)) ImGui::NewLine();
    if (predict_button(ui, std::to_string(line).c_str(), "predict line " + std::to_string(line)))
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

const char* hint_of(const AskedValue& question, std::size_t q) {
  if (question.size == 0) return "e.g. 0, 0, 1/2, 1, 1";
  if (question.kind == ValueKind::integer) return "a whole number";
  return q == 0 ? "e.g. 3/4" : "";
}

// One field for each number; what was marked or shown can only be read.
void draw_fields(Ui& ui, const Session& session, const AskedValue& question, std::size_t q) {
  const auto labels = labels_of(question, session.recording().source().dimension);
  const Prediction& prediction = *session.prediction();
  const auto& draft = ui.player().draft();
  const auto& attempt = prediction.attempt(q);
  const bool fixed = prediction.finished() || prediction.mark(q) || (attempt && attempt->shown);
  const bool list = question.size == 0;
  std::vector<std::string> numbers;
  if (draft.question == q)
    numbers = draft.numbers;
  else if (attempt)
    numbers = attempt->numbers;
  const float width =
      list ? ImGui::GetContentRegionAvail().x - ui.px(100)
           : std::min(ui.px(question.kind == ValueKind::integer ? 140 : 110),
                      (ImGui::GetContentRegionAvail().x - ui.px(20)) / static_cast<float>(labels.size()) - ui.px(26));
  bool entered = false;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    std::string text;
    if (list)
      for (const std::string& element : numbers) text += (text.empty() ? "" : ", ") + element;
    else if (i < numbers.size())
      text = numbers[i];
    if (i > 0) ImGui::SameLine();
    if (!labels[i].empty()) {
      ImGui::AlignTextToFramePadding();
      ImGui::TextUnformatted(labels[i].c_str());
      ImGui::SameLine(0, ui.px(4));
    }
    ImGui::PushID(static_cast<int>(q * 8 + i));
    ImGui::SetNextItemWidth(width);
    if (i == 0 && draft.wants_keyboard && !fixed) {
      ImGui::SetKeyboardFocusHere();
      ui.send([](Player& p) { p.keyboard_given(); });
    }
    if (ImGui::InputTextWithHint("##number", hint_of(question, q), &text,
                                 ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll |
                                     (fixed ? ImGuiInputTextFlags_ReadOnly : 0)))
      entered = !fixed;
    if (ImGui::IsItemEdited() && !fixed) {
      if (list)
        ui.send([elements = split_numbers(text)](Player& p) { p.set_draft(elements); });
      else
        ui.send([i, text](Player& p) { p.set_draft(i, text); });
    }
    ImGui::PopID();
    ui.thing("predict " + (labels[i].empty() ? "number" : labels[i]));
  }
  if (fixed) return;
  ImGui::SameLine();
  const bool pressed = predict_button(ui, attempt ? "Change" : "Answer", "predict answer", "Enter");
  if (pressed || entered) ui.send([](Player& p) { p.submit_draft(); });
  const bool spatial = session.recording().source().spatial();
  if (question.kind == ValueKind::point && question.form == Form::affine && !spatial) {
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x < ImGui::CalcTextSize("or click the place").x) ImGui::NewLine();
    ImGui::TextDisabled("or click the place");
  }
  if (draft.question == q && !draft.problem.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, ui.ink(Role::mistake));
    ImGui::TextWrapped("! %s", draft.problem.c_str());
    ImGui::PopStyleColor();
    ui.thing("predict problem");
  }
}

void draw_question(Ui& ui, const Session& session, const Prediction& prediction, std::size_t q) {
  const AskedValue& question = prediction.questions()[q];
  predict_text(ui, asked_words(question, session.recording().source()), 1.05, Role::text);
  const auto& attempt = prediction.attempt(q);
  if (question.name == "k" && !prediction.finished() && !prediction.mark(q) && !(attempt && attempt->shown))
    draw_spans(ui, session, "predict span ", [](Player& player, const std::string& index) {
      player.set_draft({index});
      player.submit_draft();
    });
  if (attempt || !prediction.finished()) draw_fields(ui, session, question, q);
}

// ---- the end ----------------------------------------------------------------------------------------------------

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

// Before something is lost, in place of the question.
void draw_doubt(Ui& ui, const Prediction& prediction) {
  const bool stop = ui.player().doubt() == Player::Doubt::stop;
  const auto given = prediction.answered();
  const auto left = prediction.questions().size() - given;
  const auto counted = [](std::size_t count, const char* what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
  };
  predict_text(ui,
               stop ? "Stop and lose " + counted(given, "answer") + "? Saving them first keeps them as a file."
                    : "Finish with " + counted(left, "open question") + "? They count as not answered.",
               1.05, Role::text);
  if (predict_button(ui, stop ? "Stop" : "Finish", "predict do it")) ui.send([](Player& p) { p.resolve_doubt(true); });
  ImGui::SameLine();
  if (ui.player().draft().wants_keyboard) {
    ImGui::SetKeyboardFocusHere();
    ImGui::GetCurrentContext()->NavDisableHighlight = false;
    ui.send([](Player& p) { p.keyboard_given(); });
  }
  if (predict_button(ui, "Keep on", "predict keep on")) ui.send([](Player& p) { p.resolve_doubt(false); });
  if (stop) {
    ImGui::SameLine();
    predict_action(ui, "file.save_answers", "Save ...");
  }
}

void draw_buttons(Ui& ui, const Prediction& prediction) {
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  const auto next = [&](std::string_view action, const char* label) {
    const float width = ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
    ImGui::SameLine(0, ui.px(6));
    if (ImGui::GetCursorScreenPos().x + width > right) ImGui::NewLine();
    predict_action(ui, action, label);
  };
  predict_action(ui, "edit.undo", "Undo");
  if (!prediction.finished()) {
    next("predict.show_me", "Show me");
    next("predict.finish", "Finish");
  }
  next("file.save_answers", "Save ...");
  next("predict.toggle", "Stop");
}

void draw_asked(Ui& ui, const Session& session, const Prediction& prediction) {
  const auto asked = ui.player().asked();
  if (prediction.finished()) draw_end(ui, prediction);
  if (asked) draw_question(ui, session, prediction, *asked);
  if (prediction.finished() && asked) {
    draw_feedback(ui, prediction, *asked);
    if (predict_button(ui, "All answers", "predict all", "Their marks, one below the other"))
      ui.send([q = *asked](Player& p) { p.choose_question(q); });
  }
  draw_buttons(ui, prediction);
  if (prediction.finished()) {
    if (!asked)
      for (std::size_t q = 0; q < prediction.questions().size(); ++q) draw_feedback(ui, prediction, q);
    return;
  }
  // Of the question itself, if it is answered; else of the one that was answered before it.
  if (asked && prediction.attempt(*asked))
    draw_feedback(ui, prediction, *asked);
  else if (const auto last = ui.player().last_said())
    draw_feedback(ui, prediction, *last);
  if (asked) draw_lines(ui, session, prediction, *asked);
}

void draw(Ui& ui) {
  const Session& session = *ui.player().session();
  const Prediction* prediction = session.prediction();
  ImGui::BeginChild("questions", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
  // Tab is to come to buttons, too, and to show where it came.
  ImGui::PushItemFlag(ImGuiItemFlags_Inputable, true);
  if (ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) &&
      ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Tab)))
    ImGui::GetCurrentContext()->NavDisableHighlight = false;
  if (prediction == nullptr) {
    invite(ui);
  } else {
    draw_marks(ui, *prediction, ui.player().asked());
    if (ui.player().doubt() != Player::Doubt::none)
      draw_doubt(ui, *prediction);
    else
      draw_asked(ui, session, *prediction);
    if (prediction->undos() + prediction->shown() > 0)
      ImGui::TextDisabled("helps: %d taken back, %d shown", prediction->undos(), prediction->shown());
  }
  ImGui::PopItemFlag();
  // Who clicks or types here has the keyboard here: Tab then walks in this panel.
  if (ImGui::IsWindowFocused() && (ImGui::IsMouseClicked(0) || ImGui::GetIO().WantTextInput) &&
      !ui.keyboard_in("predict"))
    ui.send([](Player& p) { p.focus = "predict"; });
  ImGui::EndChild();
}

}  // namespace

const Panel& panel_predict() {
  static const Panel panel{"predict", "Predict", Slot::tabs, 50, draw, nullptr, nullptr, 0, true};
  return panel;
}

}  // namespace blossom
