#include "lesson/local_text.hpp"

#include <algorithm>

#include "base/json_write.hpp"
#include "lesson/document.hpp"

namespace blossom {
namespace {

bool is_language(std::string_view name) {
  return (name.size() == 2 || name.size() == 3) &&
         std::ranges::all_of(name, [](char c) { return 'a' <= c && c <= 'z'; });
}

std::optional<std::string> read_language(const Cursor& at) {
  auto name = at.string();
  if (!name || is_language(*name)) return name;
  at.error("must be a language such as \"en\" or \"de\", not " + excerpt(*name));
  return std::nullopt;
}

}  // namespace

const std::string& LocalText::in(std::string_view language) const {
  static const std::string nothing;
  for (const auto& [name, text] : texts_)
    if (name == language) return text;
  return texts_.empty() ? nothing : texts_.front().second;
}

bool LocalText::has(std::string_view language) const {
  return std::ranges::any_of(texts_, [&](const auto& text) { return text.first == language; });
}

Languages read_languages(const Cursor& root) {
  Languages languages;
  const std::size_t mistakes = root.error_count();
  if (const auto at = root.optional("language")) languages.own = read_language(*at).value_or(languages.own);
  const auto at = root.optional("languages");
  const std::size_t count = at && at->expect_array(1, 32) ? at->size() : 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto name = read_language((*at)[i]);
    if (!name || *name == languages.own) continue;
    if (std::ranges::find(languages.others, *name) != languages.others.end())
      (*at)[i].error(excerpt(*name) + " stands here already");
    else
      languages.others.push_back(*name);
  }
  languages.known = !root.errors_since(mistakes);
  return languages;
}

std::optional<LocalText> read_local_text(const Cursor& at, const Languages& languages) {
  const auto lacks = [&](const std::string& language) {
    if (languages.known) at.error("has no text in " + excerpt(language) + ", which \"languages\" promises");
  };
  if (!at.is(Json::Kind::object)) {
    auto text = read_text(at);
    if (!text) return std::nullopt;
    for (const std::string& language : languages.others) lacks(language);
    return LocalText(*std::move(text));
  }
  LocalText local;
  const auto own = at.optional(languages.own);
  if (!own && languages.known) {
    at.error("must have a text in the lesson's own language, " + excerpt(languages.own));
  } else if (auto text = own ? read_text(*own) : std::nullopt) {
    local = LocalText(*std::move(text));
  }
  for (std::size_t i = 0; i < at.size(); ++i) {
    const std::string& name = at.json().keys[i];
    if (name == languages.own || name == "$comment") continue;
    if (std::ranges::find(languages.others, name) == languages.others.end()) {
      if (!languages.known) continue;
      at.key_error(i, is_language(name)
                          ? "the lesson is not in " + excerpt(name) + "; \"languages\" says which it is in"
                          : "must be a language such as \"en\" or \"de\", not " + excerpt(name));
    } else if (auto text = read_text(at.member(i))) {
      local.add(name, *std::move(text));
    }
  }
  for (const std::string& language : languages.others)
    if (!at.optional(language)) lacks(language);
  if (local.empty()) return std::nullopt;
  return local;
}

Json write_local_text(const LocalText& local, const Languages& languages) {
  if (local.texts().size() < 2) return json_string(local.own());
  std::vector<std::pair<std::string, Json>> members;
  for (const auto& [name, text] : local.texts())
    members.emplace_back(name.empty() ? languages.own : name, json_string(text));
  return json_object(std::move(members));
}

}  // namespace blossom
