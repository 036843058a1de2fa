// blossom step: step through an algorithm at the terminal, forward and back.

#include <iostream>
#include <sstream>

#include "algorithms/selector.hpp"
#include "app/input.hpp"
#include "app/text.hpp"
#include "lesson/prose.hpp"
#include "trace/timeline.hpp"
#include "trace/why.hpp"

namespace blossom {
namespace {

constexpr const char* keys =
    "  Enter, n    next step            o         over: skip a phase\n"
    "  b           back                 u         out of this phase\n"
    "  g NUMBER    go to a step         f, l      first, last step\n"
    "  ] and [     next, previous beat of the lesson\n"
    "  w NAME      why: where a value comes from, down to the inputs\n"
    "  t           the triangular scheme so far\n"
    "  c           the pseudo-code      ?         this help       q   quit\n";

template <Scalar S>
class Stepper {
 public:
  Stepper(const Subject& subject, const Narrator<S>& narrator)
      : subject_(subject), narrator_(narrator), timeline_(narrator.trace()) {
    if (!subject.lesson) return;
    std::vector<std::uint32_t> beats;
    for (const Beat& beat : subject.lesson_scene()->beats) beats.push_back(beat.step);
    timeline_.set_marks(std::move(beats));
  }

  void run(std::istream& in) {
    const std::string note = subject_.scene_note();
    std::cout << heading(subject_.title()) << (note.empty() ? "" : wrapped(note) + "\n\n")
              << wrapped(subject_.algorithm->summary) << "\n\n"
              << keys << "\n";
    show();
    for (std::string line; std::cout << "> " << std::flush && std::getline(in, line);) {
      std::istringstream words(line);
      std::string word, rest;
      words >> word >> rest;
      if (word == "q") return;
      if (!command(word, rest)) std::cout << "no such command: " << excerpt(line) << "; ? lists them\n";
    }
    std::cout << "\n";
  }

 private:
  bool command(const std::string& word, const std::string& rest) {
    bool moved = false;
    if (word.empty() || word == "n")
      moved = timeline_.forward();
    else if (word == "b")
      moved = timeline_.back();
    else if (word == "o")
      moved = timeline_.over();
    else if (word == "u")
      moved = timeline_.out();
    else if (word == "f")
      moved = timeline_.seek(0);
    else if (word == "l")
      moved = timeline_.seek(timeline_.last());
    else if (word == "]")
      moved = timeline_.next_mark();
    else if (word == "[")
      moved = timeline_.previous_mark();
    else if (word == "g") {
      const auto step = Exact::parse(rest);
      if (!step || !step->is_integer() || *step < Exact(0) || Exact(static_cast<int>(timeline_.last())) < *step) {
        std::cout << "g needs a step from 0 to " << timeline_.last() << "\n";
        return true;
      }
      timeline_.seek(static_cast<std::uint32_t>(step->to_double()));
      moved = true;
    } else if (word == "w")
      return why(rest), true;
    else if (word == "t")
      return std::cout << narrator_.tableau(timeline_.position()), true;
    else if (word == "c")
      return pseudo_code(), true;
    else if (word == "?")
      return std::cout << keys, true;
    else
      return false;
    if (moved)
      show();
    else
      std::cout << (timeline_.at_end() ? "this is the last step\n" : "there is nothing further that way\n");
    return true;
  }

  void show() const {
    const std::uint32_t step = timeline_.position();
    const auto& trace = narrator_.trace();
    std::cout << "\nstep " << step << " / " << timeline_.last();
    for (const std::uint32_t phase : timeline_.state().phases) std::cout << "  > " << narrator_.phase_title(phase);
    std::cout << "\n";
    if (const int line = narrator_.line(step); line > 0)
      std::cout << "    " << line << "  "
                << narrator_.algorithm_at(step).pseudo_code[static_cast<std::size_t>(line) - 1] << "\n";
    std::cout << wrapped(plain_text(read_prose(subject_.narration(narrator_, step)))) << "\n";
    if (const ValueId v = trace.main_value(step); v != absent && !trace.is_input(v)) {
      std::cout << "    " << trace.name(v) << " = " << narrator_.formula(v) << "\n";
      if (const auto polar = narrator_.polar(v); !polar.empty()) std::cout << "    blossom value " << polar << "\n";
    }
  }

  void pseudo_code() const {
    const Algorithm& algorithm = narrator_.algorithm_at(timeline_.position());
    const int current = narrator_.line(timeline_.position());
    for (std::size_t i = 0; i < algorithm.pseudo_code.size(); ++i)
      std::cout << (static_cast<int>(i) + 1 == current ? "  => " : "     ") << i + 1 << "  " << algorithm.pseudo_code[i]
                << "\n";
  }

  // A value, its operands, theirs, and so on; each value once.
  void why(const std::string& name) const {
    const auto& trace = narrator_.trace();
    const auto found = trace.find(name);
    if (!found || trace.value(*found).step > timeline_.position()) {
      std::cout << "there is no value " << excerpt(name) << " yet";
      if (const auto near = nearest_name(trace, name); near && !found) std::cout << "; did you mean " << *near << "?";
      std::cout << "\n";
      return;
    }
    for (const WhyLine& line : blossom::why(trace, *found)) {
      std::cout << std::string(2 * static_cast<std::size_t>(line.depth) + 2, ' ') << trace.name(line.value) << " = "
                << narrator_.value_text(line.value);
      if (line.given)
        std::cout << "   (given)\n";
      else if (line.told_above)
        std::cout << "   (see above)\n";
      else
        std::cout << "   = " << narrator_.formula(line.value) << "\n";
    }
  }

  const Subject& subject_;
  const Narrator<S>& narrator_;
  Timeline timeline_;
};

template <Scalar S>
int step_through(const Subject& subject) {
  const auto recorded = record<S>(subject);
  if (!recorded) return report(recorded.diagnostics);
  const Narrator<S> narrator(*recorded, 6);
  Stepper<S>(subject, narrator).run(std::cin);
  return done;
}

void set_up(CLI::App& app, int& status) {
  struct Options {
    SubjectOptions subject;
    bool decimals = false;
  };
  auto options = std::make_shared<Options>();
  add_subject_options(app, options->subject);
  app.add_flag("--decimals", options->decimals,
               "Compute in decimals (double precision); by default in exact fractions");
  app.footer(std::string("Keys, each followed by Enter:\n") + keys + "Example:\n  blossom step 11-de-casteljau");
  app.callback([options, &status] {
    const auto subject = load_subject(options->subject);
    status = !subject ? report(subject.diagnostics)
                      : (options->decimals ? step_through<double>(*subject) : step_through<Exact>(*subject));
  });
}

}  // namespace

const Command& command_step() {
  static const Command command{"step", "Step through an algorithm, forward and back, at the terminal", 25, set_up};
  return command;
}

}  // namespace blossom
