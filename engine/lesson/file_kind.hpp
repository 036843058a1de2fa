#pragma once
// What a JSON document is, so that one command can check any of Blossom's files.

#include <string_view>

#include "base/json.hpp"

namespace blossom {

enum class FileKind { lesson, exercise, answers, grade, trace, curve, surface, unknown };

// By its "schema" (of any version: the reader of that kind says which it knows), or by the keys that only one kind has.
FileKind file_kind(const Json& root);

// "lesson", "exercise", ..., "unknown".
std::string_view file_kind_name(FileKind);

}  // namespace blossom
