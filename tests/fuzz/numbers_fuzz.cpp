// Any text as a typed number: the quick ways of reading one agree with the exact one, a number that is written reads
// back as itself, and no tolerance lets its own value fall outside.

#include <cmath>

#include "fuzz.hpp"
#include "grader/compare.hpp"
#include "grader/time.hpp"

using namespace blossom;
using namespace blossom::fuzz;

namespace {

void check_tolerance(const Tolerance& tolerance, const Exact& value, std::string_view text) {
  const Window around = window(tolerance, value);
  require(around.low <= value && value <= around.high, "a value counts as itself", text);
  require(within(tolerance, value, value), "a value is within its own tolerance", text);
  require(fit(around, text) == Fit::inside, "a value that is typed fits", text);
  const Exact edge = value + slack(tolerance, value);
  require(within(tolerance, value, edge), "the boundary counts", text);
  if (edge.to_string().size() <= 400 && std::isfinite(edge.to_double()))
    require(fit(around, edge.to_string()) == Fit::inside, "the boundary fits", text);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = text_of(data, size);
  if (const auto time = parse_time(text)) {
    const auto again = parse_time(format_time(*time));
    // Offsets may lead out of the years that are read.
    if (again) require(*again == *time, "a time that is written reads back", format_time(*time));
  }
  const auto number = parse_typed(text);
  const auto quick = quick_double(text);
  if (!number) {
    require(fit(window({}, Exact(0)), text) != Fit::inside, "what is no number fits nowhere", text);
    return 0;
  }
  require(std::isfinite(number->to_double()), "a typed number is finite", text);
  if (quick) require(*quick == number->to_double(), "the quick double is the nearest one", text);
  const std::string written = number->to_string();
  if (written.size() <= 400) {
    const auto again = Exact::parse(written);
    require(again && *again == *number, "a number that is written reads back", text);
  }
  const double place = last_place(text), rounding = rounding_of(text);
  require(place >= 0 && rounding >= 0 && rounding <= place, "half a unit of the last place", text);
  check_tolerance({}, *number, text);
  check_tolerance({Tolerance::Kind::decimals, 3, 0}, *number, text);
  check_tolerance({Tolerance::Kind::significant, 3, 0}, *number, text);
  check_tolerance({Tolerance::Kind::relative, 0, Exact::ratio(1, 1000)}, *number, text);
  return 0;
}
