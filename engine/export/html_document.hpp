#pragma once
// What pages have in common: a head whose policy lets nothing run and nothing load but what stands in the page.

#include <string>
#include <string_view>

namespace blossom {

// <head> with the style sheet; a script, if there is one, is named by its digest and stands in the body.
std::string html_head(const std::string& title, const std::string& summary, std::string_view css,
                      std::string_view script);
// A file's name as an address (RFC 3986).
std::string html_address(std::string_view name);

}  // namespace blossom
