#include "player/ui/number_field.hpp"

#include <algorithm>
#include <array>

namespace blossom {
namespace {

// Up and down count in the last place; the text that results is applied at once.
int on_arrow(ImGuiInputTextCallbackData* data) {
  const auto text =
      nudged({data->Buf, static_cast<std::size_t>(data->BufTextLen)}, data->EventKey == ImGuiKey_UpArrow ? 1 : -1);
  if (!text) return 0;
  data->DeleteChars(0, data->BufTextLen);
  data->InsertChars(0, text->c_str());
  *static_cast<bool*>(data->UserData) = true;
  return 0;
}

// What was refused, in one line; the path is where it stands.
std::string message_of(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) text += (text.empty() ? "" : "; ") + printable(diagnostic.message);
  return text;
}

class InputsModel : public FieldModel {
 public:
  std::string_view panel() const override { return "inputs"; }
  FieldTexts* texts(Player& player) const override {
    return player.session() != nullptr ? &player.session()->fields() : nullptr;
  }
  const FieldTexts& texts(const Player& player) const override { return player.session()->fields(); }
  const Diagnostics& rejected(const Player& player) const override { return player.session()->rejected(); }
  void forget_rejected(Player& player) const override { player.session()->forget_rejected(); }
};

}  // namespace

const FieldModel& inputs_model() {
  static const InputsModel model;
  return model;
}

std::string with_subscript(std::string_view letter, std::size_t index) {
  std::string text(letter);
  for (const char digit : std::to_string(index)) text += {'\xE2', '\x82', static_cast<char>(0x80 + (digit - '0'))};
  return text;
}

void Fields::apply(const NumberField& field, const std::string& value, const std::string& text, const TakeNumber& take,
                   const std::string& gesture) {
  const auto x = typed_number(text);
  ui_.send([=, model = &model_, path = field.path, what = field.name + " = " + text](Player& player) {
    FieldTexts* texts = model->texts(player);
    if (texts == nullptr) return;
    if (!x)
      texts->refuse(path, value, text, std::string(number_wanted));
    else if (take(player, *x, what, gesture))
      texts->accept(path);
    else
      texts->refuse(path, value, text, message_of(model->rejected(player)));
  });
}

void Fields::send_edit(const std::string& path, const std::string& what, TakeEdit take, const std::string& gesture) {
  ui_.send([=, model = &model_](Player& player) {
    FieldTexts* texts = model->texts(player);
    if (texts == nullptr) return;
    if (take(player, what, gesture))
      texts->accept(path);
    else
      texts->refuse(path, "", "", message_of(model->rejected(player)));
  });
}

bool Fields::number_(const NumberField& field, const std::function<TakeNumber()>& edit) {
  const std::string value = number_text(field.value, field.style);
  const std::string& shown = texts_.text(field.path, value);
  std::array<char, 512> buffer{};
  shown.copy(buffer.data(), buffer.size() - 1);

  ImGui::SetNextItemWidth(field.width);
  if (ui_.gives_keyboard_to_field_of(model_.panel())) ImGui::SetKeyboardFocusHere();
  if (field.quiet) ImGui::PushStyleColor(ImGuiCol_Text, ui_.ink(Role::text_quiet));
  ImGui::PushID(field.path.c_str());
  bool counted = false;
  const bool entered = ImGui::InputText(
      "##number", buffer.data(), buffer.size(),
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_CallbackHistory,
      on_arrow, &counted);
  ImGui::PopID();
  if (field.quiet) ImGui::PopStyleColor();
  const std::string text = buffer.data();
  ui_.thing(std::string(model_.panel()) + " " + field.name);
  const bool hovered = ImGui::IsItemHovered(), left = ImGui::IsItemDeactivated();

  const auto escape = ImGui::GetKeyIndex(ImGuiKey_Escape);
  if (left && ImGui::IsKeyPressed(escape, false)) {
    ui_.send([path = field.path, model = &model_](Player& player) {
      if (FieldTexts* texts = model->texts(player)) {
        texts->drop(path);
        model->forget_rejected(player);
      }
    });
  } else if (entered || (left && texts_.holds(field.path) && texts_.error(field.path, value).empty()) ||
             (left && text != shown)) {
    if (text != value || !texts_.error(field.path, value).empty())
      apply(field, value, text, edit(), {});
    else
      ui_.send([path = field.path, model = &model_](Player& player) {
        if (FieldTexts* texts = model->texts(player)) texts->drop(path);
      });
    if (entered) ImGui::SetKeyboardFocusHere(-1);
  } else if (counted) {
    apply(field, value, text, edit(), "arrows " + field.path);
  } else if (text != shown && ImGui::IsItemActive()) {
    ui_.send([path = field.path, value, text, model = &model_](Player& player) {
      if (FieldTexts* texts = model->texts(player)) texts->type(path, value, text);
    });
  }

  mark(field.path, value);
  if (hovered && ImGui::CalcTextSize(text.c_str()).x > field.width - 2 * ImGui::GetStyle().FramePadding.x)
    ImGui::SetTooltip("%s", text.c_str());
  return hovered;
}

const std::string& Fields::problem(const std::string& path, const std::string& value) const {
  const std::string& own = texts_.error(path, value);
  if (!own.empty()) return own;
  for (const Diagnostic& diagnostic : rejected_)
    if (diagnostic.path == path && !texts_.says(message_of(rejected_))) return diagnostic.message;
  return own;
}

void Fields::mark(const std::string& path, const std::string& value) {
  const std::string& message = problem(path, value);
  if (message.empty()) return;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRect(low, high, ui_.color(Role::mistake), ui_.px(4), 0, ui_.px(2));
  if (std::find(kept_.begin(), kept_.end(), message) == kept_.end()) kept_.push_back(message);
}

void Fields::say() {
  for (const std::string& message : std::exchange(kept_, {})) say(message);
}

void Fields::say(const std::string& message) {
  const float side = ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float r = side * 0.45f;
  const ImVec2 centre{at.x + side / 2, at.y + side / 2};
  list.AddCircleFilled(centre, r, ui_.color(Role::mistake));
  const ImU32 background = ImGui::GetColorU32(ImGuiCol_WindowBg);
  list.AddRectFilled({centre.x - r * 0.15f, centre.y - r * 0.6f}, {centre.x + r * 0.15f, centre.y + r * 0.15f},
                     background);
  list.AddRectFilled({centre.x - r * 0.15f, centre.y + r * 0.35f}, {centre.x + r * 0.15f, centre.y + r * 0.65f},
                     background);
  ImGui::SetCursorScreenPos({at.x + side * 1.3f, at.y});
  ImGui::PushStyleColor(ImGuiCol_Text, ui_.ink(Role::mistake));
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() - side * 1.3f + wrap_);
  ImGui::TextUnformatted(message.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ui_.thing(std::string(model_.panel()) + " error");
}

bool Fields::wanted(std::string_view prefix) const {
  if (texts_.holds(prefix)) return true;
  return std::ranges::any_of(rejected_, [&](const Diagnostic& d) { return d.path.starts_with(prefix); });
}

void Fields::say_rest(const std::function<bool(const std::string& path)>& has_field) {
  for (const Diagnostic& diagnostic : rejected_) {
    if (has_field(diagnostic.path) || texts_.says(message_of(rejected_))) continue;
    say((diagnostic.path.empty() ? "" : printable(diagnostic.path) + ": ") + printable(diagnostic.message));
  }
}

}  // namespace blossom
