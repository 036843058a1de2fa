#include "scene/panel_parts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/utf8.hpp"

namespace blossom::parts {
namespace {

constexpr double largest_text = 1.12;  // of the theme with the largest text
constexpr double script_size = 0.7;    // of sub- and superscripts

double text_size(Role role) {  // as in the themes
  switch (role) {
    case Role::text_quiet:
      return 12.5;
    case Role::text_strong:
      return 17;
    case Role::highlight:
      return 12;
    default:
      return 14;
  }
}

double em_of(char c) {
  switch (c) {
    case ' ':
    case ',':
    case '.':
    case 'i':
    case 'l':
      return 0.32;
    case '(':
    case ')':
    case '[':
    case ']':
    case '/':
    case '-':
    case 'f':
    case 't':
    case 'r':
      return 0.41;
    case 'm':
    case 'M':
    case 'W':
    case 'w':
    case '=':
    case '+':
    case '<':
      return 0.9;
    default:
      return c >= 'A' && c <= 'Z' ? 0.74 : 0.64;
  }
}

}  // namespace

double ems(std::string_view text, bool bold, bool monospace) {
  if (monospace) return 0.61 * static_cast<double>(utf8_count(text));
  double sum = 0;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = std::max<std::size_t>(utf8_length(text, i), 1);
    sum += length == 1 ? em_of(text[i]) : 0.85;
    i += length;
  }
  return bold ? 1.12 * sum : sum;
}

double ems(const RichText& text) {
  double sum = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const TextRun& run = text[i];
    double width = ems(run.text, run.bold, run.monospace);
    if (run.level != TextRun::Level::base) {
      width *= script_size;
      // A subscript and a superscript behind it stand one above the other.
      const bool stacks = i > 0 && text[i - 1].level != TextRun::Level::base && text[i - 1].level != run.level;
      if (stacks) width = std::max(0.0, width - script_size * ems(text[i - 1].text));
    }
    sum += width;
  }
  return sum;
}

double width_of(double ems, Role role, double size) { return ems * text_size(role) * size * largest_text; }

double size_to_fit(double ems, Role role, double width, double most) {
  const double full = width_of(ems, role, 1);
  return full > 0 ? std::min(most, width / full) : most;
}

std::vector<std::string> wrapped(std::string_view text, double most_ems, bool bold, bool monospace, double hanging) {
  std::vector<std::string> lines(1);
  const auto fits = [&](const std::string& line) {
    return ems(line, bold, monospace) <= most_ems - (lines.size() > 1 ? hanging : 0);
  };
  std::size_t at = 0;
  while (at < text.size()) {
    std::size_t end = text.find(' ', at);
    if (end == std::string_view::npos) end = text.size();
    std::string word(text.substr(at, end - at));
    at = end + 1;
    if (word.empty()) continue;
    const std::string joined = lines.back().empty() ? word : lines.back() + " " + word;
    if (fits(joined)) {
      lines.back() = joined;
      continue;
    }
    if (!lines.back().empty()) lines.emplace_back();
    while (!fits(word)) {
      std::size_t kept = 0;
      while (kept < word.size()) {
        const std::size_t next = kept + std::max<std::size_t>(utf8_length(word, kept), 1);
        if (kept > 0 && !fits(word.substr(0, next))) break;
        kept = next;
      }
      if (kept >= word.size()) break;  // a single letter is wider than the line
      lines.back() = word.substr(0, kept);
      lines.emplace_back();
      word.erase(0, kept);
    }
    lines.back() = word;
  }
  return lines;
}

std::string shortened(std::string_view text, std::size_t most) {
  if (utf8_count(text) <= most) return std::string(text);
  std::size_t front = most / 2, back = text.size() - (most - 1 - most / 2);
  const auto inside = [&](std::size_t i) { return (static_cast<unsigned char>(text[i]) & 0xC0u) == 0x80u; };
  while (front > 0 && inside(front)) --front;
  while (back < text.size() && inside(back)) ++back;
  return std::string(text.substr(0, front)) + "…" + std::string(text.substr(back));
}

std::string significant(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return value == 0 ? "0" : "none";
  const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
  const int decimals = digits - 1 - magnitude;
  if (decimals >= 0) return format_short(value, std::min(decimals, 12));
  const double unit = std::pow(10, -decimals);
  return format_short(std::round(value / unit) * unit, 0);
}

void fill(View& view, const Box& b, Role role, double opacity) {
  view.polygons.push_back(
      {{{b.x, b.y, 0}, {b.right(), b.y, 0}, {b.right(), b.bottom(), 0}, {b.x, b.bottom(), 0}}, role, opacity});
}

void outline(View& view, const Box& b, Role role, double width_scale, bool dashed) {
  stroke(view, {{b.x, b.y, 0}, {b.right(), b.y, 0}, {b.right(), b.bottom(), 0}, {b.x, b.bottom(), 0}}, role,
         width_scale, dashed);
  view.polylines.back().closed = true;
}

void stroke(View& view, std::vector<glm::dvec3> points, Role role, double width_scale, bool dashed) {
  Polyline line;
  line.points = std::move(points);
  line.role = role;
  line.width_scale = width_scale;
  line.dashed = dashed;
  view.polylines.push_back(std::move(line));
}

Label& text(View& view, double x, double y, RichText runs, Role role, double size, Label::Placement placement) {
  Label label;
  label.anchor = {x, y, 0};
  label.text = std::move(runs);
  label.role = role;
  label.size_scale = size;
  label.placement = placement;
  view.labels.push_back(std::move(label));
  return view.labels.back();
}

double heading(View& view, double x, double y, const std::string& words, double width) {
  const double size = size_to_fit(ems(words, true), Role::text_quiet, width, 0.85);
  text(view, x, y + 12, {{words, TextRun::Level::base, false, true}}, Role::text_quiet, size);
  return 22;
}

std::string other_share(const std::string& share, double value) {
  if (share.find('/') != std::string::npos)
    if (const auto exact = Exact::parse(share)) return (Exact(1) - *exact).to_string();
  return format_short(1 - value, 4);
}

std::vector<std::string> weights_of(const StepSource& source, ValueId v) {
  const auto from = source.graph->operands(v);
  std::vector<std::string> texts(from.size());
  const RuleInfo& rule = *source.graph->value(v).rule;
  if (from.size() != 3 || (rule.polar != Polar::blend && rule.polar != Polar::merge)) return texts;
  // a of Blend belongs to the second point, a of Elevate to the first.
  const std::size_t own = rule.polar == Polar::merge ? 1 : 2;
  const double a = source.scalars[from[0]];
  const std::string share = source.value_text(from[0]);
  const bool is_short = share.size() <= 7;
  texts[own] = is_short ? share : format_short(a, 3);
  texts[3 - own] = is_short ? other_share(share, a) : format_short(1 - a, 3);
  return texts;
}

std::string share_text(const StepSource& source, double share) {
  constexpr long most_denominator = 999;
  const std::string decimal = format_short(share, 3);
  if (!source.exact) return decimal;
  // The convergents of its continued fraction: what is a fraction of small numbers is found after a few.
  double rest = std::abs(share);
  long p = 1, q = 0, p_before = 0, q_before = 1;
  for (int i = 0; i < 12 && rest < 1e4; ++i) {
    const long whole = static_cast<long>(rest);
    p_before = std::exchange(p, whole * p + p_before);
    q_before = std::exchange(q, whole * q + q_before);
    if (q > most_denominator) break;
    if (std::abs(static_cast<double>(p) - std::abs(share) * static_cast<double>(q)) < 1e-9 * static_cast<double>(q))
      return (share < 0 ? "-" : "") + std::to_string(p) + (q == 1 ? "" : "/" + std::to_string(q));
    if (rest - static_cast<double>(whole) < 1e-12) break;
    rest = 1 / (rest - static_cast<double>(whole));
  }
  return "≈ " + decimal;
}

}  // namespace blossom::parts
