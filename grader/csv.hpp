#pragma once
// Comma-separated values (RFC 4180), both ways.

#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.hpp"

namespace blossom {

struct CsvLimits {
  std::size_t row_bytes = 64u << 10;
  std::size_t columns = 256;
};

// Reads row by row: quoted cells with commas, quotation marks and line breaks; LF, CRLF or CR; a byte order mark is
// skipped; comma, semicolon or tab as separator, whichever the first row has most of.
class CsvReader {
 public:
  // The separator need not be found out where it is known: when one row is read again by its offset. A byte order mark
  // is then a part of it, for the file has begun before.
  CsvReader(std::string name, std::istream& in, const CsvLimits& limits = {}, char separator = 0);
  // The next row's cells; false at the end and after a mistake that one cannot read on from (a quotation mark that is
  // never closed or stands alone in a quoted cell, a row beyond the limits, a NUL, invalid UTF-8). Blank lines are
  // skipped.
  bool next(std::vector<std::string>& cells);
  int line() const { return line_; }                // where the row began
  std::uint64_t offset() const { return offset_; }  // likewise, in bytes from where the stream was
  std::uint64_t end_offset() const { return next_offset_; }
  char separator() const { return separator_; }  // known from the first row on
  const Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  enum class Raw : std::uint8_t { row, end, mistake };
  Raw read_raw();
  bool split(std::vector<std::string>& cells);
  bool fail(int line, std::string message);

  std::string name_;
  std::istream* in_;
  CsvLimits limits_;
  std::string raw_;  // the row as it stands in the file, without its end
  char separator_ = 0;
  bool begun_ = false;
  int line_ = 0;
  int next_line_ = 1;
  std::uint64_t offset_ = 0;
  std::uint64_t next_offset_ = 0;
  Diagnostics diagnostics_;
};

// A cell of text as it stands in a file: quoted when it must be, and harmless to a spreadsheet: a text that starts with
// = + - @ (or their full-width forms), a tab or a carriage return (also behind blanks) gets an apostrophe before it.
// Control characters become blanks, bytes that are no UTF-8 become U+FFFD.
std::string csv_text(std::string_view);
// A number as a spreadsheet reads it: plain decimals with a point, at most `decimals` digits behind it, no exponent.
// Nothing for what is no finite number.
std::string csv_number(double, int decimals = 4);

// Rows with CRLF, as RFC 4180 has them; cells come from csv_text and csv_number.
void write_csv_row(const std::vector<std::string>& cells, std::string& out);

}  // namespace blossom
