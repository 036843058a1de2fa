#pragma once
// A subcommand of `blossom-grade` is one file commands/NAME.cpp that defines `const GradeCommand& command_NAME()`.
// `blossom-grade EXERCISE ANSWERS...` without a subcommand's name is the subcommand `grade`.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.hpp"
#include "base/exit.hpp"
#include "grader/time.hpp"

namespace blossom {

struct GradeCommand {
  std::string_view name;
  std::string_view summary;
  int order;  // where it stands in --help
  // Adds its options to the parser and, as callback, what it does; the callback stores the exit status.
  void (*set_up)(CLI::App&, int& status);
};

const std::vector<const GradeCommand*>& grade_commands();

// A check for an option that takes one of these words.
inline auto is_one_of(std::vector<std::string> words) {
  return [words = std::move(words)](const std::string& text) {
    if (std::ranges::find(words, text) != words.end()) return std::string();
    const auto near = did_you_mean(text, words);
    std::string known;
    for (const std::string& word : words) known += (known.empty() ? "" : ", ") + word;
    return excerpt(text) + " is none of " + known + (near ? "; did you mean " + *near + "?" : "");
  };
}

// A check for an option that takes a time.
inline std::string is_time(const std::string& text) { return parse_time(text) ? std::string() : time_problem(text); }

}  // namespace blossom
