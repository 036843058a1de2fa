// To a step by its number, or to the step that makes a value.
#include <algorithm>
#include <charconv>

#include "algorithms/selector.hpp"
#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_suggested = 8;

struct Suggestion {
  std::string label, detail;
  std::uint32_t step = 0;
};

std::optional<std::uint64_t> whole_number(const std::string& text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

std::string without_blanks(const std::string& text) {
  std::string kept;
  for (const char c : text)
    if (c != ' ') kept += c;
  return kept;
}

std::string step_text(std::uint32_t step, const Session& session) {
  return "step " + std::to_string(step) + " of " + std::to_string(session.last());
}

// What begins like this comes first; each name once, where it is made.
std::vector<Suggestion> suggestions(const Session& session, const std::string& text) {
  std::vector<Suggestion> found;
  if (text.empty()) return found;
  if (const auto number = whole_number(text)) {
    if (*number <= session.last()) {
      const auto step = static_cast<std::uint32_t>(*number);
      const ValueId v = session.recording().graph().main_value(step);
      found.push_back({step_text(step, session), v == absent ? "" : session.recording().graph().name(v), step});
    }
    return found;
  }
  const TraceGraph& graph = session.recording().graph();
  std::vector<Suggestion> inside;
  for (ValueId v = 0; v < graph.value_count() && found.size() < most_suggested; ++v) {
    const std::string name = graph.name(v);
    if (!contains(name, text)) continue;
    Suggestion one{name, step_text(graph.value(v).step, session), graph.value(v).step};
    if (contains(std::string_view(name).substr(0, text.size()), text))
      found.push_back(std::move(one));
    else if (inside.size() < most_suggested)
      inside.push_back(std::move(one));
  }
  found.insert(found.end(), inside.begin(), inside.end());
  if (found.size() > most_suggested) found.resize(most_suggested);
  return found;
}

struct Search {
  std::string text, looked_for;
  std::uint64_t version = 0;
  std::vector<Suggestion> found;
  int chosen = 0;
  std::string near;       // what may have been meant
  bool to_field = false;  // the keyboard goes there
};

// A long run has many names: they are looked through only when the text changes.
void look(Search& search, const Session& session) {
  const std::string text = without_blanks(search.text);
  if (text == search.looked_for && session.version() == search.version) return;
  search.looked_for = text;
  search.version = session.version();
  search.found = suggestions(session, text);
  search.chosen = 0;
  search.near.clear();
  if (search.found.empty() && !text.empty() && !whole_number(text))
    search.near = nearest_name(session.recording().graph(), text).value_or("");
}

void draw(Ui& ui) {
  static Search search;
  const Session* session = ui.player().session();
  if (session == nullptr) return close_dialog(ui);
  if (!begin_dialog(ui, "Go to a step or value", 440)) return;
  if (dialog_opens()) {
    search = {};
    search.text = ui.player().go_to_text;
  }
  int moved = 0;
  if (std::exchange(search.to_field, false)) ImGui::SetKeyboardFocusHere();
  const bool entered = dialog_field(
      ui, "", "dialog step", search.text, true, "A step or a value's name, such as 7 or P[1][3]",
      ImGuiInputTextFlags_CallbackHistory | ImGuiInputTextFlags_AutoSelectAll,
      [](ImGuiInputTextCallbackData* data) {
        *static_cast<int*>(data->UserData) = data->EventKey == ImGuiKey_UpArrow ? -1 : 1;
        return 0;
      },
      &moved);
  look(search, *session);
  const auto count = static_cast<int>(search.found.size());
  search.chosen = std::clamp(search.chosen + moved, 0, std::max(count - 1, 0));
  const auto go = [&](const Suggestion& to) {
    ui.send([step = to.step, text = search.text](Player& player) {
      player.cancel_dialog();
      player.go_to_text = text;
      player.seek(step);
    });
  };
  const float height = static_cast<float>(most_suggested) * ImGui::GetFrameHeightWithSpacing();
  const float below = ImGui::GetFrameHeightWithSpacing() + ui.px(12);
  ImGui::BeginChild("found", {0, std::min(height, dialog_room(ui, below))}, false, ImGuiWindowFlags_NavFlattened);
  for (int i = 0; i < count; ++i) {
    const Suggestion& one = search.found[static_cast<std::size_t>(i)];
    if (choice(ui, one.label, one.detail, "go to " + one.label, i == search.chosen, true,
               i == search.chosen && moved != 0))
      go(one);
  }
  if (count == 0) {
    if (search.looked_for.empty())
      quiet_text(ui, "The run has the steps 0 to " + std::to_string(session->last()) +
                         ". A value is made by one step: its name leads there.");
    else if (whole_number(search.looked_for))
      dialog_warning(ui, "The last step is " + std::to_string(session->last()) + ".");
    else
      dialog_warning(ui, "No value of this run is called so.");
    if (!search.near.empty() && ui.button(("Did you mean " + search.near + "?").c_str(), "dialog meant")) {
      search.text = search.near;
      ui.redraw();
    }
  }
  ImGui::EndChild();
  const bool pressed = dialog_buttons(ui, "Go", count > 0);
  if ((entered || pressed) && count > 0) {
    go(search.found[static_cast<std::size_t>(search.chosen)]);
  } else if (entered) {
    if (!search.near.empty()) search.text = search.near;  // and Enter again goes there
    search.to_field = true;
    ui.redraw();
  }
  end_dialog();
}

bool is_relevant(const Player& player) { return player.dialog == Dialog::go_to; }

}  // namespace

const Panel& panel_dialog_go_to() {
  static const Panel panel{"go-to", "Go to", Slot::float_, 57, draw, is_relevant};
  return panel;
}

}  // namespace blossom
