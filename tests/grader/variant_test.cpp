// Variants of the shipped exercises, held against grader/VARIANTS.md by another route: everything is computed again
// from the variant's file, in the order of the trace, and answers are judged as handed-in ones are.

#include <filesystem>
#include <set>

#include "algorithms/selector.hpp"
#include "base/json_write.hpp"
#include "grader/helpers.hpp"
#include "grader/variant.hpp"

using namespace blossom;

namespace {

const std::string secret = "correct horse battery";
constexpr std::size_t students = 300;

std::vector<JsonDocument> varying_exercises() {
  std::vector<JsonDocument> found;
  for (const auto& file : std::filesystem::directory_iterator("exercises")) {
    if (file.path().extension() != ".json") continue;
    auto document = JsonDocument::load(file.path());
    if (document && varies(*document) && document->root().find("schema")->text == "blossom.exercise/1")
      found.push_back(std::move(*document));
  }
  return found;
}

JsonDocument variant_of(const VariantMaker& maker, const std::string& student) {
  auto variant = maker.make(student, secret);
  INFO(to_string(variant.diagnostics));
  REQUIRE(variant);
  return std::move(*variant);
}

// Whether typed numbers would be accepted, by the way a submission takes.
bool is_right(const Part& part, const Numbers<Exact>& typed) {
  std::vector<Json> items;
  for (const Exact& x : typed) items.push_back(json_string(x.to_string()));
  return match(part, part.is_single() ? items.at(0) : json_array(std::move(items))) == Match::right;
}

// All values as somebody has them who holds a misconception throughout, in its `choice`-th way; or in one value only.
class WrongRun final : public Site {
 public:
  WrongRun(const Run<Exact>& run, const Misconception& misconception) : run_(&run), misconception_(&misconception) {
    for (ValueId v = 0; v < run.trace.value_count(); ++v) {
      const auto numbers = run.trace.numbers(v);
      own_.emplace_back(numbers.begin(), numbers.end());
    }
    touched_.assign(own_.size(), false);
  }
  void throughout(std::size_t choice) {
    for (ValueId v = 0; v < own_.size(); ++v) {
      if (run_->trace.is_input(v)) continue;
      const auto wrong = candidates(v);
      touched_[v] = !wrong.empty();
      std::vector<NumbersView<Exact>> operands;
      for (const ValueId o : run_->trace.operands(v)) {
        touched_[v] = touched_[v] || touched_[o];
        operands.emplace_back(own_[o]);
      }
      Numbers<Exact> made;
      if (!wrong.empty())
        made = wrong[std::min(choice, wrong.size() - 1)];
      else if (touched_[v] && !run_->trace.value(v).rule->replay<Exact>()(operands, made))
        made.clear();
      if (touched_[v]) own_[v] = made;
      ways_ = std::max(ways_, wrong.size());
    }
  }
  std::vector<Numbers<Exact>> candidates(ValueId v) {
    value_ = v;
    return misconception_->wrong(*this);
  }
  std::size_t ways() const { return ways_; }
  bool touched(ValueId v) const { return touched_[v]; }
  const Numbers<Exact>& own(ValueId v) const { return own_[v]; }

  const Trace<Exact>& trace() const override { return run_->trace; }
  const Inputs<Exact>& inputs() const override { return run_->inputs; }
  ValueId value() const override { return value_; }
  NumbersView<Exact> numbers(ValueId v) const override {
    return own_[v].empty() ? run_->trace.numbers(v) : NumbersView<Exact>(own_[v]);
  }

 private:
  const Run<Exact>* run_;
  const Misconception* misconception_;
  std::vector<Numbers<Exact>> own_;
  std::vector<bool> touched_;
  std::size_t ways_ = 1;
  ValueId value_ = absent;
};

std::int64_t digits(const Exercise& exercise) {
  std::int64_t count = 0;
  for (const Part& part : exercise.parts)
    for (const Exact& x : part.right) {
      if (x.is_approximate()) continue;  // an irrational number is rounded
      for (const char c : x.to_string()) count += std::isdigit(static_cast<unsigned char>(c)) != 0 ? 1 : 0;
    }
  return count;
}

Exact largest_denominator(const Exercise& exercise) {
  Exact largest = 1;
  for (const Part& part : exercise.parts)
    for (const Exact& x : part.right) {
      const std::string text = x.to_string();
      const auto slash = text.find('/');
      if (x.is_approximate() || slash == std::string::npos) continue;
      largest = std::max(largest, *Exact::parse(text.substr(slash + 1)));
    }
  return largest;
}

// What "vary" says of readability and likeness, and what holds where it says nothing.
Exact demanded(const JsonDocument& document, const char* member, Exact otherwise) {
  const Json* said = document.root().find("vary")->find(member);
  return said == nullptr ? otherwise : *Exact::parse(said->text);
}

// What the model itself does not meet (the first point of a refined curve is a control point) is not demanded.
bool is_given(const Exercise& exercise, const Part& part) {
  const auto& trace = exercise.run.trace;
  const auto has = [&](ValueId v) {
    return trace.value(v).kind == part.kind && is_right(part, part.as_typed(trace.numbers(v)));
  };
  if (part.name != "C" && std::ranges::any_of(trace.operands(part.value), has)) return true;
  for (ValueId v = 0; v < trace.value_count(); ++v)
    if (trace.is_input(v) && has(v)) return true;
  return part.kind == ValueKind::scalar && (is_right(part, {Exact(0)}) || is_right(part, {Exact(1)}));
}

void check_something_to_compute(const Exercise& exercise, const Exercise& model) {
  const auto& trace = exercise.run.trace;
  for (const Part& part : exercise.parts) {
    if (part.kind == ValueKind::integer) continue;
    if (is_given(model, model.parts[*model.part(part.name)])) continue;
    INFO(part.name);
    std::vector<ValueId> others(trace.operands(part.value).begin(), trace.operands(part.value).end());
    for (ValueId v = 0; v < trace.value_count(); ++v)
      if (trace.is_input(v)) others.push_back(v);
    // The point of a rational curve is the projection of what its scheme ends with.
    if (part.name == "C") others.erase(others.begin());
    for (const ValueId v : others)
      if (trace.value(v).kind == part.kind) {
        INFO(trace.name(v));
        CHECK_FALSE(is_right(part, part.as_typed(trace.numbers(v))));
      }
    if (part.kind == ValueKind::scalar) {
      CHECK_FALSE(is_right(part, {Exact(0)}));
      CHECK_FALSE(is_right(part, {Exact(1)}));
    }
    if (part.kind == ValueKind::point)
      CHECK(std::any_of(part.right.begin(), part.right.begin() + part.dimension,
                        [](const Exact& x) { return x != Exact(0); }));
  }
}

// The pairs of "except": a misconception, and a value that it need not show in.
std::set<std::pair<std::string, ValueId>> excepted(const JsonDocument& document, const Exercise& model) {
  std::set<std::pair<std::string, ValueId>> pairs;
  const Json* pairs_in_file = document.root().find("vary")->find("except");
  if (pairs_in_file == nullptr) return pairs;
  for (const Json& pair : pairs_in_file->items) {
    std::string error;
    for (const ValueId v : Selector::parse(pair.find("value")->text, error)->select(model.run.trace))
      pairs.emplace(pair.find("misconception")->text, v);
  }
  return pairs;
}

// What a misconception makes of an asked value: in that value only, or where it is held throughout.
struct Mistaken {
  std::string misconception;
  std::string where;
  const Part* part;
  Numbers<Exact> typed;
};

std::vector<Mistaken> mistaken(const Exercise& exercise) {
  std::vector<Mistaken> all;
  for (const Misconception& misconception : exercise.run.algorithm->misconceptions) {
    const auto add = [&](const std::string& where, const Part& part, const Numbers<Exact>& wrong) {
      all.push_back({std::string(misconception.id), where, &part, part.as_typed(wrong)});
    };
    WrongRun right(exercise.run, misconception);
    for (const Part& part : exercise.parts)
      for (const auto& wrong : right.candidates(part.value)) add("only there", part, wrong);
    std::size_t ways = 1;
    for (std::size_t choice = 0; choice < ways; ++choice) {
      WrongRun wrong(exercise.run, misconception);
      wrong.throughout(choice);
      ways = wrong.ways();
      for (const Part& part : exercise.parts)
        if (wrong.touched(part.value)) add("throughout, way " + std::to_string(choice), part, wrong.own(part.value));
    }
  }
  return all;
}

void check_misconceptions(const Exercise& exercise, const std::set<std::pair<std::string, ValueId>>& except) {
  for (const Mistaken& each : mistaken(exercise)) {
    if (each.typed.empty() || except.contains({each.misconception, each.part->value})) continue;
    INFO(each.misconception << " " << each.where << ", at " << each.part->name);
    CHECK_FALSE(is_right(*each.part, each.typed));
  }
}

// Which misconceptions touch which asked values.
std::set<std::string> touched_by_misconceptions(const Exercise& exercise) {
  std::set<std::string> pairs;
  for (const Mistaken& each : mistaken(exercise)) pairs.insert(each.misconception + " " + each.part->name);
  return pairs;
}

std::string shape_of(const Exercise& exercise) {
  std::string text;
  for (ValueId v = 0; v < exercise.run.trace.value_count(); ++v)
    text += exercise.run.trace.name(v) + " " + std::to_string(exercise.run.trace.value(v).step) + "\n";
  return text;
}

}  // namespace

TEST_CASE("Variants of shipped exercises are all that VARIANTS.md says") {
  const auto exercises = varying_exercises();
  REQUIRE(exercises.size() >= 5);
  std::size_t touched_values = 0;
  for (const JsonDocument& document : exercises) {
    const auto model = read_exercise(document);
    REQUIRE(model);
    INFO(model->id);
    const VariantMaker maker(document);
    const Exact most_denominator = demanded(document, "denominator", std::max(Exact(100), largest_denominator(*model)));
    const Exact likeness = demanded(document, "likeness", Exact::ratio(3, 2));
    const std::string shape = shape_of(*model);
    const auto except = excepted(document, *model);
    const auto touched = touched_by_misconceptions(*model);
    touched_values += touched.size();
    std::set<std::string> different;
    for (std::size_t i = 0; i < students; ++i) {
      const auto variant = variant_of(maker, "s" + std::to_string(i));
      INFO("student s" << i << " of secret \"" << secret << "\": " << variant.text());
      CHECK_FALSE(varies(variant));
      const auto exercise = read_exercise(variant);
      INFO(to_string(exercise.diagnostics));
      REQUIRE(exercise);
      different.insert(variant.text());
      CHECK(exercise->id == model->id);
      CHECK(exercise->max_points == model->max_points);
      REQUIRE(shape_of(*exercise) == shape);
      check_something_to_compute(*exercise, *model);
      CHECK(largest_denominator(*exercise) <= most_denominator);
      CHECK(Exact(digits(*exercise)) <= likeness * Exact(digits(*model)));
      CHECK(Exact(digits(*model)) <= likeness * Exact(digits(*exercise)));
      CHECK(touched_by_misconceptions(*exercise) == touched);
      check_misconceptions(*exercise, except);
    }
    // So many that hardly two of a class have the same.
    CHECK(different.size() >= students - 10);
  }
  CHECK(touched_values > 3 * exercises.size());
}

TEST_CASE("One's own right answers earn everything, another student's do not") {
  for (const JsonDocument& document : varying_exercises()) {
    const VariantMaker maker(document);
    const Grader ada(*read_exercise(variant_of(maker, "ada"))), bob(*read_exercise(variant_of(maker, "bob")));
    INFO(ada.exercise().id);
    CHECK(grade_answers_to(ada, all_answers(ada.exercise())).score() == 1);
    CHECK(grade_answers_to(bob, all_answers(bob.exercise())).score() == 1);
    CHECK(grade_answers_to(bob, all_answers(ada.exercise())).score() < 1);
    CHECK(grade_answers_to(ada, all_answers(bob.exercise())).score() < 1);
  }
}

TEST_CASE("A variant is the exercise with other inputs, and the prompt with other numbers") {
  for (const JsonDocument& document : varying_exercises()) {
    const auto variant = make_variant(document, "s17", secret);
    REQUIRE(variant);
    std::vector<std::string> keys = document.root().keys;
    std::erase(keys, "vary");
    REQUIRE(variant->root().keys == keys);
    for (const auto& key : keys)
      if (key != "inputs") CHECK(write_json(*variant->root().find(key)) == write_json(*document.root().find(key)));
    CHECK(write_json(*variant->root().find("inputs")) != write_json(*document.root().find("inputs")));
    const auto exercise = read_exercise(*variant);
    REQUIRE(exercise);
    CHECK(exercise->prompt.find_first_of("{}") == std::string::npos);
    CHECK(exercise->prompt != read_exercise(document)->prompt);
    CHECK(variant_of(VariantMaker(document), "s17").text() == variant->text());
  }
}

TEST_CASE("Where nothing varies the variant is the exercise") {
  const auto document = JsonDocument::load("exercises/11-de-casteljau.json");
  REQUIRE(document);
  CHECK_FALSE(varies(*document));
  CHECK(make_variant(*document, "s17", secret)->text() == document->text());
  CHECK(check_variants(*document).empty());
}

TEST_CASE("Secrets and IDs, whatever bytes they have, make variants of their own") {
  const auto document = JsonDocument::load("exercises/16-own-degree-elevation.json");
  REQUIRE(document);
  std::set<std::string> texts;
  std::size_t count = 0;
  for (const std::string& key : {secret, std::string("another horse battery"), std::string(4096, '\0')})
    for (const std::string& id :
         {std::string(), std::string("s17"), std::string("S17"), std::string("s17 "), std::string(1, '\0'),
          std::string("\xFF\xFE"), std::string("\"}{\n</script>"), std::string(1 << 20, 'x')}) {
      const auto variant = make_variant(*document, id, key);
      REQUIRE(variant);
      texts.insert(variant->text());
      CHECK(make_variant(*document, id, key)->text() == variant->text());
      ++count;
    }
  CHECK(texts.size() == count);
}
