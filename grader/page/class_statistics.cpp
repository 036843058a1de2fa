#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <tuple>

#include "grader/lesson_grader.hpp"
#include "grader/page/class_figures.hpp"
#include "grader/page/class_page.hpp"
#include "grader/result.hpp"

namespace blossom {
namespace {

constexpr std::size_t rows_of_a_page = 1000;
constexpr std::size_t most_listed = 100;
constexpr std::size_t most_items = 10'000;
constexpr std::size_t most_mistakes = 1000;
constexpr std::size_t longest_kept = 200;  // bytes of an example's text

std::string text_of(const Json& json, std::string_view key) {
  const Json* found = json.find(key);
  return found != nullptr && found->kind == Json::Kind::string ? found->text : std::string();
}
double number_of(const Json& json, std::string_view key) {
  const Json* found = json.find(key);
  const double x = found == nullptr ? 0 : std::strtod(found->text.c_str(), nullptr);
  return std::isfinite(x) ? x : 0;
}
bool flag_of(const Json& json, std::string_view key) {
  const Json* found = json.find(key);
  return found != nullptr && found->boolean;
}
const std::vector<Json>& items_of(const Json& json, std::string_view key) {
  static const std::vector<Json> none;
  const Json* found = json.find(key);
  return found != nullptr && found->kind == Json::Kind::array ? found->items : none;
}

std::optional<Verdict> verdict_of(const Json& part) {
  const std::string word = text_of(part, "verdict");
  for (std::size_t v = 0; v < verdict_count; ++v)
    if (verdict_name(static_cast<Verdict>(v)) == word) return static_cast<Verdict>(v);
  return std::nullopt;
}

// An answer on one line: the numbers as they were typed, whatever they were wrapped in.
std::string flat(const Json& json) {
  std::string text;
  std::vector<const Json*> open{&json};
  while (!open.empty() && text.size() <= longest_kept) {
    const Json* at = open.back();
    open.pop_back();
    if (at->items.empty() && !at->text.empty()) text += (text.empty() ? "" : ", ") + at->text;
    for (std::size_t i = at->items.size(); i-- > 0;) open.push_back(&at->items[i]);
  }
  return json.kind == Json::Kind::array || json.kind == Json::Kind::object ? "(" + text + ")" : text;
}

std::string cut(std::string text) {
  if (text.size() > longest_kept) {
    std::size_t end = longest_kept;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
    text.resize(end);
    text += "…";
  }
  return text;
}

// FNV-1a, 64 bits, with a finishing mix: two sets of answers of a class of a million meet by accident once in 10^7 such
// classes.
class Hash {
 public:
  void add(std::string_view text) {
    for (const char c : text) step(static_cast<unsigned char>(c));
    step(0xFF);  // no byte of UTF-8: "ab", "c" is not "a", "bc"
  }
  std::uint64_t value() const {
    std::uint64_t h = hash_ ^ (hash_ >> 33);
    h *= 0xff51afd7ed558ccdULL;
    return h ^ (h >> 33);
  }

 private:
  void step(unsigned char byte) { hash_ = (hash_ ^ byte) * 0x100000001b3ULL; }
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

}  // namespace

void Correlation::add(double x, double y) {
  ++count_;
  const auto n = static_cast<double>(count_);
  const double dx = x - mean_x_, dy = y - mean_y_;
  mean_x_ += dx / n;
  mean_y_ += dy / n;
  xx_ += dx * (x - mean_x_);
  yy_ += dy * (y - mean_y_);
  xy_ += dx * (y - mean_y_);
}

double Correlation::value() const { return std::clamp(xy_ / std::sqrt(xx_ * yy_), -1.0, 1.0); }

double ClassFigures::quantile(double share) const {
  // Where the share falls between two scores it is their mean (Hyndman & Fan, 1996, definition 2).
  const double wanted = share * static_cast<double>(students);
  std::uint64_t before = 0;
  for (std::size_t i = 0; i <= fine_bins; ++i) {
    before += fine[i];
    if (before == 0 || static_cast<double>(before) < wanted) continue;
    std::size_t next = i;
    if (static_cast<double>(before) == wanted)
      for (next = i + 1; next < fine_bins && fine[next] == 0;) ++next;
    return static_cast<double>(i + next) / 2 / fine_bins;
  }
  return 0;
}

struct ClassStatistics::Figures {
  Figures(std::string title, Write writer, const Assignment* assignment) : write(std::move(writer)) {
    figures.title = std::move(title);
    if (assignment == nullptr) return;
    for (const Assignment::Item& item : assignment->items) {
      algorithms[item.exercise.id] = item.exercise.run.algorithm;
      for (const Part& part : item.exercise.parts)
        if (part.question) questions[{item.exercise.id, part.name}] = cut(plain_text(read_prose(part.question->ask)));
    }
  }

  ClassFigures figures;
  Write write;
  std::vector<StudentRow> rows;
  std::size_t pages = 0;
  std::map<std::pair<std::size_t, std::string>, std::size_t> item_of;
  std::map<std::string, std::size_t> exercise_of;
  std::map<std::string, const Algorithm*> algorithms;                    // by exercise
  std::map<std::pair<std::string, std::string>, std::string> questions;  // of lessons, by exercise and ID

  struct Share {
    std::size_t item;
    double share, points, max_points;
  };

  std::size_t exercise(const std::string& id) {
    const auto [at, is_new] = exercise_of.emplace(id, figures.exercises.size());
    if (is_new) {
      figures.exercises.push_back(id);
      figures.handed_in.push_back(0);
    }
    return at->second;
  }

  const Algorithm* algorithm(const std::string& exercise) const {
    const auto found = algorithms.find(exercise);
    return found == algorithms.end() ? nullptr : found->second;
  }

  std::optional<std::size_t> item(std::size_t exercise, const std::string& value) {
    const auto found = item_of.find({exercise, value});
    if (found != item_of.end()) return found->second;
    if (figures.items.size() == most_items) {
      figures.all_items = false;
      return std::nullopt;
    }
    item_of[{exercise, value}] = figures.items.size();
    const std::string& id = figures.exercises[exercise];
    const auto question = questions.find({id, value});
    figures.items.push_back(
        {id, value, algorithm(id), {}, {}, question == questions.end() ? std::string() : question->second});
    return figures.items.size() - 1;
  }

  MistakeFigures* mistake(const std::string& word) {
    if (!figures.mistakes.contains(word) && figures.mistakes.size() == most_mistakes) return nullptr;
    return &figures.mistakes[word];
  }

  void look_at(WorthList& list, Worth worth) const {
    if (++list.count <= most_listed) list.first.push_back(std::move(worth));
  }

  void add_exercise(const Json& made, const StudentRow& row, std::vector<Share>& shares, std::set<std::string>& shown) {
    const std::size_t at = exercise(text_of(made, "exercise"));
    const Json* grade = made.find("grade");
    if (grade == nullptr) return;
    ++figures.handed_in[at];
    const std::string reason = text_of(*grade, "reason");
    const double points_of_grade = number_of(*grade, "max_points");
    const double scale = points_of_grade > 0 ? number_of(made, "max_points") / points_of_grade : 0;
    const bool varies = flag_of(made, "varies");
    std::vector<std::string> alike;
    std::size_t answered = 0, wrong = 0;
    bool all_right = true;
    std::set<std::string> reasons;  // of what is wrong
    for (const Json& part : items_of(*grade, "parts")) {
      const auto verdict = verdict_of(part);
      if (!verdict) continue;
      const std::string value = text_of(part, "value"), note = text_of(part, "note"),
                        misconception = text_of(part, "misconception");
      const double most = number_of(part, "max_points"), points = number_of(part, "points");
      const Json* answer = part.find("answer");
      if (const auto i = item(at, value)) {
        ++figures.items[*i].verdicts[static_cast<std::size_t>(*verdict)];
        if (most > 0 && reason.empty()) shares.push_back({*i, points / most, points * scale, most * scale});
      }
      if (!reason.empty()) continue;
      answered += answer != nullptr ? 1 : 0;
      if (*verdict == Verdict::wrong || *verdict == Verdict::slip || *verdict == Verdict::misconception) {
        ++wrong;
        reasons.insert(misconception.empty() ? note : misconception);
      }
      count_mistake(misconception.empty() ? note : misconception, row, text_of(made, "exercise"), part, answer, shown);
      const bool own_mistake = *verdict == Verdict::wrong || (*verdict == Verdict::slip && misconception.empty());
      if (answer == nullptr) continue;
      all_right = all_right && *verdict == Verdict::correct;
      // Where everybody has the same numbers, right answers are the same.
      if (varies || own_mistake) alike.push_back(value + " = " + flat(*answer));
    }
    explain(*grade, row, text_of(made, "exercise"), answered, wrong, reasons, shown);
    if (alike.size() < (varies ? 2u : 3u)) return;
    std::ranges::sort(alike);
    Hash hash;
    hash.add(text_of(made, "exercise"));
    for (const std::string& each : alike) hash.add(each);
    figures.fingerprints.add({hash.value(), at, varies, all_right}, row.id, row.page);
  }

  void count_mistake(const std::string& word, const StudentRow& row, const std::string& exercise, const Json& part,
                     const Json* answer, std::set<std::string>& shown) {
    if (word.empty()) return;
    MistakeFigures* counted = mistake(word);
    if (counted == nullptr) return;
    ++counted->values;
    if (shown.insert(word).second) ++counted->students;
    if (!counted->example.student.empty() || answer == nullptr) return;
    // Of what the student was told, the right value: the advice is the same for everybody.
    const std::string told = text_of(part, "feedback");
    const std::size_t right = told.rfind("Right is ");
    counted->example = {cut(row.id),        row.page,
                        exercise,           text_of(part, "value"),
                        cut(flat(*answer)), right == std::string::npos ? std::string() : cut(told.substr(right)),
                        algorithm(exercise)};
  }

  void explain(const Json& grade, const StudentRow& row, const std::string& exercise, std::size_t answered,
               std::size_t wrong, const std::set<std::string>& reasons, std::set<std::string>& shown) {
    // One slip, or several of one kind, is an explanation, too.
    static const std::set<std::string, std::less<>> no_reason{"", "unknown", "trivial"};
    if (reasons.size() == 1 && !no_reason.contains(*reasons.begin())) {
      if (MistakeFigures* counted = mistake(*reasons.begin())) ++counted->explains;
      return;
    }
    const Json* explanation = grade.find("explanation");
    if (explanation == nullptr) return;
    const auto& held = items_of(*explanation, "misconceptions");
    const bool covers = number_of(*explanation, "covered") >= number_of(*explanation, "wrong");
    for (const Json& id : held) {
      MistakeFigures* counted = mistake(id.text);
      if (counted == nullptr) continue;
      counted->explains += covers ? 1 : 0;
      if (shown.insert(id.text).second) ++counted->students;
    }
    if (held.empty() && wrong >= 3 && 5 * wrong >= 4 * answered)
      look_at(figures.unexplained, {row.id, row.page, exercise,
                                    std::to_string(wrong) + " of " + std::to_string(answered) +
                                        " answers are wrong, and no known mistake explains them"});
  }

  void add_shares(const std::vector<Share>& shares) {
    double points = 0, most = 0;
    for (const Share& share : shares) points += share.points, most += share.max_points;
    for (const Share& share : shares) {
      const double rest = most - share.max_points;
      // What an item says of everything else: alone, it says nothing.
      figures.items[share.item].with_rest.add(share.share, rest > 1e-9 ? (points - share.points) / rest : 0);
    }
  }

  void add_incidents(const Json& result, StudentRow& row) {
    std::set<std::string> kinds;
    for (const Json& incident : items_of(result, "incidents")) {
      const std::string kind = text_of(incident, "kind");
      ++figures.incidents[kind];
      kinds.insert(kind);
      if (kind == "late" || kind == "missing" || kind == "duplicate") continue;  // ordinary, and counted
      look_at(figures.unread, {row.id, row.page, text_of(incident, "exercise"),
                               told(kind, text_of(incident, "source"), text_of(incident, "text"))});
    }
    if (kinds.contains("late")) ++figures.late;
    for (const std::string& kind : kinds) row.flags += (row.flags.empty() ? "" : ", ") + incident_words(kind);
  }

  static std::string told(std::string_view kind, std::string_view source, std::string_view text) {
    return incident_words(kind) + (source.empty() ? "" : ", " + cut(printable(source))) + ": " + cut(std::string(text));
  }

  void flush(bool is_last) {
    ++pages;
    write("class/" + std::to_string(pages) + ".html", class_table_html(figures, rows, pages, is_last));
    rows.clear();
  }
};

ClassStatistics::ClassStatistics(std::string title, Write write, const Assignment* assignment)
    : figures_(std::make_unique<Figures>(std::move(title), std::move(write), assignment)) {}
ClassStatistics::~ClassStatistics() = default;

void ClassStatistics::add(const Json& result, std::string_view page) {
  Figures& f = *figures_;
  ClassFigures& all = f.figures;
  if (f.rows.size() == rows_of_a_page) f.flush(false);
  StudentRow row;
  if (const Json* student = result.find("student")) {
    row.id = text_of(*student, "id");
    row.name = text_of(*student, "name");
    row.section = text_of(*student, "section");
  }
  row.page = page;
  row.points = number_of(result, "points");
  row.max_points = number_of(result, "max_points");
  if (all.assignment.empty()) all.assignment = text_of(result, "assignment");
  f.add_incidents(result, row);

  std::vector<Figures::Share> shares;
  std::set<std::string> shown;
  bool any = false;
  for (const Json& made : items_of(result, "exercises")) {
    any = any || made.find("grade") != nullptr;
    row.days_late = std::max(row.days_late, static_cast<int>(std::clamp(number_of(made, "days_late"), 0.0, 1e6)));
    f.add_exercise(made, row, shares, shown);
  }
  f.add_shares(shares);

  const double score = std::clamp(number_of(result, "score"), 0.0, 1.0);
  ++all.students;
  all.with_work += any ? 1 : 0;
  all.sum_of_scores += score;
  ++all.histogram[std::min(histogram_bins - 1, static_cast<std::size_t>(score * histogram_bins + 1e-9))];
  ++all.fine[static_cast<std::size_t>(std::lround(score * fine_bins))];
  f.rows.push_back(std::move(row));
}

void ClassStatistics::add_stray(std::string_view kind, std::string_view who, std::string_view source,
                                std::string_view text) {
  ClassFigures& all = figures_->figures;
  ++all.incidents[std::string(kind)];
  figures_->look_at(all.unread, {cut(printable(who)), {}, {}, Figures::told(kind, source, text)});
}

void ClassStatistics::finish() {
  Figures& f = *figures_;
  if (f.pages > 0 && !f.rows.empty()) f.flush(true);
  f.write("class.html", class_html(f.figures, f.rows, f.pages));
}

std::string ClassStatistics::json() const { return class_json(figures_->figures); }

// ---- identical answers ----------------------------------------------------------------------------------------------

namespace {

constexpr std::size_t most_entries = 2'000'000;
constexpr std::size_t most_id_bytes = 32u << 20;
constexpr std::size_t most_patterns = 0xFFFF;
constexpr std::size_t most_groups = 100;
constexpr std::size_t most_named = 12;  // of a group
constexpr std::uint16_t varies_bit = 0x8000;
constexpr std::uint16_t right_bit = 0x4000;

}  // namespace

void Fingerprints::add(const Answers& answers, std::string_view id, std::string_view page) {
  if (entries_.size() == most_entries || ids_.size() + id.size() >= most_id_bytes || answers.exercise >= right_bit) {
    complete_ = false;
    return;
  }
  const auto at = static_cast<std::uint32_t>(ids_.size());
  ids_ += id;
  ids_ += '\0';
  const unsigned bits = (answers.varies ? varies_bit : 0u) | (answers.right ? right_bit : 0u);
  entries_.push_back({answers.hash, at, static_cast<std::uint16_t>(answers.exercise | bits), pattern_of(id, page)});
}

std::uint16_t Fingerprints::pattern_of(std::string_view id, std::string_view page) {
  const std::string name = file_name_of(id);
  const std::size_t at = page.rfind(name);
  if (page.empty() || at == std::string_view::npos) return 0;
  const std::pair<std::string, std::string> pattern{page.substr(0, at), page.substr(at + name.size())};
  const auto found = std::ranges::find(patterns_, pattern);
  if (found != patterns_.end()) return static_cast<std::uint16_t>(found - patterns_.begin());
  if (patterns_.size() > most_patterns) return 0;
  patterns_.push_back(pattern);
  return static_cast<std::uint16_t>(patterns_.size() - 1);
}

std::string Fingerprints::page_of(const Entry& entry) const {
  if (entry.page == 0) return {};
  return patterns_[entry.page].first + file_name_of(id_of(entry)) + patterns_[entry.page].second;
}

std::vector<Fingerprints::Group> Fingerprints::groups(const std::vector<std::uint64_t>& handed_in) {
  const auto is_right = [](const Entry& entry) { return (entry.exercise & right_bit) != 0; };
  std::ranges::sort(entries_, [&](const Entry& a, const Entry& b) {
    return std::tuple(a.hash, !is_right(a), a.id_at) < std::tuple(b.hash, !is_right(b), b.id_at);
  });
  std::vector<Group> groups;
  std::vector<std::uint32_t> order;  // of each group: where its first student stands in the class
  for (std::size_t i = 0; i < entries_.size();) {
    std::size_t end = i + 1;
    while (end < entries_.size() && entries_[end].hash == entries_[i].hash) ++end;
    const std::size_t exercise = entries_[i].exercise & static_cast<std::uint16_t>(right_bit - 1);
    const bool varies = (entries_[i].exercise & varies_bit) != 0;
    const std::size_t size = end - i;
    std::size_t right = 0;
    while (right < size && is_right(entries_[i + right])) ++right;
    // Where the numbers are everybody's, what more than 2 % have in common is a mistake that the exercise invites.
    const std::size_t rare = std::max<std::size_t>(3, static_cast<std::size_t>(handed_in[exercise] / 50));
    if (size > 1 && right < size && (varies || size <= rare)) {
      Group group{exercise, varies, size, right, {}};
      for (std::size_t j = i; j < std::min(end, i + most_named); ++j)
        group.students.emplace_back(id_of(entries_[j]), page_of(entries_[j]));
      const auto at = std::ranges::upper_bound(order, entries_[i].id_at) - order.begin();
      order.insert(order.begin() + at, entries_[i].id_at);
      groups.insert(groups.begin() + at, std::move(group));
      if (groups.size() > most_groups) {
        groups.pop_back();
        order.pop_back();
      }
    }
    i = end;
  }
  return groups;
}

// ---- words ----------------------------------------------------------------------------------------------------------

std::string incident_words(std::string_view kind) {
  static const std::map<std::string_view, std::string_view> titles{{"late", "late"},
                                                                   {"missing", "nothing handed in"},
                                                                   {"duplicate", "handed in more than once"},
                                                                   {"unreadable", "not readable"},
                                                                   {"misplaced", "for no exercise of this assignment"},
                                                                   {"foreign-id", "names another author"},
                                                                   {"unlisted", "from nobody on the roster"},
                                                                   {"failed", "the grader failed"},
                                                                   {"refused", "not read from its archive or folder"}};
  const auto found = titles.find(kind);
  return std::string(found == titles.end() ? kind : found->second);
}

std::string mistake_title(std::string_view word) {
  for (const Algorithm* algorithm : algorithms())
    for (const Misconception& m : algorithm->misconceptions)
      if (m.id == word) return std::string(m.title);
  static const std::map<std::string_view, std::string_view> notes{
      {"sign", "a sign is wrong"},
      {"all-signs", "all signs are wrong"},
      {"coordinates", "coordinates are exchanged"},
      {"digits", "digits are transposed"},
      {"arithmetic", "a slip of arithmetic: one number is off where the rule was right"},
      {"rounded", "rounded: the right value in fewer digits than are asked"},
      {"trivial", "earlier values leave nothing to compute"},
      {"letter-case", "no answer: its name is typed with other capital or small letters"},
      {"unknown", "wrong for no known reason"}};
  const auto found = notes.find(word);
  return std::string(found == notes.end() ? word : found->second);
}

}  // namespace blossom
