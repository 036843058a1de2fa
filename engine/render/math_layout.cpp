#include "render/math_layout.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/math_symbols.hpp"
#include "render/math_fence.hpp"

namespace blossom {
namespace {

using Kind = Math::Kind;
using Class = Math::Class;

enum class Style : std::uint8_t { display, text, script, script_script };

// In ems. The strokes are those of DejaVu Sans, whose stems are 0.09 wide and whose signs 0.08 thick.
constexpr double rule = 0.062;  // of fractions, roots and bars
constexpr double thin = 0.167, medium = 0.2, thick = 0.26;
constexpr double script_scale = 0.7, script_script_scale = 0.54;
constexpr double sub_drop = 0.22, super_rise = 0.38;  // as scripts of names stand (rich_text.cpp)

Style smaller(Style style) {
  return style == Style::display || style == Style::text ? Style::script : Style::script_script;
}
double scale_of(Style style) {
  return style == Style::script ? script_scale : style == Style::script_script ? script_script_scale : 1;
}

// A box being made, with what scripts need to know of it.
struct Box : MathBox {
  double slant = 0;        // how far the ink leans out at its upper right
  bool is_letter = false;  // a single character: its scripts stand where those of names do

  void add(Box other, double dx, double dy) {  // dy down
    for (GlyphRun& run : other.runs) {
      run.x += dx;
      run.baseline += dy;
      runs.push_back(std::move(run));
    }
    for (TextBar& bar : other.bars) {
      bar.x += dx;
      bar.y += dy;
      bars.push_back(bar);
    }
    for (TextStroke& stroke : other.strokes) {
      for (auto& point : stroke.points) point = {point.x + dx, point.y + dy};
      strokes.push_back(std::move(stroke));
    }
    height = std::max(height, other.height - dy);
    depth = std::max(depth, other.depth + dy);
  }
};

bool is_prime(const Math& math) { return math.kind == Kind::symbol && math.text == "′"; }
bool is_empty(const Math& math) { return math.kind == Kind::row && math.parts.empty(); }

class Layout {
 public:
  Layout(const Fonts& fonts, double size, bool bold) : fonts_(&fonts), size_(size), bold_(bold) {
    const Fonts::Ink plus = fonts.ink({}, U'+');
    axis_ = (plus.top + plus.bottom) / 2;
    x_height_ = fonts.ink({}, U'x').top;
  }

  Box set(const Math& math, Style style) {
    switch (math.kind) {
      case Kind::row:
        return row(math.parts, style);
      case Kind::symbol:
        return symbol(math, style);
      case Kind::scripts:
        return scripts(math, style);
      case Kind::fraction:
        return fraction(math, style, true);
      case Kind::binomial:
        return between_fences(fraction(math, style, false), "()", style);
      case Kind::root:
        return root(math, style);
      case Kind::accent:
        return accent(math, style);
      case Kind::fenced:
        return between_fences(set(math.parts[0], style), math.text, style);
    }
    return {};
  }

 private:
  double em(Style style) const { return size_ * scale_of(style); }
  double rule_width(Style style) const { return rule * size_ * std::sqrt(scale_of(style)); }

  // ---- symbols and rows ----

  Box glyphs(const std::string& text, FontStyle look, double size) const {
    Box box;
    look.bold = look.bold || bold_;
    box.width = fonts_->width(look, text) * size;
    for (const char32_t c : decode_utf8(text)) {
      const Fonts::Ink ink = fonts_->ink(look, c);
      box.height = std::max(box.height, ink.top * size);
      box.depth = std::max(box.depth, -ink.bottom * size);
      box.slant = std::max(0.0, (ink.right - fonts_->advance(look, c)) * size);
    }
    box.runs.push_back({text, 0, 0, size, look});
    return box;
  }

  Box symbol(const Math& math, Style style) const {
    if (math.of == Class::space) {
      Box box;
      box.width = (math.text == "\u2003" ? 1 : thin) * em(style);
      return box;
    }
    const bool sign = math.of == Class::large && static_cast<unsigned char>(math.text[0]) >= 0x80;
    if (sign) return large_sign(math, style);
    if (math.of == Class::word && math.upright) {  // blanks at its ends count
      Box words = glyphs(math.text, {}, em(style));
      words.slant = 0;
      return words;
    }
    const bool italic = math.of == Class::variable && !math.upright;
    Box box = glyphs(math.text, {math.bold, italic, false}, em(style));
    box.is_letter = math.of == Class::variable || math.of == Class::number;
    return box;
  }

  // A sum is a larger letter that stands about the axis.
  Box large_sign(const Math& math, Style style) const {
    const bool integral = math.text == "∫";
    const double factor = style == Style::display ? (integral ? 1.9 : 1.6) : integral ? 1.2 : 1.1;
    Box box = glyphs(math.text, {}, em(style) * factor);
    const double middle = (box.height - box.depth) / 2, shift = middle - axis_ * em(style);
    box.runs[0].baseline = shift;
    box.height -= shift;
    box.depth += shift;
    return box;
  }

  // What stands between two things, The TeXbook, chapter 18. In scripts only functions stand apart.
  double gap(const Math& left, const Math& right, bool left_is_sign, bool right_is_sign, Style style) const {
    const Math *a = nucleus(left), *b = nucleus(right);
    const auto kind_of = [](const Math& part, const Math* symbol, bool is_sign) {
      if (symbol == nullptr)
        return part.kind == Kind::fenced || part.kind == Kind::fraction ? Class::word : Class::variable;
      if (symbol->of == Class::operation && is_sign) return Class::variable;
      if (symbol->of == Class::word) return symbol->upright ? Class::variable : Class::large;
      return symbol->of == Class::number ? Class::variable : symbol->of;
    };
    const Class l = kind_of(left, a, left_is_sign), r = kind_of(right, b, right_is_sign);
    if (l == Class::space || r == Class::space) return 0;
    if (l == Class::large)
      return r == Class::open || right.kind == Kind::fenced ? 0
             : r == Class::relation                         ? thick
             : r == Class::close                            ? 0
                                                            : thin;
    if (r == Class::large)
      return l == Class::open ? 0 : l == Class::relation ? thick : l == Class::operation ? medium : thin;
    if (style == Style::script || style == Style::script_script) return 0;
    if (l == Class::punctuation) return thin;
    if (l == Class::relation || r == Class::relation)
      return l == r || l == Class::open || r == Class::close || r == Class::punctuation ? 0 : thick;
    if (l == Class::operation || r == Class::operation) return r == Class::close || l == Class::open ? 0 : medium;
    // Inner atoms: fractions and what is fenced by \left and \right stand a little apart from letters.
    if (l == Class::word || r == Class::word)
      return l == Class::open || r == Class::close || r == Class::punctuation || r == Class::open ? 0 : thin;
    return 0;
  }

  Box row(const std::vector<Math>& parts, Style style) {
    Box box;
    double pen = 0;
    bool sign_before = false;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Math* before = i > 0 ? &parts[i - 1] : nullptr;
      // A sign where nothing is to its left, or nothing to its right.
      const Math* own = nucleus(parts[i]);
      const bool sign = own != nullptr && own->of == Class::operation &&
                        ((is_sign(before) && !(sign_before && before != nullptr)) || i + 1 == parts.size());
      if (before != nullptr) pen += gap(*before, parts[i], sign_before, sign, style) * em(style);
      Box part = set(parts[i], style);
      // An upright letter behind a slanted one keeps clear of it; slanted ones lean alike.
      const bool leans = part.is_letter && !part.runs.empty() && part.runs[0].style.italic;
      if (i > 0 && !leans) pen += 0.5 * std::min(box.slant, 0.12 * em(style));
      box.slant = part.slant;
      const double width = part.width;
      box.add(std::move(part), pen, 0);
      pen += width;
      sign_before = sign;
    }
    box.width = pen;
    box.is_letter = false;
    return box;
  }

  // ---- scripts ----

  Box scripts(const Math& math, Style style) {
    const Math& base = math.parts[0];
    const bool operation = base.kind == Kind::symbol && base.of == Class::large;
    if (operation && style == Style::display && base.text != "∫") return limits(math, style);
    Box box = set(base, style);
    const Style inner = smaller(style);
    const double e = em(style);
    const bool low = !is_empty(math.parts[1]), high = !is_empty(math.parts[2]);
    // Primes are raised already, in any font.
    const Math& raised = math.parts[2];
    const bool primes =
        is_prime(raised) || (raised.kind == Kind::row && high && std::ranges::all_of(raised.parts, is_prime));
    Box below = set(math.parts[1], inner), above = set(raised, primes ? style : inner);
    // Rules 18a to 18f, with the places that scripts of names have for letters.
    double drop = sub_drop * e, rise = super_rise * e;
    if (!box.is_letter) {
      drop = std::max(drop, box.depth + 0.12 * e);
      rise = std::max(rise, box.height - 0.32 * e);
    }
    rise = std::max(rise, above.depth + 0.25 * x_height_ * e);
    drop = std::max(drop, below.height - 0.8 * x_height_ * e);
    const double least = 3 * rule_width(style);
    if (low && high) {
      const double between = (rise - above.depth) - (below.height - drop);
      if (between < least) {
        const double missing = least - between;
        rise += 0.5 * missing;
        drop += 0.5 * missing;
      }
    }
    if (primes) rise = 0;
    const double start = box.width + 0.02 * e, lean = std::min(box.slant, 0.2 * e);
    double width = box.width;
    // The lower end of an integral lies further left.
    const double tuck = operation && base.text == "∫" ? 0.12 * e : 0;
    if (low) width = std::max(width, start - tuck + below.width);
    if (high) width = std::max(width, start + lean + above.width);
    if (low) box.add(std::move(below), start - tuck, drop);
    if (high) box.add(std::move(above), start + lean, -rise);
    box.width = width + 0.04 * e;
    box.slant = 0;
    box.is_letter = false;
    return box;
  }

  // Above and below the operator, rule 13a.
  Box limits(const Math& math, Style style) {
    Box sign = set(math.parts[0], style), below = set(math.parts[1], smaller(style)),
        above = set(math.parts[2], smaller(style));
    const double e = em(style), width = std::max({sign.width, below.width, above.width});
    const double up = sign.height + 0.14 * e + above.depth, down = sign.depth + 0.14 * e + below.height;
    Box box;
    box.width = width;
    const double sign_x = (width - sign.width) / 2, below_x = (width - below.width) / 2,
                 above_x = (width - above.width) / 2;
    box.add(std::move(sign), sign_x, 0);
    if (!is_empty(math.parts[1])) box.add(std::move(below), below_x, down);
    if (!is_empty(math.parts[2])) box.add(std::move(above), above_x, -up);
    return box;
  }

  // ---- fractions and roots ----

  // Rules 15a to 15e.
  Box fraction(const Math& math, Style style, bool with_bar) {
    const Style inner = style == Style::display ? Style::text : smaller(style);
    Box above = set(math.parts[0], inner), below = set(math.parts[1], inner);
    const double e = em(style), bar = with_bar ? rule_width(style) : 0, axis = axis_ * e;
    const double clear = (style == Style::display ? 0.2 : 0.12) * e;
    // Numbers without descent stand on one line in all fractions of a row.
    const double up = std::max(axis + bar / 2 + clear + above.depth, (style == Style::display ? 0.7 : 0.5) * e);
    const double down = std::max(bar / 2 + clear + below.height - axis, (style == Style::display ? 0.62 : 0.3) * e);
    const double overhang = 0.06 * e, side = 0.08 * e;
    const double inside = std::max(above.width, below.width) + 2 * overhang;
    Box box;
    box.width = inside + 2 * side;
    const double above_x = (box.width - above.width) / 2, below_x = (box.width - below.width) / 2;
    box.add(std::move(above), above_x, -up);
    box.add(std::move(below), below_x, down);
    if (with_bar) box.bars.push_back({side, -axis - bar / 2, inside, bar});
    return box;
  }

  Box root(const Math& math, Style style) {
    Box inside = set(math.parts[0], style);
    const double e = em(style), bar = rule_width(style);
    const double clear = (style == Style::display ? 0.16 : 0.12) * e;
    const double top = std::max(inside.height, x_height_ * e) + clear + bar / 2;  // of the middle of the line
    const double bottom = std::max(inside.depth, 0.02 * e) + 0.04 * e;
    // The sign: a short stroke up, a long one down, a longer one up, and the line over everything.
    const double reach = std::clamp((top + bottom) * 0.2, 0.24 * e, 0.42 * e), hook = 0.16 * e;
    double left = 0;
    Box box;
    if (math.parts.size() > 1) {
      Box degree = set(math.parts[1], Style::script_script);
      const double lift = bottom - 0.56 * (top + bottom) - degree.depth;
      left = std::max(0.0, degree.width - 0.2 * e);
      const double at = std::max(0.0, left - degree.width + 0.2 * e);
      box.add(std::move(degree), at, lift);
    }
    const double x = left + 0.06 * e, start = x + hook + 0.09 * e + reach;
    const double knee = bottom - 0.46 * (top + bottom);
    TextStroke sign{{{x, knee + 0.05 * e},
                     {x + hook * 0.6, knee},
                     {x + hook + 0.09 * e, bottom},
                     {start, -top},
                     {start + inside.width + 0.12 * e, -top}},
                    bar};
    const double width = inside.width;
    box.add(std::move(inside), start + 0.06 * e, 0);
    box.strokes.push_back(std::move(sign));
    box.width = start + width + 0.18 * e;
    box.height = std::max(box.height, top + bar / 2);
    box.depth = std::max(box.depth, bottom + bar / 2);
    return box;
  }

  Box accent(const Math& math, Style style) {
    Box box = set(math.parts[0], style);
    const double e = em(style), bar = rule_width(style);
    const bool letter = box.is_letter && !box.runs.empty();
    // Over the ink of a letter, which leans; over the width of everything else.
    const double y = -(std::max(box.height, x_height_ * e) + 0.1 * e + bar / 2);
    double left = 0.03 * e, right = box.width - 0.03 * e;
    if (letter && box.runs[0].style.italic) {
      left += Fonts::slant * box.height * 0.9;
      right += Fonts::slant * box.height * 0.75;
    }
    const double middle = (left + right) / 2;
    double top = -y;
    if (math.text == "\u0304") {
      box.bars.push_back({left, y - bar / 2, right - left, bar});
    } else if (math.text == "\u20D7") {
      const double half = std::max((right - left) / 2, 0.26 * e), head = 0.11 * e, line = y - 0.05 * e;
      box.strokes.push_back({{{middle - half, line}, {middle + half, line}}, bar});
      box.strokes.push_back(
          {{{middle + half - head, line - head}, {middle + half, line}, {middle + half - head, line + head}}, bar});
      top = -line + head;
    } else {
      const double half = 0.17 * e, rise = 0.15 * e;
      box.strokes.push_back({{{middle - half, y}, {middle, y - rise}, {middle + half, y}}, bar});
      top = -y + rise;
    }
    box.height = std::max(box.height, top + bar);
    return box;
  }

  // ---- fences ----

  // As tall as what is between, about the axis, rule 19: a letter while one is enough, and a line where not.
  Box between_fences(Box inside, std::string_view fences, Style style) {
    const double e = em(style), axis = axis_ * e;
    const double half = std::max(inside.height - axis, inside.depth + axis);
    Box box;
    double pen = 0;
    const auto add_fence = [&](char fence) {
      if (fence == ' ') return;
      Box made;
      if (half <= 0.56 * e) {
        made = glyphs(std::string(1, fence), {}, e);
      } else {
        const double reach = half + 0.04 * e;
        TallFence tall = tall_fence(fence, -axis - reach, -axis + reach, e);
        made.strokes.push_back(std::move(tall.stroke));
        made.width = tall.width;
        made.height = reach + axis;
        made.depth = reach - axis;
      }
      const double width = made.width;
      box.add(std::move(made), pen, 0);
      pen += width;
    };
    add_fence(fences[0]);
    const double width = inside.width;
    box.add(std::move(inside), pen, 0);
    pen += width;
    add_fence(fences[1]);
    box.width = pen;
    return box;
  }

  const Fonts* fonts_;
  double size_;
  bool bold_;
  double axis_ = 0, x_height_ = 0;  // in ems
};

}  // namespace

MathBox lay_out(const Fonts& fonts, const Math& math, double size, bool display, bool bold) {
  return Layout(fonts, size, bold).set(math, display ? Style::display : Style::text);
}

}  // namespace blossom
