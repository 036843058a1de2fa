#include "grader/time.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>

namespace blossom {
namespace {

using namespace std::chrono;

// Reads the text from left to right; once something is missing, nothing more is found.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) {}

  bool ok() const { return ok_; }
  bool at_end() const { return rest_.empty(); }
  bool next_is(char c) const { return ok_ && rest_.starts_with(c); }

  int digits(std::size_t count) {
    int number = 0;
    for (std::size_t i = 0; i < count; ++i) number = number * 10 + digit();
    return number;
  }
  void one_of(std::string_view allowed) {
    ok_ = ok_ && !rest_.empty() && allowed.find(rest_.front()) != std::string_view::npos;
    if (ok_) rest_.remove_prefix(1);
  }
  bool next_is_digit() const { return ok_ && !rest_.empty() && '0' <= rest_.front() && rest_.front() <= '9'; }

 private:
  int digit() {
    ok_ = next_is_digit();
    if (!ok_) return 0;
    const int value = rest_.front() - '0';
    rest_.remove_prefix(1);
    return value;
  }

  std::string_view rest_;
  bool ok_ = true;
};

constexpr Time first{sys_days{year{1970} / 1 / 1}};
constexpr Time last = Time{sys_days{year{9999} / 12 / 31}} + hours{24} - seconds{1};

}  // namespace

// The grammar is date-time of RFC 3339, section 5.6; T and Z may be in lower case, and a blank may stand for the T.
std::optional<Time> parse_time(std::string_view text) {
  Scanner scan(text);
  const int y = scan.digits(4);
  scan.one_of("-");
  const int m = scan.digits(2);
  scan.one_of("-");
  const int d = scan.digits(2);
  scan.one_of("Tt ");
  const int h = scan.digits(2);
  scan.one_of(":");
  const int min = scan.digits(2);
  scan.one_of(":");
  const int s = scan.digits(2);
  if (scan.next_is('.')) {
    scan.one_of(".");
    scan.digits(1);
    while (scan.next_is_digit()) scan.digits(1);
  }
  minutes offset{0};
  if (scan.next_is('+') || scan.next_is('-')) {
    const int sign = scan.next_is('-') ? -1 : 1;
    scan.one_of("+-");
    const int offset_h = scan.digits(2);
    scan.one_of(":");
    const int offset_min = scan.digits(2);
    if (offset_h > 23 || offset_min > 59) return std::nullopt;
    offset = minutes{sign * (offset_h * 60 + offset_min)};
  } else {
    scan.one_of("Zz");
  }
  const year_month_day day{year{y}, month{static_cast<unsigned>(m)}, std::chrono::day{static_cast<unsigned>(d)}};
  // A leap second (60) is the last of its minute: clocks without leap seconds have no other.
  if (!scan.ok() || !scan.at_end() || !day.ok() || h > 23 || min > 59 || s > 60) return std::nullopt;
  const Time time = Time{sys_days{day}} + hours{h} + minutes{min} + seconds{s == 60 ? 59 : s} - offset;
  if (time < first || time > last) return std::nullopt;
  return time;
}

std::string format_time(Time time) {
  const auto days = floor<std::chrono::days>(time);
  const year_month_day date{days};
  const hh_mm_ss clock{time - days};
  char text[48];
  std::snprintf(text, sizeof text, "%04d-%02u-%02uT%02d:%02d:%02dZ", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                static_cast<int>(clock.hours().count()), static_cast<int>(clock.minutes().count()),
                static_cast<int>(clock.seconds().count()));
  return text;
}

std::string time_problem(std::string_view text) {
  constexpr std::size_t day_at = 8;
  constexpr std::string_view months[] = {"January", "February", "March",     "April",   "May",      "June",
                                         "July",    "August",   "September", "October", "November", "December"};
  std::string first_day(text);
  if (first_day.size() > day_at + 2) first_day.replace(day_at, 2, "01");
  const auto month = parse_time(first_day);
  if (!month || !std::ranges::all_of(text.substr(day_at, 2), [](char c) { return '0' <= c && c <= '9'; }))
    return "must be a time with its offset from UTC such as \"2026-10-01T23:59:00+02:00\", not " + excerpt(text);
  int y = 0;
  unsigned m = 0;
  std::from_chars(text.data(), text.data() + 4, y);
  std::from_chars(text.data() + 5, text.data() + 7, m);
  const auto last_day = (year{y} / std::chrono::month{m} / std::chrono::last).day();
  return "must be a day that there is, not " + excerpt(text) + ": " + std::string(months[m - 1]) + " " +
         std::to_string(y) + " has " + std::to_string(static_cast<unsigned>(last_day)) + " days";
}

minutes offset_in(std::string_view text) {
  constexpr std::size_t clock_at = 11;  // behind it a minus belongs to no date
  const std::size_t at = text.find_first_of("+-", clock_at);
  if (at == std::string_view::npos) return minutes{0};
  Scanner scan(text.substr(at + 1));
  const int h = scan.digits(2);
  scan.one_of(":");
  return minutes{(text[at] == '-' ? -1 : 1) * (h * 60 + scan.digits(2))};
}

std::string time_in_words(Time time, minutes offset) {
  const Time there = std::clamp(time + offset, first, last);
  std::string text = format_time(there);
  text[10] = ' ';
  text.resize(text.ends_with(":00Z") ? 16 : 19);
  if (offset == minutes{0}) return text + " UTC";
  const auto size = abs(offset).count();
  char sign[24];
  std::snprintf(sign, sizeof sign, " (UTC%c%02d:%02d)", offset < minutes{0} ? '-' : '+', static_cast<int>(size / 60),
                static_cast<int>(size % 60));
  return text + sign;
}

std::optional<Time> read_time(const Cursor& cursor) {
  if (!cursor.is(Json::Kind::string)) {
    cursor.string();
    return std::nullopt;
  }
  const auto time = parse_time(cursor.json().text);
  if (!time) cursor.error(time_problem(cursor.json().text));
  return time;
}

}  // namespace blossom
