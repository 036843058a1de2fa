#include "grader/page/run_html.hpp"

#include <map>
#include <set>

#include "grader/page/html.hpp"
#include "grader/page/picture.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_cells = 160;  // of a scheme that is drawn

class RunHtml {
 public:
  RunHtml(std::string& out, const StudentRun& run) : out_(out), run_(run) {}

  void write() {
    const auto [picture, alike] = picture_of(run_);
    const bool two = run_.tells_right() && run_.tells_own();
    out_ += "<section class=\"run\">\n<h3>";
    out_ += two                ? "Your run beside the right one"
            : run_.tells_own() ? "Your run, step by step"
                               : "The run, step by step";
    out_ += "</h3>\n";
    introduce(two);
    player(picture, two, alike);
    tableau();
    steps();
    if (!picture.empty())
      out_ += "<script type=\"application/json\" class=\"picture\">" + script_json(picture) + "</script>\n";
    out_ += "</section>\n";
  }

 private:
  std::string math(std::string_view text) const { return math_html(text, *run_.exercise().run.algorithm); }
  std::string math_at(std::string_view text, std::uint32_t step) const {
    return math_html(text, run_.narrator().algorithm_at(step));
  }

  void introduce(bool two) {
    if (two)
      out_ +=
          "<p class=\"note\">What you typed stands where you typed it; everything else follows from it by the right "
          "rule. So you see where your run departs from the right one, and how far that travels.</p>\n";
    else if (run_.tells_own())
      out_ +=
          "<p class=\"note\">Each step with the values that you typed, and the rule with your own numbers in it.</p>\n";
    // At a lower level what is not asked has nothing to tell, and is not missed.
    if (run_.left_out() > 0 && (run_.tells_right() || run_.steps().size() > 100))
      out_ += "<p class=\"note\">The whole run has " + std::to_string(run_.trace().step_count()) +
              " steps. Shown are the " + std::to_string(run_.steps().size()) +
              " that make the values asked for, and what they are made from.</p>\n";
  }

  void player(const std::string& picture, bool two, bool alike) {
    const std::string last = std::to_string(run_.steps().size());
    out_ += "<div class=\"player\" role=\"group\" aria-label=\"Step player\" tabindex=\"0\" hidden>\n";
    if (!picture.empty()) {
      out_ += "<div class=\"pictures\">\n";
      if (run_.tells_right()) figure("right", alike ? "Right, and yours" : two ? "Right" : "The run");
      if (run_.tells_own() && !alike) figure("own", "Yours");
      out_ += "</div>\n";
    }
    out_ += "<div class=\"bar\">\n";
    const auto button = [&](std::string_view action, std::string_view label, std::string_view path) {
      out_.append("<button type=\"button\" data-go=\"").append(action).append("\" aria-label=\"").append(label);
      out_.append("\" title=\"").append(label).append("\"><svg viewBox=\"0 0 16 16\" aria-hidden=\"true\"><path d=\"");
      out_.append(path).append("\"/></svg></button>\n");
    };
    button("first", "First step", "M3 3v10M13 3l-7 5 7 5z");
    button("back", "Previous step", "M11 3l-7 5 7 5z");
    button("next", "Next step", "M5 3l7 5-7 5z");
    button("last", "Last step", "M13 3v10M3 3l7 5-7 5z");
    out_ += "<input type=\"range\" min=\"1\" max=\"" + last + "\" value=\"1\" step=\"1\" aria-label=\"Step\">\n";
    out_ += "<output>1 of " + last + "</output>\n</div>\n";
    out_ += "<div class=\"told\" aria-live=\"polite\" aria-atomic=\"true\"></div>\n</div>\n";
    out_ +=
        "<noscript><p class=\"note\">The player and its pictures need JavaScript; the table below has every "
        "step.</p></noscript>\n";
  }

  void figure(std::string_view side, std::string_view caption) {
    out_.append("<figure><figcaption>").append(caption).append("</figcaption><svg class=\"picture\" data-side=\"");
    out_.append(side)
        .append("\" role=\"img\" aria-label=\"")
        .append(caption)
        .append(": picture of this step\"></svg></figure>\n");
  }

  // ---- the table of steps ----

  void steps() {
    out_ +=
        "<details class=\"all\" open>\n<summary>All steps as a table</summary>\n"
        "<div class=\"scroll\"><table class=\"steps\">\n<thead><tr><th scope=\"col\">Step</th><th scope=\"col\">What "
        "happens</th>";
    if (run_.tells_right()) out_ += "<th scope=\"col\">Right</th>";
    if (run_.tells_own()) out_ += "<th scope=\"col\">Yours</th>";
    out_ += "</tr></thead>\n<tbody>\n";
    for (std::size_t i = 0; i < run_.steps().size(); ++i) step(i, run_.steps()[i]);
    out_ += "</tbody></table></div>\n</details>\n";
  }

  void step(std::size_t i, std::uint32_t k) {
    const auto& trace = run_.trace();
    ValueId v = trace.introduced_by(k) == absent ? trace.main_value(k) : absent;
    if (v != absent && trace.is_input(v)) v = absent;
    out_ += "<tr><th scope=\"row\">" + std::to_string(i + 1) + "</th><td class=\"what\">";
    // What a step says has the right numbers in it.
    const std::string text = run_.tells_right() || k == 0 ? run_.narrator().text(k) : std::string();
    if (!text.empty()) out_ += "<p>" + math_at(text, k) + "</p>";
    if (v != absent && text.find(run_.narrator().formula(v)) == std::string::npos)
      out_ += "<p class=\"formula\">" + math_at(run_.narrator().own_name(v) + " = " + run_.narrator().formula(v), k) +
              "</p>";
    out_ += "</td>";
    if (run_.tells_right()) {
      out_ += "<td class=\"right\">";
      if (v != absent) made(k, run_.narrator().numbers(v), run_.right_text(v));
      out_ += "</td>";
    }
    if (run_.tells_own()) {
      out_ += "<td class=\"own " + std::string(v == absent ? "" : style(v)) + "\">";
      if (v != absent) own(v, k);
      out_ += "</td>";
    }
    out_ += "</tr>\n";
  }

  std::string_view style(ValueId v) const {
    return run_.standing(v) == Standing::made && run_.differs(v) ? "carried" : sign_of(run_.standing(v)).style;
  }

  void made(std::uint32_t k, const std::string& numbers, const std::string& value) {
    if (!numbers.empty() && numbers != value) out_ += "<p class=\"numbers\">" + math_at(numbers, k) + "</p>";
    if (!value.empty()) out_ += "<p class=\"value\"><span class=\"eq\">= </span>" + math_at(value, k) + "</p>";
  }

  void own(ValueId v, std::uint32_t k) {
    const std::string value = run_.own_text(v);
    const auto say = [&](std::string_view text) { out_.append("<p class=\"say\">").append(text).append("</p>"); };
    switch (run_.standing(v)) {
      case Standing::given:
        return;
      case Standing::made:
        if (!run_.tells_right()) {
          made(k, run_.own_numbers(v), {});
          return say("Not asked.");
        }
        if (value.empty()) return say("Your values leave nothing to compute here.");
        if (!run_.differs(v)) return made(k, {}, value), say("The same, not asked.");
        made(k, run_.own_numbers(v), value);
        return say("Not asked; this follows from your values.");
      case Standing::missing:
        if (run_.tells_right() && run_.differs(v) && !value.empty()) {
          say(sign_html(sign_of(Standing::missing)));
          made(k, run_.own_numbers(v), value);
          return say("This would follow from your values.");
        }
        if (!run_.tells_right()) made(k, run_.own_numbers(v), {});
        return say(sign_html(sign_of(Standing::missing)));
      case Standing::wrong:
        if (!run_.expected_text(v).empty()) {
          made(k, run_.own_numbers(v), {});
          out_ +=
              "<p class=\"numbers\">= " + math_at(run_.expected_text(v), k) + " from your values, but you typed</p>";
        } else {
          made(k, run_.tells_right() ? std::string() : run_.own_numbers(v), {});
        }
        break;
      case Standing::right:
        made(k, run_.tells_right() ? std::string() : run_.own_numbers(v), {});
        break;
      case Standing::carried:
        made(k, run_.own_numbers(v), {});
        break;
      case Standing::unreadable:
        break;
    }
    out_ += "<p class=\"value typed\">";
    append_html(out_, value);
    out_ += " " + sign_html(sign_of(run_.standing(v))) + "</p>";
  }

  // ---- the triangular scheme ----

  void tableau() {
    const auto& trace = run_.trace();
    std::set<ValueId> wanted;
    for (const std::uint32_t k : run_.steps()) {
      const ValueId v = trace.main_value(k);
      if (v == absent || trace.is_input(v) || !in_scheme(v)) continue;
      wanted.insert(v);
      for (const ValueId o : trace.operands(v))
        if (in_scheme(o)) wanted.insert(o);
    }
    if (wanted.empty() || wanted.size() > most_cells) return;
    std::map<int, std::map<int, ValueId>> rows;
    int columns = 0;
    for (const ValueId v : wanted) {
      const Name& name = trace.value(v).name;
      const int column = name.arity == 2 ? name.index[0] : 0;
      rows[name.index[name.arity - 1]][column] = v;
      columns = std::max(columns, column + 1);
    }
    out_ +=
        "<h4>Triangular scheme</h4>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Triangular "
        "scheme\"><table class=\"scheme\">\n<thead><tr>";
    for (int column = 0; column < columns; ++column)
      out_ +=
          column == 0 ? "<th scope=\"col\">Given</th>" : "<th scope=\"col\">Level " + std::to_string(column) + "</th>";
    out_ += "</tr></thead>\n<tbody>\n";
    for (const auto& [index, row] : rows) {
      out_ += "<tr>";
      for (int column = 0; column < columns; ++column) {
        const auto at = row.find(column);
        if (at == row.end())
          out_ += "<td class=\"none\"></td>";
        else
          cell(at->second);
      }
      out_ += "</tr>\n";
    }
    out_ += "</tbody></table></div>\n";
  }

  bool in_scheme(ValueId v) const {
    const auto& trace = run_.trace();
    const ValueSpec* spec = run_.exercise().run.algorithm->spec(trace.value(v).name);
    return spec != nullptr && spec->tableau && trace.value(v).name.arity > 0 && trace.scope(v).empty();
  }

  void cell(ValueId v) {
    const Standing standing = run_.standing(v);
    const bool compares = run_.tells_own();
    out_ += "<td data-v=\"" + std::to_string(v) + "\" class=\"" + std::string(compares ? style(v) : "made") + "\">";
    out_ += "<span class=\"name\">" +
            math_html(typeset_name(run_.trace().value(v).name, *run_.exercise().run.algorithm)) + "</span> ";
    const std::string right = run_.tells_right() || standing == Standing::given ? run_.right_text(v) : "";
    const std::string own = compares && standing != Standing::given ? run_.own_text(v) : right;
    out_ += "<span class=\"value\">" + (own.empty() ? std::string("–") : math(own)) + "</span>";
    if (!compares || standing == Standing::given) {
      out_ += "</td>";
      return;
    }
    if (standing != Standing::made)
      out_ += sign_html(sign_of(standing));
    else if (!run_.tells_right())
      out_ += "<span class=\"quiet\">not asked</span>";
    else if (run_.differs(v))
      out_ += sign_html({"carried", "↪", "Follows"});
    if (run_.tells_right() && run_.differs(v)) out_ += "<span class=\"quiet\">right: " + math(right) + "</span>";
    out_ += "</td>";
  }

  std::string& out_;
  const StudentRun& run_;
};

}  // namespace

Sign sign_of(Verdict verdict) {
  if (verdict == Verdict::misconception) return {"wrong", "✗", "Misconception"};
  if (verdict == Verdict::slip) return {"wrong", "✗", "Slip"};
  return sign_of(standing_of(verdict));
}

Sign sign_of(Standing standing) {
  switch (standing) {
    case Standing::right:
      return {"right", "✓", "Correct"};
    case Standing::carried:
      return {"carried", "↪", "Carried over"};
    case Standing::wrong:
      return {"wrong", "✗", "Wrong"};
    case Standing::missing:
      return {"missing", "○", "No answer"};
    case Standing::unreadable:
      return {"wrong", "!", "Unreadable"};
    case Standing::given:
      return {"given", "", "Given"};
    case Standing::made:
      break;
  }
  return {"made", "", ""};
}

std::string sign_html(const Sign& sign) {
  return "<span class=\"sign " + std::string(sign.style) + "\"><span aria-hidden=\"true\">" + std::string(sign.symbol) +
         "</span> " + std::string(sign.word) + "</span>";
}

void append_run(std::string& out, const StudentRun& run) { RunHtml(out, run).write(); }

}  // namespace blossom
