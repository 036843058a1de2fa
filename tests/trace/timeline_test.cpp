#include "trace/timeline.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "trace/traces.hpp"

using namespace blossom;
using test::small_trace;

namespace {

std::vector<std::string> alive(const Trace<double>& trace, const Timeline& timeline) {
  std::vector<std::string> names;
  for (const ValueId v : timeline.state().alive) names.push_back(trace.name(v));
  return names;
}

using Names = std::vector<std::string>;
using Phases = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("a timeline begins at step 0 with what is given", "[timeline]") {
  const auto trace = small_trace();
  const Timeline timeline(trace);
  CHECK(timeline.position() == 0);
  CHECK(timeline.last() == 7);
  CHECK(alive(trace, timeline) == Names{"x", "P[0]", "P[1]"});
  CHECK(timeline.state().phases.empty());
  CHECK(!timeline.playing());
}

TEST_CASE("stepping makes values, retires them, and brings them back", "[timeline]") {
  const auto trace = small_trace();
  Timeline timeline(trace);
  CHECK(timeline.forward());
  CHECK(alive(trace, timeline) == Names{"x", "P[0]", "P[1]", "a"});
  timeline.seek(3);
  CHECK(alive(trace, timeline) == Names{"x", "P[0]", "P[1]", "b"});
  CHECK(timeline.state().phases == Phases{0});
  timeline.seek(5);
  CHECK(alive(trace, timeline) == Names{"x", "P[0]", "P[1]", "inner[7].C", "D[2]"});
  CHECK(timeline.state().phases == Phases{0, 1});
  CHECK(timeline.state().is_alive(*trace.find("D[2]")));
  CHECK(!timeline.state().is_alive(*trace.find("b")));
  CHECK(timeline.back());
  CHECK(timeline.back());
  CHECK(alive(trace, timeline) == Names{"x", "P[0]", "P[1]", "b"});
  CHECK(timeline.state().phases == Phases{0});
}

TEST_CASE("the ends hold", "[timeline]") {
  const auto trace = small_trace();
  Timeline timeline(trace);
  CHECK(!timeline.back());
  CHECK(timeline.seek(1000));
  CHECK(timeline.position() == 7);
  CHECK(timeline.at_end());
  CHECK(!timeline.forward());
  CHECK(!timeline.seek(7));
}

TEST_CASE("over passes by the phase that a step introduces, out ends the phase one is in", "[timeline]") {
  const auto trace = small_trace();
  Timeline timeline(trace);
  const auto over_from = [&](std::uint32_t step) { return timeline.seek(step), timeline.over(), timeline.position(); };
  CHECK(over_from(0) == 1);
  CHECK(over_from(1) == 2);  // introduces the outer phase
  CHECK(over_from(2) == 7);
  CHECK(over_from(4) == 6);
  CHECK(over_from(3) == 4);
  const auto out_from = [&](std::uint32_t step) { return timeline.seek(step), timeline.out(), timeline.position(); };
  CHECK(out_from(4) == 5);
  CHECK(out_from(5) == 6);  // the inner one is over already
  CHECK(out_from(3) == 6);
  CHECK(out_from(1) == 7);
}

TEST_CASE("marks are steps to jump between", "[timeline]") {
  const auto trace = small_trace();
  Timeline timeline(trace);
  CHECK(!timeline.next_mark());
  timeline.set_marks({5, 2, 2, 99});
  CHECK(timeline.marks() == Phases{2, 5});
  CHECK(timeline.next_mark());
  CHECK(timeline.position() == 2);
  CHECK(timeline.next_mark());
  CHECK(timeline.position() == 5);
  CHECK(!timeline.next_mark());
  CHECK(timeline.previous_mark());
  CHECK(timeline.position() == 2);
  CHECK(!timeline.previous_mark());
}

TEST_CASE("playing goes on by the time that passed, at its speed", "[timeline]") {
  const auto trace = small_trace();
  Timeline timeline(trace);
  CHECK(!timeline.advance(10));  // paused
  timeline.play();
  CHECK(!timeline.advance(0.75));
  CHECK(timeline.fraction() == 0.75);
  CHECK(timeline.advance(0.5));
  CHECK(timeline.position() == 1);
  CHECK(timeline.fraction() == 0.25);
  timeline.set_speed(4);
  CHECK(timeline.advance(1));
  CHECK(timeline.position() == 5);
  timeline.forward();
  CHECK(timeline.fraction() == 0);
  timeline.pause();
  CHECK(!timeline.advance(1));
  timeline.play();
  CHECK(timeline.advance(100));
  CHECK(timeline.at_end());
  CHECK(!timeline.playing());
  timeline.play();  // once more, from the beginning
  CHECK(timeline.position() == 0);
}

TEST_CASE("a range is played over and over", "[timeline]") {
  const auto trace = small_trace();
  Timeline timeline(trace);
  timeline.set_loop(2, 4);
  timeline.play();
  CHECK(timeline.position() == 2);
  std::vector<std::uint32_t> seen;
  for (int i = 0; i < 7; ++i) {
    timeline.advance(1);
    seen.push_back(timeline.position());
  }
  CHECK(seen == Phases{3, 4, 2, 3, 4, 2, 3});
  CHECK(timeline.advance(3e9 + 1));
  CHECK(timeline.position() == 4);
  CHECK(timeline.playing());
  timeline.clear_loop();
  timeline.advance(100);
  CHECK(timeline.at_end());
  timeline.set_loop(9, 3);  // ends that are out of order or beyond the trace are moved into it
  CHECK(timeline.loop() == std::pair<std::uint32_t, std::uint32_t>{3, timeline.last()});
  timeline.set_loop(3, 3);  // a single step is nothing to repeat
  CHECK_FALSE(timeline.loop());
}

TEST_CASE("times and speeds that are none change nothing", "[timeline]") {
  const auto trace = small_trace();
  Timeline timeline(trace);
  timeline.play();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double seconds : {0.0, -1.0, infinity, std::numeric_limits<double>::quiet_NaN()})
    CHECK(!timeline.advance(seconds));
  for (const double speed : {0.0, -2.0, infinity, std::numeric_limits<double>::quiet_NaN()}) timeline.set_speed(speed);
  CHECK(timeline.speed() == 1);
  CHECK(timeline.position() == 0);
}
