// Scalable Vector Graphics (W3C, SVG 1.1, chapter 8 "Paths"). Written: plane curves as paths of lines, quadratic and
// cubic Bezier segments, exactly where they are polynomial of degree 3 at most, otherwise as polylines within the
// tolerance. Read: the d of every path, polyline and polygon, each subpath one curve; elliptic arcs become rational
// quadratic segments (The NURBS Book 7.3). Transformations and viewBox are not looked at. y is down there and up here.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <pugixml.hpp>

#include "base/utf8.hpp"
#include "exchange/exchange_mesh.hpp"
#include "exchange/exchange_text.hpp"
#include "geometry/document.hpp"
#include "kernel/bezier_extraction.hpp"
#include "kernel/degree_elevation.hpp"

namespace blossom {
namespace {

using namespace exchange;

// ---- writing --------------------------------------------------------------------------------------------------------

std::string xml(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

struct Drawing {
  std::string paths;
  glm::dvec2 low{1e300}, high{-1e300};
  int digits = 17;

  std::string place(double x, double y) {
    low = glm::min(low, {x, -y});
    high = glm::max(high, {x, -y});
    return decimal(x, digits) + " " + decimal(-y, digits);
  }
};

// The d of a polynomial curve of degree 1 to 3.
std::string exact_path(const Curve<Exact>& curve, Drawing& drawing) {
  NoRecorder<Exact> none;
  const auto segments = bezier_extraction(curve, none);
  std::string d;
  glm::dvec2 last{NAN, NAN};
  for (const Curve<Exact>& segment : segments) {
    const auto at = [&](std::size_t i) {
      return glm::dvec2{segment.points[i].x.to_double(), segment.points[i].y.to_double()};
    };
    if (const auto begin = at(0); begin != last) d += (d.empty() ? "M " : " M ") + drawing.place(begin.x, begin.y);
    d += segment.degree == 1 ? " L" : segment.degree == 2 ? " Q" : " C";
    for (std::size_t i = 1; i < segment.points.size(); ++i) d += " " + drawing.place(at(i).x, at(i).y);
    last = at(segment.points.size() - 1);
  }
  return d;
}

Checked<Exported> write(const Workspace& scene, const ExportOptions& options) {
  const auto objects = chosen(scene, options);
  const double tolerance = length_of(objects, options.tolerance);
  Drawing drawing;
  drawing.digits = options.digits;
  std::size_t approximated = 0, flattened = 0, others = 0;
  for (const SceneObject* object : objects) {
    const auto* curve = std::get_if<Curve<Exact>>(&object->geometry);
    if (curve == nullptr) {
      ++others;
      continue;
    }
    std::string d;
    if (curve->dimension == 3) ++flattened;
    if (!curve->rational && curve->degree <= 3) {
      d = exact_path(*curve, drawing);
    } else {
      ++approximated;
      for (const Path& path : paths_of(*object, convert<double>(*curve), tolerance))
        for (std::size_t i = 0; i < path.points.size(); ++i)
          d += (i == 0 ? (d.empty() ? "M " : " M ") : " L ") + drawing.place(path.points[i].x, path.points[i].y);
    }
    const auto [r, g, b] = rgb_of(object->color);
    char color[8];
    std::snprintf(color, sizeof color, "#%02x%02x%02x", r, g, b);
    drawing.paths += "  <path stroke=\"" + std::string(color) + "\" d=\"" + d + "\"><title>" + xml(object->name) +
                     "</title></path>\n";
  }
  if (drawing.paths.empty())
    return Diagnostics{{"", 0, 0, "", "SVG holds plane curves, and there is no curve to be written"}};
  const glm::dvec2 size = glm::max(drawing.high - drawing.low, glm::dvec2(1e-9));
  const double margin = 0.05 * std::max(size.x, size.y);
  Exported made;
  made.bytes = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"" + decimal(drawing.low.x - margin, 9) + " " +
               decimal(drawing.low.y - margin, 9) + " " + decimal(size.x + 2 * margin, 9) + " " +
               decimal(size.y + 2 * margin, 9) + "\" fill=\"none\" stroke-width=\"" +
               decimal(std::max(size.x, size.y) / 200, 6) + "\">\n" + drawing.paths + "</svg>\n";
  made.notes.push_back("knots and parameters are left out: a path has a shape only");
  if (approximated > 0)
    made.notes.push_back(std::to_string(approximated) +
                         " curves that are rational or of a degree above 3 are written as short lines");
  if (flattened > 0) made.notes.push_back(std::to_string(flattened) + " curves in space are seen from above");
  if (others > 0) made.notes.push_back(std::to_string(others) + " surfaces and points are left out");
  return made;
}

// ---- reading --------------------------------------------------------------------------------------------------------

struct P2 {
  Exact x{0}, y{0};
  friend P2 operator+(const P2& a, const P2& b) { return {a.x + b.x, a.y + b.y}; }
  friend P2 operator-(const P2& a, const P2& b) { return {a.x - b.x, a.y - b.y}; }
  bool operator==(const P2&) const = default;
};

// One Bezier segment: its points after the first, and the weight of the middle one of an arc.
struct Segment {
  std::vector<P2> points;
  Exact weight{1};
};

constexpr std::size_t most_segments = 20'000;

// The grammar of d is of letters and numbers with hardly anything between them.
class PathReader {
 public:
  explicit PathReader(std::string_view d) : rest_(d) {}

  // False, with what is wrong: the rest is not read.
  bool read() {
    char command = 0;
    while (skip(), !rest_.empty()) {
      const char c = rest_.front();
      if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
        command = c;
        rest_.remove_prefix(1);
        if (command == 'Z' || command == 'z') {
          close();
          continue;
        }
      } else if (command == 0) {
        return fail("a path begins with M");
      }
      if (!apply(command)) return false;
      if (command == 'M') command = 'L';
      if (command == 'm') command = 'l';
      if (count_ > most_segments) return fail("has more than 20,000 segments");
    }
    flush();
    return true;
  }

  struct Piece {
    P2 start;
    std::vector<Segment> segments;
    bool closed = false;
  };
  std::vector<Piece> pieces;
  std::string wrong;

 private:
  bool fail(std::string message) {
    wrong = std::move(message);
    return false;
  }
  void skip() {
    while (!rest_.empty() && (rest_.front() == ',' || static_cast<unsigned char>(rest_.front()) <= ' '))
      rest_.remove_prefix(1);
  }
  std::optional<Exact> number() {
    skip();
    std::size_t n = 0;
    bool digits = false, dot = false;
    if (n < rest_.size() && (rest_[n] == '+' || rest_[n] == '-')) ++n;
    for (; n < rest_.size(); ++n) {
      if (rest_[n] == '.' && !dot)
        dot = true;
      else if ('0' <= rest_[n] && rest_[n] <= '9')
        digits = true;
      else
        break;
    }
    if (digits && n < rest_.size() && (rest_[n] == 'e' || rest_[n] == 'E')) {
      std::size_t e = n + 1;
      if (e < rest_.size() && (rest_[e] == '+' || rest_[e] == '-')) ++e;
      std::size_t end = e;
      while (end < rest_.size() && '0' <= rest_[end] && rest_[end] <= '9') ++end;
      if (end > e) n = end;
    }
    auto x = digits ? Exact::parse(rest_.substr(0, n)) : std::nullopt;
    if (!x) {
      fail("must be a number at " + excerpt(rest_.substr(0, 12)));
      return x;
    }
    rest_.remove_prefix(n);
    return x;
  }
  // 0 or 1, which need nothing behind them.
  std::optional<bool> flag() {
    skip();
    if (rest_.empty() || (rest_.front() != '0' && rest_.front() != '1')) {
      fail("a flag of an arc is 0 or 1");
      return std::nullopt;
    }
    const bool on = rest_.front() == '1';
    rest_.remove_prefix(1);
    return on;
  }
  bool place(bool relative, P2& to) {
    const auto x = number(), y = x ? number() : std::nullopt;
    if (!y) return false;
    to = {*x, -*y};
    if (relative) to = to + now_;
    return true;
  }

  bool apply(char command) {
    const bool relative = std::islower(static_cast<unsigned char>(command)) != 0;
    const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
    P2 a, b, to;
    switch (kind) {
      case 'M':
        if (!place(relative, to)) return false;
        flush();
        now_ = piece_.start = to;
        break;
      case 'L':
        if (!place(relative, to)) return false;
        add({to}, kind);
        break;
      case 'H':
      case 'V': {
        const auto x = number();
        if (!x) return false;
        to = now_;
        (kind == 'H' ? to.x : to.y) = kind == 'H' ? (relative ? now_.x + *x : *x) : (relative ? now_.y - *x : -*x);
        add({to}, kind);
        break;
      }
      case 'Q':
        if (!place(relative, a) || !place(relative, to)) return false;
        add({a, to}, kind);
        break;
      case 'T':
        if (!place(relative, to)) return false;
        add({last_ == 'Q' || last_ == 'T' ? now_ + (now_ - control_) : now_, to}, kind);
        break;
      case 'C':
        if (!place(relative, a) || !place(relative, b) || !place(relative, to)) return false;
        add({a, b, to}, kind);
        break;
      case 'S':
        if (!place(relative, b) || !place(relative, to)) return false;
        add({last_ == 'C' || last_ == 'S' ? now_ + (now_ - control_) : now_, b, to}, kind);
        break;
      case 'A':
        return arc(relative);
      default:
        return fail("there is no command " + excerpt(std::string(1, command)) + " in a path");
    }
    last_ = kind;
    return true;
  }
  void add(std::vector<P2> points, char kind) {
    control_ = points.size() > 1 ? points[points.size() - 2] : now_;
    now_ = points.back();
    piece_.segments.push_back({std::move(points), Exact(1)});
    last_ = kind;
    ++count_;
  }
  void close() {
    if (!piece_.segments.empty() && !(now_ == piece_.start)) add({piece_.start}, 'L');
    piece_.closed = true;
    const P2 start = piece_.start;
    flush();
    now_ = piece_.start = start;
    last_ = 'Z';
  }
  void flush() {
    if (!piece_.segments.empty()) pieces.push_back(std::move(piece_));
    piece_ = {};
    piece_.start = now_;
  }

  // From endpoints to centre (SVG 1.1, appendix F.6.5), then one rational segment for each quarter at most.
  bool arc(bool relative) {
    const auto rx = number(), ry = rx ? number() : std::nullopt, turn = ry ? number() : std::nullopt;
    const auto large = turn ? flag() : std::nullopt, sweep = large ? flag() : std::nullopt;
    P2 to;
    if (!sweep || !place(relative, to)) return false;
    double a = std::abs(rx->to_double()), b = std::abs(ry->to_double());
    const glm::dvec2 from{now_.x.to_double(), -now_.y.to_double()}, end{to.x.to_double(), -to.y.to_double()};
    if (a == 0 || b == 0 || from == end) {
      add({to}, 'A');
      return true;
    }
    const double phi = turn->to_double() * std::numbers::pi / 180, c = std::cos(phi), s = std::sin(phi);
    const glm::dvec2 half = (from - end) / 2.0, p{c * half.x + s * half.y, -s * half.x + c * half.y};
    const double too_small = p.x * p.x / (a * a) + p.y * p.y / (b * b);
    if (too_small > 1) a *= std::sqrt(too_small), b *= std::sqrt(too_small);
    const double q = a * a * p.y * p.y + b * b * p.x * p.x;
    double root = std::sqrt(std::max(0.0, (a * a * b * b - q) / q));
    if (*large == *sweep) root = -root;
    const glm::dvec2 centre{root * a * p.y / b, -root * b * p.x / a};
    const double first = std::atan2((p.y - centre.y) / b, (p.x - centre.x) / a);
    double span = std::atan2((-p.y - centre.y) / b, (-p.x - centre.x) / a) - first;
    if (*sweep && span < 0) span += 2 * std::numbers::pi;
    if (!*sweep && span > 0) span -= 2 * std::numbers::pi;
    if (!std::isfinite(first) || !std::isfinite(span)) return fail("an arc is too large");
    const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(span) / (std::numbers::pi / 2) - 1e-9)));
    const glm::dvec2 middle{c * centre.x - s * centre.y + (from.x + end.x) / 2,
                            s * centre.x + c * centre.y + (from.y + end.y) / 2};
    const auto at = [&](double t, double radius) {
      const glm::dvec2 e{radius * a * std::cos(t), radius * b * std::sin(t)};
      return P2{Exact(middle.x + c * e.x - s * e.y), Exact(-(middle.y + s * e.x + c * e.y))};
    };
    const double step = span / parts, w = std::cos(step / 2);
    for (int i = 0; i < parts; ++i) {
      const double t = first + i * step;
      const P2 next = i + 1 == parts ? to : at(t + step, 1);
      add({at(t + step / 2, 1 / w), next}, 'A');
      piece_.segments.back().weight = Exact(w);
    }
    return true;
  }

  std::string_view rest_;
  P2 now_, control_;
  Piece piece_;
  char last_ = 0;
  std::size_t count_ = 0;
};

// All segments raised to the degree of the highest, joined with knots 0, 1, 2, ...
Curve<Exact> joined(const PathReader::Piece& piece) {
  std::size_t p = 1;
  bool rational = false;
  for (const Segment& segment : piece.segments) {
    p = std::max(p, segment.points.size());
    rational = rational || !(segment.weight == Exact(1));
  }
  Curve<Exact> curve;
  curve.degree = static_cast<int>(p);
  curve.rational = rational;
  const auto homogeneous = [](const P2& at, const Exact& w) { return HPoint<Exact>(w * at.x, w * at.y, Exact(0), w); };
  curve.points.push_back(homogeneous(piece.start, Exact(1)));
  curve.knots.assign(p + 1, Exact(0));
  NoRecorder<Exact> none;
  P2 from = piece.start;
  for (std::size_t k = 0; k < piece.segments.size(); ++k) {
    const Segment& segment = piece.segments[k];
    const auto q = static_cast<int>(segment.points.size());
    Curve<Exact> piece_of{q, bezier_knots<Exact>(q), {homogeneous(from, Exact(1))}, 2, rational, true};
    for (int i = 0; i < q; ++i)
      piece_of.points.push_back(
          homogeneous(segment.points[static_cast<std::size_t>(i)], i + 1 < q ? segment.weight : Exact(1)));
    const int times = curve.degree - q;
    const auto points = times > 0 ? degree_elevation(piece_of, times, none).points : piece_of.points;
    curve.points.insert(curve.points.end(), points.begin() + 1, points.end());
    const bool last = k + 1 == piece.segments.size();
    curve.knots.insert(curve.knots.end(), last ? p + 1 : p, Exact(static_cast<std::int64_t>(k) + 1));
    from = segment.points.back();
  }
  return curve;
}

// Every path, wherever it stands; pugixml's tree is walked without recursion.
struct Walker : pugi::xml_tree_walker {
  std::vector<pugi::xml_node> found;
  bool for_each(pugi::xml_node& node) override {
    const std::string_view name = node.name();
    if (name == "path" || name == "polyline" || name == "polygon") found.push_back(node);
    return found.size() < 10'000;
  }
};

std::string data_of(const pugi::xml_node& node) {
  if (std::string_view(node.name()) == "path") return node.attribute("d").value();
  std::string d = "M " + std::string(node.attribute("points").value());
  if (std::string_view(node.name()) == "polygon") d += " Z";
  return d;
}

Checked<Imported> import(const std::string& name, std::string_view bytes) {
  pugi::xml_document document;
  const auto parsed = document.load_buffer(bytes.data(), bytes.size());
  const auto place = [&](std::ptrdiff_t offset) {
    const auto at = std::min(bytes.size(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)));
    const std::string_view before = bytes.substr(0, at);
    const std::size_t begin = before.rfind('\n') + 1;  // 0 in the first line
    const std::string_view line = bytes.substr(begin, bytes.find('\n', begin) - begin);
    // Characters, of which the offset may be in the middle of one.
    const std::size_t column = std::min(utf8_count(before.substr(begin)), utf8_count(line)) + 1;
    return std::pair(static_cast<int>(std::ranges::count(before, '\n')) + 1, static_cast<int>(column));
  };
  if (!parsed) {
    const auto [line, column] = place(parsed.offset);
    return Diagnostics{{name, line, column, "", std::string("is no XML: ") + parsed.description()}};
  }
  Walker walker;
  document.traverse(walker);
  Imported made;
  Diagnostics wrong;
  for (const pugi::xml_node& node : walker.found) {
    const std::string d = data_of(node);
    PathReader reader(d);
    const auto [line, column] = place(node.offset_debug());
    if (!reader.read()) {
      if (wrong.size() < 100) wrong.push_back({name, line, column, std::string(node.name()), reader.wrong});
      continue;
    }
    for (const auto& piece : reader.pieces) {
      SceneObject object;
      const std::string id = node.attribute("id").value(), title = node.child("title").child_value();
      object.name = !title.empty() ? title : !id.empty() ? id : "path";
      Curve<Exact> curve = joined(piece);
      if (curve.points.size() > 65'536 || made.objects.size() == most_objects) {
        if (wrong.size() < 100) wrong.push_back({name, line, column, std::string(node.name()), "there is too much"});
        break;
      }
      object.geometry = std::move(curve);
      made.objects.push_back(std::move(object));
    }
  }
  if (!wrong.empty()) return wrong;
  made.notes.push_back("colours, strokes and transformations are not taken");
  return made;
}

}  // namespace

const ExchangeFormat& format_svg() {
  static const ExchangeFormat format{"svg",    "SVG, paths in the plane",
                                     {".svg"}, "Plane curves, polynomial ones of degree up to 3 exactly",
                                     import,   write};
  return format;
}

}  // namespace blossom
