// blossom trace: every step of an algorithm, as text or JSON.

#include <iostream>

#include "algorithms/trace_json.hpp"
#include "app/input.hpp"
#include "app/text.hpp"
#include "lesson/prose.hpp"

namespace blossom {
namespace {

constexpr int shown_digits = 6;  // of decimals, as in pictures; JSON has all

struct Options {
  SubjectOptions subject;
  bool exact = false;
  std::string format = "text";
};

template <Scalar S>
std::string as_text(const Narrator<S>& narrator, const Subject& subject) {
  const auto& trace = narrator.trace();
  std::string text = heading(subject.title());
  if (const std::string note = subject.scene_note(); !note.empty()) text += wrapped(note) + "\n\n";
  text += wrapped(subject.algorithm->summary) + "\n\n";
  for (std::size_t line = 0; line < subject.algorithm->pseudo_code.size(); ++line)
    text += "  " + std::to_string(line + 1) + "  " + std::string(subject.algorithm->pseudo_code[line]) + "\n";
  text += "\n";
  const std::string last = std::to_string(trace.step_count() - 1);
  for (std::uint32_t step = 0; step < trace.step_count(); ++step) {
    const std::string number = std::to_string(step);
    const auto depth = trace.phase_path(trace.step(step).phase).size();
    // A line of an algorithm inside of this one stands in a listing that is not printed.
    const int line = &narrator.algorithm_at(step) == subject.algorithm ? narrator.line(step) : 0;
    const std::string head = std::string(last.size() - number.size(), ' ') + number + "  " +
                             std::string(2 * depth, ' ') + (line > 0 ? "[" + std::to_string(line) + "] " : "");
    text += head + wrapped(plain_text(read_prose(subject.narration(narrator, step))), head.size()) + "\n";
  }
  if (const auto tableau = narrator.tableau(trace.step_count() - 1); !tableau.empty())
    text += "\nThe triangular scheme:\n\n" + tableau;
  const auto approximate = trace.approximate_values();
  if (!approximate.empty()) {
    std::string note = "Exact before step " + std::to_string(trace.value(approximate.front()).step) + ". " +
                       (approximate.size() == 1
                            ? "One value is irrational, or comes of an irrational one, and is shown as a decimal: "
                            : std::to_string(approximate.size()) +
                                  " values are irrational, or come of irrational ones, and are shown in decimals: ");
    for (std::size_t i = 0; i < approximate.size() && i < 8; ++i)
      note += (i > 0 ? ", " : "") + trace.name(approximate[i]);
    note += approximate.size() > 8 ? ", ... (all are marked in --format json)." : ".";
    text += "\n" + wrapped(note) + "\n";
  }
  return text;
}

template <Scalar S>
int run(const Subject& subject, const Options& options) {
  const auto recorded = record<S>(subject);
  if (!recorded) return report(recorded.diagnostics);
  std::cout << (options.format == "json" ? write_trace(Narrator<S>(*recorded))
                                         : as_text(Narrator<S>(*recorded, shown_digits), subject));
  return done;
}

void set_up(CLI::App& app, int& status) {
  auto options = std::make_shared<Options>();
  add_subject_options(app, options->subject);
  app.add_flag("--exact", options->exact, "Compute in exact rational numbers: 1/3 instead of 0.333...");
  app.add_option("--format", options->format, "text or json")
      ->check(CLI::IsMember({"text", "json"}))
      ->capture_default_str();
  app.footer(
      "Examples:\n"
      "  blossom trace 11-de-casteljau --exact\n"
      "  blossom trace lessons/11-de-casteljau.json --format json > trace.json\n"
      "  echo '{\"curve\": {\"degree\": 2, \"points\": [[0,0],[1,2],[2,0]]}, \"u\": \"1/3\"}' |\n"
      "    blossom trace --algorithm de_casteljau --inputs - --exact\n"
      "Exit status: 0 done, 1 the input is at fault, 2 wrong usage, 3 the machine.");
  app.callback([options, &status] {
    const auto subject = load_subject(options->subject);
    status = !subject ? report(subject.diagnostics)
                      : (options->exact ? run<Exact>(*subject, *options) : run<double>(*subject, *options));
  });
}

}  // namespace

const Command& command_trace() {
  static const Command command{"trace", "Print every step of an algorithm, with its numbers", 20, set_up};
  return command;
}

}  // namespace blossom
