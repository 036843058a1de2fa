#include <algorithm>
#include <cmath>
#include <tuple>

#include "grader/page/assets.hpp"
#include "grader/page/class_figures.hpp"
#include "grader/page/html.hpp"
#include "grader/page/run_html.hpp"
#include "grader/page/student_page.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_hard_cells = 12;
constexpr std::size_t most_item_rows = 500;
constexpr std::size_t most_mistake_rows = 40;

std::string count_text(std::uint64_t n) { return std::to_string(n); }
std::string counted(std::uint64_t n, std::string_view one, std::string_view many) {
  return std::to_string(n) + " " + std::string(n == 1 ? one : many);
}
std::string two_decimals(double x) { return format_short(std::abs(x) < 0.005 ? 0 : x, 2); }

// A path that a student's ID is part of, as a link: file_name_of leaves %XX in it, which a link means otherwise.
std::string link(std::string_view page, std::string_view text, std::string_view up = "") {
  if (page.empty()) return html_escape(text);
  std::string href(up);
  for (const char c : page) {
    if (c == '%')
      href += "%25";
    else
      href += c;
  }
  return "<a href=\"" + html_escape(href) + "\">" + html_escape(text) + "</a>";
}

std::string head(const ClassFigures& figures, const std::string& title) {
  return page_head(title, std::string(assets::page_css) + std::string(assets::class_css)) + "<header>\n<div><h1>" +
         html_escape(title) + "</h1><p class=\"who\">" + html_escape(figures.assignment) + "</p></div>\n";
}

// ---- the histogram --------------------------------------------------------------------------------------------------

std::string histogram(const ClassFigures& figures) {
  constexpr int width = 760, height = 240, left = 10, base = 200, top = 28;
  const std::uint64_t most = std::max<std::uint64_t>(1, *std::ranges::max_element(figures.histogram));
  const double step = double(width - 2 * left) / histogram_bins;
  std::string svg = "<div class=\"scroll\"><svg class=\"chart\" viewBox=\"0 0 " + std::to_string(width) + " " +
                    std::to_string(height) +
                    "\" role=\"img\" aria-label=\"Histogram of scores; the numbers stand in the table below\">\n";
  std::string rows;
  for (std::size_t i = 0; i < histogram_bins; ++i) {
    const double x = left + step * static_cast<double>(i);
    const std::uint64_t n = figures.histogram[i];
    const double tall = static_cast<double>(n) / static_cast<double>(most) * (base - top);
    const int from = static_cast<int>(i * 100 / histogram_bins), to = static_cast<int>((i + 1) * 100 / histogram_bins);
    const std::string range = std::to_string(from) + "–" + std::to_string(to) + " %";
    if (n > 0) {
      svg += "<rect class=\"bar\" x=\"" + format_short(x + 2, 1) + "\" y=\"" + format_short(base - tall, 1) +
             "\" width=\"" + format_short(step - 4, 1) + "\" height=\"" + format_short(tall, 1) + "\"><title>" + range +
             ": " + count_text(n) + "</title></rect>\n";
      svg += "<text class=\"count\" x=\"" + format_short(x + step / 2, 1) + "\" y=\"" +
             format_short(base - tall - 5, 1) + "\">" + count_text(n) + "</text>\n";
    }
    rows += "<tr><th scope=\"row\">" + range + "</th><td class=\"number\">" + count_text(n) + "</td></tr>\n";
  }
  svg += "<line class=\"axis\" x1=\"" + std::to_string(left) + "\" x2=\"" + std::to_string(width - left) + "\" y1=\"" +
         std::to_string(base) + "\" y2=\"" + std::to_string(base) + "\"/>\n";
  for (int percent = 0; percent <= 100; percent += 20)
    svg += "<text class=\"tick\" x=\"" + format_short(left + (width - 2.0 * left) * percent / 100, 1) + "\" y=\"" +
           std::to_string(base + 22) + "\"" +
           (percent == 0     ? " style=\"text-anchor:start\""
            : percent == 100 ? " style=\"text-anchor:end\""
                             : "") +
           ">" + std::to_string(percent) + " %</text>\n";
  svg += "</svg></div>\n";
  return svg +
         "<details><summary>As a table</summary><table class=\"narrow\"><thead><tr><th scope=\"col\">Score</th><th "
         "scope=\"col\">Students</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></details>\n";
}

// ---- cells ----------------------------------------------------------------------------------------------------------

std::uint64_t total(const ItemFigures& item) {
  std::uint64_t sum = 0;
  for (const std::uint64_t n : item.verdicts) sum += n;
  return sum;
}

// One bar, as wide as all answers, of the verdicts in their order; each is named by its pattern and in its title.
std::string verdict_bar(const ItemFigures& item) {
  const auto all = static_cast<double>(std::max<std::uint64_t>(1, total(item)));
  std::string svg = "<svg class=\"verdicts\" viewBox=\"0 0 300 20\" preserveAspectRatio=\"none\" aria-hidden=\"true\">";
  double x = 0;
  for (std::size_t v = 0; v < verdict_count; ++v) {
    const double wide = 300 * static_cast<double>(item.verdicts[v]) / all;
    if (wide > 0)
      svg += "<rect class=\"v-" + std::string(verdict_name(static_cast<Verdict>(v))) + "\" x=\"" + format_short(x, 2) +
             "\" y=\"0\" width=\"" + format_short(wide, 2) + "\" height=\"20\"/>";
    x += wide;
  }
  return svg + "</svg>";
}

std::string verdict_heads() {
  std::string text;
  for (std::size_t v = 0; v < verdict_count; ++v) {
    const auto verdict = static_cast<Verdict>(v);
    text += "<th scope=\"col\" class=\"number\"><span class=\"key v-" + std::string(verdict_name(verdict)) +
            "\"></span>" + std::string(sign_of(verdict).word) + "</th>";
  }
  return text;
}

std::string verdict_counts(const ItemFigures& item) {
  std::string text;
  for (const std::uint64_t n : item.verdicts)
    text += "<td class=\"number" + std::string(n == 0 ? " zero" : "") + "\">" + count_text(n) + "</td>";
  return text;
}

// As the student's page has it; the name that is typed is its title.
std::string value_name(const std::string& name, const Algorithm* algorithm) {
  return "<span class=\"value\" title=\"" + html_escape(name) + "\">" +
         (algorithm != nullptr ? math_html(name, *algorithm) : "<code>" + html_escape(name) + "</code>") + "</span>";
}

std::string item_name(const ClassFigures& figures, const ItemFigures& item) {
  const std::string name = item.asked.empty() ? value_name(item.value, item.algorithm)
                                              : "<span class=\"asked\">" +
                                                    (item.algorithm != nullptr ? math_html(item.asked, *item.algorithm)
                                                                               : html_escape(item.asked)) +
                                                    "</span>";
  return "<th scope=\"row\">" + name + "<span class=\"quiet\"> " +
         (item.algorithm != nullptr ? "<code>" + html_escape(item.value) + "</code> " : "") +
         (figures.exercises.size() > 1 ? html_escape(item.exercise) : "") + "</span></th>";
}

std::string hardest(const ClassFigures& figures) {
  std::vector<const ItemFigures*> items;
  for (const ItemFigures& item : figures.items)
    if (item.with_rest.count() > 0) items.push_back(&item);
  if (items.empty()) return "<p class=\"note\">Nothing has been graded.</p>\n";
  std::ranges::stable_sort(items,
                           [](const auto* a, const auto* b) { return a->with_rest.mean_x() < b->with_rest.mean_x(); });
  if (items.size() > most_hard_cells) items.resize(most_hard_cells);
  std::string out =
      "<div class=\"scroll\"><table class=\"cells\"><thead><tr><th scope=\"col\">Value</th><th "
      "scope=\"col\" class=\"number\">Mean share</th><th scope=\"col\" class=\"wide\">Verdicts</th>" +
      verdict_heads() + "</tr></thead><tbody>\n";
  for (const ItemFigures* item : items)
    out += "<tr>" + item_name(figures, *item) + "<td class=\"number\">" + percent_text(item->with_rest.mean_x()) +
           "</td><td class=\"wide\">" + verdict_bar(*item) + "</td>" + verdict_counts(*item) + "</tr>\n";
  return out + "</tbody></table></div>\n";
}

std::string item_statistics(const ClassFigures& figures) {
  std::string out =
      "<p class=\"note\">Difficulty is the mean share of a value's points, of those who handed the exercise in: near 1 "
      "it "
      "was easy, near 0 hard. Discrimination is the correlation of that share with the share of all other points: from "
      "about 0.3 on, a value tells strong from weak students; near 0 it tells nothing; below 0 look at it, for those "
      "who "
      "are right otherwise get it wrong. “–”: nothing to correlate, as everybody has the same share.</p>\n"
      "<div class=\"scroll\"><table class=\"items\"><thead><tr><th scope=\"col\">Value</th><th scope=\"col\" "
      "class=\"number\">Students</th><th scope=\"col\" class=\"number\">Difficulty</th><th scope=\"col\" "
      "class=\"number\">Discrimination</th></tr></thead><tbody>\n";
  for (std::size_t i = 0; i < std::min(figures.items.size(), most_item_rows); ++i) {
    const ItemFigures& item = figures.items[i];
    const Correlation& c = item.with_rest;
    const bool doubtful = c.defined() && c.value() < 0 && c.count() >= 10;
    out += "<tr>" + item_name(figures, item) + "<td class=\"number\">" + count_text(c.count()) +
           "</td><td class=\"number\">" + (c.count() > 0 ? two_decimals(c.mean_x()) : "–") +
           "</td><td class=\"number\">" + (c.defined() ? two_decimals(c.value()) : "–") +
           (doubtful ? " <span class=\"sign wrong\">look at it</span>" : "") + "</td></tr>\n";
  }
  out += "</tbody></table></div>\n";
  if (figures.items.size() > most_item_rows || !figures.all_items)
    out += "<p class=\"note\">There are more values; summary.json has up to 10000 of them.</p>\n";
  return out;
}

// ---- mistakes -------------------------------------------------------------------------------------------------------

std::string mistakes(const ClassFigures& figures) {
  std::vector<std::pair<std::string, const MistakeFigures*>> all;
  for (const auto& [word, counted] : figures.mistakes) all.emplace_back(word, &counted);
  if (all.empty()) return "<p class=\"note\">No known mistakes were found.</p>\n";
  // The most frequent first; what has no known reason last, for it is no mistake of its own.
  const auto rank = [](const auto& entry) {
    return std::tuple(entry.first != "unknown", entry.second->students, entry.second->values);
  };
  std::ranges::stable_sort(all, [&](const auto& a, const auto& b) { return rank(a) > rank(b); });
  std::uint64_t most = 1;
  for (const auto& [word, counted] : all) most = std::max(most, counted->students);
  std::string out =
      "<p class=\"note\">Explained is a submission if all that is wrong in it comes of this mistake, alone or with one "
      "other; slips count as mistakes, too.</p>\n<div class=\"scroll\"><table class=\"mistakes\"><thead><tr><th "
      "scope=\"col\">Mistake</th><th "
      "scope=\"col\" class=\"number\">Students</th><th scope=\"col\" class=\"medium\"></th><th scope=\"col\" "
      "class=\"number\">Values</th><th scope=\"col\" class=\"number\">Submissions "
      "explained</th><th scope=\"col\">For example</th></tr></thead><tbody>\n";
  for (std::size_t i = 0; i < std::min(all.size(), most_mistake_rows); ++i) {
    const auto& [word, counted] = all[i];
    const Example& example = counted->example;
    out += "<tr><th scope=\"row\">" + html_escape(mistake_title(word)) + "<span class=\"quiet\"> " + html_escape(word) +
           "</span></th><td class=\"number\" data-label=\"Students\">" + count_text(counted->students) +
           "</td><td class=\"medium\"><svg class=\"verdicts\" viewBox=\"0 0 300 20\" preserveAspectRatio=\"none\" "
           "aria-hidden=\"true\"><rect "
           "class=\"bar\" x=\"0\" y=\"3\" height=\"14\" width=\"" +
           format_short(300 * static_cast<double>(counted->students) / static_cast<double>(most), 1) +
           "\"/></svg></td><td class=\"number\" data-label=\"Values\">" + count_text(counted->values) +
           "</td><td class=\"number\" data-label=\"Submissions explained\">" + count_text(counted->explains) +
           "</td><td class=\"example\">";
    if (!example.student.empty()) {
      out += link(example.page, example.student) + ", " + html_escape(example.exercise) + ": " +
             value_name(example.value, example.algorithm) + " = " + html_escape(example.answer);
      if (!example.told.empty())
        out +=
            "<span class=\"quiet\"> " +
            (example.algorithm != nullptr ? math_html(example.told, *example.algorithm) : html_escape(example.told)) +
            "</span>";
    }
    out += "</td></tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

// ---- worth a look ---------------------------------------------------------------------------------------------------

std::string worth_list(const WorthList& list, std::string_view title) {
  if (list.count == 0) return {};
  std::string out = "<h3>" + std::string(title) + " (" + count_text(list.count) + ")</h3>\n<ul class=\"worth\">\n";
  for (const Worth& worth : list.first)
    out += "<li>" + (worth.student.empty() ? "Nobody's" : link(worth.page, worth.student)) +
           (worth.exercise.empty() ? "" : " · " + html_escape(worth.exercise)) + ": " + html_escape(worth.why) +
           "</li>\n";
  out += "</ul>\n";
  if (list.count > list.first.size())
    out += "<p class=\"note\">And " + count_text(list.count - list.first.size()) +
           " more; results.jsonl and incidents.csv have them all.</p>\n";
  return out;
}

// The students from `begin` on: "s1, s2, …".
std::string names(const Fingerprints::Group& group, std::size_t begin, std::size_t end) {
  std::string out;
  for (std::size_t i = begin; i < std::min(end, group.students.size()); ++i)
    out += (i > begin ? ", " : "") + link(group.students[i].second, group.students[i].first);
  return out + (end > group.students.size() ? ", …" : "");
}

std::string alike(const ClassFigures& figures, const Fingerprints::Group& group) {
  const std::string exercise = html_escape(figures.exercises[group.exercise]);
  // Whose numbers fit may fill the whole list: then the count alone says that there are others.
  if (group.right > 0 && group.right < group.students.size()) {
    const std::string source = names(group, 0, group.right);
    return exercise + ": <strong>the answers of " + names(group, group.right, group.size) + " are those of " + source +
           "</strong>, which are right for " + (group.right == 1 ? source + "'s numbers" : "their numbers");
  }
  return exercise + ", " + counted(group.size, "student", "students") +
         (group.varies ? ", <strong>with different numbers</strong>" : "") + ": " + names(group, 0, group.size);
}

std::string worth_a_look(ClassFigures& figures) {
  std::string out;
  const auto groups = figures.fingerprints.groups(figures.handed_in);
  if (!groups.empty()) {
    out +=
        "<h3>The same answers (" + count_text(groups.size()) +
        ")</h3>\n<p class=\"note\">Several values, all wrong and all alike, that no known mistake explains; or, where "
        "everybody has numbers of their own, all answers alike, though they cannot follow from two exercises. That "
        "is a reason to look, not a proof.</p>\n<ul class=\"worth\">\n";
    for (const auto& group : groups) out += "<li>" + alike(figures, group) + "</li>\n";
    out += "</ul>\n";
  }
  if (!figures.fingerprints.complete())
    out += "<p class=\"note\">The class is so large that only its first part was searched for the same answers.</p>\n";
  out += worth_list(figures.unexplained, "Nearly everything wrong, for no known reason");
  out += worth_list(figures.unread, "Not read, or doubtful");
  return out.empty() ? "<p class=\"note\">Nothing stands out.</p>\n" : out;
}

// ---- students -------------------------------------------------------------------------------------------------------

std::string table(const std::vector<StudentRow>& rows, std::string_view up) {
  std::string out =
      "<div class=\"scroll\"><table class=\"students\"><thead><tr><th scope=\"col\">Student</th><th "
      "scope=\"col\">Name</th><th scope=\"col\">Section</th><th scope=\"col\" class=\"number\">Points</th><th "
      "scope=\"col\" class=\"number\">Days late</th><th scope=\"col\">To note</th></tr></thead><tbody>\n";
  for (const StudentRow& row : rows)
    out += "<tr><th scope=\"row\">" + link(row.page, row.id, up) + "</th><td>" + html_escape(row.name) + "</td><td>" +
           html_escape(row.section) + "</td><td class=\"number\">" + format_short(row.points, 2) + " / " +
           format_short(row.max_points, 2) + "</td><td class=\"number\">" +
           (row.days_late > 0 ? std::to_string(row.days_late) : "") + "</td><td>" + html_escape(row.flags) +
           "</td></tr>\n";
  return out + "</tbody></table></div>\n";
}

std::string incident_counts(const ClassFigures& figures) {
  std::string out;
  for (const auto& [kind, n] : figures.incidents)
    out += (out.empty() ? "" : ", ") + count_text(n) + " " + html_escape(incident_words(kind));
  return out.empty() ? out
                     : "<p class=\"note\">Incidents: " + out +
                           ". Each with its file is in <a href=\"incidents.csv\">incidents.csv</a>.</p>\n";
}

std::string figure(std::string_view name, const std::string& value) {
  return "<div><dt>" + std::string(name) + "</dt><dd>" + value + "</dd></div>";
}

std::string json_number_text(double x) { return format_number(std::isfinite(x) ? x : 0); }

}  // namespace

std::string class_html(ClassFigures& figures, const std::vector<StudentRow>& rows, std::size_t table_pages) {
  std::string out = head(figures, figures.title);
  const auto n = static_cast<double>(std::max<std::uint64_t>(1, figures.students));
  out += "<dl class=\"figures\">" + figure("Students", count_text(figures.students)) +
         figure("Handed in", count_text(figures.with_work)) + figure("Mean", percent_text(figures.sum_of_scores / n)) +
         figure("Median", percent_text(figures.quantile(0.5))) +
         figure("Middle half", percent_text(figures.quantile(0.25)) + " – " + percent_text(figures.quantile(0.75))) +
         "</dl>\n</header>\n<main>\n";
  const auto section = [&](std::string_view id, std::string_view title, const std::string& content) {
    out.append("<article id=\"").append(id).append("\">\n<h2>").append(title).append("</h2>\n").append(content);
    out += "</article>\n";
  };
  section("scores", "Scores", histogram(figures) + incident_counts(figures));
  section("cells", "Hardest values", hardest(figures));
  section("mistakes", "Mistakes", mistakes(figures));
  section("look", "Worth a look", worth_a_look(figures));
  section("items", "Item statistics", item_statistics(figures));
  std::string students;
  if (table_pages == 0) {
    students = table(rows, "");
  } else {
    students = "<p>In pages of 1000, in the order of the class:</p>\n<p class=\"pages\">";
    for (std::size_t i = 1; i <= table_pages; ++i)
      students += "<a href=\"class/" + std::to_string(i) + ".html\">" + std::to_string(i) + "</a> ";
    students += "</p>\n";
  }
  section("students", "Students", students);
  return out + "</main>\n</body>\n</html>\n";
}

std::string class_table_html(const ClassFigures& figures, const std::vector<StudentRow>& rows, std::size_t page,
                             bool is_last) {
  std::string out = head(figures, figures.title + ", students, page " + std::to_string(page)) + "</header>\n<main>\n";
  std::string pages = "<p class=\"pages\"><a href=\"../class.html\">The class</a> ";
  if (page > 1) pages += "<a rel=\"prev\" href=\"" + std::to_string(page - 1) + ".html\">Previous page</a> ";
  if (!is_last) pages += "<a rel=\"next\" href=\"" + std::to_string(page + 1) + ".html\">Next page</a>";
  pages += "</p>\n";
  return out + "<article>\n" + pages + table(rows, "../") + pages + "</article>\n</main>\n</body>\n</html>\n";
}

std::string class_json(ClassFigures& figures) {
  const auto n = static_cast<double>(std::max<std::uint64_t>(1, figures.students));
  std::string out = R"({"students":)" + count_text(figures.students) + R"(,"handed_in":)" +
                    count_text(figures.with_work) + R"(,"late":)" + count_text(figures.late) + R"(,"mean_score":)" +
                    json_number_text(figures.sum_of_scores / n) + R"(,"median_score":)" +
                    json_number_text(figures.quantile(0.5)) + R"(,"histogram":[)";
  for (std::size_t i = 0; i < histogram_bins; ++i) out += (i > 0 ? "," : "") + count_text(figures.histogram[i]);
  out += R"(],"items":[)";
  for (std::size_t i = 0; i < figures.items.size(); ++i) {
    const ItemFigures& item = figures.items[i];
    const Correlation& c = item.with_rest;
    out += (i > 0 ? "," : "") + (R"({"exercise":)" + json_quote(item.exercise)) + R"(,"value":)" +
           json_quote(item.value) + R"(,"difficulty":)" + (c.count() > 0 ? json_number_text(c.mean_x()) : "null") +
           R"(,"discrimination":)" + (c.defined() ? json_number_text(c.value()) : "null") + R"(,"verdicts":{)";
    for (std::size_t v = 0; v < verdict_count; ++v)
      out +=
          (v > 0 ? "," : "") + json_quote(verdict_name(static_cast<Verdict>(v))) + ":" + count_text(item.verdicts[v]);
    out += "}}";
  }
  out += R"(],"mistakes":[)";
  bool first = true;
  for (const auto& [word, counted] : figures.mistakes) {
    out += (first ? "" : ",") + (R"({"word":)" + json_quote(word)) + R"(,"students":)" + count_text(counted.students) +
           R"(,"values":)" + count_text(counted.values) + R"(,"explains":)" + count_text(counted.explains) + "}";
    first = false;
  }
  out += R"(],"alike":[)";
  first = true;
  for (const auto& group : figures.fingerprints.groups(figures.handed_in)) {
    out += (first ? "" : ",") + (R"({"exercise":)" + json_quote(figures.exercises[group.exercise])) + R"(,"varies":)" +
           (group.varies ? "true" : "false") + R"(,"students":)" + count_text(group.size) + R"(,"first":[)";
    for (std::size_t i = 0; i < group.students.size(); ++i)
      out += (i > 0 ? "," : "") + json_quote(group.students[i].first);
    out += "]}";
    first = false;
  }
  return out + R"(],"unexplained":)" + count_text(figures.unexplained.count) + "}";
}

}  // namespace blossom
