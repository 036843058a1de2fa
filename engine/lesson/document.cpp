#include "lesson/document.hpp"

#include <algorithm>

namespace blossom {

bool expect_schema(const Cursor& root, std::string_view expected) {
  const auto at = root.required("schema");
  if (!at) return false;
  const auto schema = at->string();
  if (!schema) return false;
  if (*schema == expected) return true;
  const std::string_view kind = expected.substr(0, expected.find('/') + 1);
  at->error("must be " + excerpt(expected) + ", not " + excerpt(*schema) +
            (schema->starts_with(kind) ? "; this program does not know that version" : ""));
  return false;
}

std::optional<std::string> read_text(const Cursor& at) {
  auto text = at.string();
  if (!text) return std::nullopt;
  if (text->find_first_not_of(" \t\r\n") == std::string::npos) {
    at.error("must not be empty");
    return std::nullopt;
  }
  return text;
}

std::optional<std::string> read_id(const Cursor& at) {
  auto id = at.string();
  if (!id) return std::nullopt;
  const auto allowed = [](char c) { return ('a' <= c && c <= 'z') || ('0' <= c && c <= '9') || c == '-'; };
  if (!id->empty() && id->size() <= 64 && std::all_of(id->begin(), id->end(), allowed)) return id;
  at.error("must be 1 to 64 of a-z, 0-9 and -, such as \"de-boor-2\", not " + excerpt(*id));
  return std::nullopt;
}

std::optional<Marking> read_marking(const Cursor& at) {
  const auto text = at.string();
  if (!text) return std::nullopt;
  for (const Marking marking : {Marking::at_once, Marking::at_end})
    if (*text == marking_name(marking)) return marking;
  at.error(R"(must be "at-once" or "at-end", not )" + excerpt(*text));
  return std::nullopt;
}

std::string_view marking_name(Marking marking) { return marking == Marking::at_once ? "at-once" : "at-end"; }

std::string no_such_algorithm(std::string_view id) {
  const auto ids = algorithm_ids();
  std::string message = "there is no algorithm " + excerpt(id);
  if (const auto near = did_you_mean(id, ids)) return message + "; did you mean " + excerpt(*near) + "?";
  message += "; the algorithms are";
  for (std::size_t i = 0; i < ids.size(); ++i) message += (i == 0 ? " " : ", ") + ids[i];
  return message;
}

const Algorithm* read_algorithm(const Cursor& root) {
  const auto at = root.required("algorithm");
  if (!at) return nullptr;
  const auto id = at->string();
  if (!id) return nullptr;
  if (const Algorithm* algorithm = find_algorithm(*id)) return algorithm;
  at->error(no_such_algorithm(*id));
  return nullptr;
}

std::optional<Run<Exact>> read_run(const Cursor& root, const Algorithm& algorithm) {
  const auto at = root.required("inputs");
  if (!at) return std::nullopt;
  const auto inputs = read_inputs(algorithm, *at);
  if (!inputs) return std::nullopt;
  auto run = record<Exact>(algorithm, *inputs);
  report_at(*at, run.diagnostics);
  return std::move(run.value);
}

}  // namespace blossom
