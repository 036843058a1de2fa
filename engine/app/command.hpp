#pragma once
// A subcommand of `blossom` is one file that defines `const Command& command_NAME()`.

#include <CLI/CLI.hpp>
#include <string_view>
#include <vector>

#include "base/exit.hpp"

namespace blossom {

struct Command {
  std::string_view name;
  std::string_view summary;
  int order;  // where it stands in --help
  // Adds its options to the parser and, as callback, what it does; the callback stores the exit status.
  void (*set_up)(CLI::App&, int& status);
};

const std::vector<const Command*>& commands();

}  // namespace blossom
