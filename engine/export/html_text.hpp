#pragma once
// Text as it stands on the page of a lesson.

#include <string>
#include <string_view>

#include "base/html.hpp"
#include "lesson/prose.hpp"

namespace blossom {

// Names with their sub- and superscripts, one above the other where both are.
std::string html_names(const RichText&);
std::string html_typeset(std::string_view text, const Algorithm&);
// Prose, its names set the same way.
std::string html_prose(const Prose&, const Algorithm&);
// "step {n} of {last}" with what the braces stand for.
std::string filled(std::string_view words, std::string_view key, std::string_view with);

}  // namespace blossom
