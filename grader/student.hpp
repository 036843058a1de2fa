#pragma once
// Somebody of a class, as the roster has them.

#include <optional>
#include <string>

#include "grader/time.hpp"

namespace blossom {

struct Student {
  std::string id;       // the only identity that counts: results, variants and file names go by it
  std::string name;     // "Lovelace, Ada"; this and all that follows may be empty
  std::string login;    // SIS Login ID
  std::string sis_id;   // SIS User ID
  std::string lms_id;   // the learning platform's own number (Canvas's ID, Moodle's participant)
  std::string email;
  std::string section;
  std::optional<Time> due;  // an extension: instead of the assignment's date
};

}  // namespace blossom
