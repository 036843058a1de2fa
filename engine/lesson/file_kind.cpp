#include "lesson/file_kind.hpp"

#include <array>
#include <utility>

namespace blossom {
namespace {

constexpr std::array<std::pair<FileKind, std::string_view>, 12> names{{{FileKind::lesson, "lesson"},
                                                                       {FileKind::exercise, "exercise"},
                                                                       {FileKind::assignment, "assignment"},
                                                                       {FileKind::answers, "answers"},
                                                                       {FileKind::grade, "grade"},
                                                                       {FileKind::result, "result"},
                                                                       {FileKind::trace, "trace"},
                                                                       {FileKind::curve, "curve"},
                                                                       {FileKind::surface, "surface"},
                                                                       {FileKind::scene, "scene"},
                                                                       {FileKind::schema, "schema"},
                                                                       {FileKind::unknown, "unknown"}}};

FileKind kind_of_schema(std::string_view schema) {
  constexpr std::string_view prefix = "blossom.";
  if (!schema.starts_with(prefix)) return FileKind::unknown;
  schema.remove_prefix(prefix.size());
  const std::string_view name = schema.substr(0, schema.find('/'));
  for (const auto kind : {FileKind::lesson, FileKind::exercise, FileKind::assignment, FileKind::answers,
                          FileKind::grade, FileKind::result, FileKind::trace, FileKind::scene})
    if (name == file_kind_name(kind)) return kind;
  return FileKind::unknown;
}

}  // namespace

std::string_view file_kind_name(FileKind kind) {
  for (const auto& [each, name] : names)
    if (each == kind) return name;
  return {};
}

std::string with_article(FileKind kind) {
  if (kind == FileKind::unknown) return "a file of an unknown kind";
  const std::string name(file_kind_name(kind));
  const bool vowel = std::string_view("aeiou").find(name[0]) != std::string_view::npos;
  return (vowel ? "an " : "a ") + name + (kind == FileKind::answers ? " file" : "");
}

FileKind file_kind(const Json& root) {
  if (root.kind != Json::Kind::object) return FileKind::unknown;
  if (const Json* schema = root.find("schema"); schema != nullptr && schema->kind == Json::Kind::string)
    if (const FileKind kind = kind_of_schema(schema->text); kind != FileKind::unknown) return kind;
  if (const Json* schema = root.find("$schema"); schema != nullptr && schema->kind == Json::Kind::string)
    if (schema->text.find("json-schema.org") != std::string::npos) return FileKind::schema;
  if (root.find("beats") != nullptr || root.find("scenes") != nullptr) return FileKind::lesson;
  if (root.find("ask") != nullptr) return FileKind::exercise;
  if (root.find("exercises") != nullptr) return root.find("score") != nullptr ? FileKind::result : FileKind::assignment;
  if (root.find("answers") != nullptr) return FileKind::answers;
  if (root.find("parts") != nullptr) return FileKind::grade;
  if (root.find("steps") != nullptr && root.find("values") != nullptr) return FileKind::trace;
  if (root.find("objects") != nullptr) return FileKind::scene;
  const Json* degree = root.find("degree");
  if (degree == nullptr && root.find("points") == nullptr) return FileKind::unknown;
  return degree != nullptr && degree->kind == Json::Kind::array ? FileKind::surface : FileKind::curve;
}

}  // namespace blossom
