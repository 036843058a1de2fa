#pragma once
// What a JSON document is, so that one command can check any of Blossom's files.

#include <string>
#include <string_view>

#include "base/json.hpp"

namespace blossom {

enum class FileKind {
  lesson,
  exercise,
  assignment,
  answers,
  grade,
  result,
  trace,
  curve,
  surface,
  scene,
  schema,
  unknown
};

// By its "schema" (of any version: the reader of that kind says which it knows), or by the keys that only one kind has.
// A JSON Schema, which is about such files, says so in "$schema" (https://json-schema.org/...).
FileKind file_kind(const Json& root);

// "lesson", "exercise", ..., "unknown".
std::string_view file_kind_name(FileKind);
// "a lesson", "an answers file", "a file of an unknown kind".
std::string with_article(FileKind);

}  // namespace blossom
