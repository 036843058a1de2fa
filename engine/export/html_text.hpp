#pragma once
// Text as it stands on the page of a lesson.

#include <string>
#include <string_view>

#include "lesson/prose.hpp"

namespace blossom {

// As it may stand in an element or a quoted attribute.
std::string html_escaped(std::string_view);
// Names with their sub- and superscripts, one above the other where both are.
std::string html_names(const RichText&);
std::string html_typeset(std::string_view text, const Algorithm&);
// Prose, its names set the same way.
std::string html_prose(const Prose&, const Algorithm&);
// "step {n} of {last}" with what the braces stand for.
std::string filled(std::string_view words, std::string_view key, std::string_view with);
// JSON as it may stand in a <script>: nothing in it ends the element.
std::string script_json(std::string_view json);

}  // namespace blossom
