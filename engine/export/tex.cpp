// A LaTeX document: each step with its picture in TikZ, its words, its formula, and the scheme as far as it is filled.
// It needs what texlive-latex-base and texlive-pictures have, and uses better fonts where they are.

#include <algorithm>
#include <cctype>

#include "algorithms/typeset.hpp"
#include "base/json.hpp"
#include "export/export.hpp"
#include "export/latex_text.hpp"
#include "export/page_words.hpp"
#include "export/paper_view.hpp"
#include "export/tikz_canvas.hpp"
#include "render/painter.hpp"
#include "scene/panels.hpp"
#include "scene/scheme.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

constexpr double picture_width = 560, picture_height = 300, points_per_unit = 0.58;
// In points: fonts come in whole ones.
constexpr LetterSizes letters{6.6 / points_per_unit, 8.6 / points_per_unit};
// Larger schemes would be too small to read on a page.
constexpr int most_columns = 7;
constexpr double most_rows = 24;

constexpr std::string_view packages = R"(\documentclass[10pt,a4paper]{article}
\IfFileExists{lmodern.sty}{\usepackage{lmodern}\usepackage[T1]{fontenc}}{%
  \DeclareTextCommandDefault{\textquotedbl}{''}}
\usepackage[utf8]{inputenc}
\usepackage[margin=2cm]{geometry}
\usepackage{amsmath}
\usepackage{tikz}
\usepackage[hidelinks]{hyperref}
)";

constexpr std::string_view commands = R"(% A step: its heading, its phase, its picture.
\newsavebox{\blossombox}
\newcommand{\blossomstep}[2]{\par\addvspace{18pt plus 6pt}\penalty-200
  \noindent\begin{minipage}{\textwidth}{\large\bfseries #1}\hfill
  \parbox[t]{0.78\textwidth}{\raggedleft\small\itshape #2}\par\smallskip
  \centering\usebox{\blossombox}\end{minipage}\par\nobreak\smallskip\noindent\ignorespaces}
% A scheme in the middle of a line, smaller where it is too wide or too high.
\newcommand{\blossomscheme}[1]{\par\nobreak\medskip\sbox{\blossombox}{\def\arraystretch{1.25}$\displaystyle #1$}%
  \ifdim\wd\blossombox>\textwidth\sbox{\blossombox}{\resizebox{\textwidth}{!}{\usebox{\blossombox}}}\fi
  \ifdim\dimexpr\ht\blossombox+\dp\blossombox\relax>0.6\textheight
    \sbox{\blossombox}{\resizebox{!}{0.6\textheight}{\usebox{\blossombox}}}\fi
  \noindent\hfil\usebox{\blossombox}\par\medskip}
% The line of the code, and the formula, which stay with the step.
\newcommand{\blossomline}[2]{\par\nobreak\smallskip{\small\raggedright #1:\enspace\texttt{#2}\par}\nobreak}
\newcommand{\blossomformula}[1]{\par\nobreak{\raggedright$#1$\par}}
% A question, which no page cuts, with room for its answer; and what stands behind one whose answer the next step tells.
\newenvironment{blossomquestion}[1]{\par\addvspace{10pt}\noindent
  \begin{minipage}{\textwidth}\setlength{\parskip}{4pt plus 2pt}\textbf{#1.} \ignorespaces}{\end{minipage}\par}
\newcommand{\blossomanswer}[1]{\par\medskip #1: \hrulefill\par}
\newcommand{\blossomturn}{\clearpage}
\makeatletter
\def\@listi{\leftmargin\leftmargini\topsep=2pt\parsep=1pt\itemsep=1pt}
\let\@listI\@listi\@listi
\makeatother
\setlength{\parindent}{0pt}
\frenchspacing
\setlength{\parskip}{4pt plus 2pt}
\emergencystretch=3em
% A page ends between two steps, and within one only where it is longer than a page.
\raggedbottom\interlinepenalty=5000
)";

// Text between the names of a formula; blanks before words are kept.
std::string tex_between(std::string_view text) {
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  std::string tex;
  std::size_t from = 0;
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    if (text[i] != ' ' || !is_letter(text[i + 1]) || (i > 0 && is_letter(text[i - 1]))) continue;
    tex += tex_value(text.substr(from, i - from)) + "\\ ";
    from = i + 1;
  }
  return tex + tex_value(text.substr(from));
}

// A formula as text has it, "(1 - u) P[0][1] + u P[0][2]", in TeX: names as they are typeset, numbers as fractions.
std::string tex_formula(const std::string& formula, const Algorithm& algorithm) {
  const RichText runs = typeset_text(formula, algorithm);
  std::string tex;
  for (std::size_t i = 0; i < runs.size();) {
    std::size_t end = i + 1;
    while (end < runs.size() && runs[end].level != TextRun::Level::base) ++end;
    if (!runs[i].italic && end == i + 1) {
      tex += tex_between(runs[i++].text);
      continue;
    }
    // Of words, the last one has the scripts.
    RichText name(runs.begin() + static_cast<std::ptrdiff_t>(i), runs.begin() + static_cast<std::ptrdiff_t>(end));
    if (const auto blank = name[0].text.find_last_of(" (,"); blank != std::string::npos && !name[0].italic) {
      tex += tex_between(std::string_view(name[0].text).substr(0, blank + 1));
      name[0].text.erase(0, blank + 1);
    }
    tex += tex_name(name) + " ";
    i = end;
  }
  return tex;
}

class Document {
 public:
  Document(const Story& story, const LessonExportOptions& options, std::shared_ptr<const Fonts> fonts)
      : story_(story),
        options_(options),
        fonts_(fonts),
        words_(story.language),
        canvas_(std::move(fonts), points_per_unit) {}

  // The file, or nothing if it was stopped.
  std::optional<std::string> write() {
    add_head();
    std::size_t done = 0;
    for (const StoryScene& scene : story_.scenes) {
      if (!scene.heading.empty()) body_ += "\\section*{" + latex_text(scene.heading) + "}\n";
      add_code(scene.recording->algorithm());
      last_scheme_.clear();
      for (const StoryStep& told : scene.steps) {
        add_step(scene, told);
        if (!report_progress(options_, ++done, story_.step_count())) return std::nullopt;
      }
    }
    if (!story_.exercises.empty()) {
      body_ += "\\section*{" + word("practise") + "}\n\\begin{itemize}\n";
      for (const StoryLink& link : story_.exercises) body_ += "\\item {}" + latex_text(link.words()) + "\n";
      body_ += "\\end{itemize}\n";
    }
    if (options_.checkpoints) add_answers();
    return std::string(packages) + TikzCanvas::preamble(canvas_.colors()) + unicode_declarations(body_) +
           std::string(commands) + "\\hypersetup{pdftitle={" + latex_text(story_.title) + "}}\n\\begin{document}\n" +
           body_ + "\\end{document}\n";
  }

 private:
  std::string words(const Prose& prose, const Algorithm& algorithm) const { return prose_latex(prose, algorithm); }
  std::string word(std::string_view key) const { return latex_text(words_(key)); }
  std::string word(std::string_view key, std::uint32_t n) const { return latex_text(words_(key, std::to_string(n))); }

  void add_head() {
    const Algorithm& algorithm = story_.scenes.front().recording->algorithm();
    if (!story_.unit.empty()) body_ += "{\\small " + latex_text(story_.unit) + "}\\par\n";
    body_ += "{\\LARGE\\bfseries\\raggedright " + latex_text(story_.title) + "\\par}\\medskip\n";
    if (!story_.summary.empty()) body_ += words(read_prose(story_.summary), algorithm) + "\\par\n";
    if (story_.minutes > 0)
      body_ +=
          "\\textbf{" + word("time") + ":} " + word("duration", static_cast<std::uint32_t>(story_.minutes)) + "\\par\n";
    if (!story_.objectives.empty()) {
      body_ += "\\textbf{" + word("objectives") + "}\n\\begin{itemize}\n";
      for (const auto& objective : story_.objectives)
        body_ += "\\item {}" + words(read_prose(objective), algorithm) + "\n";
      body_ += "\\end{itemize}\n";
    }
    std::string before;
    for (const StoryLink& link : story_.prerequisites) before += (before.empty() ? "" : "; ") + link.words();
    if (!before.empty()) body_ += "\\textbf{" + word("before") + ":} " + latex_text(before) + "\\par\n";
    if (!story_.source.empty()) body_ += "\\textbf{" + word("source") + ":} " + latex_text(story_.source) + "\\par\n";
    body_ += "\\medskip\\hrule\n";
  }

  void add_code(const Algorithm& algorithm) {
    body_ += "\\begin{list}{}{\\setlength{\\itemsep}{0pt}\\setlength{\\parsep}{0pt}}\\small\\ttfamily\\raggedright\n";
    int number = 0;
    for (const std::string_view line : algorithm.pseudo_code) {
      const std::size_t blanks = std::min(line.find_first_not_of(' '), line.size());
      body_ += "\\item[" + std::to_string(++number) + "] \\hspace*{" + std::to_string(blanks) + "ex}" +
               latex_text(line.substr(blanks)) + "\n";
    }
    body_ += "\\end{list}\n";
  }

  void add_step(const StoryScene& scene, const StoryStep& told) {
    const StepSource& source = scene.source();
    const Algorithm& algorithm = source.algorithm_at(told.step);
    if (turn_) body_ += "\n\\blossomturn\n";
    turn_ = false;
    const Scene picture = picture_with_knots(scene, told.step, picture_width, picture_height, *options_.theme, letters);
    paint(picture, *options_.theme, *fonts_, canvas_, 1);
    body_ += "\n\\sbox{\\blossombox}{%\n" + canvas_.picture() + "}%\n\\blossomstep{" + word("stepname", told.step) +
             "}{" + latex_text(told.phase) + "}\n" + words(told.prose, algorithm);
    const auto& code = algorithm.pseudo_code;
    if (told.line > 0 && static_cast<std::size_t>(told.line) <= code.size()) {
      const std::string_view line = code[static_cast<std::size_t>(told.line) - 1];
      body_ += "\\blossomline{" + word("line", static_cast<std::uint32_t>(told.line)) + "}{" +
               latex_text(line.substr(std::min(line.find_first_not_of(' '), line.size()))) + "}\n";
    }
    add_formula(source, told.step, algorithm);
    // A question stands with its step; the scheme, which the next one shows, would drive it to the next page.
    if (options_.checkpoints && told.question)
      add_question(*told.question, algorithm);
    else
      add_scheme(source, told.step);
  }

  void add_formula(const StepSource& source, std::uint32_t step, const Algorithm& algorithm) {
    const ValueId v = source.graph->main_value(step);
    if (v == absent || source.graph->is_input(v)) return;
    const std::string formula = source.formula(v), numbers = source.numbers(v), value = source.value_text(v);
    constexpr std::size_t most = 400;  // a knot vector of hundreds of knots is not for a line
    const std::string own = source.own_name(v);
    std::string tex = own.find('.') == std::string::npos
                          ? tex_name(typeset_name(source.graph->value(v).name, algorithm))
                          : tex_formula(own, algorithm);
    if (formula.size() < most) tex += " = " + tex_formula(formula, algorithm);
    if (numbers != formula && numbers != value && numbers.size() < most) tex += " = " + tex_formula(numbers, algorithm);
    if (value.size() < most && value != formula) tex += " = " + tex_value(value);
    body_ += "\\blossomformula{" + tex + "}\n";
  }

  // Only where it has grown.
  void add_scheme(const StepSource& source, std::uint32_t step) {
    const Scheme* scheme = source.graph->main_value(step) == absent ? nullptr : scheme_at(source, step);
    if (scheme == nullptr || scheme->column_count() > most_columns || scheme->rows > most_rows) return;
    std::string tableau = latex_tableau(source, step);
    if (tableau == last_scheme_) return;
    body_ += "\\blossomscheme{" + tableau + "}\n";
    last_scheme_ = std::move(tableau);
  }

  void add_question(const StoryStep::Question& question, const Algorithm& algorithm) {
    using Kind = Checkpoint::Kind;
    body_ += "\\begin{blossomquestion}{" + word("question") + "}" + words(question.ask, algorithm) + "\n";
    if (!question.options.empty()) {
      body_ += "\\begin{itemize}\n";
      for (std::size_t i = 0; i < question.options.size(); ++i)
        body_ += "\\item[" + letter_of(i) + "] {}" + words(question.options[i], algorithm) + "\n";
      body_ += "\\end{itemize}\n";
    }
    const Kind kind = question.checkpoint->kind;
    if (kind != Kind::choice) body_ += "\\blossomanswer{" + word(asked_word(kind)) + "}\n";
    body_ += "\\end{blossomquestion}\n";
    turn_ = kind != Kind::choice && kind != Kind::order;
  }

  void add_answers() {
    std::string answers;
    for (const StoryScene& scene : story_.scenes) {
      for (const StoryStep& told : scene.steps) {
        if (!told.question) continue;
        const StoryStep::Question& question = *told.question;
        const Algorithm& algorithm = scene.source().algorithm_at(told.step);
        answers += "\\item[" + word("stepname", told.step) + "] " +
                   (scene.heading.empty() ? "" : "\\emph{" + latex_text(scene.heading) + ".} ") + "\\textbf{" +
                   latex_text(question.answer) + "}\n";
        if (const auto at = right_option(question)) answers += " " + words(question.options[*at], algorithm) + "\n";
        if (!question.right.empty()) answers += "\\par " + words(question.right, algorithm) + "\n";
      }
    }
    if (!answers.empty())
      body_ +=
          "\\clearpage\n\\section*{" + word("answers") + "}\n\\begin{description}\n" + answers + "\\end{description}\n";
  }

  const Story& story_;
  const LessonExportOptions& options_;
  std::shared_ptr<const Fonts> fonts_;
  PageWords words_;
  TikzCanvas canvas_;
  std::string body_, last_scheme_;
  bool turn_ = false;  // the next step tells what was asked
};

Checked<LessonExported> write(const Story& story, const fs::path& out, const LessonExportOptions& options) {
  const auto fonts = Fonts::load();
  if (!fonts) return fonts.diagnostics;
  const auto text = Document(story, options, *fonts).write();
  if (!text) return stopped();
  if (const auto saved = write_file(out, *text); !saved) return saved.diagnostics;
  return LessonExported{{out}, {}};
}

}  // namespace

const LessonFormat& lesson_tex() {
  static const LessonFormat format{"tex", "LaTeX", ".tex", false, "a document with TikZ pictures, formulas and schemes",
                                   write};
  return format;
}

}  // namespace blossom
