#pragma once
// How an algorithm tells what it does. A kernel template computes through rules (pure functions, see rules.hpp) and
// names what it makes:
//
//     auto b = rec.apply(Blend{}, "P"_v(r, i), alpha, P[i], P[i + 1]);
//
// With NoRecorder, apply() is the rule and nothing else: ids are empty types, names are constants nobody reads, and the
// compiler emits the plain algorithm. With trace/trace_recorder.hpp the same line also notes that P[r][i] came from
// those three values by that rule. There is one text of each algorithm, so what is replayed is what was computed.
//
// A recorder R has: R::recording, R::Id, R::Number (the scalar), and
//   apply(rule, name, operands...)  -> Traced<result, Id>     a new value, in a step of its own
//   input(name, value) / inputs(symbol, values) / list(name, values)  the givens
//   phase(Phase)   -> guard         a named part of the algorithm, as long as the guard lives
//   one_step()     -> guard         values made while it lives share one step
//   retire(id)                      the value is no longer part of the picture from the current step on
//   polar_knots(id, first_knot, count), polar_bezier(id, i, p), polar_net(id, u, v)   the polar label of a point that
//                                   no rule can tell: of an input, of an interpolated net

#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "geometry/geometry.hpp"

namespace blossom {

// A value's letter, at most 8 ASCII characters, packed so that names cost nothing to make, copy or compare.
struct Symbol {
  std::uint64_t packed = 0;

  static constexpr bool fits(std::string_view text) { return !text.empty() && text.size() <= 8; }
  static constexpr Symbol of(std::string_view text) {
    Symbol s;
    for (std::size_t c = 0; c < text.size() && c < 8; ++c)
      s.packed |= static_cast<std::uint64_t>(static_cast<unsigned char>(text[c])) << (8 * c);
    return s;
  }
  std::string text() const {
    std::string t;
    for (std::uint64_t rest = packed; rest != 0; rest >>= 8) t.push_back(static_cast<char>(rest & 0xff));
    return t;
  }
  constexpr bool operator==(const Symbol&) const = default;
};

// A symbol with up to two indices: k, U[3], P[1][4].
struct Name {
  Symbol symbol;
  std::int32_t index[2] = {0, 0};
  std::uint8_t arity = 0;
  std::uint8_t outer = 0;  // 1: belongs to what surrounds the innermost scoped phase

  constexpr bool operator==(const Name&) const = default;
};

// A result of a scoped phase, named in the scope around it.
constexpr Name outer(Name name) {
  name.outer = 1;
  return name;
}

struct NameMaker {
  Symbol symbol;
  constexpr Name operator()() const { return {symbol, {0, 0}, 0}; }
  constexpr Name operator()(int i) const { return {symbol, {i, 0}, 1}; }
  constexpr Name operator()(int i, int j) const { return {symbol, {i, j}, 2}; }
  constexpr operator Name() const { return (*this)(); }  // NOLINT: "k"_v is a name
};

#if defined(__clang__) && __clang_major__ < 15  // it leaves consteval literals inside templates to the linker
constexpr NameMaker operator""_v(const char* text, std::size_t size) {
#else
consteval NameMaker operator""_v(const char* text, std::size_t size) {
#endif
  if (!Symbol::fits({text, size})) throw "a symbol has 1 to 8 characters";
  return {Symbol::of({text, size})};
}

// A named part of an algorithm. A scoped phase puts its label before the names inside it: elevate[2].Q[1][3]. A phase
// that is another algorithm says which: its narration and pseudo-code apply inside.
struct Phase {
  std::string_view id;
  int index = -1;
  bool scoped = false;
  std::string_view algorithm = {};
};

template <class T, class Id>
struct Traced {
  T value;
  [[no_unique_address]] Id id;
};

template <class T, class Id>
struct Ref {
  const T& value;
  [[no_unique_address]] Id id;
};

struct NoId {};

// Values given from outside, with consecutive ids. Indexable; a slice of it can be an operand.
template <class T, class Id>
struct Givens {
  std::span<const T> value;
  [[no_unique_address]] Id first{};

  Ref<T, Id> operator[](int i) const {
    if constexpr (std::is_same_v<Id, NoId>)
      return {value[static_cast<std::size_t>(i)], {}};
    else
      return {value[static_cast<std::size_t>(i)], static_cast<Id>(first + static_cast<Id>(i))};
  }
  int size() const { return static_cast<int>(value.size()); }
  std::span<const T> values() const { return value; }
};

// Values made on the way: their numbers lie together (a rule can read a span of them), their ids beside them.
template <class T, class Id>
class Cells {
  static constexpr bool traced = !std::is_same_v<Id, NoId>;

 public:
  void reserve(int n) {
    values_.reserve(static_cast<std::size_t>(n));
    if constexpr (traced) ids_.reserve(static_cast<std::size_t>(n));
  }
  void resize(int n) {
    values_.resize(static_cast<std::size_t>(n));
    if constexpr (traced) ids_.resize(static_cast<std::size_t>(n));
  }
  template <class V>  // Traced or Ref
  void push_back(const V& v) {
    values_.push_back(v.value);
    if constexpr (traced) ids_.push_back(v.id);
  }
  // from[first] .. from[first+count-1]; From: Givens or Cells.
  template <class From>
  void append(const From& from, int first, int count) {
    const auto added = from.values().subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(count));
    values_.insert(values_.end(), added.begin(), added.end());
    if constexpr (traced)
      for (int i = first; i < first + count; ++i) ids_.push_back(from[i].id);
  }
  template <class V>
  void set(int i, const V& v) {
    values_[static_cast<std::size_t>(i)] = v.value;
    if constexpr (traced) ids_[static_cast<std::size_t>(i)] = v.id;
  }
  Ref<T, Id> operator[](int i) const {
    if constexpr (traced)
      return {values_[static_cast<std::size_t>(i)], ids_[static_cast<std::size_t>(i)]};
    else
      return {values_[static_cast<std::size_t>(i)], {}};
  }
  int size() const { return static_cast<int>(values_.size()); }
  std::span<const T> values() const { return values_; }
  std::vector<T> take() { return std::move(values_); }
  void give(std::vector<T>&& values) requires(!traced) { values_ = std::move(values); }

 private:
  struct Nothing {};
  std::vector<T> values_;
  [[no_unique_address]] std::conditional_t<traced, std::vector<Id>, Nothing> ids_;
};

// Several neighbouring values as one operand of a rule whose last argument is a span.
template <class T, class Id, class Source>
struct Slice {
  std::span<const T> value;
  const Source* source;
  int first;
  int count() const { return static_cast<int>(value.size()); }
  Id id(int i) const { return (*source)[first + i].id; }
};

template <class T, class Id>
Slice<T, Id, Cells<T, Id>> slice(const Cells<T, Id>& cells, int first, int count) {
  return {cells.values().subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(count)), &cells, first};
}
template <class T, class Id>
Slice<T, Id, Givens<T, Id>> slice(const Givens<T, Id>& givens, int first, int count) {
  return {givens.values().subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(count)), &givens, first};
}

template <Scalar S>
struct NoRecorder {
  static constexpr bool recording = false;
  using Id = NoId;
  using Number = S;
  struct Guard {
    ~Guard() {}  // not trivial, so that a guard is not an unused variable
  };

  template <class Rule, class... Operands>
  [[gnu::always_inline]] auto apply(Rule, const Name&, const Operands&... operands) const {
    return Traced<decltype(Rule::template apply<S>(operands.value...)), NoId>{
        Rule::template apply<S>(operands.value...), {}};
  }
  template <class T>
  Traced<T, NoId> input(const Name&, const T& value) const {
    return {value, {}};
  }
  template <class T>
  Givens<T, NoId> inputs(const NameMaker&, std::span<const T> values) const {
    return {values, {}};
  }
  template <class T>
  Givens<T, NoId> inputs(const NameMaker&, int, std::span<const T> values) const {
    return {values, {}};
  }
  Traced<std::span<const S>, NoId> list(const Name&, const std::span<const S>& values) const { return {values, {}}; }
  Guard phase(const Phase&) const { return {}; }
  Guard one_step() const { return {}; }
  void retire(NoId) const {}
  void polar_knots(NoId, NoId, int) const {}
  void polar_bezier(NoId, int, int) const {}
  void polar_net(NoId, std::span<const S>, std::span<const S>) const {}
};

// A curve on its way through an algorithm. Knots is Givens or Cells, and so is Points.
template <class Knots, class Points>
struct TracedCurve {
  int degree = 0;
  Knots U;
  Points P;
  int dimension = 2;
  bool rational = false;
};

template <class R>
using MadeCurve =
    TracedCurve<Cells<typename R::Number, typename R::Id>, Cells<HPoint<typename R::Number>, typename R::Id>>;

}  // namespace blossom
