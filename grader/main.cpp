// blossom-grade: grades answers to exercises on the algorithms of curves and surfaces, one file or a whole class.

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <vector>

#include "base/diagnostics.hpp"
#include "grader/command.hpp"

namespace {

using namespace blossom;

// What was typed that means nothing, in the order it was typed in (CLI11's own message has it backwards), and the
// option that was probably meant.
std::string unexpected(const CLI::App& app) {
  std::vector<std::string> options;
  for (const CLI::App* command : app.get_subcommands())
    for (const CLI::Option* option : command->get_options())
      for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  std::string typed, meant;
  for (const std::string& argument : app.remaining(true)) {
    typed += (typed.empty() ? "" : " ") + argument;
    const auto near =
        argument.starts_with("--") ? did_you_mean(argument.substr(0, argument.find('=')), options) : std::nullopt;
    if (near && meant.empty()) meant = "; did you mean " + *near + "?";
  }
  return "not expected: " + typed + meant;
}

int run(int argc, char** argv) {
  CLI::App app(
      "blossom-grade grades answers to exercises on the algorithms of curves and surfaces.\n"
      "`blossom-grade EXERCISE ANSWERS...` is short for `blossom-grade grade EXERCISE ANSWERS...`.",
      "blossom-grade");
  app.require_subcommand(1);
  app.set_version_flag("--version", BLOSSOM_VERSION);
  app.failure_message([](const CLI::App* root, const CLI::Error& error) {
    const auto given = root->get_subcommands();
    const bool extra = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
    return "blossom-grade: " + printable(extra ? unexpected(*root) : error.what()) + "\nTry `blossom-grade " +
           (given.empty() ? "" : given[0]->get_name() + " ") + "--help`.\n";
  });
  int status = done;
  auto ordered = grade_commands();
  std::ranges::sort(ordered, {}, [](const GradeCommand* c) { return std::pair(c->order, c->name); });
  for (const GradeCommand* command : ordered)
    command->set_up(*app.add_subcommand(std::string(command->name), std::string(command->summary)), status);

  // What is no subcommand is the exercise of `grade`.
  std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool names_command =
      !arguments.empty() && std::ranges::any_of(ordered, [&](const auto* c) { return c->name == arguments[0]; });
  const bool asks_about_all =
      arguments.empty() || arguments[0] == "--help" || arguments[0] == "-h" || arguments[0] == "--version";
  if (!names_command && !asks_about_all && !std::filesystem::exists(arguments[0])) {
    std::vector<std::string> names;
    for (const GradeCommand* command : ordered) names.emplace_back(command->name);
    if (const auto near = did_you_mean(arguments[0], names)) {
      std::cerr << "blossom-grade: there is no command or file " << excerpt(arguments[0]) << "; did you mean \""
                << *near << "\"?\nTry `blossom-grade --help`.\n";
      return wrong_usage;
    }
  }
  if (!names_command && !asks_about_all) arguments.insert(arguments.begin(), "grade");
  std::ranges::reverse(arguments);  // parse() takes the first from the end
  try {
    app.parse(arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? done : wrong_usage;
  }
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("blossom-grade: out of memory\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "blossom-grade: %s\n", printable(error.what()).c_str());
  }
  return machine_at_fault;
}
