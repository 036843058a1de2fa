// What a recorder keeps, and what a trace tells of it.

#include <catch2/catch.hpp>

#include "trace/traces.hpp"

using namespace blossom;
using test::small_trace;

TEST_CASE("what is given at the beginning is step 0, and each rule's value a step of its own", "[trace]") {
  const auto trace = small_trace();
  REQUIRE(trace.step_count() == 8);
  CHECK(trace.values_of(0) == std::pair<ValueId, ValueId>{0, 3});
  CHECK(trace.name(trace.main_value(1)) == "a");
  CHECK(trace.main_value(2) == absent);  // introduces a phase
  CHECK(trace.introduced_by(2) == 0);
  CHECK(trace.introduced_by(3) == absent);
  CHECK(trace.values_of(5).second - trace.values_of(5).first == 2);
  CHECK(trace.values_of(7).second - trace.values_of(7).first == 3);  // with the inputs it needed
}

TEST_CASE("phases nest, and scoped ones are part of the names inside them", "[trace]") {
  const auto trace = small_trace();
  REQUIRE(trace.phases().size() == 2);
  CHECK(trace.phases()[0].label() == "outer");
  CHECK(trace.phases()[1].label() == "inner[7]");
  CHECK(trace.phases()[1].parent == 0);
  CHECK(trace.phases()[0].first_step == 2);
  CHECK(trace.phases()[0].last_step == 6);
  CHECK(trace.phases()[1].last_step == 5);
  CHECK(trace.find("inner[7].C"));
  CHECK(trace.find("D[2]"));  // named in the scope around
  CHECK(!trace.find("inner[7].D[2]"));
  CHECK(!trace.find("C"));
}

TEST_CASE("numbers, operands and lives of values", "[trace]") {
  const auto trace = small_trace();
  const ValueId C = *trace.find("inner[7].C");
  CHECK(trace.value(C).kind == ValueKind::point);
  CHECK(std::ranges::equal(trace.numbers(C), std::vector<double>{1, 2, 0, 1}));
  CHECK(std::ranges::equal(trace.operands(C),
                           std::vector<ValueId>{*trace.find("x"), *trace.find("P[0]"), *trace.find("P[1]")}));
  CHECK(trace.retired_at(*trace.find("a")) == 3);
  CHECK(trace.retired_at(C) == absent);
  CHECK(trace.alive(*trace.find("a"), 2));
  CHECK(!trace.alive(*trace.find("a"), 3));
  CHECK(!trace.alive(C, 4));
  CHECK(to_string(trace.polar_labels()[C]) == "b(0.25)");
}

TEST_CASE("replaying with a value of one's own carries it forward", "[trace]") {
  const auto trace = small_trace();
  const auto replayed = trace.replay({{*trace.find("b"), {2.0}}});
  CHECK(replayed[*trace.find("e")] == std::vector<double>{0.125});
  CHECK(replayed[*trace.find("f")] == std::vector<double>{0.5});
  const auto impossible = trace.replay({{*trace.find("b"), {0.0}}});  // the quotient by 0 does not exist
  CHECK(impossible[*trace.find("e")].empty());
}

TEST_CASE("a recorder that is cleared records the next run from the beginning", "[trace]") {
  TraceRecorder<double> rec;
  const auto run = [&] {
    auto phase = rec.phase({"only"});
    rec.apply(Sum{}, "s"_v, rec.input("a"_v, 1.0), rec.input("b"_v, 2.0));
  };
  run();
  CHECK(rec.trace().find("s"));
  rec.clear();
  CHECK(rec.trace().value_count() == 0);
  run();
  CHECK(rec.trace().value_count() == 3);
  CHECK(rec.trace().find("s") == 2);
}

TEST_CASE("copies of traces are equal, and a change is a difference", "[trace]") {
  const auto trace = small_trace();
  auto copy = trace;
  CHECK(copy == trace);
  copy.rational = true;
  CHECK(!(copy == trace));
  TraceRecorder<double> rec;
  rec.input("x"_v, 0.5);
  CHECK(!(std::move(rec).take() == trace));
}

TEST_CASE("growing arrays keep what they hold", "[trace]") {
  Growing<int> numbers;
  for (int i = 0; i < 100'000; ++i) numbers.push_back(i);
  Growing<int> copy(numbers);
  copy.push_back(copy[7]);
  CHECK(copy.size() == 100'001);
  CHECK(copy.back() == 7);
  CHECK(std::ranges::equal(std::span<const int>(copy).first(100'000), std::span<const int>(numbers)));
  numbers = std::move(copy);
  CHECK(numbers.size() == 100'001);
  numbers.clear();
  CHECK(numbers.empty());
}

TEST_CASE("rules know which operands they take", "[trace]") {
  using K = ValueKind;
  const auto takes = [](const RuleInfo& rule, std::vector<K> kinds) { return rule.accepts(kinds); };
  CHECK(takes(rule_info<Blend>, {K::scalar, K::point, K::point}));
  CHECK(takes(rule_info<Blend>, {K::integer, K::point, K::vector}));
  CHECK(!takes(rule_info<Blend>, {K::scalar, K::point}));
  CHECK(!takes(rule_info<Blend>, {K::scalar, K::point, K::point, K::point}));
  CHECK(!takes(rule_info<Blend>, {K::point, K::point, K::point}));
  CHECK(takes(rule_info<FindSpan>, {K::integer, K::scalar, K::list}));
  CHECK(!takes(rule_info<FindSpan>, {K::scalar, K::scalar, K::list}));
  CHECK(takes(rule_info<Mean>, {K::scalar, K::scalar, K::scalar}));
  CHECK(takes(rule_info<Mean>, {K::list}));
  CHECK(!takes(rule_info<Mean>, {K::list, K::scalar}));
  CHECK(!takes(rule_info<Mean>, {}));
}
