#pragma once
// What an algorithm cannot do with these numbers, found on the way (a weight of zero at u). What can be checked before
// is checked before, by the algorithm's file. Caught in algorithms/run.hpp and turned into a diagnostic at that input.

#include <string>

namespace blossom {

struct KernelError {
  std::string input;    // which input is at fault: "u", "profiles[2]"
  std::string message;  // what is wrong, and what would be right
};

}  // namespace blossom
