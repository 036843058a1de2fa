// Other programs' files, of the studio.
#include "exchange/format.hpp"
#include "player/player.hpp"

namespace blossom {
namespace {

std::string joined(std::string text, const std::vector<std::string>& notes) {
  for (const std::string& note : notes) text += "; " + printable(note);
  return text + ".";
}

}  // namespace

bool Player::import_file(const std::filesystem::path& file) {
  if (!in_studio()) return false;
  auto read = blossom::import_file(file);
  const std::string name = printable(file.filename().string());
  if (!read) {
    show_problems(name + " cannot be imported", std::move(read.diagnostics));
    return false;
  }
  Worked scene = studio_->workspace();
  const std::size_t first = scene->objects.size();
  for (SceneObject& object : read->objects) {
    object.color = static_cast<int>((scene->objects.size()) % object_colors);
    object.shows = usual_shows(object.geometry);
    scene = edit::add(std::move(*scene), std::move(object));
    if (!scene) break;
  }
  if (!studio_->edit(std::move(scene), "import " + name)) {
    show_problems(name + " cannot be imported", studio_->problems());
    return false;
  }
  const std::size_t count = studio_->workspace().objects.size() - first;
  studio_->choose(first);
  studio_->fit();
  notice(joined(std::to_string(count) + (count == 1 ? " thing" : " things") + " imported", read->notes));
  return true;
}

bool Player::export_file(const std::filesystem::path& file, bool only_chosen) {
  if (!in_studio()) return false;
  ExportOptions options;
  if (only_chosen) options.objects = studio_->chosen();
  auto notes = blossom::export_file(studio_->workspace(), file, options);
  const std::string name = printable(file.filename().string());
  if (!notes) {
    show_problems(name + " cannot be written", std::move(notes.diagnostics));
    return false;
  }
  notice(joined(name + " is written", *notes));
  return true;
}

}  // namespace blossom
