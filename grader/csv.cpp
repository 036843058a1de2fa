#include "grader/csv.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <streambuf>

#include "base/utf8.hpp"

namespace blossom {
namespace {

constexpr std::string_view separators = ",;\t";
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool starts_with_any(std::string_view text, std::initializer_list<std::string_view> starts) {
  return std::ranges::any_of(starts, [&](std::string_view start) { return text.starts_with(start); });
}

// Spreadsheets take a text for a formula by its first character, some of them after leaving blanks away, some of them
// in its full-width form (OWASP, "CSV Injection").
bool looks_like_formula(std::string_view text) {
  if (starts_with_any(text, {"\t", "\r"})) return true;
  for (;;) {
    const std::size_t visible = std::min(text.find_first_not_of(" \t\r\n\v\f"), text.size());
    text.remove_prefix(visible);
    if (starts_with_any(text, {"\xC2\xA0"}))  // no-break space
      text.remove_prefix(2);
    else if (starts_with_any(text, {"\xE3\x80\x80", byte_order_mark, "\xE2\x80\x8B"}))  // wide and zero-width blanks
      text.remove_prefix(3);
    else
      break;
  }
  return starts_with_any(text, {"=", "+", "-", "@", "\xEF\xBC\x9D", "\xEF\xBC\x8B", "\xEF\xBC\x8D", "\xEF\xBC\xA0"});
}

}  // namespace

CsvReader::CsvReader(std::string name, std::istream& in, const CsvLimits& limits, char separator)
    : name_(std::move(name)), in_(&in), limits_(limits), separator_(separator), begun_(separator != 0) {}

bool CsvReader::fail(int line, std::string message) {
  diagnostics_.push_back({name_, line, 0, "", std::move(message)});
  return false;
}

bool CsvReader::next(std::vector<std::string>& cells) {
  if (!diagnostics_.empty()) return false;
  for (;;) {
    const Raw raw = read_raw();
    if (raw != Raw::row) return false;
    if (!raw_.empty()) return split(cells);
  }
}

// Reads up to the end of the row, which is a line's end outside quotation marks. While the separator is not known, any
// of the three ends a cell: what matters is only where quoted cells begin.
CsvReader::Raw CsvReader::read_raw() {
  constexpr int end_of_file = std::streambuf::traits_type::eof();
  raw_.clear();
  line_ = next_line_;
  offset_ = next_offset_;
  std::streambuf& in = *in_->rdbuf();
  const auto mistake = [&](std::string message) {
    fail(line_, std::move(message));
    return Raw::mistake;
  };
  enum class At : std::uint8_t { cell_start, plain, quoted, quote_in_quoted } at = At::cell_start;
  for (;;) {
    const int got = in.sbumpc();
    if (got == end_of_file) {
      if (at == At::quoted) return mistake("a quotation mark that is never closed; end the cell with \"");
      return raw_.empty() ? Raw::end : Raw::row;
    }
    ++next_offset_;
    const char c = std::streambuf::traits_type::to_char_type(got);
    if (c == '\0') return mistake("a NUL byte; CSV is text, saved as UTF-8");
    const bool line_ends = c == '\n' || (c == '\r' && in.sgetc() != '\n');
    if (line_ends && next_line_ < std::numeric_limits<int>::max()) ++next_line_;
    if (at != At::quoted && (c == '\n' || c == '\r')) {
      begun_ = true;
      if (c == '\r' && in.sgetc() == '\n') {
        in.sbumpc();
        ++next_offset_;
        ++next_line_;
      }
      return Raw::row;
    }
    if (raw_.size() == limits_.row_bytes)
      return mistake("a row of more than " + std::to_string(limits_.row_bytes) + " bytes" +
                     (at == At::quoted ? "; is a quotation mark not closed?" : ""));
    raw_ += c;
    if (!begun_ && raw_ == byte_order_mark) {
      raw_.clear();
      begun_ = true;
      at = At::cell_start;
      continue;
    }
    begun_ = begun_ || raw_.size() >= byte_order_mark.size();
    const bool separates = separator_ != 0 ? c == separator_ : separators.find(c) != std::string_view::npos;
    if (at == At::quoted)
      at = c == '"' ? At::quote_in_quoted : At::quoted;
    else if (at == At::quote_in_quoted && c == '"')
      at = At::quoted;
    else if (separates)
      at = At::cell_start;
    else
      at = at == At::cell_start && c == '"' ? At::quoted : At::plain;
  }
}

bool CsvReader::split(std::vector<std::string>& cells) {
  for (std::size_t i = 0; i < raw_.size();) {
    const std::size_t length = utf8_length(raw_, i);
    if (length == 0) return fail(line_, "invalid UTF-8; the file must be saved as UTF-8");
    i += length;
  }
  if (separator_ == 0) {
    std::array<std::ptrdiff_t, separators.size()> counts{};
    bool quoted = false;
    for (const char c : raw_) {
      quoted = quoted != (c == '"');
      const std::size_t which = separators.find(c);
      if (!quoted && which != std::string_view::npos) ++counts[which];
    }
    separator_ = separators[static_cast<std::size_t>(std::ranges::max_element(counts) - counts.begin())];
  }

  cells.clear();
  for (std::size_t i = 0;;) {
    if (cells.size() == limits_.columns)
      return fail(line_, "more than " + std::to_string(limits_.columns) + " columns");
    std::string& cell = cells.emplace_back();
    if (i < raw_.size() && raw_[i] == '"') {
      for (++i; i < raw_.size() && (raw_[i] != '"' || (i + 1 < raw_.size() && raw_[i + 1] == '"')); ++i) {
        cell += raw_[i];
        if (raw_[i] == '"') ++i;
      }
      // Only a first row, where the separator was not known yet, can end before the quotation mark is closed.
      if (i == raw_.size()) return fail(line_, "a quotation mark that is never closed; end the cell with \"");
      ++i;
      if (i < raw_.size() && raw_[i] != separator_)
        return fail(line_, "text behind the end of a quoted cell; a quotation mark inside it is written \"\"");
    } else {
      const std::size_t end = std::min(raw_.find(separator_, i), raw_.size());
      cell = raw_.substr(i, end - i);
      i = end;
    }
    if (i == raw_.size()) return true;
    ++i;  // the separator
  }
}

std::string csv_text(std::string_view text) {
  std::string clean;
  bool quote = false;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    const std::string_view character = text.substr(i, std::max<std::size_t>(length, 1));
    i += character.size();
    if (length == 0)
      clean += "\xEF\xBF\xBD";
    else if (is_control(character))
      clean += ' ';
    else if (character == "\"")
      clean += "\"\"";
    else
      clean += character;
    // A semicolon separates cells where decimals have a comma.
    quote = quote || character == "\"" || character == "," || character == ";";
  }
  // A control character may have stood before what is a formula now.
  if (looks_like_formula(text) || looks_like_formula(clean)) clean.insert(0, "'");
  quote = quote || clean.starts_with(' ') || clean.ends_with(' ');
  return quote ? "\"" + clean + "\"" : clean;
}

std::string csv_number(double number, int decimals) {
  if (!std::isfinite(number)) return {};
  // The largest double has 309 digits before the point.
  std::array<char, 512> text{};
  const int precision = std::clamp(decimals, 0, 100);
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed, precision);
  std::string out(text.data(), end.ptr);
  if (out.find('.') != std::string::npos) {
    out.erase(out.find_last_not_of('0') + 1);
    if (out.ends_with('.')) out.pop_back();
  }
  return out == "-0" ? "0" : out;
}

void write_csv_row(const std::vector<std::string>& cells, std::string& out) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) out += ',';
    out += cells[i];
  }
  if (cells.size() == 1 && cells[0].empty()) out += "\"\"";  // or it would be a blank line
  out += "\r\n";
}

}  // namespace blossom
