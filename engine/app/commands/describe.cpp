// blossom describe: what an algorithm takes, makes and asks, with the names that lessons and exercises use.

#include <algorithm>
#include <iostream>
#include <set>

#include "algorithms/formula_words.hpp"
#include "algorithms/narrate.hpp"
#include "app/input.hpp"
#include "app/text.hpp"
#include "base/json_write.hpp"
#include "base/utf8.hpp"
#include "lesson/document.hpp"
#include "lesson/names.hpp"
#include "lesson/starter.hpp"

namespace blossom {
namespace {

constexpr std::size_t longest_value = 60;  // of an example, in characters

std::string from_to(const InputSpec& spec) {
  if (spec.at_least == 0 && spec.at_most == 0) return {};
  if (spec.at_most == 0) return ", at least " + std::to_string(spec.at_least);
  return ", " + std::to_string(spec.at_least) + " to " + std::to_string(spec.at_most);
}

// What stands there in a file.
std::string form_of(const InputSpec& spec) {
  switch (spec.type) {
    case InputSpec::Type::number:
      return "a number: 0.4, \"2/5\"";
    case InputSpec::Type::integer:
      return "a whole number" + from_to(spec);
    case InputSpec::Type::choice: {
      std::string text = "one of";
      for (std::size_t i = 0; i < spec.choices.size(); ++i)
        text += (i > 0 ? ", \"" : " \"") + std::string(spec.choices[i]) + "\"";
      return text;
    }
    case InputSpec::Type::curve:
      return R"(a curve: {"degree": 2, "points": [[0, 0], ...]}, with "knots" and "weights" if it has them)";
    case InputSpec::Type::surface:
      return R"(a surface: {"degree": [2, 2], "points": [[[0, 0, 0], ...], ...]}, with "knots" and "weights" if it has )"
             "them";
    case InputSpec::Type::curves:
      return "an array of curves" + from_to(spec);
    case InputSpec::Type::numbers:
      return "an array of numbers" + from_to(spec);
    case InputSpec::Type::points:
      return "an array of points [[x, y], ...]" + from_to(spec);
    case InputSpec::Type::net:
      return "rows of points [[[x, y, z], ...], ...]";
  }
  return {};
}

// A heading of a part, and lines below it that are indented.
void part(std::string_view title) { std::cout << "\n" << title << "\n"; }

void line(const std::string& text, std::size_t indent = 2) {
  std::cout << std::string(indent, ' ') << wrapped(text, indent) << "\n";
}

std::string shortened(const std::string& text) {
  std::size_t end = 0, count = 0;
  for (; end < text.size() && count < longest_value; ++count) end += std::max<std::size_t>(utf8_length(text, end), 1);
  return end < text.size() ? text.substr(0, end) + "..." : text;
}

void write_inputs(const Algorithm& algorithm) {
  part("Inputs");
  for (const InputSpec& spec : algorithm.inputs) {
    line(json_quote(spec.name) + ": " + form_of(spec) +
         (spec.fallback.empty() ? "" : "; without it " + std::string(spec.fallback)));
    line(std::string(spec.description), 6);
  }
}

void write_code(const Algorithm& algorithm) {
  part("Pseudo-code");
  for (std::size_t i = 0; i < algorithm.pseudo_code.size(); ++i)
    std::cout << (i < 9 ? "   " : "  ") << i + 1 << "  " << algorithm.pseudo_code[i] << "\n";
}

std::string example_of(const Narrator<Exact>& narrator, ValueId v) {
  const auto& trace = narrator.trace();
  const std::string name = trace.name(v) + " = ", formula = narrator.formula(v);
  const std::string value = shortened(narrator.value_text(v));
  if (trace.is_input(v) || formula == narrator.value_text(v)) return name + value;
  return name + (is_sentence(formula) ? value + ", " + formula : formula + " = " + value);
}

// By families, in the order of the run: given ones first, then what is made.
void write_values(const Narrator<Exact>& narrator) {
  const auto& trace = narrator.trace();
  const auto families = name_families(trace);
  for (const bool given : {true, false}) {
    part(given ? "Values that are given, of this example" : "Values that are made");
    for (const NameFamily& family : families) {
      const auto made = std::ranges::find_if(family.values, [&](ValueId v) { return !trace.is_input(v); });
      if (given != (made == family.values.end())) continue;
      const ValueId v = given ? family.values.front() : *made;
      const std::uint32_t step = trace.value(v).step;
      const ValueSpec* spec = narrator.algorithm_at(step).spec(trace.value(v).name);
      if (spec == nullptr) spec = narrator.run().algorithm->spec(trace.value(v).name);
      const int at = given ? 0 : narrator.line(step);
      line(family.ranges + (spec != nullptr ? ": " + std::string(spec->meaning) : "") +
           (at > 0 ? ", line " + std::to_string(at) : ""));
      line((family.values.size() > 1 ? "such as " : "here ") + example_of(narrator, v), 6);
    }
  }
}

void write_phases(const Narrator<Exact>& narrator) {
  const auto& trace = narrator.trace();
  if (trace.phases().empty()) return;
  part("Phases, for {\"phase\": ...} and {\"after\": ...}");
  std::set<std::string> told;
  for (std::uint32_t phase = 0; phase < trace.phases().size(); ++phase) {
    std::string path;
    for (const std::uint32_t outer : trace.phase_path(phase))
      path += (path.empty() ? "" : ".") + trace.phases()[outer].label();
    std::string kind = path;  // one of those that differ in nothing but numbers
    std::erase_if(kind, [](char c) { return '0' <= c && c <= '9'; });
    if (told.insert(kind).second) line(json_quote(path) + ": " + narrator.phase_title(phase));
  }
}

void write_questions(const Algorithm& algorithm) {
  if (!algorithm.asks.empty()) {
    part("What exercises usually ask");
    std::string asks;
    for (const std::string_view ask : algorithm.asks) asks += (asks.empty() ? "" : ", ") + json_quote(ask);
    line(asks);
  }
  if (algorithm.misconceptions.empty()) return;
  part("Misconceptions that grading knows");
  for (const Misconception& known : algorithm.misconceptions)
    line(std::string(known.id) + ": " + std::string(known.title));
}

int describe(const Algorithm& algorithm) {
  const auto inputs = starting_inputs(algorithm, find_folder("lessons"));
  if (!inputs) return report(inputs.diagnostics);
  const auto document = JsonDocument::parse("inputs", write_json(*inputs));
  Diagnostics diagnostics;
  const auto read = read_inputs(algorithm, Cursor(*document, diagnostics));
  const auto run = record<Exact>(algorithm, *read);
  const Narrator<Exact> narrator(*run);
  std::cout << heading(std::string(algorithm.title) + " (" + std::string(algorithm.id) + ")")
            << wrapped(algorithm.summary) << "\n";
  if (!algorithm.source.empty()) std::cout << wrapped("Read on: " + std::string(algorithm.source)) << "\n";
  write_inputs(algorithm);
  write_code(algorithm);
  write_values(narrator);
  write_phases(narrator);
  write_questions(algorithm);
  std::cout << "\nNext: blossom new lesson --algorithm " << algorithm.id
            << " writes the example as a lesson, blossom trace tells all its steps.\n";
  return done;
}

void set_up(CLI::App& app, int& status) {
  auto id = std::make_shared<std::string>();
  app.add_option("ALGORITHM", *id, "Which one, see `blossom list`")->required();
  app.footer(
      "Tells its inputs, its pseudo-code, the names of its values and phases with an example of each, what exercises\n"
      "usually ask, and the misconceptions that grading knows.\n"
      "Example:\n"
      "  blossom describe de_boor");
  app.callback([id, &status] {
    const Algorithm* algorithm = find_algorithm(*id);
    if (algorithm == nullptr) throw CLI::ValidationError("ALGORITHM", no_such_algorithm(*id));
    status = describe(*algorithm);
  });
}

}  // namespace

const Command& command_describe() {
  static const Command command{"describe", "Tell what an algorithm takes, makes and asks, with the names of its values",
                               15, set_up};
  return command;
}

}  // namespace blossom
