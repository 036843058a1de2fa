// One page that needs nothing else and no network: it steps, plays, asks, prints and reads well aloud.
//
// Every word stands in the document, as a list of all steps, tables and code; the script (ask.js, show.js, page.js)
// shows one step at a time and draws its picture. The page runs nothing but that script and loads nothing: its policy
// names the script and the style sheet by their digests.

#include "base/json.hpp"
#include "export/export.hpp"
#include "export/html_assets.hpp"
#include "export/html_document.hpp"
#include "export/html_scene.hpp"
#include "export/html_text.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

std::string icon(std::string_view path) {
  return "<svg viewBox=\"0 0 24 24\" aria-hidden=\"true\"><path d=\"" + std::string(path) + "\"/></svg>";
}

class PageWriter {
 public:
  PageWriter(const Story& story, const HtmlPage& page, const LessonExportOptions& options)
      : story_(story), page_(page), words_(page.words), options_(options) {}

  std::string write(const std::vector<HtmlScene>& scenes) const {
    const std::string css = page_.looks.themes(story_.colors) + std::string(assets::page_css) + page_.looks.rules();
    const std::string script = std::string(assets::ask_js) + std::string(assets::show_js) +
                               std::string(assets::slide_js) + std::string(assets::page_js);
    std::string out = head(css, script);
    out += title() + "<main>\n" + about() + player();
    for (const HtmlScene& scene : scenes) out += scene.html;
    for (const HtmlScene& stop : page_.stops) out += stop.html;
    out += "</main>\n" + help();
    out += "<script type=\"application/json\" id=\"lesson\">" + script_json(data(scenes)) + "</script>\n";
    return out + "<script>" + script + "</script>\n</body>\n</html>\n";
  }

 private:
  std::string word(std::string_view key) const { return html_escape(words_(key)); }
  // Where the page's own words are in another language than the lesson's.
  std::string own_language() const {
    return words_.language() == story_.language ? "" : " lang=\"" + std::string(words_.language()) + "\"";
  }

  std::string head(const std::string& css, const std::string& script) const {
    std::string out = "<!DOCTYPE html>\n<html lang=\"" + html_escape(story_.language) + "\"";
    if (options_.theme->name != light_theme().name) out += " data-theme=\"" + html_escape(options_.theme->name) + "\"";
    out += ">\n" + html_head(story_.title, story_.summary, css, script);
    return out + "<body>\n";
  }

  std::string title() const {
    std::string out = "<header class=\"top\">\n<div>\n";
    if (!story_.unit.empty()) out += "<p class=\"unit\">" + html_escape(story_.unit) + "</p>\n";
    out += "<h1>" + html_escape(story_.title) + "</h1>\n</div>\n<div class=\"tools js\"" + own_language() +
           " hidden>\n<button type=\"button\" id=\"theme\" aria-label=\"" + word("theme") + "\" title=\"" +
           word("theme") + "\">" +
           "<svg viewBox=\"0 0 24 24\" aria-hidden=\"true\"><circle cx=\"12\" cy=\"12\" r=\"9\"/>"
           "<path class=\"half\" d=\"M12 3v18a9 9 0 0 0 0-18z\"/></svg></button>\n<button type=\"button\" id=\"help\" "
           "aria-label=\"" +
           word("help") + "\" title=\"" + word("help") + "\">?</button>\n</div>\n</header>\n";
    return out;
  }

  std::string about() const {
    std::string inside;
    if (!story_.summary.empty()) inside += "<p>" + html_escape(story_.summary) + "</p>\n";
    const Algorithm& algorithm = story_.scenes.front().recording->algorithm();
    const auto list = [&](std::string_view heading, const auto& items, const auto& written) {
      if (items.empty()) return;
      inside += "<h2>" + word(heading) + "</h2>\n<ul>\n";
      for (const auto& item : items) inside += "<li>" + written(item) + "</li>\n";
      inside += "</ul>\n";
    };
    list("objectives", story_.objectives,
         [&](const std::string& item) { return html_prose(read_prose(item), algorithm); });
    const auto linked = [](const StoryLink& link) {
      const std::string words = html_escape(link.words());
      return link.page.empty() ? words : "<a href=\"" + html_address(link.page + ".html") + "\">" + words + "</a>";
    };
    list("before", story_.prerequisites, linked);
    list("practise", story_.exercises, linked);
    if (!story_.source.empty())
      inside += "<h2>" + word("source") + "</h2>\n<p>" + html_escape(story_.source) + "</p>\n";
    if (story_.beside) inside += "<p><a href=\"index.html\">" + word("lessons") + "</a></p>\n";
    if (inside.empty()) return {};
    std::string summary = word("about");
    if (story_.minutes > 0) summary += " · " + filled(word("minutes"), "n", std::to_string(story_.minutes));
    return "<details class=\"about\">\n<summary>" + summary + "</summary>\n" + inside + "</details>\n";
  }

  std::string button(std::string_view go, std::string_view path, std::string_view style = "") const {
    return "<button type=\"button\" data-go=\"" + std::string(go) + "\"" +
           (style.empty() ? "" : " class=\"" + std::string(style) + "\"") + " aria-label=\"" + word(go) +
           "\" title=\"" + word(go) + "\">" + icon(path) + "</button>\n";
  }

  std::string player() const {
    std::string out;
    if (story_.scenes.size() > 1) {
      out += "<nav class=\"scenes js\" hidden aria-label=\"" + word("scenes") + "\">\n";
      for (std::size_t i = 0; i < story_.scenes.size(); ++i)
        out += "<button type=\"button\" data-scene=\"" + std::to_string(i) + "\"><b>" + std::to_string(i + 1) +
               "</b> " + html_escape(story_.scenes[i].heading) + "</button>\n";
      out += "</nav>\n";
    }
    out += "<section class=\"player js\" aria-label=\"" + word("player") + "\" hidden>\n";
    out += "<figure class=\"picture\"><svg role=\"img\" id=\"picture\"></svg></figure>\n";
    out +=
        "<div class=\"side\">\n<div class=\"told\" aria-live=\"polite\"><p class=\"phase\"></p><div class=\"say\">"
        "</div></div>\n<div class=\"sliders\" role=\"group\" aria-label=\"" +
        word("sliders") + "\" hidden></div>\n<div class=\"question\"></div>\n";
    const auto card = [&](std::string_view name) {
      out += "<section class=\"card " + std::string(name) + "\" hidden><h2" + own_language() + ">" + word(name) +
             "</h2><div></div></section>\n";
    };
    card("formula");
    out += "<section class=\"card scheme\" hidden><h2" + own_language() +
           "></h2><div class=\"scroll\" tabindex=\"0\">"
           "<div class=\"sheet\"></div></div></section>\n";
    card("code");
    out += "</div>\n<div class=\"more\">\n<figure class=\"knots card\" hidden><figcaption" + own_language() + ">" +
           word("knots") + "</figcaption><svg role=\"img\" id=\"knots\" aria-label=\"" + word("knots") +
           "\"></svg></figure>\n";
    out += "<div class=\"score\" hidden" + own_language() +
           "><output></output><span class=\"dots\"></span>"
           "<button type=\"button\" data-do=\"save\" class=\"main\">" +
           word("save") + "</button><button type=\"button\" data-do=\"forget\">" + word("forget") +
           "</button></div>\n</div>\n";
    return out + bar() + "</section>\n";
  }

  std::string bar() const {
    std::string out = "<div class=\"bar\" role=\"group\" aria-label=\"" + word("player") + "\"" + own_language() +
                      ">\n<div class=\"track\"><div class=\"marks\"></div><input type=\"range\" min=\"0\" "
                      "step=\"1\" value=\"0\" aria-label=\"" +
                      word("scrub") + "\"></div>\n";
    out += "<div class=\"buttons\">\n" + button("first", "M6 5v14M19 5l-9 7 9 7z") +
           button("beatback", "M12 6l-7 6 7 6zM19 6l-7 6 7 6z", "beats") + button("back", "M16 5l-9 7 9 7z") +
           "<button type=\"button\" data-go=\"play\" class=\"play\" aria-label=\"" + word("play") + "\" title=\"" +
           word("play") + "\">" +
           "<svg viewBox=\"0 0 24 24\" aria-hidden=\"true\"><path class=\"on\" d=\"M7 4l13 8-13 8z\"/>"
           "<path class=\"off\" d=\"M7 5h3v14H7zM14 5h3v14h-3z\"/></svg></button>\n" +
           button("next", "M8 5l9 7-9 7z") + button("beatnext", "M12 6l7 6-7 6zM5 6l7 6-7 6z", "beats") +
           button("last", "M18 5v14M5 5l9 7-9 7z") + "</div>\n";
    out += "<output class=\"where\"></output>\n<label class=\"speed\"><span>" + word("speed") +
           "</span> <select aria-label=\"" + word("speed") + "\">";
    for (const std::string_view speed : {"0.5", "1", "2", "4"})
      out += "<option value=\"" + std::string(speed) + "\"" + (speed == "1" ? " selected" : "") + ">" +
             std::string(speed) + "×</option>";
    return out + "</select></label>\n</div>\n";
  }

  std::string help() const {
    std::string out = "<dialog id=\"keys\"" + own_language() +
                      " aria-labelledby=\"keys-title\">\n<h2 id=\"keys-title\">" + word("help") + "</h2>\n<dl>\n";
    const auto row = [&](const std::string& key, std::string_view what) {
      out += "<dt>" + key + "</dt><dd>" + word(what) + "</dd>\n";
    };
    row("←, →", "keyarrows");
    row(word("ends"), "keyends");
    row(word("pages"), "keybeats");
    row(word("space"), "keyspace");
    if (!page_.stops.empty()) row("←, →", "keyslider");
    row("?", "keyhelp");
    row(word("swipe"), "keyarrows");
    return out + "</dl>\n<form method=\"dialog\"><button class=\"main\">" + word("close") +
           "</button></form>\n</dialog>\n";
  }

  std::string data(const std::vector<HtmlScene>& scenes) const {
    std::string out = "{\"id\":" + json_quote(story_.id) + ",\"words\":" + words_.json() + ",\n\"scenes\":[";
    for (std::size_t i = 0; i < scenes.size(); ++i) out += (i == 0 ? "" : ",\n") + scenes[i].json;
    out += "],\n\"stops\":[";
    for (std::size_t i = 0; i < page_.stops.size(); ++i) out += (i == 0 ? "" : ",\n") + page_.stops[i].json;
    out += "],\n\"elements\":[\n";
    for (std::size_t i = 0; i < page_.elements.size(); ++i) out += (i == 0 ? "" : ",\n") + page_.elements[i];
    return out + "]}";
  }

  const Story& story_;
  const HtmlPage& page_;
  const PageWords& words_;
  const LessonExportOptions& options_;
};

Checked<LessonExported> write(const Story& story, const fs::path& out, const LessonExportOptions& options) {
  const auto fonts = Fonts::load();
  if (!fonts) return fonts.diagnostics;
  SliderStops sliders(story);
  HtmlPage page{{}, PageWords(story.language), **fonts, sliders, options.checkpoints};
  std::vector<HtmlScene> scenes;
  std::size_t done = 0;
  const std::size_t count = story.step_count() + 2 * sliders.count();
  for (const StoryScene& scene : story.scenes) {
    auto made = html_scene(page, scene, scenes.size(), [&] { return report_progress(options, ++done, count); });
    if (!made) return stopped();
    scenes.push_back(*std::move(made));
  }
  if (const auto written = write_file(out, PageWriter(story, page, options).write(scenes)); !written)
    return written.diagnostics;
  return LessonExported{{out}, sliders.notes()};
}

}  // namespace

const LessonFormat& lesson_html() {
  static const LessonFormat format{
      "html", "Web page", ".html", false, "one self-contained page that steps, plays and asks", write};
  return format;
}

}  // namespace blossom
