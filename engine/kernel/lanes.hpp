#pragma once
// Several doubles in one vector register, for the loops over the vertices of grids: four, or two where the processor
// has no longer ones.
//
// Left alone with many points of x, y, z the compiler vectorizes within a point, and loses the gain in shuffles; here
// some vertices are computed side by side, by the operations of a single one in the same order, so with the same bits.
// What is written over Xyz<T> serves one vertex, T = double, and several, T = Lanes.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "geometry/geometry.hpp"

namespace blossom::detail {

#ifdef __AVX__
inline constexpr int lanes = 4;
#else
inline constexpr int lanes = 2;
#endif
using Lanes [[gnu::vector_size(lanes * sizeof(double))]] = double;
using Truths [[gnu::vector_size(lanes * sizeof(double))]] = std::int64_t;  // -1 or 0 each

inline bool all(bool truth) { return truth; }
inline bool all(Truths truths) {
  bool result = true;
  for (int k = 0; k < lanes; ++k) result = result && truths[k] != 0;
  return result;
}

inline bool both(bool a, bool b) { return a && b; }
inline Truths both(Truths a, Truths b) { return a & b; }
template <class T, class... More>
bool all_of(T truths, const More&... more) {
  ((truths = both(truths, more)), ...);
  return all(truths);
}

inline double square_root(double x) { return std::sqrt(x); }
inline Lanes square_root(Lanes x) {
  for (int k = 0; k < lanes; ++k) x[k] = std::sqrt(x[k]);
  return x;
}
inline double absolute(double x) { return std::abs(x); }
inline Lanes absolute(Lanes x) { return x < 0 ? -x : x; }
inline double larger(double a, double b) { return std::max(a, b); }
inline Lanes larger(Lanes a, Lanes b) { return a < b ? b : a; }
inline bool finite_number(double x) { return std::isfinite(x); }
inline Truths finite_number(Lanes x) { return x - x == 0; }

// Three coordinates, of one vertex or of several.
template <class T>
struct Xyz {
  T x, y, z;

  friend Xyz operator+(const Xyz& a, const Xyz& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Xyz operator-(const Xyz& a, const Xyz& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  template <class F>
  friend Xyz operator*(const Xyz& a, const F& factor) {
    return {a.x * factor, a.y * factor, a.z * factor};
  }
  friend T dot(const Xyz& a, const Xyz& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend Xyz cross(const Xyz& a, const Xyz& b) {
    return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
  }
  friend T max_norm(const Xyz& a) { return larger(larger(absolute(a.x), absolute(a.y)), absolute(a.z)); }
};

// The same with a weight.
template <class T>
struct Xyzw {
  Xyz<T> xyz;
  T w;
};

inline Xyzw<double> load(const HPoint<double>& P) { return {{P.x, P.y, P.z}, P.w}; }

// From `lanes` points.
inline Xyzw<Lanes> load_lanes(const HPoint<double>* P) {
#ifdef __AVX__
  Lanes a, b, c, d;
  std::memcpy(&a, P, sizeof a);
  std::memcpy(&b, P + 1, sizeof b);
  std::memcpy(&c, P + 2, sizeof c);
  std::memcpy(&d, P + 3, sizeof d);
  const Lanes ab_xz = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_yw = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lanes cd_xz = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_yw = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return {{__builtin_shufflevector(ab_xz, cd_xz, 0, 1, 4, 5), __builtin_shufflevector(ab_yw, cd_yw, 0, 1, 4, 5),
           __builtin_shufflevector(ab_xz, cd_xz, 2, 3, 6, 7)},
          __builtin_shufflevector(ab_yw, cd_yw, 2, 3, 6, 7)};
#else
  return {{Lanes{P[0].x, P[1].x}, Lanes{P[0].y, P[1].y}, Lanes{P[0].z, P[1].z}}, Lanes{P[0].w, P[1].w}};
#endif
}

// The first `count` of them, 1 <= count <= lanes; the loops of known length are those that run.
inline void store(const Xyz<Lanes>& from, int count, Point<double>* to) {
  if (count == lanes) {
    for (int k = 0; k < lanes; ++k) to[k] = {from.x[k], from.y[k], from.z[k]};
  } else {
    for (int k = 0; k < count; ++k) to[k] = {from.x[k], from.y[k], from.z[k]};
  }
}

inline void store(Lanes from, int count, double* to) {
  if (count == lanes) {
    std::memcpy(to, &from, sizeof from);
  } else {
    for (int k = 0; k < count; ++k) to[k] = from[k];
  }
}

}  // namespace blossom::detail
