#include "grader/roster.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <span>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "base/json.hpp"
#include "base/utf8.hpp"
#include "grader/csv.hpp"

namespace blossom {
namespace {

// A gradebook that Canvas exports has a column for each assignment of the year.
constexpr CsvLimits limits{1u << 20, 4096};
// As a file name each byte of an ID may become three, and a file name has 255.
constexpr std::size_t most_id_bytes = 64;
constexpr std::size_t most_namesakes = 32;

enum Column : std::uint8_t { id, name, first_name, last_name, login, sis_id, lms_id, email, section, due, identifier };
constexpr std::size_t column_count = identifier + 1;

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return out;
}

// A cell without the blanks around it; control characters in it are blanks, too.
std::string clean(std::string_view cell) {
  std::string out;
  for (std::size_t i = 0; i < cell.size();) {
    const std::string_view character = cell.substr(i, std::max<std::size_t>(utf8_length(cell, i), 1));
    i += character.size();
    out += is_control(character) || character == "\xC2\xA0" ? " " : character;  // U+00A0, the no-break space
  }
  out.erase(out.find_last_not_of(' ') + 1);
  out.erase(0, out.find_first_not_of(' '));
  return out;
}

std::string normal(std::string_view title) {
  std::string out = lower(title);
  std::erase_if(out, [](char c) { return c == ' ' || c == '_' || c == '-' || c == '\t'; });
  return out;
}

// Where each known column is.
struct Columns {
  std::array<int, column_count> at;
  std::size_t count = 0;  // of all columns
  bool canvas = false;

  Columns() { at.fill(-1); }
  bool has(Column column) const { return at[column] >= 0; }
  std::string cell(const std::vector<std::string>& cells, Column column) const {
    const auto i = static_cast<std::size_t>(at[column]);
    return has(column) && i < cells.size() ? clean(cells[i]) : std::string();
  }
};

struct Title {
  std::string_view normal;
  Column column;
};
constexpr Title plain_titles[] = {{"id", id},
                                  {"name", name},
                                  {"fullname", name},
                                  {"student", name},
                                  {"firstname", first_name},
                                  {"lastname", last_name},
                                  {"surname", last_name},
                                  {"login", login},
                                  {"sisloginid", login},
                                  {"sisid", sis_id},
                                  {"sisuserid", sis_id},
                                  {"idnumber", sis_id},
                                  {"lmsid", lms_id},
                                  {"canvasid", lms_id},
                                  {"email", email},
                                  {"emailaddress", email},
                                  {"section", section},
                                  {"group", section},
                                  {"groups", section},
                                  {"due", due},
                                  {"identifier", identifier},
                                  {"username", login}};

Columns read_header(const std::vector<std::string>& cells, const std::string& file, int line, Diagnostics& mistakes) {
  Columns columns;
  columns.count = cells.size();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string title = normal(clean(cells[i]));
    const auto known = std::ranges::find(plain_titles, title, &Title::normal);
    if (known == std::end(plain_titles)) continue;
    int& at = columns.at[known->column];
    if (at >= 0)
      mistakes.push_back({file, line, 0, "",
                          "columns " + excerpt(cells[static_cast<std::size_t>(at)]) + " and " + excerpt(cells[i]) +
                              " mean the same; keep one of them"});
    else
      at = static_cast<int>(i);
    columns.canvas = columns.canvas || title == "sisuserid" || title == "sisloginid";
  }
  columns.canvas = columns.canvas && columns.has(id) && !columns.has(lms_id);
  if (!columns.has(id) && !columns.has(identifier) && !columns.has(login))
    mistakes.push_back({file, line, 0, "",
                        "missing column \"id\"; a roster has the columns id, name, login, sis id, lms id, email, "
                        "section and due, of which only id is needed, or is a file exported by Canvas or Moodle"});
  return columns;
}

// "4711" of "Participant 4711", in whatever language.
std::string participant(const std::string& text) {
  const std::size_t digits = text.find_last_not_of("0123456789") + 1;
  return digits < text.size() ? text.substr(digits) : text;
}

Student student_of(const Columns& columns, const std::vector<std::string>& cells, std::string* due_text = nullptr) {
  const auto cell = [&](Column column) { return columns.cell(cells, column); };
  Student student;
  student.id = cell(id);
  student.name = cell(name);
  if (student.name.empty()) {
    const std::string first = cell(first_name), last = cell(last_name);
    student.name = last + (first.empty() || last.empty() ? "" : ", ") + first;
  }
  student.login = cell(login);
  student.sis_id = cell(sis_id);
  student.lms_id = columns.canvas ? student.id : cell(lms_id);
  student.email = cell(email);
  student.section = cell(section);
  student.is_participant = columns.has(identifier) && student.lms_id.empty();
  if (student.is_participant) student.lms_id = participant(cell(identifier));
  if (!columns.has(id)) student.id = columns.has(login) ? student.login : student.lms_id;
  const std::string when = cell(due);
  student.due = parse_time(when);
  if (due_text != nullptr) *due_text = when;
  return student;
}

// Rows that Canvas puts among the students: what the assignments are worth, how they are posted, and the student whom
// teachers look through the eyes of.
bool is_no_student(const Columns& columns, const Student& student, const std::vector<std::string>& cells) {
  if (std::ranges::all_of(cells, [](const std::string& cell) { return clean(cell).empty(); })) return true;
  if (!columns.canvas) return false;
  return (student.id.empty() && (student.name.empty() || student.name == "Points Possible")) ||
         (student.name == "Student, Test" && student.sis_id.empty());
}

// The first 32 bits tell names apart that are to be compared; equal ones are always read again.
std::uint64_t hash(std::string_view folded) {
  std::uint64_t h = 0xcbf29ce484222325;  // FNV-1a
  for (const char c : folded) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  h ^= h >> 29;
  return (h * 0xbf58476d1ce4e5b9) >> 32 << 32;
}

std::array<std::string_view, 4> other_names(const Student& student) {
  return {student.login, student.sis_id, student.lms_id, student.email};
}

}  // namespace

struct Roster::Table {
  std::string file;
  int fd = -1;
  struct stat status {};
  char separator = ',';
  Columns columns;
  std::vector<std::uint64_t> rows;  // where each row is in the file: 40 bits of offset, 24 of length
  // Names, sorted: 32 bits of hash, 32 of row.
  std::vector<std::uint64_t> ids;
  std::vector<std::uint64_t> others;

  ~Table() {
    if (fd >= 0) ::close(fd);
  }

  // Room for all rows at once: growing bit by bit would take twice the memory for a while, and room that is never used
  // takes none.
  void reserve() {
    constexpr std::size_t most = 4'000'000;
    std::string chunk(64u << 10, '\0');
    std::size_t count = 1;
    for (off_t at = 0;;) {
      const ssize_t got = ::pread(fd, chunk.data(), chunk.size(), at);
      if (got <= 0) break;
      count += static_cast<std::size_t>(std::count(chunk.data(), chunk.data() + got, '\n'));
      at += got;
    }
    count = std::min(count, most);
    rows.reserve(count);
    ids.reserve(count);
    std::size_t others_each = 0;
    for (const Column column : {login, sis_id, lms_id, email, identifier}) others_each += columns.has(column) ? 1 : 0;
    others.reserve(count * others_each);
  }

  void add_names(std::size_t row, const Student& student) {
    std::array<std::string, 5> known{folded(student.id)};
    ids.push_back(hash(known[0]) | row);
    std::size_t count = 1;
    for (const std::string_view text : other_names(student)) {
      std::string name = folded(text);
      if (text.empty() || std::find(known.begin(), known.begin() + count, name) != known.begin() + count) continue;
      others.push_back(hash(name) | row);
      known[count++] = std::move(name);
    }
  }

  Student student(std::size_t index) const {
    const std::uint64_t offset = rows[index] >> 24, length = rows[index] & 0xFFFFFF;
    std::string text(length, '\0');
    struct stat now {};
    ssize_t got = -1;
    do {
      got = ::pread(fd, text.data(), text.size(), static_cast<off_t>(offset));
    } while (got < 0 && errno == EINTR);
    const bool changed = got != static_cast<ssize_t>(length) || ::fstat(fd, &now) != 0 ||
                         now.st_size != status.st_size || now.st_mtim.tv_sec != status.st_mtim.tv_sec ||
                         now.st_mtim.tv_nsec != status.st_mtim.tv_nsec;
    std::istringstream in(std::move(text));
    CsvReader reader(file, in, limits, separator);
    std::vector<std::string> cells;
    if (changed || !reader.next(cells)) throw std::runtime_error(printable(file) + ": has changed while it was in use");
    return student_of(columns, cells);
  }

  // The rows that have names of this hash.
  static std::vector<std::size_t> having(const std::vector<std::uint64_t>& names, std::uint64_t h) {
    std::vector<std::size_t> found;
    for (auto it = std::ranges::lower_bound(names, h); it != names.end() && (*it >> 32 << 32) == h; ++it) {
      if (found.size() == most_namesakes) return {};
      found.push_back(static_cast<std::size_t>(*it & 0xFFFFFFFF));
    }
    return found;
  }
};

namespace {

// An id that stands twice, ignoring case, for each row but the first that has it.
template <class Table>
void find_twins(const Table& table, const std::vector<int>& lines, Diagnostics& mistakes) {
  for (std::size_t begin = 0; begin < table.ids.size() && mistakes.size() < most_diagnostics;) {
    std::size_t end = begin + 1;
    while (end < table.ids.size() && table.ids[end] >> 32 == table.ids[begin] >> 32) ++end;
    // Different ids of the same hash are few, or somebody has made them: then it's enough to tell some of the twins.
    std::vector<std::pair<std::string, std::size_t>> first;
    for (std::size_t i = begin; end - begin > 1 && i < end && mistakes.size() < most_diagnostics; ++i) {
      const auto row = static_cast<std::size_t>(table.ids[i] & 0xFFFFFFFF);
      const std::string id_text = table.student(row).id;
      const auto twin = std::ranges::find(first, folded(id_text), &std::pair<std::string, std::size_t>::first);
      if (twin != first.end())
        mistakes.push_back({table.file, lines[row], 0, "",
                            "the id " + excerpt(id_text) + " stands in line " + std::to_string(lines[twin->second]) +
                                " already, ignoring case; each student has an id of their own"});
      else if (first.size() < most_namesakes)
        first.emplace_back(folded(id_text), row);
    }
    begin = end;
  }
}

void check(const Student& student, const std::string& due_text, const Columns& columns,
           const std::vector<std::string>& cells, const std::string& file, int line, Diagnostics& mistakes) {
  const auto mistake = [&](std::string message) {
    if (mistakes.size() < most_diagnostics) mistakes.push_back({file, line, 0, "", std::move(message)});
  };
  if (student.id.empty()) mistake("no id" + (student.name.empty() ? "" : " for " + excerpt(student.name)));
  if (student.id.size() > most_id_bytes)
    mistake("the id " + excerpt(student.id) + " is too long; at most " + std::to_string(most_id_bytes) + " bytes");
  if (!due_text.empty() && !student.due) mistake("due " + time_problem(due_text));
  const auto extra = static_cast<std::ptrdiff_t>(std::min(columns.count, cells.size()));
  if (std::any_of(cells.begin() + extra, cells.end(), [](const std::string& cell) { return !clean(cell).empty(); }))
    mistake(std::to_string(cells.size()) + " cells where the header has " + std::to_string(columns.count) +
            "; a cell that has a comma in it stands in quotation marks");
}

// Whether the first that is no blank opens an object or an array: no title of a column begins so.
bool is_json(std::istream& in) {
  const int first = (in >> std::ws).peek();
  in.clear();
  in.seekg(0);
  return first == '{' || first == '[';
}

}  // namespace

Checked<Roster> Roster::load(const std::filesystem::path& path) {
  auto table = std::make_shared<Table>();
  table->file = path.string();
  const auto problem = [&](std::string message) { return Diagnostics{{table->file, 0, 0, "", std::move(message)}}; };
  table->fd = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
  if (table->fd < 0 || ::fstat(table->fd, &table->status) != 0)
    return problem("cannot be read: " + std::generic_category().message(errno));
  if (!S_ISREG(table->status.st_mode)) return problem("must be a file");

  std::ifstream in(path, std::ios::binary);
  if (is_json(in))
    return problem("is JSON; a roster is CSV: a row of titles such as id,name and a row for each student");
  CsvReader reader(table->file, in, limits);
  std::vector<std::string> cells;
  Diagnostics mistakes;
  if (!reader.next(cells))
    return reader.diagnostics().empty() ? problem("is empty; the first row has the names of the columns")
                                        : reader.diagnostics();
  table->columns = read_header(cells, table->file, reader.line(), mistakes);
  table->separator = reader.separator();
  if (!mistakes.empty()) return mistakes;

  table->reserve();
  std::vector<int> lines;
  while (reader.next(cells)) {
    std::string due_text;
    const Student student = student_of(table->columns, cells, &due_text);
    if (is_no_student(table->columns, student, cells)) continue;
    check(student, due_text, table->columns, cells, table->file, reader.line(), mistakes);
    if (reader.end_offset() >= 1ull << 40 || table->rows.size() >= 0xFFFFFFFF) return problem("too large");
    if (!student.id.empty()) table->add_names(table->rows.size(), student);
    table->rows.push_back(reader.offset() << 24 | (reader.end_offset() - reader.offset()));
    lines.push_back(reader.line());
  }
  mistakes.insert(mistakes.end(), reader.diagnostics().begin(), reader.diagnostics().end());
  if (table->rows.empty() && mistakes.empty()) return problem("has no students");
  std::ranges::sort(table->ids);
  std::ranges::sort(table->others);
  find_twins(*table, lines, mistakes);
  if (!mistakes.empty()) return mistakes;
  Roster roster;
  roster.table_ = std::move(table);
  return roster;
}

std::size_t Roster::size() const { return table_->rows.size(); }

Student Roster::student(std::size_t index) const { return table_->student(index); }

std::optional<std::size_t> Roster::find(std::string_view key) const { return match({std::string(key)}).index; }

Roster::Match Roster::match(const StudentKey& key) const {
  if (key.text.empty()) return {};
  const bool by_number = key.kind == StudentKey::Kind::lms_number;
  const bool numbers_only =
      by_number && (table_->columns.has(lms_id) || table_->columns.canvas || table_->columns.has(identifier));
  const std::string name = normal_form(key.text), loosely = folded(name);
  const std::uint64_t h = hash(loosely);
  std::vector<std::size_t> exactly, nearly;
  const auto compare = [&](std::size_t row, std::span<const std::string_view> texts) {
    const auto has = [&](const auto& wanted, auto&& form) {
      return std::ranges::any_of(texts, [&](std::string_view text) { return form(text) == wanted; });
    };
    if (has(name, normal_form)) exactly.push_back(row);
    if (has(loosely, folded)) nearly.push_back(row);
  };
  for (const std::size_t row : Table::having(table_->ids, h)) {
    const Student candidate = student(row);
    const std::string_view text = numbers_only ? candidate.lms_id : candidate.id;
    if (!by_number && normal_form(text) == name) return {row};
    compare(row, std::array{text});
  }
  for (const std::size_t row : Table::having(table_->others, h)) {
    const Student candidate = student(row);
    if (numbers_only)
      compare(row, std::array<std::string_view, 1>{candidate.lms_id});
    else
      compare(row, other_names(candidate));
  }
  if (exactly.size() == 1) return {exactly.front()};
  if (exactly.empty() && nearly.size() == 1) return {nearly.front()};
  return {std::nullopt, !nearly.empty()};
}

Roster::Match Roster::match(std::span<const StudentKey> keys) const {
  Match all;
  for (const StudentKey& key : keys) {
    const Match one = match(key);
    all.ambiguous = all.ambiguous || one.ambiguous || (all.index && one.index && *all.index != *one.index);
    if (!all.index) all.index = one.index;
  }
  if (all.ambiguous) all.index.reset();
  return all;
}

}  // namespace blossom
