#pragma once
// Somebody of a class, as the roster has them.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "grader/time.hpp"

namespace blossom {

struct Student {
  std::string id;      // the only identity that counts: results, variants and file names go by it
  std::string name;    // "Lovelace, Ada"; this and all that follows may be empty
  std::string login;   // SIS Login ID
  std::string sis_id;  // SIS User ID
  std::string lms_id;  // the learning platform's own number (Canvas's ID, Moodle's participant)
  std::string email;
  std::string section;
  bool is_participant = false;  // lms_id is Moodle's number of a participant, which is nobody's in Canvas
  std::optional<Time> due;      // an extension: instead of the assignment's date
};

// What a submission may be known by.
struct StudentKey {
  enum class Kind : std::uint8_t {
    anything,    // an ID, or whatever else a roster knows somebody by
    lms_number,  // what Canvas or Moodle numbers its users with
  };
  std::string text;
  Kind kind = Kind::anything;

  bool operator==(const StudentKey&) const = default;
};

// A name as it is compared and told apart: in Unicode's normal form C, for a zip file made on macOS has the letter and
// its accent apart. What is no UTF-8 stays as it is.
std::string normal_form(std::string_view name);
// The same, with A to Z as a to z.
std::string folded(std::string_view name);

}  // namespace blossom
