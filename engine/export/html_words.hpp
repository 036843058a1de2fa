#pragma once
// The words of the page's own controls, in the languages they are written in.

#include <string>
#include <string_view>

namespace blossom {

struct HtmlWords {
  // "en", or the story's language if the words exist in it.
  explicit HtmlWords(std::string_view language);

  std::string_view language() const { return language_; }
  std::string_view operator()(std::string_view key) const;  // precondition: it is in the table
  std::string json() const;                                 // {"next": "Next step", ...}

 private:
  std::string_view language_;
  std::size_t column_;
};

}  // namespace blossom
