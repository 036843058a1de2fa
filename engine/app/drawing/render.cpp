// blossom render: the steps of an algorithm as pictures, or a scene of the studio as one.

#include <algorithm>
#include <iostream>

#include "app/input.hpp"
#include "app/page_look.hpp"
#include "app/progress.hpp"
#include "export/story.hpp"
#include "lesson/file_kind.hpp"
#include "render/lesson_theme.hpp"
#include "render/picture.hpp"
#include "scene/workspace_view.hpp"
#include "studio/scene_file.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

struct Options {
  SubjectOptions subject;
  int step = -1;
  bool all = false;
  bool svg = false;
  bool exact = false;
  std::string out = "out";
  std::string contact_sheet;
  PageLookOptions look;
  std::string context = "osmesa";
};

constexpr std::uint32_t most_on_sheet = 24;

std::string file_name(const std::string& stem, std::uint32_t step, std::uint32_t last, const char* extension) {
  std::string number = std::to_string(step);
  number.insert(0, std::to_string(last).size() - number.size(), '0');
  return stem + "-" + number + extension;
}

Checked<Story> story_of(const Subject& subject, bool exact) {
  StoryOptions options;
  options.language = subject.language;
  options.scene = subject.scene;
  options.exact = exact;
  auto story =
      subject.lesson ? make_story(*subject.lesson, options) : make_story(*subject.algorithm, subject.inputs, options);
  if (!story) return at_inputs(subject, story.diagnostics);
  return story;
}

int draw(const Subject& subject, const Options& options, const PageLook& look) {
  const auto story = story_of(subject, options.exact);
  if (!story) return report(story.diagnostics);
  const StoryScene& told = story->scenes.front();
  const std::uint32_t last = told.recording->last();

  std::vector<std::uint32_t> steps;
  if (options.step >= 0) {
    if (static_cast<std::uint32_t>(options.step) > last)
      return report({{"", 0, 0, "--step",
                      "must be from 0 to " + std::to_string(last) + ", not " + std::to_string(options.step)}});
    steps.push_back(static_cast<std::uint32_t>(options.step));
  } else if (options.all || !options.contact_sheet.empty()) {
    for (std::uint32_t step = 0; step <= last; ++step) steps.push_back(step);
  } else {
    steps.push_back(last);
  }

  // A sheet of hundreds of steps shows nothing: then it has the lesson's beats, or steps at equal distances.
  std::vector<std::uint32_t> on_sheet = steps;
  if (steps.size() > most_on_sheet) {
    on_sheet.clear();
    if (told.beats.size() > 1)
      for (const Beat& beat : told.beats) on_sheet.push_back(beat.step);
    else
      for (std::uint32_t i = 0; i < most_on_sheet; ++i) on_sheet.push_back(i * last / (most_on_sheet - 1));
  }
  if (!options.all && options.step < 0 && !options.contact_sheet.empty()) steps = on_sheet;

  std::error_code error;
  fs::create_directories(options.out, error);
  std::vector<Image> images;
  std::vector<std::string> captions;
  const bool each = options.step >= 0 || options.all || options.contact_sheet.empty();
  std::size_t written = 0;
  auto progress = std::make_optional<Progress>();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::uint32_t step = steps[i];
    const Scene scene = told.page(told.steps[step], story->title, look.width, look.height);
    const std::string title = story->title + ", step " + std::to_string(step);
    Checked<bool> saved = true;
    if (options.svg) {
      const auto text = draw_svg(scene, *look.theme);
      if (!text) return report(text.diagnostics);
      if (each) saved = write_file(fs::path(options.out) / file_name(story->id, step, last, ".svg"), *text);
    }
    if (!options.svg || !options.contact_sheet.empty()) {
      auto image = draw_image(scene, *look.theme, look.scale, options.context);
      if (!image) {
        report(image.diagnostics);
        return machine_at_fault;
      }
      if (each && !options.svg)
        saved = write_png(fs::path(options.out) / file_name(story->id, step, last, ".png"), *image, title,
                          scene.description);
      if (!options.contact_sheet.empty() && std::ranges::find(on_sheet, step) != on_sheet.end()) {
        images.push_back(std::move(*image));
        captions.push_back("step " + std::to_string(step));
      }
    }
    if (!saved) {
      report(saved.diagnostics);
      return machine_at_fault;
    }
    written += each ? 1 : 0;
    if (steps.size() > 1) progress->show(i + 1, steps.size());
  }
  progress.reset();
  if (!options.contact_sheet.empty()) {
    const auto fonts = Fonts::load();
    if (!fonts) {
      report(fonts.diagnostics);
      return machine_at_fault;
    }
    const int columns = images.size() < 5 ? 2 : (images.size() < 17 ? 3 : 4);
    const auto saved =
        write_png(options.contact_sheet, contact_sheet(**fonts, *look.theme, images, captions, columns, 560),
                  story->title + ": all steps");
    if (!saved) {
      report(saved.diagnostics);
      return machine_at_fault;
    }
  }
  if (written > 0)
    std::cout << written << (written == 1 ? " picture" : " pictures") << " in " << printable(options.out) << "\n";
  if (!options.contact_sheet.empty()) std::cout << "contact sheet: " << printable(options.contact_sheet) << "\n";
  return done;
}

// The scene of a file, if that is what the option names.
bool names_scene(const std::string& given) {
  std::error_code error;
  if (given.empty() || !fs::is_regular_file(given, error)) return false;
  const auto document = JsonDocument::load(given);
  return document && file_kind(document->root()) == FileKind::scene;
}

// One picture: into the file --out if it is called .png or .svg, or else into that folder.
int draw_scene(const Options& options, const PageLook& look) {
  const auto workspace = load_scene(options.subject.lesson);
  if (!workspace) return report(workspace.diagnostics);
  const std::string extension = fs::path(options.out).extension().string();
  const bool named = extension == ".png" || extension == ".svg";
  const bool svg = named ? extension == ".svg" : options.svg;
  fs::path file = options.out;
  if (!named) {
    std::error_code error;
    fs::create_directories(file, error);
    file /= (workspace->id.empty() ? fs::path(options.subject.lesson).stem().string() : workspace->id) +
            (svg ? ".svg" : ".png");
  }
  WorkspaceLook shown;
  if (workspace->objects.size() == 1) shown.current = 0;
  const Scene scene = WorkspaceScenes().page(*workspace, shown, look.width, look.height);
  Checked<bool> saved = true;
  if (svg) {
    const auto text = draw_svg(scene, *look.theme);
    if (!text) return report(text.diagnostics);
    saved = write_file(file, *text);
  } else {
    const auto image = draw_image(scene, *look.theme, look.scale, options.context);
    if (!image) {
      report(image.diagnostics);
      return machine_at_fault;
    }
    saved = write_png(file, *image, scene.title, scene.description);
  }
  if (!saved) {
    report(saved.diagnostics);
    return machine_at_fault;
  }
  std::cout << printable(file.string()) << "\n";
  return done;
}

int run(const Options& options) {
  Diagnostics mistakes;
  PageLook look = read_page_look(options.look, !options.svg || !options.contact_sheet.empty(), mistakes);
  if (!mistakes.empty()) {
    report(mistakes);
    return wrong_usage;
  }
  if (names_scene(options.subject.lesson)) return draw_scene(options, look);
  const auto subject = load_subject(options.subject);
  if (!subject) return report(subject.diagnostics);
  const Theme theme = with_colors(*look.theme, subject->lesson ? subject->lesson->colors : LessonColors());
  look.theme = &theme;
  return draw(*subject, options, look);
}

void set_up(CLI::App& app, int& status) {
  auto options = std::make_shared<Options>();
  add_subject_options(app, options->subject);
  auto* step = app.add_option("--step", options->step, "Only this step (from 0; by default the last one)")
                   ->check(CLI::Range(0, 1'000'000'000));
  app.add_flag("--all", options->all, "Every step, one file each")->excludes(step);
  app.add_option("--contact-sheet", options->contact_sheet, "All steps small in one PNG file");
  app.add_flag("--svg", options->svg, "SVG files instead of PNG");
  app.add_flag("--exact", options->exact, "Compute and label in exact fractions");
  app.add_option("--out", options->out, "The folder for the pictures; of a scene also a file, .png or .svg")
      ->capture_default_str();
  add_page_look_options(app, options->look);
  app.add_option("--context", options->context, "How OpenGL is reached without a display: osmesa or egl")
      ->check(CLI::IsMember({"osmesa", "egl"}))
      ->capture_default_str();
  app.footer(
      "Examples:\n"
      "  blossom render 22-de-boor --step 6 --exact\n"
      "  blossom render 22-de-boor --all --out pictures --theme dark\n"
      "  blossom render 22-de-boor --contact-sheet sheet.png\n"
      "  blossom render vase.json --out vase.svg     (a scene of the studio)\n"
      "Exit status: 0 done, 1 the input is at fault, 2 wrong usage, 3 the machine.");
  app.callback([options, &status] { status = run(*options); });
}

}  // namespace

const Command& command_render() {
  static const Command command{"render", "Draw the steps of an algorithm, or a scene: PNG, SVG, a contact sheet", 30,
                               set_up};
  return command;
}

}  // namespace blossom
