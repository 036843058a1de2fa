// The marks of the questions, and what is said of an answer.
#include "player/ui/predict_parts.hpp"

#include <imgui_internal.h>

#include <utility>

namespace blossom {

bool predict_button(Ui& ui, const char* label, const std::string& name, const std::string& tip) {
  const bool pressed = ui.button(label, name);
  if (!tip.empty() && ImGui::IsItemHovered()) predict_tip(ui, tip);
  return pressed;
}

bool predict_action(Ui& ui, std::string_view id, const char* label) {
  const Action* action = find_action(id);
  IM_ASSERT(action != nullptr);
  const bool enabled = action->enabled == nullptr || action->enabled(ui.player());
  const bool pressed = ui.button(label, std::string(id), enabled);
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
    std::string tip(action->title);
    if (!action->keys.empty()) tip += "   " + std::string(action->keys.front());
    predict_tip(ui, tip);
  }
  if (pressed) ui.act(id);
  return pressed;
}

// Beside the panel, where it covers nothing of what it is about; above the item where the panel is as wide as the
// window.
void predict_tip(Ui& ui, const std::string& text) {
  const ImVec2 low = ImGui::GetItemRectMin();
  const float edge = ImGui::GetWindowPos().x - ui.px(12);
  const float width = ImGui::CalcTextSize(text.c_str()).x + 2 * ImGui::GetStyle().WindowPadding.x;
  if (edge > width)
    ImGui::SetNextWindowPos({edge, low.y}, ImGuiCond_Always, {1, 0});
  else
    ImGui::SetNextWindowPos({low.x, low.y - ui.px(4)}, ImGuiCond_Always, {0, 1});
  ImGui::SetTooltip("%s", text.c_str());
}

void predict_text(Ui& ui, const std::string& text, double size, Role role) {
  double height = 0;
  const double width = ui.units(ImGui::GetContentRegionAvail().x);
  Sheet sheet = ui.flow(text, width, size, role, height, false);
  ui.sheet("predict text", std::move(sheet), width, height);
}

Mark mark_of(const Prediction& prediction, std::size_t question) {
  const auto& attempt = prediction.attempt(question);
  if (attempt && attempt->shown) return Mark::shown;
  if (const auto mark = prediction.mark(question)) {
    if (mark->verdict == Verdict::missing) return Mark::missing;
    if (mark->verdict == Verdict::correct) return Mark::right;
    return mark->verdict == Verdict::carried ? Mark::partly : Mark::wrong;
  }
  return attempt ? Mark::answered : Mark::open;
}

// Told apart by shape: a ring, a disc, a dotted disc, a tick, a tick in a ring, a cross, a dash.
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
    case Mark::missing:
      list.AddLine({c.x - 0.6f * r, c.y}, {c.x + 0.6f * r, c.y}, ui.color(Role::mistake), r * 0.4f);
      break;
    case Mark::wrong:
      list.AddLine({c.x - 0.65f * r, c.y - 0.65f * r}, {c.x + 0.65f * r, c.y + 0.65f * r}, ui.color(Role::mistake),
                   r * 0.4f);
      list.AddLine({c.x + 0.65f * r, c.y - 0.65f * r}, {c.x - 0.65f * r, c.y + 0.65f * r}, ui.color(Role::mistake),
                   r * 0.4f);
      break;
  }
}

static const char* mark_text(Mark mark) {
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
    case Mark::missing:
      return "no answer";
  }
  return "";
}

void draw_marks(Ui& ui, const Prediction& prediction, std::optional<std::size_t> asked) {
  const float side = ui.px(22);
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(2), ui.px(2)});
  for (std::size_t q = 0; q < prediction.questions().size(); ++q) {
    const AskedValue& question = prediction.questions()[q];
    if (q > 0) {
      ImGui::SameLine();
      if (ImGui::GetCursorScreenPos().x + side > right) ImGui::NewLine();
    }
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushID(static_cast<int>(q));
    // Tab comes to the row once; in it the arrows walk.
    ImGui::PushItemFlag(ImGuiItemFlags_Inputable, asked ? asked == q : q == 0);
    const bool pressed = ImGui::InvisibleButton("mark", {side, side});
    ImGui::PopItemFlag();
    ImGui::PopID();
    if (pressed) ui.send([q](Player& p) { p.choose_question(q); });
    ui.thing("predict question " + question.name);
    const Mark mark = mark_of(prediction, q);
    const bool focused = ImGui::IsItemFocused() && ImGui::GetIO().NavVisible;
    if (ImGui::IsItemHovered() || focused) {
      ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + side, at.y + side}, ui.color(Role::rule_line, 0.5),
                                                ui.px(4));
      predict_tip(ui, question.name + ": " + mark_text(mark));
    }
    if (asked == q)
      ImGui::GetWindowDrawList()->AddRect(at, {at.x + side, at.y + side}, ui.color(Role::current), ui.px(4), 0,
                                          ui.px(2));
    draw_mark(ui, mark, {at.x + side / 2, at.y + side / 2}, side * 0.3f);
  }
  ImGui::PopStyleVar();
}

// What an answer was worth; of one that was shown, why it is right; of one that is marked later, that it was taken.
void draw_feedback(Ui& ui, const Prediction& prediction, std::size_t q) {
  const AskedValue& question = prediction.questions()[q];
  const auto mark = prediction.mark(q);
  const auto& attempt = prediction.attempt(q);
  if (!mark && !attempt) return;
  const Mark shape = mark_of(prediction, q);
  std::string said = attempt ? answer_words(question, attempt->numbers) : question.name;
  if (shape == Mark::shown) {
    said = "Shown: " + said;
    const std::string reason = reason_words(question, ui.player().session()->recording().source());
    if (!reason.empty()) said += ", because " + reason;
    said += ".";
  } else if (shape == Mark::missing) {
    said += ": " + (mark->feedback.empty() ? std::string("no answer.") : mark->feedback);
  } else {
    said += std::string(": ") + mark_text(shape) + ".";
    // "right. Correct." says it twice.
    if (mark && !mark->feedback.empty() && mark->verdict != Verdict::correct) said += " " + mark->feedback;
  }
  const Role role = shape == Mark::wrong || shape == Mark::missing  ? Role::mistake
                    : shape == Mark::right || shape == Mark::partly ? Role::right
                                                                    : Role::text;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_mark(ui, shape, {at.x + ui.px(8), at.y + ui.px(11)}, ui.px(7));
  ImGui::Indent(ui.px(22));
  predict_text(ui, said, 0.92, role);
  ui.thing("predict feedback " + question.name);
  ImGui::Unindent(ui.px(22));
}

// The knot i of the first curve as numbers are shown now.
static std::string knot_words(const Session& session, int i) {
  const Inputs<Exact>& inputs = session.inputs();
  const auto curves = curves_of(inputs);
  const auto at = static_cast<std::size_t>(i);
  if (session.exact() && !curves.empty() && at < curve_at(inputs, curves.front()).knots.size())
    return number_text(curve_at(inputs, curves.front()).knots[at]);
  return format_short(session.recording().source().curves.front().knots[at], 3);
}

void draw_spans(Ui& ui, const Session& session, const std::string& name,
                void (*picked)(Player&, const std::string& index)) {
  const auto& curves = session.recording().source().curves;
  if (curves.empty()) return;
  const auto& curve = curves.front();
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  bool first = true;
  for (int i = curve.degree; i <= curve.n(); ++i) {
    const double a = curve.knots[static_cast<std::size_t>(i)], b = curve.knots[static_cast<std::size_t>(i) + 1];
    if (!(a < b)) continue;
    const std::string label =
        "[" + knot_words(session, i) + ", " + knot_words(session, i + 1) + (i == curve.n() ? "]" : ")");
    const float width = ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
    if (!std::exchange(first, false)) {
      ImGui::SameLine();
      if (ImGui::GetCursorScreenPos().x + width > right) ImGui::NewLine();
    }
    const std::string index = std::to_string(i);
    if (predict_button(ui, label.c_str(), name + index)) ui.send([=](Player& player) { picked(player, index); });
  }
}

}  // namespace blossom
