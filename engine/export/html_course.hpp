#pragma once
// The list of a course's pages: its lessons by units, with what each needs and how long it takes.

#include <string>
#include <vector>

#include "export/story.hpp"

namespace blossom {

// A lesson whose page stands beside the list.
struct CoursePage {
  StoryLink link;
  std::string unit, language;
  std::string about;  // prose: the summary, or what is learned first
  int minutes = 0;
  std::size_t steps = 0;
  std::vector<StoryLink> prerequisites;
};
CoursePage course_page(const Story&, const std::string& page);  // the page's file without its extension

// A page like those of the lessons, without a script. In the order of the lessons; a unit stands where its first lesson
// does. The theme's name is that of the pages.
std::string html_course(const std::vector<CoursePage>&, const std::string& theme);

}  // namespace blossom
