// blossom convert: between scenes and other programs' files.

#include <iostream>

#include "app/input.hpp"
#include "exchange/format.hpp"
#include "studio/scene_file.hpp"

namespace blossom {
namespace {

struct Wanted {
  std::string from, to;
  double tolerance = 0.1;
  int digits = 17;
};

bool is_scene(const std::filesystem::path& file) {
  if (file.extension() != ".json") return false;
  const auto document = JsonDocument::load(file);
  return document && document->root().kind == Json::Kind::object && document->root().find("objects") != nullptr;
}

void say(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) std::cerr << "note: " << printable(note) << "\n";
}

int convert_file(const Wanted& wanted) {
  const std::filesystem::path from = wanted.from, to = wanted.to;
  Workspace scene;
  if (is_scene(from)) {
    auto read = load_scene(from);
    if (!read) return report(read.diagnostics);
    scene = std::move(*read);
  } else {
    auto read = import_file(from);
    if (!read) return report(read.diagnostics);
    say(read->notes);
    scene.id = "imported";
    scene.title = from.stem().string();
    for (SceneObject& object : read->objects) {
      object.name = free_name(scene, object.name);
      object.color = static_cast<int>(scene.objects.size() % object_colors);
      object.shows = usual_shows(object.geometry);
      scene.objects.push_back(std::move(object));
    }
  }
  if (to.extension() == ".json" && scene.objects.size() != 1) {
    const auto written = write_file(to, write_scene(scene));
    return report(written.diagnostics);
  }
  ExportOptions options;
  options.tolerance = wanted.tolerance / 100;
  options.digits = wanted.digits;
  const auto notes = export_file(scene, to, options);
  if (!notes) return report(notes.diagnostics);
  say(*notes);
  return 0;
}

std::string formats() {
  std::string text = "Formats:\n  .json   a scene of the studio, or one curve, surface or points\n";
  for (const ExchangeFormat* format : exchange_formats()) {
    if (format->id == "json") continue;
    std::string name(format->extensions.front());
    name.resize(8, ' ');
    text += "  " + name + std::string(format->title) + ": " + std::string(format->holds) +
            (format->import == nullptr ? " (written only)" : "") + "\n";
  }
  return text +
         "\nExamples:\n  blossom convert lessons/scenes/vase.json vase.obj\n  blossom convert points.csv points.json";
}

void set_up(CLI::App& app, int& status) {
  auto wanted = std::make_shared<Wanted>();
  app.add_option("FROM", wanted->from, "What to read: a scene, or a file of another program")->required();
  app.add_option("TO", wanted->to, "What to write; its ending says the format")->required();
  app.add_option("--tolerance", wanted->tolerance, "Of triangles and lines, in percent of the size of all of it")
      ->check(CLI::Range(0.0001, 10.0))
      ->capture_default_str();
  app.add_option("--digits", wanted->digits, "Of numbers, where the format has text")
      ->check(CLI::Range(3, 17))
      ->capture_default_str();
  app.footer(formats());
  app.callback([wanted, &status] { status = convert_file(*wanted); });
}

}  // namespace

const Command& command_convert() {
  static const Command command{"convert", "Convert scenes to and from files of other programs", 60, set_up};
  return command;
}

}  // namespace blossom
