#pragma once
// What a lesson calls by its id, the lessons before it and its exercises, by number and title.

#include <filesystem>
#include <string>
#include <string_view>

#include "lesson/links.hpp"

namespace blossom {

struct StoryLink {
  std::string id, number, title;  // without a file of this id there is no title
  std::string page;               // what the file of its page is called, without its extension; empty: none

  // "22 De Boor's algorithm", or the id.
  std::string words() const { return title.empty() ? id : number + (number.empty() ? "" : " ") + title; }
};

// "22" of "22-de-boor"; empty if a file's name does not begin so.
std::string file_number(const std::string& stem);

// The titles that files have: those beside a lesson's file, then those of the course that comes with the program.
class CourseTitles {
 public:
  // `pages`: the lessons of the lesson's own folder have pages beside each other. A lesson without a file has no
  // folder.
  CourseTitles(const std::filesystem::path& lesson, const CourseFolders& course, bool pages);

  StoryLink lesson(const std::string& id, std::string_view language) const;
  StoryLink exercise(const std::string& id, std::string_view language) const;
  bool pages() const { return pages_; }

 private:
  CourseIndex index_;
  std::vector<std::filesystem::path> lessons_, exercises_;  // folders, in the order in which they are asked
  bool pages_;
};

}  // namespace blossom
