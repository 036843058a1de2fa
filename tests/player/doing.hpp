#pragma once
// What tests of the player do again and again, and ask of it.

#include <catch2/catch.hpp>
#include <fstream>

#include "player/desk.hpp"
#include "player/state.hpp"

namespace blossom::test {

namespace fs = std::filesystem;

inline const fs::path de_boor = "tests/play/data/22-de-boor.json";

inline std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  INFO("no " << from << " in\n" << text);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

inline void open(Player& player, const fs::path& file) {
  const bool opened = player.open(fs::absolute(file));
  INFO(to_string(player.problems().list));
  REQUIRE(opened);
}

inline std::string state(Player& player, const std::string& key) {
  const auto is = state_of(player, key);
  INFO("no " << key);
  REQUIRE(is);
  return *is;
}

inline void go_to(Player& player, const std::string& value) {
  const auto v = player.session()->recording().graph().find(value);
  INFO(value);
  REQUIRE(v);
  player.seek(player.session()->recording().graph().value(*v).step);
}

// What the step makes.
inline std::string made(const Player& player) {
  const TraceGraph& graph = player.session()->recording().graph();
  const ValueId v = graph.main_value(player.session()->step());
  return v == absent ? "" : graph.name(v);
}

inline bool set_u(Player& player, const Exact& u, const std::string& gesture = {}) {
  return player.edit(set_number(player.session()->algorithm(), player.session()->inputs(), "u", u), "u", gesture);
}

inline bool move(Player& player, std::size_t point, int x, int y, const std::string& gesture = {}) {
  return player.edit(move_point(player.session()->algorithm(), player.session()->inputs(), {"curve", 0, point},
                                Point<Exact>(Exact(x), Exact(y), Exact(0))),
                     "move a point", gesture);
}

inline void let_pass(Player& player, double seconds) {
  for (double t = 0; t < seconds; t += 0.1) player.advance(0.1);
}

inline Link link_to(const Player& player, const std::string& value) {
  return {Link::Kind::value, player.session()->recording().graph().find(value).value()};
}

}  // namespace blossom::test
