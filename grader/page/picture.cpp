#include "grader/page/picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>

#include "algorithms/typeset.hpp"
#include "kernel/tessellate.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_points = 400;
constexpr int curve_steps = 24;  // through each span
constexpr std::size_t most_samples = 400;

using Place = std::array<double, 2>;

std::string coordinate(double x) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.5g", x == 0 ? 0.0 : x);
  return text.data();
}
std::string json(const Place& at) { return "[" + coordinate(at[0]) + "," + coordinate(at[1]) + "]"; }

// Space is seen from the front, a little from the right and from above.
Place projected(double x, double y, double z, int dimension) {
  if (dimension == 2) return {x, y};
  constexpr double cos_a = 0.8192, sin_a = 0.5736, cos_b = 0.9063, sin_b = 0.4226;  // 35 and 25 degrees
  return {cos_a * x + sin_a * y, -sin_a * sin_b * x + cos_a * sin_b * y + cos_b * z};
}

std::optional<Place> place_of(NumbersView<Exact> numbers, int dimension) {
  if (numbers.size() != 4 || numbers[3] == Exact(0)) return std::nullopt;
  const double w = numbers[3].to_double();
  const Place at =
      projected(numbers[0].to_double() / w, numbers[1].to_double() / w, numbers[2].to_double() / w, dimension);
  if (!std::isfinite(at[0]) || !std::isfinite(at[1])) return std::nullopt;
  return at;
}

struct Box {
  Place low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  Place high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};
  void add(const Place& at) {
    for (std::size_t i = 0; i < 2; ++i) low[i] = std::min(low[i], at[i]), high[i] = std::max(high[i], at[i]);
  }
  double size() const { return std::max({high[0] - low[0], high[1] - low[1], 1e-9}); }
};

class Picture {
 public:
  explicit Picture(const StudentRun& run) : run_(run), trace_(run.trace()), steps_(run.steps()) {}

  std::string write() {
    choose();
    if (points_.empty()) return {};
    std::string steps = write_steps();
    if (!any_in_step_) return {};
    std::string text = R"({"box":)" + box() + R"(,"right":)" + (run_.tells_right() ? "true" : "false") + R"(,"own":)" +
                       (run_.tells_own() ? "true" : "false");
    if (run_.tells_right()) text += R"(,"curve":)" + curves();
    return text + R"(,"points":)" + write_points() + R"(,"lines":)" + lines() + R"(,"steps":)" + steps + "}";
  }

  bool alike() const {
    return run_.tells_right() && run_.tells_own() &&
           std::ranges::all_of(points_, [](const Drawn& drawn) { return drawn.right == drawn.own; });
  }

 private:
  struct Drawn {
    ValueId value;
    const ValueSpec* spec;
    std::optional<Place> right, own;
  };

  const ValueSpec* drawn_spec(ValueId v) const {
    if (trace_.value(v).kind != ValueKind::point) return nullptr;
    const Name& name = trace_.value(v).name;
    const ValueSpec* spec = run_.narrator().algorithm_at(trace_.value(v).step).spec(name);
    if (spec == nullptr) spec = run_.exercise().run.algorithm->spec(name);
    return spec == nullptr || spec->draw == ValueSpec::Draw::none ? nullptr : spec;
  }

  std::size_t told_at(std::uint32_t step) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(steps_, step) - steps_.begin());
  }

  void choose() {
    std::vector<char> relevant(trace_.value_count(), 0);
    for (const std::uint32_t k : steps_) {
      const auto [first, end] = trace_.values_of(k);
      for (ValueId v = first; v < end; ++v) {
        relevant[v] = 1;
        for (const ValueId o : trace_.operands(v)) relevant[o] = 1;
      }
    }
    for (ValueId v = 0; v < trace_.value_count() && points_.size() < most_points; ++v) {
      const bool first_input = trace_.is_input(v) && trace_.scope(v).empty();
      if ((relevant[v] == 0 && !first_input) || trace_.value(v).step > steps_.back()) continue;
      const ValueSpec* spec = drawn_spec(v);
      if (spec == nullptr) continue;
      Drawn drawn{v, spec, std::nullopt, std::nullopt};
      if (run_.tells_right() || trace_.is_input(v)) drawn.right = place_of(trace_.numbers(v), trace_.dimension);
      if (run_.tells_own() && run_.shows(v)) drawn.own = place_of(run_.own(v), trace_.dimension);
      if (!drawn.right && !drawn.own) continue;
      index_[v] = points_.size();
      points_.push_back(drawn);
    }
  }

  // All of the right run, and of theirs what is not too far off to be drawn to one scale.
  std::string box() const {
    Box right;
    for (const Drawn& drawn : points_)
      if (drawn.right) right.add(*drawn.right);
    Box all = right;
    for (const Drawn& drawn : points_) {
      if (!drawn.own) continue;
      Place at = *drawn.own;
      for (std::size_t i = 0; i < 2; ++i)
        at[i] = std::clamp(at[i], right.low[i] - right.size() / 2, right.high[i] + right.size() / 2);
      all.add(at);
    }
    return "[" + coordinate(all.low[0]) + "," + coordinate(all.low[1]) + "," + coordinate(all.high[0]) + "," +
           coordinate(all.high[1]) + "]";
  }

  std::string write_points() const {
    std::string text;
    for (const Drawn& drawn : points_) {
      const ValueId v = drawn.value;
      const auto& record = trace_.value(v);
      text += text.empty() ? "[" : ",\n";
      text += R"({"n":[)";
      const RichText name = typeset_name(record.name, run_.narrator().algorithm_at(record.step));
      for (std::size_t i = 0; i < name.size(); ++i)
        text += (i > 0 ? "," : "") + ("[" + json_quote(name[i].text)) + "," +
                std::to_string(static_cast<int>(name[i].level)) + "]";
      text += R"(],"s":)" + std::to_string(told_at(record.step));
      if (const std::uint32_t end = trace_.retired_at(v); end != absent)
        text += R"(,"e":)" + std::to_string(told_at(end));
      const bool level = drawn.spec->draw == ValueSpec::Draw::level && record.name.arity == 2;
      const bool alone = drawn.spec->draw == ValueSpec::Draw::point;
      const int number = level ? record.name.index[0] : trace_.is_input(v) ? 0 : alone ? -2 : -1;
      text += R"(,"l":)" + std::to_string(number);
      if (drawn.right) text += R"(,"r":)" + json(*drawn.right);
      if (drawn.own) text += R"(,"y":)" + json(*drawn.own);
      if (const auto would = place_of(run_.expected(v), trace_.dimension); would && run_.tells_own())
        text += R"(,"w":)" + json(*would);
      text += R"(,"k":)" + std::to_string(static_cast<int>(run_.standing(v))) + "}";
    }
    return text + "]";
  }

  // Points in a row: of one level, of one polygon; of a net along both indices.
  std::string lines() const {
    using Key = std::tuple<std::string, std::uint64_t, int, int>;
    std::map<Key, std::map<int, std::size_t>> rows;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Name& name = trace_.value(points_[i].value).name;
      if (points_[i].spec->draw == ValueSpec::Draw::point || name.arity == 0) continue;
      const std::string scope = trace_.scope(points_[i].value);
      const bool two = name.arity == 2;
      rows[{scope, name.symbol.packed, two ? 0 : 2, two ? name.index[0] : 0}][name.index[two ? 1 : 0]] = i;
      if (two && points_[i].spec->draw == ValueSpec::Draw::net)
        rows[{scope, name.symbol.packed, 1, name.index[1]}][name.index[0]] = i;
    }
    std::string text;
    for (const auto& [key, row] : rows) {
      std::string line;
      int last = 0;
      std::size_t count = 0;
      const auto finish = [&] {
        if (count > 1) text += (text.empty() ? "[" : ",") + line + "]";
        line.clear();
        count = 0;
      };
      for (const auto& [at, point] : row) {
        if (count > 0 && at != last + 1) finish();
        line += (count++ == 0 ? "[" : ",") + std::to_string(point);
        last = at;
      }
      finish();
    }
    return text.empty() ? "[]" : text + "]";
  }

  std::string write_steps() {
    std::string text;
    for (const std::uint32_t k : steps_) {
      text += text.empty() ? "[{" : ",{";
      const ValueId v = trace_.introduced_by(k) == absent ? trace_.main_value(k) : absent;
      if (v != absent && !trace_.is_input(v)) {
        std::string operands, cells;
        for (const ValueId o : trace_.operands(v)) {
          cells += "," + std::to_string(o);
          if (const auto at = index_.find(o); at != index_.end())
            operands += (operands.empty() ? "" : ",") + std::to_string(at->second);
        }
        const auto at = index_.find(v);
        if (at != index_.end()) text += R"("v":)" + std::to_string(at->second) + ",";
        if (!operands.empty()) text += R"("o":[)" + operands + "],";
        any_in_step_ = any_in_step_ || at != index_.end() || !operands.empty();
        text += R"("c":[)" + std::to_string(v) + cells + "]";
      }
      text += "}";
    }
    return text + "]";
  }

  std::string curves() const {
    std::vector<const Curve<Exact>*> curves;
    for (const auto& [name, input] : run_.exercise().run.inputs.values) {
      if (const auto* curve = std::get_if<Curve<Exact>>(&input)) curves.push_back(curve);
      if (const auto* several = std::get_if<std::vector<Curve<Exact>>>(&input))
        for (const auto& curve : *several) curves.push_back(&curve);
    }
    std::string text;
    CurveSamples samples;
    std::size_t count = 0;
    for (const auto* curve : curves) {
      sample_curve(convert<double>(*curve), curve->degree == 1 ? 1 : curve_steps, samples);
      count += samples.points.size();
      if (count > most_samples) break;
      samples.pieces.push_back(samples.points.size());
      for (std::size_t i = 0; i + 1 < samples.pieces.size(); ++i) {
        text += text.empty() ? "[[" : ",[";
        for (std::size_t j = samples.pieces[i]; j < samples.pieces[i + 1]; ++j) {
          const auto& p = samples.points[j];
          const Place at = projected(p.x, p.y, p.z, curve->dimension);
          text += (j > samples.pieces[i] ? "," : "") + coordinate(at[0]) + "," + coordinate(at[1]);
        }
        text += "]";
      }
    }
    return text.empty() ? "[]" : text + "]";
  }

  const StudentRun& run_;
  const Trace<Exact>& trace_;
  const std::vector<std::uint32_t>& steps_;
  std::vector<Drawn> points_;
  std::map<ValueId, std::size_t> index_;
  bool any_in_step_ = false;
};

}  // namespace

RunPicture picture_of(const StudentRun& run) {
  Picture picture(run);
  std::string json = picture.write();
  return {std::move(json), picture.alike()};
}

}  // namespace blossom
