// Text that was set for a picture, read again as what it says.

#include <algorithm>
#include <cmath>

#include "export/latex_text.hpp"
#include "export/tikz_canvas.hpp"

namespace blossom {
namespace {

struct Line {
  std::vector<const GlyphRun*> runs;
  double baseline = 0, size = 0;
};

// Scripts are smaller than what they belong to, and a little above or below its baseline.
bool is_script_of(const GlyphRun& run, const Line& line) {
  return run.size < 0.9 * line.size && std::abs(run.baseline - line.baseline) < 0.6 * line.size;
}

std::vector<Line> lines_of(std::span<const GlyphRun> runs) {
  std::vector<Line> lines;
  for (const auto& run : runs) {
    if (run.text.empty()) continue;
    const bool same = !lines.empty() && std::abs(run.baseline - lines.back().baseline) < 0.01 * run.size;
    if (!lines.empty() && (same || is_script_of(run, lines.back())))
      lines.back().runs.push_back(&run);
    else
      lines.push_back({{&run}, run.baseline, run.size});
  }
  return lines;
}

// A letter or two in italics are a name; so is whatever has a script.
bool is_name(const GlyphRun& run) {
  const auto letters = decode_utf8(run.text);
  return run.style.italic && letters.size() <= 2 &&
         std::none_of(letters.begin(), letters.end(), [](char32_t c) { return c == U' '; });
}

// The last word of a text, which a script after it belongs to.
std::size_t last_word(std::string_view text) {
  const auto blank = text.find_last_of(" (,=[");
  return blank == std::string_view::npos ? 0 : blank + 1;
}

std::string styled(const GlyphRun& run, const std::string& text) {
  if (text.empty()) return text;
  std::string result = text;
  if (run.style.monospace) result = "\\texttt{" + result + "}";
  if (run.style.italic) result = "\\textit{" + result + "}";
  if (run.style.bold) result = "\\textbf{" + result + "}";
  return result;
}

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
  return first == std::string_view::npos ? std::string() : std::string(text.substr(first, last - first + 1));
}

// Consecutive scripts stand at one letter, first all that are below, then all that are above.
std::string line_text(const Line& line) {
  std::string out;
  for (std::size_t i = 0; i < line.runs.size();) {
    const GlyphRun& run = *line.runs[i++];
    std::string below, above, blanks;
    while (i < line.runs.size() && is_script_of(*line.runs[i], line)) {
      const std::string_view script = line.runs[i]->text;
      (line.runs[i]->baseline > line.baseline ? below : above) += trimmed(script);
      if (script.ends_with(' ')) blanks = " ";
      ++i;
    }
    if (below.empty() && above.empty() && !is_name(run)) {
      out += styled(run, latex_text(run.text));
      continue;
    }
    const std::string_view whole = run.text;
    const std::size_t cut = is_name(run) ? 0 : last_word(whole);
    const std::string name = trimmed(whole.substr(cut));
    out += styled(run, latex_text(whole.substr(0, cut)));
    std::string formula = name.empty() ? "{}" : latex_symbol(name);
    if (!below.empty()) formula += "_{" + latex_text(below) + "}";
    if (!above.empty()) formula += "^{" + latex_text(above) + "}";
    if (run.style.bold) formula = "\\boldsymbol{" + formula + "}";
    out += "$" + formula + "$" + blanks;
    if (below.empty() && above.empty() && whole.ends_with(' ')) out += " ";
  }
  return out;
}

}  // namespace

std::vector<LatexLine> latex_lines(const Fonts& fonts, std::span<const GlyphRun> runs) {
  std::vector<LatexLine> result;
  for (const Line& line : lines_of(runs)) {
    double left = line.runs.front()->x, right = left;
    for (const GlyphRun* run : line.runs)
      right = std::max(right, run->x + fonts.width(run->style, run->text) * run->size);
    result.push_back({line_text(line), (left + right) / 2, line.baseline, line.size});
  }
  return result;
}

}  // namespace blossom
