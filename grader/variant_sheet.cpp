#include "grader/variant_sheet.hpp"

#include <algorithm>

#include "grader/page/assets.hpp"
#include "grader/page/html.hpp"
#include "grader/page/student_page.hpp"
#include "lesson/prose.hpp"

namespace blossom {
namespace {

constexpr std::string_view coordinates[] = {"x", "y", "z"};

std::string element(std::string_view tag, std::string_view text) {
  return "<" + std::string(tag) + ">" + html_escape(text) + "</" + std::string(tag.substr(0, tag.find(' '))) + ">";
}

// A text in which names of values and points do not break in the middle: P[1][0], (3, 4).
std::string with_names(std::string_view text) {
  constexpr std::size_t longest_point = 24;
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = std::min(text.find_first_of(" \n(", i + 1), text.size());
    bool is_whole = text.substr(i, end - i).find('[') != std::string_view::npos;
    if (text[i] == '(') {
      const std::size_t close = text.find(')', i);
      is_whole = close != std::string_view::npos && close - i < longest_point;
      if (is_whole) end = close + 1;
    }
    const std::string piece = html_escape(text.substr(i, end - i));
    out += is_whole ? "<span class=\"whole\">" + piece + "</span>" : piece;
    i = end;
  }
  return out;
}

std::string subscript(std::string_view symbol, std::size_t i) {
  return "<i>" + std::string(symbol) + "</i><sub>" + std::to_string(i) + "</sub>";
}

// A table of columns under their headings, so many side by side as fit on paper.
struct Columns {
  std::vector<std::string> heads;              // HTML
  std::vector<std::string> row_heads;          // HTML
  std::vector<std::vector<std::string>> rows;  // text
};
std::string table_of(const Columns& columns, const std::string& caption) {
  constexpr std::size_t line = 64;  // characters
  std::string out;
  for (std::size_t first = 0, end = 0; first < columns.heads.size(); first = end) {
    for (std::size_t taken = 0; end < columns.heads.size() && (end == first || taken <= line); ++end) {
      std::size_t widest = 2;
      for (const auto& row : columns.rows) widest = std::max(widest, row[end].size());
      taken += widest + 3;
    }
    out += "<table>";
    if (!caption.empty()) out += element("caption", first == 0 ? caption : "(continued)");
    out += "<thead><tr><td></td>";
    for (std::size_t i = first; i < end; ++i) out += "<th scope=\"col\">" + columns.heads[i] + "</th>";
    out += "</tr></thead><tbody>";
    for (std::size_t r = 0; r < columns.rows.size(); ++r) {
      out += "<tr><th scope=\"row\">" + columns.row_heads[r] + "</th>";
      for (std::size_t i = first; i < end; ++i) out += element("td", columns.rows[r][i]);
      out += "</tr>";
    }
    out += "</tbody></table>\n";
  }
  return out;
}

// Points as they are given: their coordinates, and their weights where there are some. A point of weight 0 has none.
std::string points_table(std::span<const HPoint<Exact>> points, int dimension, bool rational,
                         const std::vector<std::string>& heads, const std::string& caption) {
  Columns columns{heads, {}, {}};
  const auto numbers = [&](const HPoint<Exact>& P) { return std::array<Exact, 3>{P.x, P.y, P.z}; };
  for (int c = 0; c < dimension; ++c) {
    columns.row_heads.push_back("<i>" + std::string(coordinates[c]) + "</i>");
    auto& row = columns.rows.emplace_back();
    for (const auto& P : points)
      row.push_back(P.w == Exact(0) ? "–" : format_number(numbers(P)[static_cast<std::size_t>(c)] / P.w));
  }
  if (rational) {
    columns.row_heads.emplace_back("weight");
    auto& row = columns.rows.emplace_back();
    for (const auto& P : points) row.push_back(format_number(P.w));
  }
  return table_of(columns, caption);
}

std::string knots_table(const std::vector<Exact>& knots, std::string_view symbol, const std::string& caption) {
  Columns columns;
  columns.row_heads = {"knot"};
  columns.rows.emplace_back();
  for (std::size_t i = 0; i < knots.size(); ++i) {
    columns.heads.push_back(subscript(symbol, i));
    columns.rows[0].push_back(format_number(knots[i]));
  }
  return table_of(columns, caption);
}

std::string of_curve(const Curve<Exact>& curve, const std::string& which) {
  std::vector<std::string> heads;
  for (std::size_t i = 0; i < curve.points.size(); ++i) heads.push_back(subscript("P", i));
  const std::string degree = "degree " + std::to_string(curve.degree);
  std::string out = points_table(curve.points, curve.dimension, curve.rational, heads,
                                 "Control points" + which + " (" + degree + ")");
  if (!curve.bezier) out += knots_table(curve.knots, "u", "Knots" + which);
  return out;
}

std::string of_surface(const Surface<Exact>& surface) {
  std::vector<std::string> heads;
  for (int i = 0; i < surface.rows; ++i)
    for (int j = 0; j < surface.columns; ++j)
      heads.push_back("<i>P</i><sub>" + std::to_string(i) + "," + std::to_string(j) + "</sub>");
  std::string out = points_table(surface.points, 3, surface.rational, heads,
                                 "Control points (degrees " + std::to_string(surface.degree[0]) + " and " +
                                     std::to_string(surface.degree[1]) + ")");
  if (!surface.bezier)
    for (std::size_t d = 0; d < 2; ++d)
      out += d == 0 ? knots_table(surface.knots[d], "u", "Knots along u")
                    : knots_table(surface.knots[d], "v", "Knots along v");
  return out;
}

// "(0, 2), (3, 4)": points without weights.
std::string in_a_row(std::span<const HPoint<Exact>> points, int dimension) {
  std::string out;
  for (const auto& P : points) {
    std::string text = "(" + format_number(P.x) + ", " + format_number(P.y);
    if (dimension == 3) text += ", " + format_number(P.z);
    if (!out.empty()) out += ", ";
    out += "<span class=\"whole\">" + html_escape(text + ")") + "</span>";
  }
  return out;
}

// The rows of a net, each on a line of its own where it is not too long.
std::string in_rows(const PointNet<Exact>& net) {
  constexpr int most_on_line = 5;
  const std::span<const HPoint<Exact>> points(net.points);
  const auto columns = static_cast<std::size_t>(net.columns);
  std::string out;
  for (std::size_t first = 0; first < points.size(); first += columns)
    out += "<div" + std::string(net.columns <= most_on_line ? " class=\"whole\">" : ">") +
           in_a_row(points.subspan(first, columns), 3) + "</div>";
  return out;
}

// All inputs, in the algorithm's order: curves as tables, then the single numbers.
std::string given(const Run<Exact>& run) {
  std::string tables, numbers;
  for (const InputSpec& spec : run.algorithm->inputs) {
    const std::string name(spec.name);
    const auto row_of_html = [&](const std::string& value) {
      numbers += "<tr><th scope=\"row\"><i>" + html_escape(name) + "</i></th><td>" + value + "</td><td>" +
                 math_html(spec.description, *run.algorithm) + "</td></tr>";
    };
    const auto row = [&](const std::string& value) { row_of_html(value.empty() ? "none" : html_escape(value)); };
    switch (spec.type) {
      case InputSpec::Type::curve:
        tables += of_curve(run.inputs.curve(name), "");
        break;
      case InputSpec::Type::surface:
        tables += of_surface(run.inputs.surface(name));
        break;
      case InputSpec::Type::curves: {
        const auto& curves = run.inputs.curves(name);
        for (std::size_t i = 0; i < curves.size(); ++i)
          tables += of_curve(curves[i], " of " + name + "[" + std::to_string(i) + "]");
        break;
      }
      case InputSpec::Type::number:
        row(format_number(run.inputs.number(name)));
        break;
      case InputSpec::Type::integer:
        row(std::to_string(run.inputs.integer(name)));
        break;
      case InputSpec::Type::choice:
        row(run.inputs.choice(name));
        break;
      case InputSpec::Type::numbers: {
        std::string all;
        for (const Exact& number : run.inputs.numbers(name)) all += (all.empty() ? "" : ", ") + format_number(number);
        row(all);
        break;
      }
      case InputSpec::Type::points: {
        const auto& points = run.inputs.points(name);
        row_of_html(points.points.empty() ? "none" : in_a_row(points.points, points.dimension));
        break;
      }
      case InputSpec::Type::net:
        row_of_html(in_rows(run.inputs.net(name)));
        break;
    }
  }
  return tables + (numbers.empty() ? "" : "<table class=\"numbers\"><tbody>" + numbers + "</tbody></table>\n");
}

std::string how_exact(const Part& part) {
  const Tolerance& t = part.tolerance;
  if (part.kind == ValueKind::integer) return "a whole number";
  switch (t.kind) {
    case Tolerance::Kind::exact:
      return "exact: fractions are welcome";
    case Tolerance::Kind::decimals:
      return "to " + std::to_string(t.digits) + " decimals";
    case Tolerance::Kind::significant:
      return "to " + std::to_string(t.digits) + " significant digits";
    case Tolerance::Kind::absolute:
      return "off by at most " + format_number(t.amount.to_double());
    case Tolerance::Kind::relative:
      return "off by at most " + format_number((t.amount * Exact(100)).to_double()) + " %";
  }
  return "";
}

// A name that may go on in the next line behind its scope, and nowhere else: along_u.M[1][1].
std::string breakable(std::string_view name) {
  const std::size_t scope = name.rfind('.') + 1;
  if (scope == 0) return html_escape(name);
  return html_escape(name.substr(0, scope)) + "<wbr><span class=\"whole\">" + html_escape(name.substr(scope)) +
         "</span>";
}

// What is written into the boxes of a part.
std::vector<std::string> heads_of(const Part& part) {
  if (part.kind == ValueKind::list) return {part.as_set ? "all of them, in any order" : "all of them, in order"};
  if (part.form == Form::weight) return {"weight w"};
  if (part.is_single()) return {"value"};
  std::vector<std::string> heads;
  for (int c = 0; c < part.dimension; ++c)
    heads.push_back((part.form == Form::homogeneous ? "w " : "") + std::string(coordinates[c]));
  if (part.form == Form::homogeneous) heads.emplace_back("w");
  return heads;
}

// The symbol and what it stands for: "P[r][i]: the point i of level r".
std::string meaning_of(const Exercise& exercise, const Part& part) {
  const Name& name = exercise.run.trace.value(part.value).name;
  const ValueSpec* spec = exercise.run.algorithm->spec(name);
  if (spec == nullptr) return "";
  std::string text(spec->symbol);
  for (const auto index : spec->indices) text += "[" + std::string(index) + "]";
  return text + ": " + std::string(spec->meaning);
}

// Parts that make one table: of one kind and meaning, in a row.
std::string answers(const Exercise& exercise, bool solutions) {
  std::string out = "<div class=\"groups\">";
  const auto& parts = exercise.parts;
  for (std::size_t first = 0; first < parts.size();) {
    const auto heads = heads_of(parts[first]);
    const std::string meaning = meaning_of(exercise, parts[first]), exact = how_exact(parts[first]);
    std::size_t end = first + 1;
    while (end < parts.size() && heads_of(parts[end]) == heads && meaning_of(exercise, parts[end]) == meaning &&
           how_exact(parts[end]) == exact && parts[end].points == parts[first].points)
      ++end;
    out += parts[first].kind == ValueKind::list ? "<div class=\"list\">" : "<div>";
    out += "<p class=\"caption\">";
    if (!meaning.empty()) out += with_names(meaning) + "<br>";
    const std::string points =
        number_text(parts[first].points) + (parts[first].points == Exact(1) ? " point" : " points");
    out += "<span class=\"quiet\">" + html_escape(exact + "; " + points + (end - first > 1 ? " each" : "")) +
           "</span></p><table class=\"answers\"><thead><tr><th scope=\"col\">name</th>";
    for (const auto& head : heads) out += "<th scope=\"col\">" + html_escape(head) + "</th>";
    out += "</tr></thead><tbody>\n";
    for (; first < end; ++first) {
      const Part& part = parts[first];
      out += "<tr><th scope=\"row\"><code>" + breakable(part.name) + "</code></th>";
      for (std::size_t c = 0; c < heads.size(); ++c) {
        std::string text;
        if (solutions && part.kind == ValueKind::list)
          for (const Exact& x : part.right) text += (text.empty() ? "" : ", ") + format_number(x);
        else if (solutions)
          text = format_number(part.right[c]);
        out += element("td", text);
      }
      out += "</tr>\n";
    }
    out += "</tbody></table></div>\n";
  }
  return out + "</div>\n";
}

// "section 1", or what the course calls it if that is more than a number.
std::string section_text(const std::string& section) {
  const bool number = std::ranges::all_of(section, [](char c) { return '0' <= c && c <= '9'; });
  return (number ? "section " : "") + html_escape(section);
}

// How a part's answer looks in a file.
std::string example_of(const Part& part) {
  if (part.kind == ValueKind::integer) return "3";
  if (part.is_single()) return "\"2/5\"";
  if (part.kind == ValueKind::list) return "[0, \"1/2\", 1]";
  std::string text = "[1, \"2/5\"";
  for (std::size_t i = 2; i < part.size(); ++i) text += i == 2 ? ", 0" : ", 1";
  return text + "]";
}

std::string room_and_way(const Exercise& exercise) {
  const Part& first = exercise.parts.front();
  const std::string file = "{\"schema\": \"blossom.answers/1\", \"exercise\": " + json_quote(exercise.id) +
                           ", \"answers\": {" + json_quote(first.name) + ": " + example_of(first) +
                           (exercise.parts.size() > 1 ? ", ..." : "") + "}}";
  return "<h2>Room to compute</h2>\n<div class=\"room\"></div>\n<p class=\"quiet\">To be handed in as a text file, "
         "whose "
         "name ends in .json: <code class=\"file\">" +
         html_escape(file) + "</code></p>\n";
}

std::string_view who_has_these(Sharing sharing) {
  switch (sharing) {
    case Sharing::nobody_else:
      return " Nobody else in your class has these numbers.";
    case Sharing::some:
      return " Others in your class have other numbers.";
    case Sharing::everybody:
      break;
  }
  return "";
}

}  // namespace

std::string sheet_head(std::string_view title) { return page_head(title, assets::sheet_css); }

std::string sheet_page(const Exercise& variant, const Student& student, bool solutions, Sharing sharing) {
  std::string out = "<section class=\"sheet\">\n<header><span class=\"name\">" +
                    html_escape(student.name.empty() ? student.id : student.name) + "</span><span>";
  if (!student.section.empty()) out += section_text(student.section) + " · ";
  out += "ID " + html_escape(student.id) + "</span></header>\n";
  out += element("h1", (solutions ? "Solutions: " : "") + variant.title);
  out += "\n<div class=\"prompt\">" + prose_html(read_prose(variant.prompt), *variant.run.algorithm) + "</div>\n";
  out += "<h2>Given</h2>\n<div class=\"given\">" + given(variant.run) + "</div>\n";
  out += "<h2>" + std::string(solutions ? "Right answers" : "Your answers") + "</h2>\n";
  out += answers(variant, solutions);
  if (!solutions) out += room_and_way(variant);
  out += "<p class=\"quiet\">Exercise <code>" + html_escape(variant.id) + "</code>, " +
         number_text(variant.max_points) + " points.";
  if (!solutions) out += who_has_these(sharing);
  out += "</p>\n</section>\n";
  return out;
}

std::string sheet_end() { return "</body>\n</html>\n"; }

}  // namespace blossom
