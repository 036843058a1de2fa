#pragma once
// What dialogs are made of. A dialog stands in the middle over the dimmed rest, has the keyboard, and goes with Escape;
// Enter is its main button.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "player/ui/ui.hpp"

namespace blossom {

// False: it is not drawn in this frame, and end_dialog() is not called. `width` in units.
bool begin_dialog(Ui&, const char* title, double width);
void end_dialog();
// In its first frame: where what a dialog keeps for a moment is set.
bool dialog_opens();
// How high its contents may be from ImGui's cursor on, in pixels, if `below` pixels of other things follow them.
float dialog_room(const Ui&, float below);
void close_dialog(Ui&);

// A field for one line, its label above it, over the whole width. The keyboard goes to it as the dialog opens if
// `first`. True: Enter was pressed in it.
bool dialog_field(Ui&, const char* label, const std::string& name, std::string& text, bool first = false,
                  const char* hint = "", ImGuiInputTextFlags flags = 0, ImGuiInputTextCallback = nullptr,
                  void* data = nullptr);
// The row of buttons below: "dialog cancel" (none without a label) and "dialog ok", which is also meant by Enter while
// no button has the focus. True: the main one was pressed.
bool dialog_buttons(Ui&, const char* main, bool enabled = true, const char* cancel = "Cancel");
// ImGui's, with a ring around it that is seen on every ground.
bool radio(Ui&, const std::string& label, const std::string& name, bool chosen);
// A line that something is wrong, with a sign before it.
void dialog_warning(Ui&, const std::string& text);
void quiet_text(Ui&, const std::string& text);  // wrapped

// As much of the text as is so many pixels wide in the current font, and "…". `front`: its end is what counts.
std::string shortened(const std::string& text, float pixels, bool front = false);
// At most so many lines of so many pixels in the current font, the last one shortened.
std::vector<std::string> wrapped(const std::string& text, float pixels, std::size_t most_lines);
// Letters apart from their case.
bool contains(std::string_view text, std::string_view part);
// A row of a list that keys and the mouse choose from; scrolls itself into view when it becomes `chosen`.
bool choice(Ui&, const std::string& label, const std::string& detail, const std::string& name, bool chosen,
            bool enabled = true, bool scroll_to = false);

// A file that is to be written: what one has typed, from the folder where it begins.
struct Target {
  std::filesystem::path folder;
  std::string text;
  std::string armed;  // that this file may be replaced was said

  std::filesystem::path path() const;
  // What is wrong with it; empty: nothing.
  std::string wrong(const std::vector<std::string>& extensions) const;
  bool exists() const;
  // True: it may be written now. Otherwise it is there already, and the next press replaces it.
  bool confirm();
  bool asks() const { return !armed.empty() && armed == text; }
};
// What is wrong or will be replaced, and the buttons: the path when it is to be written now. `entered`: Enter was
// pressed in a field.
std::optional<std::filesystem::path> ask_to_save(Ui&, Target&, const std::string& wrong, bool entered);
// "~", and relative to the folder.
std::filesystem::path typed_path(const std::filesystem::path& folder, const std::string& text);
// The folder of what is open if one may write there, otherwise the working folder.
std::filesystem::path folder_to_save(const Player&);

}  // namespace blossom
