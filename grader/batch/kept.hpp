#pragma once
// submissions.jsonl of a folder of results: what was handed in, kept for regrading. Its lines are JSON Lines as
// source.hpp has them; and where such a line cannot say it:
//
//   {"student"?, "submitted"?, "source"?, "problem": text}          what was not read, and why
//   {"student"?, "submitted"?, "source"?, "refused": text}          an entry that was refused
//   {"student"?, "submitted"?, "source"?, "submission_hex": text}   bytes that are no UTF-8

#include "grader/batch/source.hpp"

namespace blossom {

void write_kept(const std::string& student, const Found&, std::string& line);
Checked<std::unique_ptr<SubmissionSource>> open_kept(const std::filesystem::path&);

}  // namespace blossom
