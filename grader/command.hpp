#pragma once
// A subcommand of `blossom-grade` is one file commands/NAME.cpp that defines `const GradeCommand& command_NAME()`.
// `blossom-grade EXERCISE ANSWERS...` without a subcommand's name is the subcommand `grade`.

#include <CLI/CLI.hpp>
#include <string_view>
#include <vector>

#include "base/exit.hpp"

namespace blossom {

struct GradeCommand {
  std::string_view name;
  std::string_view summary;
  int order;  // where it stands in --help
  // Adds its options to the parser and, as callback, what it does; the callback stores the exit status.
  void (*set_up)(CLI::App&, int& status);
};

const std::vector<const GradeCommand*>& grade_commands();

}  // namespace blossom
