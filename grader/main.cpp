// blossom-grade: grades answers to exercises on the algorithms of curves and surfaces, one file or a whole class.

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <vector>

#include "base/diagnostics.hpp"
#include "grader/command.hpp"

namespace {

using namespace blossom;

int run(int argc, char** argv) {
  CLI::App app(
      "blossom-grade grades answers to exercises on the algorithms of curves and surfaces.\n"
      "`blossom-grade EXERCISE ANSWERS...` is short for `blossom-grade grade EXERCISE ANSWERS...`.",
      "blossom-grade");
  app.require_subcommand(1);
  app.set_version_flag("--version", BLOSSOM_VERSION);
  app.failure_message([](const CLI::App* root, const CLI::Error& error) {
    const auto given = root->get_subcommands();
    return "blossom-grade: " + printable(error.what()) + "\nTry `blossom-grade " +
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
  const bool asks_about_all = arguments.empty() || arguments[0] == "--help" || arguments[0] == "-h" ||
                              arguments[0] == "--version";
  if (!names_command && !asks_about_all) arguments.insert(arguments.begin(), "grade");
  std::ranges::reverse(arguments);  // as CLI11 takes them
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
