#include "export/html_course.hpp"

#include <algorithm>

#include "base/html.hpp"
#include "export/html_assets.hpp"
#include "export/html_canvas.hpp"
#include "export/html_document.hpp"
#include "export/page_words.hpp"

namespace blossom {
namespace {

std::string link_to(const StoryLink& link) {
  const std::string words = html_escape(link.words());
  return link.page.empty() ? words : "<a href=\"" + html_address(link.page + ".html") + "\">" + words + "</a>";
}

std::string entry(const CoursePage& page, const PageWords& words, const std::string& language) {
  std::string out = "<li" + (page.language != language ? " lang=\"" + html_escape(page.language) + "\"" : "") +
                    ">\n<h3>" + link_to(page.link) + "</h3>\n";
  if (!page.about.empty()) out += "<p>" + html_escape(plain_text(read_prose(page.about))) + "</p>\n";
  out += "<p class=\"quiet\">";
  if (page.minutes > 0) out += html_escape(words("duration", std::to_string(page.minutes))) + ", ";
  out += html_escape(page.steps == 1 ? std::string(words("onestep")) : words("allsteps", std::to_string(page.steps)));
  if (!page.prerequisites.empty()) {
    out += " · " + html_escape(words("before")) + ": ";
    for (std::size_t i = 0; i < page.prerequisites.size(); ++i)
      out += (i > 0 ? "; " : "") + link_to(page.prerequisites[i]);
  }
  return out + "</p>\n</li>\n";
}

// The language of most lessons.
std::string language_of(const std::vector<CoursePage>& pages) {
  std::string most = "en";
  std::ptrdiff_t count = 0;
  for (const CoursePage& page : pages) {
    const auto same = std::ranges::count(pages, page.language, &CoursePage::language);
    if (same > count) most = page.language, count = same;
  }
  return most;
}

}  // namespace

CoursePage course_page(const Story& story, const std::string& page) {
  return {{story.id, file_number(page), story.title, page},
          story.unit,
          story.language,
          !story.summary.empty() || story.objectives.empty() ? story.summary : story.objectives.front(),
          story.minutes,
          story.step_count(),
          story.prerequisites};
}

std::string html_course(const std::vector<CoursePage>& pages, const std::string& theme) {
  const std::string language = language_of(pages);
  const PageWords words(language);
  const std::string css = HtmlLooks().themes({}) + std::string(assets::page_css) + std::string(assets::course_css);
  const std::string title(words("lessons"));
  std::string out = "<!DOCTYPE html>\n<html lang=\"" + html_escape(language) + "\"";
  if (theme != light_theme().name) out += " data-theme=\"" + html_escape(theme) + "\"";
  out += ">\n" + html_head(title, {}, css, {}) + "<body>\n<header class=\"top\"><h1>" + html_escape(title) +
         "</h1></header>\n<main class=\"course\">\n";
  std::vector<std::string> units;
  for (const CoursePage& page : pages)
    if (std::ranges::find(units, page.unit) == units.end()) units.push_back(page.unit);
  for (const std::string& unit : units) {
    out += "<section>\n";
    if (!unit.empty()) out += "<h2>" + html_escape(unit) + "</h2>\n";
    out += "<ul>\n";
    for (const CoursePage& page : pages)
      if (page.unit == unit) out += entry(page, words, language);
    out += "</ul>\n</section>\n";
  }
  return out + "</main>\n</body>\n</html>\n";
}

}  // namespace blossom
