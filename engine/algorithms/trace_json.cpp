#include "algorithms/trace_json.hpp"

#include <array>
#include <bit>
#include <charconv>

#include "geometry/document.hpp"

namespace blossom {
namespace {

// Whether two numbers are the same one: of doubles every bit, of exact ones also what is known about them.
bool same_number(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }
bool same_number(const Exact& a, const Exact& b) { return a == b && a.is_approximate() == b.is_approximate(); }

// Appends to one string; nothing is built twice.
template <Scalar S>
class Writer {
 public:
  explicit Writer(const Narrator<S>& narrator) : narrator_(narrator), trace_(narrator.trace()) {}

  std::string write() && {
    out_.reserve(256 * (std::size_t{trace_.value_count()} + trace_.step_count()) + 1024);
    read_phases();
    read_retired();
    const Run<S>& run = narrator_.run();
    text("{\"schema\": \"blossom.trace/1\", \"algorithm\": ");
    quoted(run.algorithm->id);
    text(",\n\"inputs\": {");
    bool first = true;
    for (const auto& [name, value] : run.inputs.values) {
      if (!std::exchange(first, false)) text(", ");
      quoted(name);
      text(": ");
      out_ += write_input<S>(value);
    }
    text("},\n\"exact\": ");
    text(std::same_as<S, Exact> ? "true" : "false");
    text(", \"dimension\": ");
    integer(trace_.dimension);
    text(", \"rational\": ");
    text(trace_.rational ? "true" : "false");
    lines("phases", static_cast<std::uint32_t>(trace_.phases().size()), [&](std::uint32_t i) { phase(i); });
    lines("steps", trace_.step_count(), [&](std::uint32_t k) { step(k); });
    lines("values", trace_.value_count(), [&](ValueId v) { value(v); });
    text(",\n\"result\": {");
    result(run.outcome);
    text("}}\n");
    return std::move(out_);
  }

 private:
  void text(std::string_view t) { out_ += t; }
  void integer(std::int64_t n) {
    char digits[24];
    out_.append(digits, std::to_chars(digits, digits + sizeof digits, n).ptr);
  }
  void quoted(std::string_view t) {
    const bool plain =
        std::all_of(t.begin(), t.end(), [](char c) { return c >= ' ' && c < 127 && c != '"' && c != '\\'; });
    if (!plain) {
      out_ += json_quote(t);
      return;
    }
    out_ += '"';
    out_ += t;
    out_ += '"';
  }
  void number(double x) {
    char digits[32];
    out_.append(digits, std::to_chars(digits, digits + sizeof digits, x).ptr);
  }
  void number(const Exact& x) {
    out_ += '"';
    out_ += x.to_string();
    out_ += '"';
  }
  template <class Numbers>
  void numbers(const Numbers& all) {
    out_ += '[';
    bool first = true;
    for (const S& x : all) {
      if (!std::exchange(first, false)) text(", ");
      number(x);
    }
    out_ += ']';
  }
  template <class Line>
  void lines(std::string_view key, std::uint32_t count, Line&& line) {
    text(",\n\"");
    text(key);
    text("\": [");
    for (std::uint32_t i = 0; i < count; ++i) {
      text(i > 0 ? ",\n{" : "\n{");
      line(i);
      out_ += '}';
    }
    out_ += ']';
  }

  // The scope and the path of each phase, once: every value and every step needs one.
  void read_phases() {
    for (const PhaseRecord& record : trace_.phases()) {
      const bool inside = record.parent != absent;
      std::string& scope = scopes_.emplace_back(inside ? scopes_[record.parent] : "");
      outer_scopes_.push_back(record.scoped ? scope : inside ? outer_scopes_[record.parent] : "");
      if (record.scoped) scope += record.label() + ".";
      paths_.push_back((inside ? paths_[record.parent] + ", " : "") + json_quote(record.label()));
    }
  }
  void read_retired() {
    retired_.reserve(trace_.value_count());
    for (ValueId v = 0; v < trace_.value_count(); ++v) retired_.push_back(trace_.retired_at(v));
  }

  void phase(std::uint32_t i) {
    const PhaseRecord& record = trace_.phases()[i];
    text("\"id\": ");
    quoted(record.id);
    if (record.index >= 0) {
      text(", \"index\": ");
      integer(record.index);
    }
    if (record.scoped) text(", \"scoped\": true");
    if (!record.algorithm.empty()) {
      text(", \"algorithm\": ");
      quoted(record.algorithm);
    }
    if (record.parent != absent) {
      text(", \"parent\": ");
      integer(record.parent);
    }
    text(", \"first_step\": ");
    integer(record.first_step);
    text(", \"last_step\": ");
    integer(record.last_step);
  }

  void step(std::uint32_t k) {
    text("\"index\": ");
    integer(k);
    text(", \"kind\": ");
    quoted(narrator_.kind(k));
    text(", \"line\": ");
    integer(narrator_.line(k));
    text(", \"phase\": [");
    if (trace_.step(k).phase != absent) text(paths_[trace_.step(k).phase]);
    text("], \"text\": ");
    quoted(narrator_.text(k));
  }

  void name(ValueId v) {
    const Name& name = trace_.value(v).name;
    out_ += '"';
    if (const std::uint32_t phase = trace_.phase_of(v); phase != absent)
      text(name.outer != 0 ? outer_scopes_[phase] : scopes_[phase]);
    for (std::uint64_t rest = name.symbol.packed; rest != 0; rest >>= 8) out_ += static_cast<char>(rest & 0xff);
    for (int i = 0; i < name.arity; ++i) {
      out_ += '[';
      integer(name.index[i]);
      out_ += ']';
    }
    out_ += '"';
  }

  void value(ValueId v) {
    const ValueRecord& record = trace_.value(v);
    const auto all = trace_.numbers(v);
    text("\"name\": ");
    name(v);
    text(", \"kind\": \"");
    text(kind_name(record.kind));
    text("\", \"value\": ");
    switch (record.kind) {
      case ValueKind::integer:
      case ValueKind::scalar:
        number(all[0]);
        break;
      case ValueKind::point:
        point(all);
        break;
      case ValueKind::vector:
      case ValueKind::list:
        numbers(all);
        break;
    }
    if constexpr (std::same_as<S, Exact>) approximate(all);
    text(", \"step\": ");
    integer(record.step);
    if (retired_[v] != absent) {
      text(", \"retired\": ");
      integer(retired_[v]);
    }
    text(", \"rule\": \"");
    text(trace_.is_input(v) ? "input" : record.rule->name);
    text("\", \"from\": [");
    bool first = true;
    for (const ValueId o : trace_.operands(v)) {
      if (!std::exchange(first, false)) text(", ");
      name(o);
    }
    out_ += ']';
    if (const std::string label = narrator_.polar(v); !label.empty()) {
      text(", \"polar\": ");
      quoted(label);
    }
  }

  void point(NumbersView<S> P) {
    const S& w = P[3];
    const auto dimension = static_cast<std::size_t>(trace_.dimension);
    std::array<S, 3> shown{P[0], P[1], P[2]};
    const bool divide = trace_.rational && !(w == S(0));
    if (divide)
      for (S& x : shown) x = x / w;
    numbers(std::span<const S>(shown).first(dimension));
    if (trace_.rational) {
      text(", \"weight\": ");
      number(w);
    }
    // What is known in double precision only is read as decimals and multiplied exactly: not the same product.
    const bool rounded = std::same_as<S, Exact> && divide &&
                         std::any_of(P.begin(), P.end(), [](const S& x) { return is_approximate(x); });
    bool same = !rounded && (trace_.rational || same_number(w, S(1)));
    for (std::size_t i = 0; i < 3; ++i)
      same = same && same_number(i < dimension ? (divide ? shown[i] * w : shown[i]) : S(0), P[i]);
    if (same) return;
    text(", \"homogeneous\": ");
    numbers(P);
  }

  void approximate(NumbersView<S> all) {
    const auto count =
        static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [](const S& x) { return is_approximate(x); }));
    if (count == 0) return;
    text(", \"approximate\": ");
    if (count == all.size()) {
      text("true");
      return;
    }
    out_ += '[';
    bool first = true;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!is_approximate(all[i])) continue;
      if (!std::exchange(first, false)) text(", ");
      integer(static_cast<std::int64_t>(i));
    }
    out_ += ']';
  }

  void result(const Outcome<S>& outcome) {
    if (const auto* C = std::get_if<HPoint<S>>(&outcome)) {
      const std::array<S, 3> shown{C->x, C->y, C->z};
      text("\"point\": ");
      numbers(std::span<const S>(shown).first(static_cast<std::size_t>(trace_.dimension)));
    } else if (const auto* curve = std::get_if<Curve<S>>(&outcome)) {
      text("\"curve\": ");
      out_ += write_curve(*curve);
    } else if (const auto* curves = std::get_if<std::vector<Curve<S>>>(&outcome)) {
      text("\"curves\": [");
      for (std::size_t i = 0; i < curves->size(); ++i) out_ += (i > 0 ? ", " : "") + write_curve((*curves)[i]);
      text("]");
    } else if (const auto* surfaces = std::get_if<std::vector<Surface<S>>>(&outcome)) {
      text("\"surfaces\": [");
      for (std::size_t i = 0; i < surfaces->size(); ++i) out_ += (i > 0 ? ", " : "") + write_surface((*surfaces)[i]);
      text("]");
    } else {
      text("\"surface\": ");
      out_ += write_surface(std::get<Surface<S>>(outcome));
    }
  }

  const Narrator<S>& narrator_;
  const Trace<S>& trace_;
  std::string out_;
  std::vector<std::string> scopes_, outer_scopes_, paths_;  // of the phases
  std::vector<std::uint32_t> retired_;                      // of the values
};

}  // namespace

template <Scalar S>
std::string write_trace(const Narrator<S>& narrator) {
  return Writer<S>(narrator).write();
}

template std::string write_trace(const Narrator<double>&);
template std::string write_trace(const Narrator<Exact>&);

}  // namespace blossom
