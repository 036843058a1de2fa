#include <algorithm>

#include "base/json_write.hpp"
#include "lesson/catalog.hpp"
#include "lesson/file_kind.hpp"
#include "lesson/starter.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

constexpr int most_tries = 20'000;

// Small values of each type, the plainest first.
std::vector<std::string> candidates(const InputSpec& spec) {
  using Type = InputSpec::Type;
  switch (spec.type) {
    case Type::number:
      return {"\"1/2\"", "1", "\"1/4\"", "2", "90", "20"};
    case Type::integer: {
      std::vector<std::string> numbers;
      for (int n = spec.at_least; n <= spec.at_most && numbers.size() < 4; ++n) numbers.push_back(std::to_string(n));
      return numbers;
    }
    case Type::choice: {
      std::vector<std::string> words;
      for (const std::string_view word : spec.choices) words.push_back(json_quote(word));
      return words;
    }
    case Type::curve:
      return {R"({"degree": 3, "points": [[0, 0], [1, 3], [5, 3], [6, 0]]})",
              R"({"degree": 2, "knots": [0, 0, 0, 1, 1, 2, 2, 2], "points": [[0, 0], [1, 2], [3, 3], [5, 2], [6, 0]]})",
              R"({"degree": 2, "knots": [0, 0, 0, 1, 2, 2, 2], "points": [[0, 0], [1, 2], [3, 2], [4, 0]]})",
              R"({"degree": 2, "knots": [0, 1, 2, 3, 4, 5, 6], "points": [[0, 0], [1, 2], [3, 2], [4, 0]]})",
              R"({"degree": 2, "points": [[0, 2, 0], [2, 3, 1], [4, 2, 3]]})",
              R"({"degree": 1, "points": [[0, 0, 0], [0, 0, 4]]})"};
    case Type::surface:
      return {R"({"degree": [2, 2], "points": [[[0, 0, 0], [0, 2, 1], [0, 4, 0]], [[2, 0, 1], [2, 2, 4], [2, 4, 1]],
                  [[4, 0, 0], [4, 2, 1], [4, 4, 0]]]})",
              R"({"degree": [2, 1], "knots": [[0, 0, 0, 1, 1, 2, 2, 2], [0, 0, 1, 1]],
                  "points": [[[0, 0, 0], [0, 3, 0]], [[1, 0, 1], [1, 3, 1]], [[2, 0, 3], [2, 3, 2]],
                             [[3, 0, 1], [3, 3, 1]], [[4, 0, 0], [4, 3, 0]]]})"};
    case Type::curves: {
      if (spec.name == "u_curves")
        return {R"([{"degree": 2, "points": [[0, 0, 0], [2, 0, 2], [4, 0, 0]]},
                    {"degree": 2, "points": [[0, 3, 0], [2, 3, 1], [4, 3, 1]]}])"};
      if (spec.name == "v_curves")
        return {
            R"([{"degree": 1, "points": [[0, 0, 0], [0, 3, 0]]}, {"degree": 1, "points": [[4, 0, 0], [4, 3, 1]]}])"};
      return {R"([{"degree": 2, "points": [[0, 0, 0], [2, 0, 2], [4, 0, 0]]},
                  {"degree": 2, "points": [[0, 2, 0], [2, 2, 4], [4, 2, 0]]},
                  {"degree": 2, "points": [[0, 5, 0], [2, 5, 1], [4, 5, 0]]}])"};
    }
    case Type::numbers:
      return {R"(["1/4", "1/2", "3/4"])", R"(["1/2"])", R"(["1/4", "1/2"])", "[]"};
    case Type::points:
      return {"[[0, 0], [3, 4], [6, 4], [9, 0]]", "[[0, 0], [3, 4], [6, 4], [9, 0], [12, 4]]", "[[0, 1], [6, 2]]",
              "[[0, 0]]", "[[0, 0, 0], [0, 0, 1]]"};
    case Type::net:
      return {R"([[[0, 0, 0], [0, 2, 1], [0, 4, 1], [0, 6, 0]], [[2, 0, 1], [2, 2, 3], [2, 4, 3], [2, 6, 1]],
                  [[4, 0, 1], [4, 2, 3], [4, 4, 2], [4, 6, 1]], [[6, 0, 0], [6, 2, 1], [6, 4, 1], [6, 6, 0]]])",
              R"([[[0, 0, 0], [0, 2, 1], [0, 4, 0]], [[2, 0, 1], [2, 2, 4], [2, 4, 1]],
                  [[4, 0, 0], [4, 2, 1], [4, 4, 0]]])"};
  }
  return {};
}

// Whether the algorithm accepts them and takes so many steps.
bool are_accepted(const Algorithm& algorithm, const std::string& text, std::uint32_t least_steps = 2) {
  const auto document = JsonDocument::parse("inputs", text);
  if (!document) return false;
  Diagnostics diagnostics;
  const auto inputs = read_inputs(algorithm, Cursor(*document, diagnostics));
  if (!inputs) return false;
  const auto run = record<Exact>(algorithm, *inputs);
  return run && run->trace.step_count() >= least_steps;
}

// The inputs of a lesson about it: the one that is named after it, else the first that has no other scene, else any.
std::optional<Json> of_a_lesson(const Algorithm& algorithm, const fs::path& folder) {
  std::string namesake(algorithm.id);
  std::ranges::replace(namesake, '_', '-');
  std::optional<Json> found;
  int best = 0;
  Diagnostics none;  // a folder that cannot be read has no lessons
  for (const fs::path& file : json_files(folder, none)) {
    const auto document = JsonDocument::load(file);
    if (!document || file_kind(document->root()) != FileKind::lesson) continue;
    const Json& root = document->root();
    const Json* several = root.find("scenes");
    const Json* id = root.find("id");
    const int rank = id != nullptr && id->text == namesake ? 3 : several == nullptr ? 2 : 1;
    if (rank <= best) continue;
    std::vector<const Json*> scenes{&root};
    for (std::size_t i = 0; several != nullptr && i < several->items.size(); ++i) scenes.push_back(&several->items[i]);
    for (const Json* scene : scenes) {
      const Json* about = scene->find("algorithm");
      const Json* inputs = scene->find("inputs");
      if (rank <= best || about == nullptr || inputs == nullptr || about->text != algorithm.id ||
          !are_accepted(algorithm, write_json(*inputs)))
        continue;
      found = *inputs;
      best = rank;
    }
  }
  return found;
}

// The first combination that is accepted; with or without the inputs that may be left out.
std::optional<std::string> ready_made(const Algorithm& algorithm, bool with_optional, std::uint32_t least_steps) {
  std::vector<std::string_view> names;
  std::vector<std::vector<std::string>> choices;
  for (const InputSpec& spec : algorithm.inputs) {
    if (!spec.fallback.empty() && !with_optional) continue;
    names.push_back(spec.name);
    choices.push_back(candidates(spec));
    if (!spec.fallback.empty()) choices.back().insert(choices.back().begin(), std::string(spec.fallback));
  }
  std::vector<std::size_t> chosen(names.size(), 0);
  for (int tries = 0; tries < most_tries; ++tries) {
    std::string text = "{";
    for (std::size_t i = 0; i < names.size(); ++i)
      text += (i > 0 ? ", " : "") + json_quote(names[i]) + ": " + choices[i][chosen[i]];
    text += "}";
    if (are_accepted(algorithm, text, least_steps)) return text;
    std::size_t i = names.size();
    while (i > 0 && ++chosen[i - 1] == choices[i - 1].size()) chosen[--i] = 0;
    if (i == 0) break;
  }
  return std::nullopt;
}

}  // namespace

Checked<Json> starting_inputs(const Algorithm& algorithm, const fs::path& lessons) {
  if (auto inputs = of_a_lesson(algorithm, lessons)) return *std::move(inputs);
  constexpr std::uint32_t worth_telling = 6;
  for (const std::uint32_t steps : {worth_telling, 2u})
    for (const bool with_optional : {false, true})
      if (const auto text = ready_made(algorithm, with_optional, steps))
        return JsonDocument::parse("inputs", *text)->root();
  return Diagnostics{{"", 0, 0, "", "there are no ready-made inputs that " + std::string(algorithm.id) + " accepts"}};
}

}  // namespace blossom
