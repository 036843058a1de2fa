// `blossom`: trace, draw, check and step through the algorithms of curves and surfaces.

#include <algorithm>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "base/diagnostics.hpp"

int main(int argc, char** argv) {
  CLI::App app(
      "Blossom steps through the algorithms of curves and surfaces: every value, where it comes from, and why.\n"
      "Start with `blossom list`, then `blossom trace 11-de-casteljau` and `blossom play 11-de-casteljau`.",
      "blossom");
  app.require_subcommand(1);
  app.set_version_flag("--version", BLOSSOM_VERSION);
  app.failure_message([](const CLI::App* root, const CLI::Error& error) {
    const auto given = root->get_subcommands();
    return "blossom: " + blossom::printable(error.what()) + "\nTry `blossom " +
           (given.empty() ? "" : given[0]->get_name() + " ") + "--help`.\n";
  });

  int status = blossom::done;
  auto ordered = blossom::commands();
  std::ranges::sort(ordered, {}, [](const blossom::Command* c) { return std::pair(c->order, c->name); });
  for (const blossom::Command* command : ordered) {
    CLI::App* sub = app.add_subcommand(std::string(command->name), std::string(command->summary));
    command->set_up(*sub, status);
  }

  // CLI11 would say of a mistyped command only that one is required.
  if (argc > 1 && argv[1][0] != '-') {
    std::vector<std::string> names;
    for (const blossom::Command* command : ordered) names.emplace_back(command->name);
    if (std::ranges::find(names, argv[1]) == names.end()) {
      std::cerr << "blossom: there is no command " << blossom::excerpt(argv[1]);
      if (const auto near = blossom::did_you_mean(argv[1], names)) std::cerr << "; did you mean \"" << *near << "\"?";
      std::cerr << "\nTry `blossom --help`.\n";
      return blossom::wrong_usage;
    }
  }

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    status = app.exit(error) == 0 ? blossom::done : blossom::wrong_usage;
  } catch (const std::exception& error) {  // out of memory, out of threads: the machine, not the input
    std::cerr << "blossom: " << blossom::printable(error.what()) << "\n";
    return blossom::machine_at_fault;
  }
  std::cout.flush();
  if (!std::cout) {
    std::cerr << "blossom: the output cannot be written\n";
    return blossom::machine_at_fault;
  }
  return status;
}
