#pragma once
// What one student handed in, from files and folders that are named one by one: a few files, as a learning platform
// puts them before an autograder. A whole class comes through batch/source.hpp.

#include <filesystem>
#include <string>
#include <vector>

#include "grader/result.hpp"

namespace blossom {

struct HandedIn {
  std::vector<Submission> submissions;
  std::vector<Incident> refused;  // what in a folder is no answers file
};

// Of a folder every *.json in it or below, by name; links are not followed; other files and hidden ones are refused,
// but for what systems leave behind (is_litter). A file named itself is read whatever its name, through links. "-" is
// standard input. Of each no more than its limit is read, so what is longer is found to be too large.
HandedIn read_handed_in(const std::vector<std::string>& paths);

// What Gradescope says of a submission in submission_metadata.json ("Submission Metadata" in its documentation).
struct SubmissionMetadata {
  Student student;                // of a group: the first in the file; due: their extension, or the assignment's date
  std::optional<Time> submitted;  // created_at
};

// Who it is goes by their student number (sid), else by e-mail address, else by Gradescope's own number. Earlier
// submissions are not looked at.
Checked<SubmissionMetadata> read_submission_metadata(const JsonDocument&);

}  // namespace blossom
