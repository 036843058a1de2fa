#pragma once
// A player for tests: with a desk that only notes what is put on it, and a place of its own to remember things.

#include "player/player.hpp"
#include "scratch.hpp"

namespace blossom::test {

class FakeDesk final : public Desk {
 public:
  void set_clipboard(const std::string& copied) override { text = copied; }
  std::string clipboard() override { return text; }
  bool choose_file(bool, const std::filesystem::path&, std::function<void(std::filesystem::path)>) override {
    return false;
  }
  Checked<bool> save_picture(const Scene&, const std::filesystem::path& file) override {
    pictures.push_back(file);
    return true;
  }

  std::string text;
  std::vector<std::filesystem::path> pictures;
};

inline PlayerOptions options_in(const Scratch& scratch, bool watch = false) {
  return {{scratch / "config", scratch / "state"}, "lessons", "exercises", watch};
}

struct World {
  explicit World(bool watch = false) : player_(std::make_unique<Player>(options_in(scratch, watch), desk)) {}
  Player& player() { return *player_; }

  Scratch scratch;
  FakeDesk desk;

 private:
  std::unique_ptr<Player> player_;
};

}  // namespace blossom::test
