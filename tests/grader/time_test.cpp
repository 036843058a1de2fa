// RFC 3339, section 5.6 and its examples in 5.8.

#include "grader/time.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace blossom;
using namespace std::chrono;

namespace {

std::string utc(std::string_view text) {
  const auto time = parse_time(text);
  return time ? format_time(*time) : "none";
}

}  // namespace

TEST_CASE("a time with an offset is the same instant in UTC", "[time]") {
  CHECK(utc("2026-10-01T21:59:00Z") == "2026-10-01T21:59:00Z");
  CHECK(utc("2026-10-01T23:59:00+02:00") == "2026-10-01T21:59:00Z");
  CHECK(utc("2026-10-01t23:59:00-00:00") == "2026-10-01T23:59:00Z");
  CHECK(utc("2026-12-31 22:30:00-05:00") == "2027-01-01T03:30:00Z");
  CHECK(utc("2024-02-29T00:00:00z") == "2024-02-29T00:00:00Z");
  // The examples of RFC 3339, section 5.8.
  CHECK(utc("1985-04-12T23:20:50.52Z") == "1985-04-12T23:20:50Z");
  CHECK(utc("1996-12-19T16:39:57-08:00") == "1996-12-20T00:39:57Z");
  CHECK(utc("1990-12-31T23:59:60Z") == "1990-12-31T23:59:59Z");
  CHECK(utc("1990-12-31T15:59:60-08:00") == "1990-12-31T23:59:59Z");
}

TEST_CASE("what is no time of RFC 3339, or no such day, is nothing", "[time]") {
  for (const char* text : {"",
                           "2026-10-01",
                           "2026-10-01T21:59:00",
                           "2026-10-01T21:59Z",
                           "2026-1-01T21:59:00Z",
                           "2026-02-29T00:00:00Z",
                           "2026-13-01T00:00:00Z",
                           "2026-00-01T00:00:00Z",
                           "2026-04-31T00:00:00Z",
                           "2026-10-01T24:00:00Z",
                           "2026-10-01T21:60:00Z",
                           "2026-10-01T21:59:61Z",
                           "2026-10-01T21:59:00.Z",
                           "2026-10-01T21:59:00+2:00",
                           "2026-10-01T21:59:00+0200",
                           "2026-10-01T21:59:00+24:00",
                           "2026-10-01T21:59:00+02:60",
                           "2026-10-01T21:59:00Zx",
                           " 2026-10-01T21:59:00Z",
                           "20261001T215900Z",
                           "-026-10-01T21:59:00Z",
                           "1969-12-31T23:59:59Z",
                           "1970-01-01T00:00:00+01:00",
                           "9999-12-31T23:59:59-01:00",
                           "2026-10-01T21:59:00\xE2\x88\x92"
                           "02:00",
                           "+2026-10-01T21:59:00Z"}) {
    INFO(text);
    CHECK_FALSE(parse_time(text).has_value());
  }
  CHECK_FALSE(parse_time(std::string_view("2026-10-01T21:59:00Z\0", 21)).has_value());
}

TEST_CASE("every second from 1970 to 9999 comes back as it was written", "[time]") {
  CHECK(utc("1970-01-01T00:00:00Z") == "1970-01-01T00:00:00Z");
  CHECK(utc("9999-12-31T23:59:59Z") == "9999-12-31T23:59:59Z");
  const unsigned seed = 20261001;
  INFO("seed " << seed);
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<long long> any(0, 253'402'300'799);  // seconds to the end of 9999
  for (int i = 0; i < 10'000; ++i) {
    const Time time{seconds{any(random)}};
    REQUIRE(parse_time(format_time(time)) == time);
  }
}

TEST_CASE("of a day that does not exist it is told how many days the month has", "[time]") {
  CHECK(time_problem("2026-11-31T00:00:00Z").find("November 2026 has 30 days") != std::string::npos);
  CHECK(time_problem("2027-02-29T00:00:00Z").find("February 2027 has 28 days") != std::string::npos);
  CHECK(time_problem("2026-13-01T00:00:00Z").starts_with("must be a time with its offset"));
  CHECK(time_problem("2026-11-31").starts_with("must be a time with its offset"));
  CHECK(time_problem("").starts_with("must be a time with its offset"));
}

TEST_CASE("people are told a time as clocks with the file's offset show it", "[time]") {
  const auto told = [](const std::string& text) { return time_in_words(*parse_time(text), offset_in(text)); };
  CHECK(told("2026-10-01T23:59:00+02:00") == "2026-10-01 23:59 (UTC+02:00)");
  CHECK(told("2026-10-01T23:59:07-03:30") == "2026-10-01 23:59:07 (UTC-03:30)");
  CHECK(told("2026-10-01T23:59:00.5Z") == "2026-10-01 23:59 UTC");
  CHECK(told("2026-10-01T23:59:00+00:00") == "2026-10-01 23:59 UTC");
  CHECK(told("9999-12-31T23:59:59Z") == "9999-12-31 23:59:59 UTC");
  CHECK(time_in_words(*parse_time("2026-10-01T21:59:00Z")) == "2026-10-01 21:59 UTC");
}

TEST_CASE("a time in a document is read, or told", "[time]") {
  const auto document = JsonDocument::parse("a.json", R"({"due": "2026-10-01T23:59:00+02:00", "bad": "soon", "n": 3})");
  REQUIRE(document);
  Diagnostics diagnostics;
  const Cursor root(*document, diagnostics);
  CHECK(read_time(*root.required("due")) == parse_time("2026-10-01T21:59:00Z"));
  CHECK(diagnostics.empty());
  CHECK_FALSE(read_time(*root.required("bad")));
  CHECK_FALSE(read_time(*root.required("n")));
  CHECK(
      to_string(diagnostics) ==
      "a.json:1:45: bad: must be a time with its offset from UTC such as \"2026-10-01T23:59:00+02:00\", not \"soon\"\n"
      "a.json:1:58: n: must be a string, not 3\n");
}
