#pragma once
// Text as it may stand in pages. Control characters (but line breaks and tabs, which are white space there) and invalid
// UTF-8 become U+FFFD.

#include <string>
#include <string_view>

namespace blossom {

// As it may stand in an element or a quoted attribute.
std::string html_escape(std::string_view text);
void append_html(std::string& out, std::string_view text);  // the same, appended

// JSON text as it may stand inside a <script>: < becomes \u003C, so that nothing can end the element.
std::string script_json(std::string_view json);

}  // namespace blossom
