#include "export/html_document.hpp"

#include <openssl/evp.h>

#include <array>
#include <cctype>

#include "base/html.hpp"

namespace blossom {
namespace {

// "'sha256-...'", as a Content Security Policy names an inline script or style sheet.
std::string digest_source(std::string_view text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned size = 0;
  if (EVP_Digest(text.data(), text.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1) return "'none'";
  std::array<unsigned char, 4 * (EVP_MAX_MD_SIZE / 3 + 1) + 1> base64{};
  EVP_EncodeBlock(base64.data(), digest.data(), static_cast<int>(size));
  return "'sha256-" + std::string(reinterpret_cast<const char*>(base64.data())) + "'";
}

}  // namespace

std::string html_head(const std::string& title, const std::string& summary, std::string_view css,
                      std::string_view script) {
  std::string out =
      "<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; base-uri 'none'; "
      "form-action 'none'; script-src " +
      (script.empty() ? std::string("'none'") : digest_source(script)) + "; style-src " + digest_source(css) +
      "\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<meta name=\"referrer\" content=\"no-referrer\">\n"
      "<title>" +
      html_escape(title) + "</title>\n";
  if (!summary.empty()) out += "<meta name=\"description\" content=\"" + html_escape(summary) + "\">\n";
  return out + "<style>" + std::string(css) + "</style>\n</head>\n";
}

std::string html_address(std::string_view name) {
  constexpr char digits[] = "0123456789ABCDEF";
  std::string out;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || std::string_view("-._~/").find(c) != std::string_view::npos)
      out += c;
    else
      (out += '%') += {digits[byte >> 4], digits[byte & 15]};
  }
  return out;
}

}  // namespace blossom
