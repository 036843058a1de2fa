#pragma once
// A subcommand of `blossom` is one file that defines `const Command& command_NAME()`.

#include <CLI/CLI.hpp>
#include <string_view>
#include <vector>

namespace blossom {

// Exit statuses, the same for all our programs.
enum Exit { done = 0, input_at_fault = 1, wrong_usage = 2, machine_at_fault = 3 };

struct Command {
  std::string_view name;
  std::string_view summary;
  int order;  // where it stands in --help
  // Adds its options to the parser and, as callback, what it does; the callback stores the exit status.
  void (*set_up)(CLI::App&, int& status);
};

const std::vector<const Command*>& commands();

}  // namespace blossom
