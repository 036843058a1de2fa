// blossom new: a lesson or an exercise that works, to begin with.

#include <algorithm>
#include <array>
#include <iostream>

#include "app/input.hpp"
#include "base/utf8.hpp"
#include "lesson/document.hpp"
#include "lesson/starter.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

struct Given {
  std::string what;
  std::string algorithm;
  std::string out;
  std::string language = "en";
  bool force = false;
};

// A letter with an accent in the letters that an id may have; empty: any other character.
std::string_view plain_letters(std::string_view letter) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 14> groups{{{"äÄæÆ", "ae"},
                                                                                         {"öÖœŒøØ", "oe"},
                                                                                         {"üÜ", "ue"},
                                                                                         {"ß", "ss"},
                                                                                         {"áàâãåÁÀÂÃÅ", "a"},
                                                                                         {"çčćÇČĆ", "c"},
                                                                                         {"éèêëěÉÈÊËĚ", "e"},
                                                                                         {"íìîïÍÌÎÏ", "i"},
                                                                                         {"ñńÑŃ", "n"},
                                                                                         {"óòôõÓÒÔÕ", "o"},
                                                                                         {"úùûůÚÙÛŮ", "u"},
                                                                                         {"ýÿÝ", "y"},
                                                                                         {"šśŠŚ", "s"},
                                                                                         {"žźżŽŹŻ", "z"}}};
  for (const auto& [letters, plain] : groups)
    if (letters.find(letter) != std::string_view::npos) return plain;
  return {};
}

// "05-De_Boor.json" is about "de-boor", "Übung 1.json" about "uebung-1".
std::string id_of(const fs::path& file) {
  std::string id;
  const std::string stem = file.stem().string();
  for (std::size_t i = 0; i < stem.size();) {
    const std::size_t length = std::max<std::size_t>(utf8_length(stem, i), 1);
    const char c = stem[i];
    const char small = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c == '_' || c == ' ' ? '-' : c;
    if (('a' <= small && small <= 'z') || ('0' <= small && small <= '9') || small == '-')
      id += small;
    else if (length > 1)
      id += plain_letters(std::string_view(stem).substr(i, length));
    i += length;
  }
  const std::size_t number = std::min(id.find_first_not_of("0123456789"), id.size());
  if (number < id.size() && id[number] == '-') id.erase(0, number + 1);
  return id.empty() ? "my-lesson" : id.substr(0, 64);
}

// Where the JSON Schema is, from the file's folder; empty if it is not found.
std::string schema_beside(const fs::path& file, const std::string& what) {
  const fs::path schema = find_folder(what + "s") / (what + ".schema.json");
  std::error_code error;
  if (!fs::exists(schema, error)) return {};
  const fs::path folder = file.parent_path().empty() ? fs::path(".") : file.parent_path();
  const fs::path relative = fs::proximate(schema, folder, error);
  return error ? std::string() : relative.generic_string();
}

const Algorithm& known_algorithm(const std::string& id) {
  if (const Algorithm* algorithm = find_algorithm(id)) return *algorithm;
  throw CLI::ValidationError("--algorithm", no_such_algorithm(id));
}

void say_what_next(const Given& given, const std::string& file) {
  std::cout << "Written: " << printable(file) << "\n\nNext:\n"
            << "  blossom lint " << printable(file) << "    names every mistake, at its line and column\n";
  if (given.what == "lesson")
    std::cout << "  blossom play " << printable(file) << "    shows it, and again whenever you save it\n"
              << "  blossom export " << printable(file) << " --to html    one page for a browser\n";
  else
    std::cout << "  blossom-grade " << printable(file) << " ANSWERS...    grades what is handed in\n";
}

int make(Given given) {
  const Algorithm& algorithm = known_algorithm(given.algorithm);
  if (given.out.empty()) {
    given.out = "my-" + std::string(algorithm.id) + (given.what == "exercise" ? "-exercise" : "") + ".json";
    std::ranges::replace(given.out, '_', '-');
  }
  const bool to_terminal = given.out == "-";
  std::error_code error;
  if (!to_terminal && !given.force && fs::exists(given.out, error))
    return report({{given.out, 0, 0, "", "is there already; --force writes over it, --out names another file"}});
  const auto inputs = starting_inputs(algorithm, find_folder("lessons"));
  if (!inputs) return report(inputs.diagnostics);
  Start start{to_terminal ? "my-" + given.what : id_of(given.out), given.language,
              to_terminal ? std::string() : schema_beside(given.out, given.what)};
  const std::string text = given.what == "lesson" ? starting_lesson(algorithm, *inputs, start)
                                                  : starting_exercise(algorithm, *inputs, start);
  if (to_terminal) {
    std::cout << text;
    return done;
  }
  if (const auto written = write_file(given.out, text); !written) {
    report(written.diagnostics);
    return machine_at_fault;
  }
  say_what_next(given, given.out);
  return done;
}

void set_up(CLI::App& app, int& status) {
  auto given = std::make_shared<Given>();
  app.add_option("WHAT", given->what, "lesson or exercise")->required()->check(CLI::IsMember({"lesson", "exercise"}));
  app.add_option("--algorithm", given->algorithm,
                 "What it is about; `blossom list` has all of them, and `blossom describe ALGORITHM` tells about one")
      ->required();
  app.add_option(
      "--out", given->out,
      "The file to write, by default my-de-boor.json for de_boor (my-de-boor-exercise.json for an exercise); - "
      "is standard output");
  app.add_option("--language", given->language, "The language it will be written in, such as de")
      ->check([](const std::string& name) {
        const bool fits = (name.size() == 2 || name.size() == 3) &&
                          std::ranges::all_of(name, [](char c) { return 'a' <= c && c <= 'z'; });
        return fits ? std::string() : excerpt(name) + " is no language such as en or de";
      })
      ->capture_default_str();
  app.add_flag("--force", given->force, "Write over a file that is there");
  app.footer(
      "The file works as it is, and says in comments what each of its parts is for. Its inputs are those of a lesson\n"
      "about the algorithm, if there is one.\n"
      "Examples:\n"
      "  blossom new lesson --algorithm de_boor --out lessons/95-my-de-boor.json\n"
      "  blossom new exercise --algorithm knot_insertion --out exercises/95-insert.json\n"
      "Exit status: 0 written, 1 the file is there already, 2 wrong usage, 3 it cannot be written.");
  app.callback([given, &status] { status = make(*given); });
}

}  // namespace

const Command& command_new() {
  static const Command command{"new", "Start a lesson or an exercise: a file that works, with comments", 35, set_up};
  return command;
}

}  // namespace blossom
