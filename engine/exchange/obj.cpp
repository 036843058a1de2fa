// Wavefront OBJ, with its free-form statements (Alias|Wavefront, Advanced Visualizer 4.0, appendix B1 "Object Files"):
// cstype, deg, curv (with 3D control points as written by most programs), surf, parm, end. Blossom's knot vectors are
// OBJ's: n + p + 2 parameters for n + 1 control points. Of a surface the points are listed with u running first.

#include <algorithm>

#include "exchange/exchange_mesh.hpp"
#include "exchange/exchange_text.hpp"
#include "geometry/document.hpp"

namespace blossom {
namespace {

using namespace exchange;

// ---- writing --------------------------------------------------------------------------------------------------------

// Names are one word there.
std::string word_of(std::string name) {
  for (char& c : name)
    if (static_cast<unsigned char>(c) <= ' ') c = '_';
  return name;
}

class Writer {
 public:
  explicit Writer(const ExportOptions& options) : options_(options) {}

  void point(const HPoint<Exact>& P, bool rational) {
    const double w = P.w.to_double(), scale = w == 0 ? 1 : w;
    out += "v " + number(P.x.to_double() / scale) + " " + number(P.y.to_double() / scale) + " " +
           number(P.z.to_double() / scale) + (rational ? " " + number(w) : "") + "\n";
    ++vertices_;
  }
  void parameters(char direction, const std::vector<Exact>& U) {
    out += std::string("parm ") + direction;
    for (const Exact& u : U) out += " " + number(u.to_double());
    out += "\n";
  }
  void type(bool rational) { out += std::string("cstype ") + (rational ? "rat " : "") + "bspline\n"; }
  void curve(const SceneObject& object, const Curve<Exact>& c) {
    const std::size_t first = vertices_ + 1;
    out += "o " + word_of(object.name) + "\n";
    for (const auto& P : c.points) point(P, c.rational);
    type(c.rational);
    out += "deg " + std::to_string(c.degree) + "\ncurv " + number(c.domain_begin().to_double()) + " " +
           number(c.domain_end().to_double());
    for (std::size_t i = 0; i < c.points.size(); ++i) out += " " + std::to_string(first + i);
    out += "\n";
    parameters('u', c.knots);
    out += "end\n";
  }
  void surface(const SceneObject& object, const Surface<Exact>& s) {
    const std::size_t first = vertices_ + 1;
    out += "o " + word_of(object.name) + "\n";
    for (int j = 0; j < s.columns; ++j)
      for (int i = 0; i < s.rows; ++i) point(s.at(i, j), s.rational);
    type(s.rational);
    const auto end = [&](std::size_t d, int at) {
      return number(s.knots[d][static_cast<std::size_t>(at)].to_double());
    };
    out += "deg " + std::to_string(s.degree[0]) + " " + std::to_string(s.degree[1]) + "\nsurf " + end(0, s.degree[0]) +
           " " + end(0, s.rows) + " " + end(1, s.degree[1]) + " " + end(1, s.columns);
    for (std::size_t i = 0; i < s.points.size(); ++i) out += " " + std::to_string(first + i);
    out += "\n";
    parameters('u', s.knots[0]);
    parameters('v', s.knots[1]);
    out += "end\n";
  }
  template <class Points>
  void points(const SceneObject& object, const Points& all) {
    const std::size_t first = vertices_ + 1;
    out += "o " + word_of(object.name) + "\n";
    for (const auto& P : all) point(P, false);
    out += "p";
    for (std::size_t i = 0; i < all.size(); ++i) out += " " + std::to_string(first + i);
    out += "\n";
  }

  std::string out = "# curves and surfaces as free-form elements\n";

 private:
  std::string number(double x) const { return decimal(x, options_.digits); }
  const ExportOptions& options_;
  std::size_t vertices_ = 0;
};

Checked<Exported> write(const Workspace& scene, const ExportOptions& options) {
  Writer writer(options);
  for (const SceneObject* object : chosen(scene, options)) {
    if (const auto* curve = std::get_if<Curve<Exact>>(&object->geometry)) writer.curve(*object, *curve);
    if (const auto* surface = std::get_if<Surface<Exact>>(&object->geometry)) writer.surface(*object, *surface);
    if (const auto* row = std::get_if<PointRow<Exact>>(&object->geometry)) writer.points(*object, row->points);
    if (const auto* net = std::get_if<PointNet<Exact>>(&object->geometry)) writer.points(*object, net->points);
  }
  return Exported{std::move(writer.out),
                  {"colours, what is shown and how things were made are left out",
                   "numbers are rounded to " + std::to_string(std::clamp(options.digits, 1, 17)) + " digits"}};
}

// ---- reading --------------------------------------------------------------------------------------------------------

constexpr std::size_t most_vertices = 1'000'000;

// One free-form element between curv or surf and end.
struct Element {
  int line = 0;
  bool surface = false, rational = false, bezier = false;
  std::array<int, 2> degree{};
  std::array<std::vector<Exact>, 2> parameters;
  std::vector<std::size_t> points;
  std::string name;
};

class Reader {
 public:
  explicit Reader(const std::string& name) : name_(name) {}

  Checked<Imported> read(std::string_view bytes) {
    Lines lines(bytes);
    std::string joined;
    for (std::string_view line; wrong_.size() < 100 && lines.next(line);) {
      line_ = lines.number();
      if (const auto comment = line.find('#'); comment != std::string_view::npos) line = line.substr(0, comment);
      if (line.ends_with('\\')) {  // goes on in the next line
        joined += std::string(line.substr(0, line.size() - 1)) + " ";
        continue;
      }
      joined += line;
      statement(split(joined, " \t"));
      joined.clear();
    }
    if (!wrong_.empty()) return wrong_;
    if (faces_ > 0) made_.notes.push_back(std::to_string(faces_) + " faces and lines of a mesh are not taken");
    if (trims_ > 0)
      made_.notes.push_back(std::to_string(trims_) + " trimming curves are not taken: surfaces are whole");
    if (others_ > 0) made_.notes.push_back(std::to_string(others_) + " elements of other types are not taken");
    return std::move(made_);
  }

 private:
  using Words = std::vector<std::string_view>;

  void error(std::string message) { wrong_.push_back({name_, line_, 1, "", std::move(message)}); }

  std::optional<Exact> number(std::string_view word) {
    auto x = Exact::parse(word);
    if (!x) error("must be a number, not " + excerpt(word));
    return x;
  }
  std::optional<int> integer(std::string_view word) {
    const auto x = Exact::parse(word);
    if (x && x->is_integer() && abs(*x) < Exact(1'000'000'000)) return static_cast<int>(x->to_double());
    error("must be a whole number, not " + excerpt(word));
    return std::nullopt;
  }

  void statement(const Words& words) {
    if (words.empty()) return;
    const std::string_view what = words[0];
    if (what == "v") return vertex(words);
    if (what == "o" || what == "g") {
      object_ = words.size() > 1 ? std::string(words[1]) : std::string();
    } else if (what == "cstype") {
      rational_ = words.size() > 1 && words[1] == "rat";
      type_ = words.size() > 1 ? std::string(words.back()) : std::string();
    } else if (what == "deg") {
      for (std::size_t d = 0; d < 2 && d + 1 < words.size(); ++d)
        if (const auto degree = integer(words[d + 1])) degree_[d] = *degree;
    } else if (what == "curv" || what == "surf") {
      begin(words, what == "surf");
    } else if (what == "parm") {
      parameters(words);
    } else if (what == "end") {
      finish();
    } else if (what == "f" || what == "l") {
      ++faces_;
    } else if (what == "trim" || what == "hole" || what == "scrv") {
      ++trims_;
    } else if (what == "curv2" || what == "call" || what == "csh" || what == "bmat" || what == "con") {
      ++others_;
    }
  }

  void vertex(const Words& words) {
    if (words.size() < 4 || words.size() > 8) return error("a vertex has 3 coordinates, and perhaps a weight");
    if (vertices_.size() == most_vertices) return error("there are more than a million vertices");
    HPoint<Exact> P(0, 0, 0, 1);
    for (int k = 0; k < 3; ++k)
      if (auto x = number(words[static_cast<std::size_t>(k) + 1])) P[k] = std::move(*x);
    if (words.size() == 5)  // more words are a colour
      if (auto w = number(words[4])) P.w = std::move(*w);
    vertices_.push_back(std::move(P));
  }

  void begin(const Words& words, bool surface) {
    element_.reset();
    if (type_ != "bspline" && type_ != "bezier") {
      ++others_;
      return;
    }
    const std::size_t bounds = surface ? 4 : 2;
    if (words.size() <= bounds + 1) return error("has no control points");
    Element element{line_, surface, rational_, type_ == "bezier", degree_, {}, {}, object_};
    for (std::size_t i = bounds + 1; i < words.size(); ++i) {
      const auto index = integer(words[i].substr(0, words[i].find('/')));
      if (!index) return;
      const auto count = static_cast<int>(vertices_.size());
      const int at = *index < 0 ? count + *index : *index - 1;  // negative ones count from the last
      if (at < 0 || at >= count)
        return error("there is no vertex " + std::to_string(*index) + " yet; there are " + std::to_string(count));
      element.points.push_back(static_cast<std::size_t>(at));
    }
    if (element.points.size() > 65'536) return error("has more than 65,536 control points");
    element_ = std::move(element);
  }

  void parameters(const Words& words) {
    if (!element_) return;
    if (words.size() < 3 || (words[1] != "u" && words[1] != "v")) return error("parm takes u or v and parameters");
    auto& list = element_->parameters[words[1] == "u" ? 0 : 1];
    for (std::size_t i = 2; i < words.size(); ++i) {
      auto u = number(words[i]);
      if (!u) return;
      if (list.size() > 70'000) return error("has too many parameters");
      list.push_back(std::move(*u));
    }
  }

  // The knots that a Bezier element's parameters mean: each joint p times, the ends p + 1 times.
  static std::vector<Exact> knots_of(const Element& element, std::size_t d) {
    if (!element.bezier) return element.parameters[d];
    const int p = element.degree[d];
    std::vector<Exact> U;
    const auto& at = element.parameters[d];
    for (std::size_t i = 0; i < at.size(); ++i)
      U.insert(U.end(), static_cast<std::size_t>(i == 0 || i + 1 == at.size() ? p + 1 : p), at[i]);
    return U;
  }

  // Whatever is not valid is said in the words of the reader of geometry.
  void finish() {
    if (!element_) return;
    const Element element = *std::move(element_);
    element_.reset();
    line_ = element.line;
    SceneObject object;
    object.name = element.name.empty() ? (element.surface ? "surface" : "curve") : element.name;
    std::string text;
    if (element.surface) {
      Surface<Exact> surface;
      surface.degree = element.degree;
      surface.rational = element.rational;
      for (std::size_t d = 0; d < 2; ++d) surface.knots[d] = knots_of(element, d);
      surface.rows = static_cast<int>(surface.knots[0].size()) - element.degree[0] - 1;
      surface.columns = static_cast<int>(surface.knots[1].size()) - element.degree[1] - 1;
      const auto count = static_cast<std::int64_t>(surface.rows) * surface.columns;
      if (surface.rows < 1 || surface.columns < 1 || count != static_cast<std::int64_t>(element.points.size()))
        return error("its parameters and degrees are for " + std::to_string(surface.rows) + " x " +
                     std::to_string(surface.columns) + " control points, not " + std::to_string(element.points.size()));
      for (int i = 0; i < surface.rows; ++i)
        for (int j = 0; j < surface.columns; ++j)
          surface.points.push_back(placed(element, static_cast<std::size_t>(j * surface.rows + i)));
      text = write_surface(surface);
    } else {
      Curve<Exact> curve{element.degree[0], knots_of(element, 0), {}, 3, element.rational, false};
      for (std::size_t i = 0; i < element.points.size(); ++i) curve.points.push_back(placed(element, i));
      text = write_curve(curve);
    }
    take(std::move(object), element.surface, std::move(text));
  }

  HPoint<Exact> placed(const Element& element, std::size_t i) const {
    const HPoint<Exact>& P = vertices_[element.points[i]];
    if (!element.rational) return {P.x, P.y, P.z, Exact(1)};
    return {P.w * P.x, P.w * P.y, P.w * P.z, P.w};
  }

  void take(SceneObject object, bool surface, std::string text) {
    const auto document = JsonDocument::parse(name_, std::move(text));
    if (!document) return error("is too large");
    Diagnostics problems;
    const Cursor root(*document, problems);
    if (surface) {
      if (auto read = read_surface(root)) object.geometry = std::move(*read);
    } else if (auto read = read_curve(root)) {
      object.geometry = std::move(*read);
    }
    for (const Diagnostic& problem : problems) error(problem.path + ": " + problem.message);
    if (!problems.empty()) return;
    if (made_.objects.size() < most_objects)
      made_.objects.push_back(std::move(object));
    else
      ++others_;
  }

  std::string name_, object_, type_;
  bool rational_ = false;
  std::array<int, 2> degree_{1, 1};
  std::vector<HPoint<Exact>> vertices_;  // coordinates and weight, not multiplied
  std::optional<Element> element_;
  Imported made_;
  Diagnostics wrong_;
  int line_ = 0;
  std::size_t faces_ = 0, trims_ = 0, others_ = 0;
};

Checked<Imported> import(const std::string& name, std::string_view bytes) { return Reader(name).read(bytes); }

}  // namespace

const ExchangeFormat& format_obj() {
  static const ExchangeFormat format{"obj",    "Wavefront OBJ, free-form",
                                     {".obj"}, "Curves and surfaces of all kinds (curv, surf), and points",
                                     import,   write};
  return format;
}

}  // namespace blossom
