#include "grader/page/student_page.hpp"

#include <algorithm>
#include <numeric>

#include "grader/lesson_grader.hpp"
#include "grader/page/assets.hpp"
#include "grader/page/html.hpp"
#include "grader/page/run_html.hpp"
#include "grader/variant.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_given = 120;

class StudentPage {
 public:
  explicit StudentPage(const StudentResult& result) : result_(result) {}

  std::string write() {
    const std::string& title = result_.assignment->title;
    out_ = page_head(title + " – " + who(), assets::page_css);
    out_ += "<header>\n<div>\n<h1>" + html_escape(title) + "</h1>\n<p class=\"who\">" + html_escape(who());
    if (!result_.student.section.empty()) out_ += " · section " + html_escape(result_.student.section);
    out_ += "</p>\n";
    dates();
    out_ += "</div>\n<p class=\"score\"><strong>" + number_text(result_.points) + "</strong> of " +
            number_text(result_.max_points) + " points<span>" + percent_text(result_.score()) +
            "</span></p>\n</header>\n<main>\n";
    incidents({});
    for (std::size_t i = 0; i < result_.exercises.size(); ++i) exercise(i);
    out_ += "</main>\n";
    if (any_run_) out_.append("<script>\n").append(assets::page_js).append("</script>\n");
    out_ += "</body>\n</html>\n";
    return std::move(out_);
  }

 private:
  std::string who() const {
    const Student& student = result_.student;
    return student.name.empty() ? student.id : student.name + " (" + student.id + ")";
  }

  void dates() {
    const Assignment& assignment = *result_.assignment;
    if (const auto due = result_.student.due ? result_.student.due : assignment.due)
      out_ += "<p class=\"who\">Due " + time_in_words(*due, assignment.offset) + "</p>\n";
    const bool all_told = std::ranges::all_of(
        result_.exercises, [&](const ExerciseResult& made) { return exercise_of(made).feedback == Feedback::full; });
    if (assignment.full_feedback_from && !all_told)
      out_ += "<p class=\"who\">The right values will be told from " +
              time_in_words(*assignment.full_feedback_from, assignment.offset) + " on</p>\n";
  }

  // With the numbers and the level of feedback of this student, where they are known.
  const Exercise& exercise_of(const ExerciseResult& made) const {
    if (made.grade) return *made.grade->exercise;
    return made.grader ? made.grader->exercise() : result_.assignment->items[made.item].exercise;
  }

  // A path is the instructor's; its last name is the student's.
  static std::string file_of(const std::string& source) {
    return printable(std::string_view(source).substr(source.rfind('/') + 1));
  }

  void incidents(std::string_view exercise_id) {
    for (const Incident& incident : result_.incidents) {
      using Kind = Incident::Kind;
      const Kind kind = incident.kind;
      if (incident.exercise != exercise_id || !concerns_student(kind) || kind == Kind::late ||
          (kind == Kind::missing && !exercise_id.empty()))
        continue;
      const std::string_view what = kind == Kind::duplicate    ? "Handed in more than once: "
                                    : kind == Kind::unreadable ? "Not readable: "
                                    : kind == Kind::misplaced  ? "Not part of this assignment: "
                                                               : "";
      const std::string file = file_of(incident.source);
      out_.append("<p class=\"notice\">").append(what).append(html_escape(file));
      out_.append(file.empty()              ? ""
                  : kind == Kind::duplicate ? " "
                                            : ": ")
          .append(html_escape(as_sentence(incident.text)));
      out_ += "</p>\n";
    }
  }

  // Something that may have been meant for any exercise.
  bool any_unreadable() const {
    return std::ranges::any_of(result_.incidents, [](const Incident& incident) {
      return incident.kind == Incident::Kind::unreadable && incident.exercise.empty();
    });
  }

  void exercise(std::size_t i) {
    const ExerciseResult& made = result_.exercises[i];
    const Assignment::Item& item = result_.assignment->items[made.item];
    exercise_ = &exercise_of(made);
    out_ += "<article>\n<div class=\"title\"><h2>";
    if (result_.exercises.size() > 1) out_ += std::to_string(i + 1) + ". ";
    out_ += html_escape(exercise_->title) + "</h2><p class=\"points\">" + number_text(made.points) + " of " +
            number_text(made.max_points) + " points</p></div>\n";
    // Whose own numbers are not known is not shown somebody else's.
    if (made.grade || made.grader || !varies(item.document)) prompt();
    lateness(made, item);
    incidents(exercise_->id);
    if (!made.grade) {
      out_ += any_unreadable() ? "<p class=\"notice\">Nothing that can be read was handed in for this exercise.</p>\n"
                               : "<p class=\"notice\">Nothing was handed in for this exercise.</p>\n";
    } else {
      const StudentRun run(made);
      graded(made, run);
      if (run.any_told()) append_run(out_, run);
      any_run_ = any_run_ || run.any_told();
    }
    out_ += "</article>\n";
  }

  std::string math(std::string_view text) const { return math_html(text, *exercise_->run.algorithm); }

  void prompt() {
    const Narrator<Exact> narrator(exercise_->run, 7);
    const Prose words = read_prose(narrator.fill(exercise_->prompt, 0));
    out_ += "<div class=\"prompt\">" + prose_html(words, *exercise_->run.algorithm) + "</div>\n";
    if (!exercise_->is_sheet()) numbers_of(exercise_->run, "The numbers of this exercise");
  }

  void numbers_of(const Run<Exact>& run, std::string_view title) {
    const Narrator<Exact> narrator(run, 7);
    const auto& trace = run.trace;
    std::string given;
    std::size_t count = 0;
    const auto [first, end] = trace.values_of(0);
    for (ValueId v = first; v < end && count < most_given; ++v) {
      const Name& name = trace.value(v).name;
      // Single knots stand in their vector.
      const bool listed = name.arity == 0 || trace.value(v).kind == ValueKind::point;
      if (!listed || !trace.is_input(v)) continue;
      ++count;
      given += "<li>" + math_html(typeset_name(name, *run.algorithm)) + " = " +
               math_html(narrator.value_text(v), *run.algorithm) + "</li>\n";
    }
    if (!given.empty())
      out_ += "<details class=\"given\"><summary>" + std::string(title) + "</summary>\n<ul>\n" + given +
              "</ul></details>\n";
  }

  void lateness(const ExerciseResult& made, const Assignment::Item& item) {
    if (made.submitted)
      out_ += "<p class=\"note\">Handed in " + time_in_words(*made.submitted, result_.assignment->offset) + ".</p>\n";
    if (made.days_late <= 0 || !made.grade) return;
    out_ +=
        "<p class=\"notice\">" + std::to_string(made.days_late) + (made.days_late == 1 ? " day" : " days") + " late";
    if (exercise_->max_points != Exact(0)) {
      const Exact before = made.grade->points * item.points / exercise_->max_points;
      const Exact lost = before - made.points;
      if (Exact(0) < lost) out_ += ": " + number_text(made.points) + " of the " + number_text(before) + " points count";
    }
    out_ += ".</p>\n";
  }

  void graded(const ExerciseResult& made, const StudentRun& run) {
    const Grade& grade = *made.grade;
    if (!grade.reason.empty()) {
      const bool is_said = std::ranges::any_of(result_.incidents, [&](const Incident& incident) {
        return incident.kind == Incident::Kind::unreadable && incident.exercise == exercise_->id &&
               incident.text == grade.reason;
      });
      if (is_said) return;
      out_ += "<p class=\"notice\">This could not be graded: " + html_escape(as_sentence(grade.reason)) + "</p>\n";
      return;
    }
    if (exercise_->feedback == Feedback::none) {
      out_ += "<p class=\"note\">The answers will be discussed later.</p>\n";
      return;
    }
    explanation(grade);
    parts(grade, run);
    if (exercise_->max_points != made.max_points && exercise_->max_points != Exact(0)) {
      const Exact here = grade.points * made.max_points / exercise_->max_points;
      out_ += "<p class=\"note\">Together " + number_text(grade.points) + " of " + number_text(exercise_->max_points) +
              ", which is " + number_text(here) + " of " + number_text(made.max_points) + " points here.</p>\n";
    }
    for (const std::string& note : grade.notes)
      out_ += "<p class=\"notice\">" + html_escape(as_sentence(note)) + "</p>\n";
  }

  void explanation(const Grade& grade) {
    if (exercise_->feedback < Feedback::hint || !grade.explanation) return;
    const Explanation& all = *grade.explanation;
    if (all.wrong < 2) return;  // the part itself says it
    out_ += "<p class=\"explanation\">";
    const auto values = [](std::size_t n) { return std::to_string(n) + (n == 1 ? " value" : " values"); };
    if (all.misconceptions.empty()) {
      out_ += "No single mistake explains the " + values(all.wrong) + " that went wrong: look at each of them.";
    } else {
      if (all.covered == all.wrong)
        out_ += "All " + values(all.wrong) + " that went wrong come from ";
      else
        out_ += std::to_string(all.covered) + " of the " + values(all.wrong) + " that went wrong " +
                (all.covered == 1 ? "comes from " : "come from ");
      out_ += all.misconceptions.size() == 1 ? "one mistake: " : "two mistakes: ";
      for (std::size_t i = 0; i < all.misconceptions.size(); ++i)
        out_ += (i > 0 ? ", and " : "") + ("<strong>" + math(all.misconceptions[i]->title) + "</strong>");
      out_ += ".";
    }
    out_ += "</p>\n";
  }

  void parts(const Grade& grade, const StudentRun& run) {
    if (exercise_->is_sheet()) return questions(grade, run);
    std::vector<std::size_t> all(grade.parts.size());
    std::iota(all.begin(), all.end(), 0);
    table(grade, run, all, *exercise_->run.algorithm);
    if (std::ranges::count(grade.parts, Verdict::carried, &PartGrade::verdict) > 0) note_on_carried();
  }

  // Of a lesson: those of each scene with its numbers.
  void questions(const Grade& grade, const StudentRun& run) {
    std::vector<std::vector<std::size_t>> asked(exercise_->scenes.size());
    for (std::size_t i = 0; i < grade.parts.size(); ++i) asked[exercise_->parts[i].question->scene].push_back(i);
    for (std::size_t s = 0; s < asked.size(); ++s) {
      const Exercise& scene = exercise_->scenes[s];
      if (asked[s].empty()) continue;
      if (asked.size() > 1) out_ += "<h3>" + html_escape(scene.title) + "</h3>\n";
      numbers_of(scene.run, "The numbers of these questions");
      table(grade, run, asked[s], *scene.run.algorithm);
    }
    if (std::ranges::count(grade.parts, Verdict::carried, &PartGrade::verdict) > 0) note_on_carried();
  }

  void note_on_carried() {
    out_ += "<p class=\"note\">Carried over: the right rule, on a value of yours that was wrong before.</p>\n";
  }

  void table(const Grade& grade, const StudentRun& run, const std::vector<std::size_t>& which,
             const Algorithm& algorithm) {
    const bool asks = exercise_->is_sheet(), advises = exercise_->feedback >= Feedback::hint;
    out_ += "<div class=\"scroll\"><table class=\"parts" + std::string(asks ? " questions" : "") +
            "\">\n<thead><tr><th scope=\"col\">" + (asks ? "Question" : "Value") +
            "</th><th scope=\"col\">Your answer</th><th scope=\"col\">Verdict</th><th scope=\"col\">Points</th>";
    if (advises && !asks) out_ += "<th scope=\"col\">What to know</th>";
    out_ += "</tr></thead>\n<tbody>\n";
    std::vector<std::string_view> said;
    for (const std::size_t i : which) {
      const Part& part = exercise_->parts[i];
      const PartGrade& graded = grade.parts[i];
      const Json* typed = run.typed()[i];
      out_ += "<tr><th scope=\"row\">" + (asks ? question(*part.question, typed, algorithm) : math(part.name)) +
              "</th><td data-label=\"Your answer\" class=\"typed\">" +
              (typed == nullptr ? "–" : html_escape(typed_text(*typed))) + "</td><td data-label=\"Verdict\">" +
              sign_html(sign_of(standing_of(graded.verdict))) + "</td><td data-label=\"Points\" class=\"number\">" +
              number_text(graded.points) + " / " + number_text(part.points) + "</td>";
      if (advises) {
        const bool nothing = graded.verdict == Verdict::correct || graded.feedback.empty();
        const std::string advice = nothing ? std::string() : math_html(feedback(graded, said), algorithm);
        // Below a question there is more room than beside it.
        if (!asks)
          out_ += std::string("<td class=\"advice") + (nothing ? " none" : "") + "\">" + advice + "</td>";
        else if (!nothing)
          out_ += "</tr>\n<tr class=\"more\"><td class=\"advice\" colspan=\"4\">" + advice + "</td>";
      }
      out_ += "</tr>\n";
    }
    out_ += "</tbody></table></div>\n";
  }

  // What was asked; of what there was to choose from or to put in order, what was taken and, where it is told, what is
  // right.
  std::string question(const Question& asked, const Json* typed, const Algorithm& algorithm) const {
    std::string text = "<div class=\"ask\">" + prose_html(read_prose(asked.ask), algorithm) + "</div>";
    if (asked.options.empty()) return text;
    const bool is_line = asked.kind == Checkpoint::Kind::line, is_order = asked.kind == Checkpoint::Kind::order;
    const bool tells = exercise_->feedback == Feedback::full;
    const LetterMark mark = typed != nullptr ? mark_letters(asked, *typed) : LetterMark{};
    text += is_line ? "<ol class=\"options code\">" : "<ol class=\"options\" type=\"a\">";
    for (std::size_t i = 0; i < asked.options.size(); ++i) {
      const std::string name = is_line ? std::to_string(i + 1) : letter_of(i);
      const bool taken = !is_order && mark.verdict != Verdict::invalid && mark.choice == i;
      const bool right = !is_order && (tells || (taken && mark.verdict == Verdict::correct)) && name == asked.right;
      text += "<li>" + (is_line ? "<code>" + html_escape(asked.options[i]) + "</code>"
                                : prose_html(read_prose(asked.options[i]), algorithm));
      if (taken)
        text += " " + sign_html({right ? "right" : "wrong", right ? "✓" : "✗", right ? "Right, yours" : "Yours"});
      if (right && !taken) text += " " + sign_html({"right", "✓", "Right"});
      if (is_order && tells)
        text += " <span class=\"quiet\">place " + std::to_string(asked.right.find(name) + 1) + "</span>";
      text += "</li>";
    }
    return text + "</ol>";
  }

  // Advice that was given already is only named.
  std::string feedback(const PartGrade& part, std::vector<std::string_view>& said) const {
    const Misconception* const m = find_misconception(*exercise_, part.misconception);
    if (m == nullptr) return part.feedback;
    if (std::ranges::find(said, part.misconception) == said.end()) {
      said.push_back(part.misconception);
      return part.feedback;
    }
    const std::string advice = advice_of(*m);
    if (!part.feedback.starts_with(advice)) return part.feedback;
    return "As above: " + std::string(m->title) + "." + part.feedback.substr(advice.size());
  }

  const StudentResult& result_;
  const Exercise* exercise_ = nullptr;
  std::string out_;
  bool any_run_ = false;
};

}  // namespace

std::string student_page(const StudentResult& result) { return StudentPage(result).write(); }

}  // namespace blossom
