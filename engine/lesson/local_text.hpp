#pragma once
// A text in one or several languages. In files a plain string, which is in the lesson's own language, or an object of
// texts by language:
//
//   "say": "A point."        "say": {"en": "A point.", "de": "Ein Punkt."}
//
// Languages are named as in BCP 47, without regions: "en", "de", "pt". A text that a language lacks is shown in the
// lesson's own.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/json.hpp"

namespace blossom {

class LocalText {
 public:
  LocalText() = default;
  LocalText(std::string text) { texts_.emplace_back(std::string(), std::move(text)); }

  bool empty() const { return texts_.empty() || texts_.front().second.empty(); }
  // In this language, or else in the lesson's own.
  const std::string& in(std::string_view language) const;
  bool has(std::string_view language) const;
  const std::string& own() const { return in({}); }
  operator std::string_view() const { return own(); }
  bool operator==(const LocalText&) const = default;
  bool operator==(std::string_view text) const { return own() == text; }

  // The first is in the lesson's own language and has no name.
  const std::vector<std::pair<std::string, std::string>>& texts() const { return texts_; }
  void add(std::string language, std::string text) { texts_.emplace_back(std::move(language), std::move(text)); }

 private:
  std::vector<std::pair<std::string, std::string>> texts_;
};

// The languages of a lesson: its own ("language", by default "en"), and those its texts are translated into
// ("languages"); a text that lacks one of these is a mistake.
struct Languages {
  std::string own = "en";
  std::vector<std::string> others;
  bool known = true;  // false where the lesson's languages have mistakes: what a text lacks is not known
};
Languages read_languages(const Cursor& root);

// Nothing, with diagnostics, if it is no text in these languages.
std::optional<LocalText> read_local_text(const Cursor&, const Languages&);
// As read_local_text reads it, to be written again.
Json write_local_text(const LocalText&, const Languages&);

}  // namespace blossom
