#pragma once
// The fixed words of all formats, in the languages they are written in: those around a lesson's own.

#include <string>
#include <string_view>

#include "scene/display_list.hpp"

namespace blossom {

struct PageWords {
  // "en", or the story's language if the words exist in it.
  explicit PageWords(std::string_view language);

  std::string_view language() const { return language_; }
  std::string_view operator()(std::string_view key) const;  // precondition: it is in the table
  // With this in the place of its braces: "step {n} of {last}".
  std::string operator()(std::string_view key, std::string_view n) const;
  // The words of scenes, which are English there: "This step". Anything else stays.
  void put_into(Label&) const;
  void put_into(View&) const;
  std::string json() const;  // {"next": "Next step", ...}: those of web pages

 private:
  std::string_view language_;
  std::size_t column_;
};

}  // namespace blossom
