#pragma once
// What the kinds of sources share; only they include it.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "grader/batch/descriptor.hpp"
#include "grader/batch/source.hpp"

namespace blossom {

std::unique_ptr<SubmissionSource> lines_of(Descriptor file, const SourceLimits&);
std::unique_ptr<SubmissionSource> folder_of(Descriptor folder, const SourceLimits&);
std::unique_ptr<SubmissionSource> archive_of(Descriptor file, const SourceLimits&);

// Whose a file is by its path ("s17/a.json"), likeliest first.
std::vector<StudentKey> keys_of(std::string_view path);
bool is_json_name(std::string_view name);

inline constexpr std::string_view hidden_name = "not read: its name begins with a point, which hides it";
inline constexpr std::string_view no_json_name = "not read: the name of a submission ends in .json";
std::size_t most_line_bytes(const SourceLimits&);
std::string too_long(const SourceLimits&);
std::string too_large(const SourceLimits&);
std::string too_deep(const SourceLimits&);
std::optional<Time> time_of(std::int64_t seconds);  // nothing outside of 1970 to 9999

std::string system_says(int error);

}  // namespace blossom
