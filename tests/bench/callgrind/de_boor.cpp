// Recording costs nothing where nobody records: de Boor's algorithm through the kernel's template with NoRecorder, and
// the same loop written by hand, as two functions whose instructions callgrind counts:
//
//   g++ -std=c++20 -O3 -DNDEBUG -ffp-contract=off -DGLM_FORCE_XYZW_ONLY -Iengine -o de_boor
//     tests/bench/callgrind/de_boor.cpp engine/base/exact.cpp engine/base/scalar.cpp
//   valgrind --tool=callgrind --callgrind-out-file=out ./de_boor
//   callgrind_annotate --inclusive=yes out | grep point_by

#include <cstdio>
#include <cstring>

#include "kernel/de_boor.hpp"

namespace {

using namespace blossom;

[[gnu::noinline]] HPoint<double> point_by_kernel(const Curve<double>& curve, double u) {
  NoRecorder<double> none;
  return de_boor(curve, u, none);
}

// What one writes who has never heard of recorders: spans, indices, one array.
[[gnu::noinline]] HPoint<double> point_by_hand(const Curve<double>& curve, double u) {
  const int p = curve.degree;
  const double* U = curve.knots.data();
  const int k = find_span<double>(curve.knots, p, u);
  const int s = std::min(multiplicity<double>(curve.knots, u), p);
  const int last = U[k + 1] == u ? k : k - s;
  const int width = p - s;
  const int first = last - width;
  HPoint<double> P[max_degree + 1];
  for (int j = 0; j <= width; ++j) P[j] = curve.points[static_cast<std::size_t>(first + j)];
  for (int r = 1; r <= width; ++r) {
    HPoint<double> before = P[r - 1];
    for (int j = r; j <= width; ++j) {
      const int i = first + j;
      const double a = (u - U[i]) / (U[i + p - r + 1] - U[i]);
      const double b = 1 - a;
      const HPoint<double> Q(b * before.x + a * P[j].x, b * before.y + a * P[j].y, b * before.z + a * P[j].z,
                             b * before.w + a * P[j].w);
      before = P[j];
      P[j] = Q;
    }
  }
  const HPoint<double>& C = P[width];
  if (!curve.rational) return C;
  if (C.w == 0) throw KernelError{"u", "the weight of the point at this parameter is 0: it lies at infinity"};
  return {C.x / C.w, C.y / C.w, C.z / C.w, 1};
}

}  // namespace

int main() {
  Curve<double> curve;
  curve.degree = 3;
  curve.rational = true;
  curve.knots = {0, 0, 0, 0, 1, 2, 3.5, 4, 5.25, 6, 7, 7, 7, 7};
  for (int i = 0; i < 10; ++i) curve.points.emplace_back(i, i % 3, 0.5 * i, 1 + 0.1 * i);
  int different = 0;
  for (int i = 0; i <= 1000; ++i) {
    const auto a = point_by_kernel(curve, 7 * i / 1000.0);
    const auto b = point_by_hand(curve, 7 * i / 1000.0);
    different += std::memcmp(&a, &b, sizeof a) == 0 ? 0 : 1;
  }
  std::printf("%d of 1001 points differ\n", different);
  return different == 0 ? 0 : 1;
}
