#pragma once
// What the start page shows: the shipped lessons and exercises, loaded one after the other in the background so that
// the window is there at once.

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

#include "player/document.hpp"
#include "scene/recording.hpp"
#include "studio/workspace.hpp"

namespace blossom {

struct ShelfItem {
  std::filesystem::path file;
  std::string id, title, unit, summary;
  std::string number;     // of the course, as its file's name begins: "22"; may be empty
  std::string elsewhere;  // its titles in other languages, one below the other
  Document::Kind kind = Document::Kind::lesson;
  int minutes = 0;
  std::vector<std::string> exercises;          // ids, of a lesson
  std::shared_ptr<const Recording> recording;  // for the thumbnail; in decimals
  std::uint32_t telling_step = 0;              // whose picture tells most: the last of the triangle; a surface's last
};

// A scene of the folder "scenes" beside the lessons.
struct ShelfScene {
  std::filesystem::path file;
  std::shared_ptr<const Workspace> workspace;
};

class Shelf {
 public:
  // Begins to load; the folders may be missing. Other files in them than lessons, exercises and scenes are passed over.
  Shelf(std::filesystem::path lessons, std::filesystem::path exercises);
  ~Shelf();  // stops soon
  Shelf(const Shelf&) = delete;
  Shelf& operator=(const Shelf&) = delete;

  std::vector<std::shared_ptr<const ShelfItem>> items() const;  // those loaded so far, lessons first, by file name
  std::vector<ShelfScene> scenes() const;                       // by file name
  Diagnostics diagnostics() const;                              // of files that are damaged
  bool done() const;
  std::uint64_t version() const;  // grows with every file and at the end: whether to draw anew
  void wait();                    // until all are loaded

 private:
  void load(const std::stop_token&, const std::filesystem::path& lessons, const std::filesystem::path& exercises);
  mutable std::mutex mutex_;
  std::condition_variable loaded_;
  void load_scenes(const std::stop_token&, const std::filesystem::path& folder);
  std::vector<std::shared_ptr<const ShelfItem>> items_;
  std::vector<ShelfScene> scenes_;
  Diagnostics diagnostics_;
  std::uint64_t version_ = 0;
  bool done_ = false;
  std::jthread thread_;  // last: it uses all of the above
};

}  // namespace blossom
