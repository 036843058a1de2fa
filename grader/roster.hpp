#pragma once
// The class: a CSV file with a header row. Known columns, whatever their case, blanks and underscores: id (needed,
// unique even ignoring case), name (or "first name" and "last name"), login, sis id, lms id (or canvas id), email,
// section, due (an extension, RFC 3339); Canvas's own export is known by its header (Student, ID, SIS User ID, SIS
// Login ID, Section), and Moodle's (Identifier or Username, Full name, Email address). Other columns are ignored.
//
// Canvas's ID is the id of a student of its export; Moodle's is the user name, or the number of the participant. The
// rows "Points Possible" and "Student, Test" of Canvas are no students.
//
// A class of a million takes 8 bytes of memory for each student and 8 for each name that somebody is known by; its rows
// stay in the file, which is kept open.

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "grader/student.hpp"

namespace blossom {

class Roster {
 public:
  // Every mistake at once: no id, an id twice, columns that are missing, a due that is no time, a row of more cells
  // than the header has.
  static Checked<Roster> load(const std::filesystem::path&);

  std::size_t size() const;
  // In the order of the file. Throws std::runtime_error, as find does, when the file is no longer what it was.
  Student student(std::size_t index) const;
  // Who has this id, exactly; or this login, SIS ID, LMS ID or e-mail address, exactly, if that is only one; or any of
  // them ignoring the case of A to Z, if that is only one. What more than 32 have (a placeholder such as "none") finds
  // nobody. Names that Unicode holds canonically equivalent are the same.
  std::optional<std::size_t> find(std::string_view key) const;

  struct Match {
    std::optional<std::size_t> index;
    bool ambiguous = false;  // nobody, for it may be one or the other
  };
  // Whose all these keys may be. An LMS's number is looked for among such numbers alone, if the roster has them: a
  // student number may be the same by chance. Where two keys, or one number, are two students', it is nobody.
  Match match(std::span<const StudentKey>) const;

 private:
  Match match(const StudentKey&) const;

  struct Table;
  std::shared_ptr<const Table> table_;
};

}  // namespace blossom
