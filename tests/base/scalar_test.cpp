#include "base/scalar.hpp"

#include <catch2/catch.hpp>

using namespace blossom;

TEST_CASE("a number in a message is short: its fraction, or as many digits as there is room for") {
  const auto brief = [](const char* text) { return format_brief(*Exact::parse(text)); };
  CHECK(brief("0") == "0");
  CHECK(brief("-2/6") == "-1/3");
  CHECK(brief("12345678901234567890") == "12345678901234567890");
  CHECK(brief("1e300") == "1e+300");
  CHECK(brief("1.0000000000000002") == "1.0000000000000002");
  CHECK(brief("333333333333333333333333/1000000000000000000000000") == "0.3333333333333333");
  CHECK(brief("-1.2345678901234567e-300") == "-1.23456789012e-300");
  CHECK(brief("-1.7976931348623157e308") == "-1.79769313486e+308");
  CHECK(format_brief(Exact::approximate(0.1)) == "0.1");
}
