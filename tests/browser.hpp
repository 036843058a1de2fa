#pragma once
// Pages in a headless Chromium: opened as a student opens them, and the document as it is then. What a probe that was
// added to the page finds, it writes into the document.

#include <regex>

#include "app/program.hpp"
#include "base/json.hpp"

namespace blossom::test {

inline std::string chromium() {
  for (const char* path : {"/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"})
    if (fs::exists(path)) return path;
  return {};
}

// The first text between the two; empty: there is none.
inline std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin);
  if (from == std::string::npos) return {};
  const std::size_t to = text.find(end, from + begin.size());
  return to == std::string::npos ? std::string() : text.substr(from + begin.size(), to - from - begin.size());
}

// How the script of a probe begins: its checks, and what they found; an error of the page is found, too.
inline constexpr const char* probe_start = R"js(
"use strict";
const found = [];
let checks = 0;
const check = (what, right) => { ++checks; if (!right) found.push("FAULT " + what); };
addEventListener("error", (event) => found.push("FAULT error: " + event.message));
)js";

// Windows cannot be as narrow as a phone, frames can.
inline std::string framed(const std::string& page, const std::string& width, const std::string& height) {
  const std::string quoted = std::regex_replace(json_quote(page), std::regex("<"), "\\u003C");
  return "<!DOCTYPE html><body><iframe id=\"phone\" width=\"" + width + "\" height=\"" + height +
         "\" style=\"border: 0\"></iframe><script>document.getElementById('phone').srcdoc = " + quoted +
         "</script></body>";
}

// The document in a window of this size, "360,740", after its script has run.
inline Ended browse(const std::string& browser, std::string page, const std::string& window,
                    const std::string& system = "preferredColorScheme=1") {
  const Scratch scratch;
  const std::string width = window.substr(0, window.find(','));
  if (std::stoi(width) < 500) page = framed(page, width, window.substr(width.size() + 1));
  return run_program(
      browser, {"--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
                "--disable-background-networking", "--disable-component-update", "--disable-sync",
                "--user-data-dir=" + (scratch / "profile"), "--blink-settings=" + system, "--window-size=" + window,
                "--virtual-time-budget=8000", "--dump-dom", "file://" + scratch.write("page.html", page)});
}

}  // namespace blossom::test
