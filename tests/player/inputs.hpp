#pragma once
// Inputs as a test writes them down: the text of a file's "inputs".

#include <catch2/catch.hpp>

#include "algorithms/run.hpp"

namespace blossom::test {

inline Inputs<Exact> inputs_from(std::string_view algorithm, const std::string& text) {
  const auto document = JsonDocument::parse("inputs", text);
  REQUIRE(document);
  Diagnostics diagnostics;
  const auto inputs = read_inputs(*find_algorithm(algorithm), Cursor(*document, diagnostics));
  INFO(to_string(diagnostics));
  REQUIRE(inputs);
  return *inputs;
}

}  // namespace blossom::test
