// A file to open: typed with the folder's files to choose from, or one that was open before.
#include <algorithm>

#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_entries = 2000, most_recent_shown = 5;

struct Entry {
  std::string name;  // "..", "folder/", "file.json"
  fs::path path;
  bool is_folder = false;
};

struct Browser {
  fs::path folder;  // where what is typed begins
  std::string text;
  fs::path listed;  // whose entries these are
  std::vector<Entry> entries;
  int chosen = 0;
  std::string wrong;
  bool to_field = false;  // the keyboard goes there
  bool has_system_dialog = true;
};

std::vector<Entry> entries_of(const fs::path& folder) {
  std::vector<Entry> folders, files;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    std::error_code unknown;
    if (name.starts_with(".") || folders.size() + files.size() >= most_entries) continue;
    if (at->is_directory(unknown))
      folders.push_back({name + "/", at->path(), true});
    else if (at->path().extension() == ".json" && !name.ends_with(".schema.json"))
      files.push_back({name, at->path(), false});
  }
  std::ranges::sort(folders, {}, &Entry::name);
  std::ranges::sort(files, {}, &Entry::name);
  if (folder.has_parent_path() && folder != folder.root_path())
    folders.insert(folders.begin(), Entry{"..", folder.parent_path(), true});
  folders.insert(folders.end(), files.begin(), files.end());
  return folders;
}

fs::path without_slash(fs::path folder) {
  return folder.has_filename() || folder == folder.root_path() ? folder : folder.parent_path();
}

fs::path first_folder(const Player& player) {
  std::error_code error;
  if (player.session() != nullptr && !player.session()->document().file.empty())
    return player.session()->document().file.parent_path();
  if (player.in_studio() && !player.studio()->file().empty()) return player.studio()->file().parent_path();
  if (!player.settings.recent.empty() && fs::exists(player.settings.recent.front().parent_path(), error))
    return player.settings.recent.front().parent_path();
  return fs::current_path(error);
}

void enter(Browser& browser, const fs::path& folder) {
  std::error_code error;  // the folder one is in may be gone
  const fs::path whole = fs::absolute(folder, error);
  browser.folder = without_slash(error || whole.empty() ? fs::path("/") : whole.lexically_normal());
  browser.text.clear();
  browser.wrong.clear();
  browser.chosen = 0;
  browser.to_field = true;
}

void open_file(Ui& ui, const fs::path& file) {
  ui.send([file](Player& player) {
    player.cancel_dialog();
    player.open_asking(file);
  });
}

// The folder of what is typed, and what its entries are to have in them.
std::vector<const Entry*> matching(Browser& browser) {
  const std::size_t slash = browser.text.rfind('/');
  const bool in_other = slash != std::string::npos || browser.text == "~";
  const fs::path folder =
      in_other ? without_slash(typed_path(browser.folder, browser.text.substr(0, std::max<std::size_t>(slash, 1))))
               : browser.folder;
  const std::string filter =
      slash != std::string::npos ? browser.text.substr(slash + 1) : (in_other ? "" : browser.text);
  if (browser.listed != folder) {
    browser.entries = entries_of(folder);
    browser.listed = folder;
    browser.chosen = 0;
  }
  std::vector<const Entry*> found;
  for (const Entry& entry : browser.entries)
    if (entry.name == ".." ? filter.empty() : contains(entry.name, filter)) found.push_back(&entry);
  return found;
}

void take(Ui& ui, Browser& browser, const Entry& entry) {
  if (entry.is_folder)
    enter(browser, fs::path(entry.path));
  else
    open_file(ui, entry.path);
}

// Enter: what is typed if there is such a file or folder, otherwise what is chosen in the list.
void take_typed(Ui& ui, Browser& browser, const std::vector<const Entry*>& found) {
  std::error_code error;
  const fs::path typed = typed_path(browser.folder, browser.text);
  if (!browser.text.empty() && fs::is_directory(typed, error)) return enter(browser, typed);
  if (!browser.text.empty() && fs::exists(typed, error)) return open_file(ui, typed);
  if (!found.empty() && !(browser.text.empty() && found[static_cast<std::size_t>(browser.chosen)]->name == ".."))
    return take(ui, browser, *found[static_cast<std::size_t>(browser.chosen)]);
  browser.wrong = browser.text.empty() ? "Choose a file, or type its name." : "There is no such file here.";
}

int on_arrow(ImGuiInputTextCallbackData* data) {
  *static_cast<int*>(data->UserData) = data->EventKey == ImGuiKey_UpArrow ? -1 : 1;
  return 0;
}

void list_of_folder(Ui& ui, Browser& browser, const std::vector<const Entry*>& found, bool scroll) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool chosen = static_cast<int>(i) == browser.chosen;
    const Entry entry = *found[i];  // entering a folder makes another list
    const std::string label = entry.name == ".." ? ".. (the folder above)" : printable(entry.name);
    if (choice(ui, label, entry.is_folder ? "folder" : "", "file " + entry.name, chosen, true, chosen && scroll))
      return take(ui, browser, entry);
  }
  if (found.empty())
    quiet_text(ui, browser.text.empty() ? "There are no lessons here." : "Nothing here has this in its name.");
}

void list_of_recent(Ui& ui) {
  std::size_t shown = 0;
  std::error_code error;
  for (const fs::path& file : ui.player().settings.recent) {
    if (shown == most_recent_shown || !fs::exists(file, error)) continue;
    if (shown++ == 0) ui.heading("Open before");
    if (choice(ui, printable(file.filename().string()), printable(file.parent_path().string()),
               "recent " + file.stem().string(), false))
      open_file(ui, file);
  }
}

// The browser is the one there is: it is still there when the answer comes.
void system_dialog(Ui& ui, Browser& browser) {
  if (!browser.has_system_dialog) return;
  if (!ui.button("System's dialog ...", "dialog system", true, "The dialog for files that other programs show")) return;
  ui.send([&browser](Player& player) {
    browser.has_system_dialog = player.desk().choose_file(false, browser.folder / "", [&player](const fs::path& file) {
      if (file.empty()) return;
      player.cancel_dialog();
      player.open_asking(file);
    });
    if (!browser.has_system_dialog) browser.wrong = "This system has no dialog of its own.";
  });
}

void draw(Ui& ui) {
  static Browser browser;
  if (!begin_dialog(ui, "Open", 620)) return;
  if (dialog_opens()) {
    const bool has_system_dialog = browser.has_system_dialog;
    browser = {};
    browser.has_system_dialog = has_system_dialog;
    enter(browser, first_folder(ui.player()));
  }
  ImGui::TextDisabled(
      "in %s",
      shortened(printable(browser.folder.string()), ImGui::GetContentRegionAvail().x - ui.px(30), true).c_str());
  ui.thing("dialog folder");
  int moved = 0;
  if (std::exchange(browser.to_field, false)) ImGui::SetKeyboardFocusHere();
  const std::string before = browser.text;
  const bool entered =
      dialog_field(ui, "", "dialog open path", browser.text, true, "The name of a file, or a part of it",
                   ImGuiInputTextFlags_CallbackHistory, on_arrow, &moved);
  if (browser.text != before) browser.wrong.clear(), browser.chosen = 0;
  const auto found = matching(browser);
  browser.chosen = std::clamp(browser.chosen + moved, 0, std::max(static_cast<int>(found.size()) - 1, 0));

  std::size_t recent = std::min(ui.player().settings.recent.size(), most_recent_shown);
  const float row = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.y;
  float below = 2 * ImGui::GetFrameHeightWithSpacing() + ImGui::GetTextLineHeightWithSpacing() + ui.px(14);
  float lists = dialog_room(ui, below);
  const float recent_height =
      std::min(static_cast<float>(recent) * row + ImGui::GetTextLineHeightWithSpacing(), lists * 0.4f);
  lists = std::min(lists - (recent > 0 ? recent_height + ui.px(8) : 0), 9 * row);
  ImGui::BeginChild("files", {0, lists}, true, ImGuiWindowFlags_NavFlattened);
  list_of_folder(ui, browser, found, moved != 0 || browser.text != before);
  ImGui::EndChild();
  if (recent > 0) {
    ImGui::BeginChild("recent", {0, recent_height}, false, ImGuiWindowFlags_NavFlattened);
    list_of_recent(ui);
    ImGui::EndChild();
  }
  if (!browser.wrong.empty())
    dialog_warning(ui, browser.wrong);
  else
    quiet_text(ui, "A lesson, an exercise, a scene, a trace, a curve or a surface: files that end in .json.");
  system_dialog(ui, browser);
  const bool pressed = dialog_buttons(ui, "Open");
  if (entered || pressed) take_typed(ui, browser, found);
  browser.to_field = browser.to_field || entered;
  end_dialog();
}

bool is_relevant(const Player& player) { return player.dialog == Dialog::open; }

}  // namespace

const Panel& panel_dialog_open() {
  static const Panel panel{"open", "Open", Slot::float_, 55, draw, is_relevant};
  return panel;
}

}  // namespace blossom
