#pragma once
// Points in time as files have them: RFC 3339, always with an offset, to the second.

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "base/json.hpp"

namespace blossom {

using Time = std::chrono::sys_seconds;

// "2026-10-01T23:59:00+02:00", "2026-10-01T21:59:00Z"; fractions of a second are dropped. Years 1970 to 9999. Nothing
// if it is no such text, or no such day.
std::optional<Time> parse_time(std::string_view);
// Why a text is no time, with what would be right: "must be ..., not ...".
std::string time_problem(std::string_view);
// In UTC: "2026-10-01T21:59:00Z".
std::string format_time(Time);
// The offset from UTC that such a text is written with. Precondition: parse_time reads it.
std::chrono::minutes offset_in(std::string_view);
// For people, with seconds where there are any: "2026-10-01 21:59 UTC", or as clocks with that offset show it,
// "2026-10-01 23:59 (UTC+02:00)".
std::string time_in_words(Time, std::chrono::minutes offset = {});
// A string with such a time, or a diagnostic.
std::optional<Time> read_time(const Cursor&);

}  // namespace blossom
