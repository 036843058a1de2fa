// Any bytes as CSV, and as a class: rows keep the limits and read back when they are written; in an accepted roster
// everybody has an ID of their own and is found by it.

#include <sys/mman.h>
#include <unistd.h>

#include <set>
#include <sstream>

#include "fuzz.hpp"
#include "grader/csv.hpp"
#include "grader/roster.hpp"

using namespace blossom;
using namespace blossom::fuzz;

namespace {

using Rows = std::vector<std::vector<std::string>>;
constexpr CsvLimits limits{4096, 32};

Rows read_rows(const std::string& text, char separator, Diagnostics& diagnostics) {
  std::istringstream in(text);
  CsvReader reader("f", in, limits, separator);
  Rows rows;
  int line = 0;
  for (std::vector<std::string> cells; reader.next(cells);) {
    require(reader.line() > line, "rows come one after the other");
    line = reader.line();
    require(!cells.empty() && cells.size() <= limits.columns, "a row has cells, no more than the limit");
    for (const std::string& cell : cells)
      require(cell.size() <= limits.row_bytes && is_utf8(cell), "a cell is text within the limit", cell);
    rows.push_back(cells);
  }
  diagnostics = reader.diagnostics();
  return rows;
}

std::string written(const Rows& rows) {
  std::string out;
  for (const auto& cells : rows) {
    std::vector<std::string> texts;
    for (const std::string& cell : cells) texts.push_back(csv_text(cell));
    write_csv_row(texts, out);
  }
  return out;
}

// What csv_text makes of a cell is text that a spreadsheet does not run, and stays as it is the second time.
void check_cells(const Rows& rows) {
  const std::string once = written(rows);
  Diagnostics diagnostics;
  const Rows again = read_rows(once, ',', diagnostics);
  // Defusing makes a row longer, so that it may no longer keep the limit; and a row of one empty cell is a blank line.
  if (!diagnostics.empty() || again.size() != rows.size()) return;
  for (const auto& cells : again)
    for (const std::string& cell : cells) {
      const std::size_t first = cell.find_first_not_of(" ");
      require(first == std::string::npos || std::string_view("=+-@\t\r").find(cell[first]) == std::string_view::npos,
              "a cell is harmless to a spreadsheet", cell);
    }
  require(written(again) == once, "written, read and written again it is the same", once);
}

void check_roster(const std::string& text) {
  const int file = memfd_create("roster", MFD_CLOEXEC);
  require(file >= 0 && write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size()), "there is memory");
  const auto roster = Roster::load("/proc/self/fd/" + std::to_string(file));
  if (roster) {
    std::set<std::string> ids;
    for (std::size_t i = 0; i < roster->size(); ++i) {
      const Student student = roster->student(i);
      require(!student.id.empty() && ids.insert(student.id).second, "everybody has an ID of their own", student.id);
      require(roster->find(student.id) == i, "everybody is found by it", student.id);
    }
  } else {
    require(!roster.diagnostics.empty(), "what is refused has a reason");
    for (const Diagnostic& d : roster.diagnostics) require(is_harmless(to_string(d)), "a mistake is harmless text");
  }
  close(file);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = text_of(data, size);
  Diagnostics diagnostics;
  const Rows rows = read_rows(text, 0, diagnostics);
  std::string lines = text;  // which end with LF, CRLF or CR
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i] == '\r' && (i + 1 == lines.size() || lines[i + 1] != '\n')) lines[i] = '\n';
  if (!diagnostics.empty()) check_diagnostics(diagnostics, lines);
  check_cells(rows);
  check_roster(text);
  return 0;
}
