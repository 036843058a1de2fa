#pragma once
// Starts one of the built programs as a user would, and catches what it prints and how it ends.

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "scratch.hpp"

namespace blossom::test {
namespace fs = std::filesystem;

inline std::string read_all(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  REQUIRE(in);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

struct Ended {
  int status = -1;  // the exit status; 128 + the signal's number if one ended it
  std::string out, err;
};

struct Setting {
  std::string input = {};      // standard input
  std::string output_to = {};  // a file for standard output, instead of catching it
  std::string folder = {};     // to start in, instead of the root of the sources
};

// "blossom" or "blossom-grade" (or a file elsewhere), in the root of the sources, where `lessons` and `exercises` are.
inline Ended run_program(const std::string& program, std::vector<std::string> arguments, const Setting& setting = {}) {
  const Scratch scratch;
  const std::string in = scratch.write("in", setting.input), out = scratch / "out", err = scratch / "err";
  const std::string output = setting.output_to.empty() ? out : setting.output_to;
  arguments.insert(arguments.begin(), (fs::path(BLOSSOM_BIN_DIR) / program).string());
  std::vector<char*> argv;
  for (auto& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, in.c_str(), O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT, 0600);
  if (!setting.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, setting.folder.c_str());
  pid_t child = 0;
  const int failed = posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  INFO("cannot start " << argv[0]);
  REQUIRE(failed == 0);

  Ended ended;
  int how = 0;
  REQUIRE(waitpid(child, &how, 0) == child);
  ended.status = WIFEXITED(how) ? WEXITSTATUS(how) : 128 + WTERMSIG(how);
  if (setting.output_to.empty()) ended.out = read_all(out);
  ended.err = read_all(err);
  return ended;
}

inline Ended blossom(std::vector<std::string> arguments, const Setting& setting = {}) {
  return run_program("blossom", std::move(arguments), setting);
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace blossom::test

// Says all of it when a check fails.
#define SHOW(ended) \
  INFO("status " << (ended).status << "\n--- stdout\n" << (ended).out << "--- stderr\n" << (ended).err)
