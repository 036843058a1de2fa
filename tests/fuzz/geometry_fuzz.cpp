// Any document as a curve and as a surface: what is accepted is written as text that gives the same geometry, has a
// positive denominator at the ends and in the middle of each span of its domain, and is a point there.

#include "fuzz.hpp"
#include "geometry/document.hpp"
#include "kernel/evaluate.hpp"

using namespace blossom;
using namespace blossom::fuzz;

namespace {

constexpr std::uint64_t work = 20'000'000;  // about 0.2 s of exact arithmetic
constexpr std::size_t most_spans = 20;

// The ends of the first spans between a and b, and their middles.
std::vector<Exact> parameters(const std::vector<Exact>& knots, const Exact& a, const Exact& b) {
  std::vector<Exact> at{a, b};
  for (std::size_t i = 1; i < knots.size() && at.size() < 2 * most_spans; ++i) {
    if (!(a <= knots[i - 1] && knots[i - 1] < knots[i] && knots[i] <= b)) continue;
    at.push_back(knots[i]);
    at.push_back((knots[i - 1] + knots[i]) / Exact(2));
  }
  return at;
}

void check(const Curve<Exact>& curve) {
  const std::string written = write_curve(curve);
  const auto document = JsonDocument::parse("g", written);
  require(document.value.has_value(), "a written curve is JSON", to_string(document.diagnostics));
  Diagnostics diagnostics;
  const auto again = read_curve(Cursor(*document, diagnostics));
  require(again && *again == curve, "a written curve reads back", written + "\n" + to_string(diagnostics));
  for (const Exact& u : parameters(curve.knots, curve.domain_begin(), curve.domain_end())) {
    const auto C = homogeneous_point(curve, u);
    require(Exact(0) < C.w, "the denominator is positive in the domain", written);
  }
}

void check(const Surface<Exact>& surface) {
  const std::string written = write_surface(surface);
  const auto document = JsonDocument::parse("g", written);
  require(document.value.has_value(), "a written surface is JSON", to_string(document.diagnostics));
  Diagnostics diagnostics;
  const auto again = read_surface(Cursor(*document, diagnostics));
  require(again && *again == surface, "a written surface reads back", written + "\n" + to_string(diagnostics));
  const auto of = [&](std::size_t direction, int count) {
    const auto& knots = surface.knots[direction];
    auto at = parameters(knots, knots[static_cast<std::size_t>(surface.degree[direction])],
                         knots[static_cast<std::size_t>(count)]);
    at.resize(std::min<std::size_t>(at.size(), 6));
    return at;
  };
  for (const Exact& u : of(0, surface.rows))
    for (const Exact& v : of(1, surface.columns))
      require(Exact(0) < homogeneous_point(surface, u, v).w, "the denominator is positive in the domain", written);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = text_of(data, size);
  const auto document = JsonDocument::parse("f", text);
  if (!document) return 0;
  const ExactBudget budget(work);
  try {
    Diagnostics of_curve, of_surface;
    const auto curve = read_curve(Cursor(*document, of_curve));
    require(curve.has_value() == of_curve.empty(), "a curve, or what is wrong with it");
    if (!curve) check_diagnostics(of_curve, text);
    const auto surface = read_surface(Cursor(*document, of_surface));
    require(surface.has_value() == of_surface.empty(), "a surface, or what is wrong with it");
    if (!surface) check_diagnostics(of_surface, text);
    if (curve) check(*curve);
    if (surface) check(*surface);
  } catch (const ExactTooLarge&) {
    // Whoever reads geometry to compute with it sets a budget and says so.
  }
  return 0;
}
