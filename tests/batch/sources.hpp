#pragma once
// What the tests of sources share: all that a source gives, and one line for each.

#include <catch2/catch.hpp>

#include "grader/batch/source.hpp"

namespace blossom {

struct Everything {
  std::vector<Found> found;
  std::string failure;
};

inline Everything read_all(SubmissionSource& source) {
  Everything all;
  for (Found found; source.next(found);) all.found.push_back(found);
  all.failure = source.failure();
  return all;
}

inline Everything read_all(const std::string& path, const SourceLimits& limits = {}) {
  auto source = open_submissions(path, limits);
  INFO(to_string(source.diagnostics));
  REQUIRE(source);
  return read_all(**source);
}

// "s17|#4711 < s17.json: text" or "... ! problem", with "refused" before it; a long text as "65536 of x".
inline std::string line_of(const Found& found) {
  std::string line = found.refused ? "refused " : "";
  for (std::size_t i = 0; i < found.keys.size(); ++i) {
    line += i > 0 ? "|" : "";
    line += (found.keys[i].kind == StudentKey::Kind::lms_number ? "#" : "") + found.keys[i].text;
  }
  line += " < " + found.submission.source;
  if (!found.submission.problem.empty()) return line + " ! " + found.submission.problem;
  const std::string& text = found.submission.text;
  return line + ": " + (text.size() <= 200 ? text : std::to_string(text.size()) + " of " + text.front());
}

inline std::string lines_of(const Everything& all) {
  std::string lines;
  for (const Found& found : all.found) lines += line_of(found) + "\n";
  return lines;
}

}  // namespace blossom
