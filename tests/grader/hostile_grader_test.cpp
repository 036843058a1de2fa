// What a hostile submission may cost, in counted work and in bytes, and what of its text may reach a report: bounds
// that are the same on every machine.

#include "base/utf8.hpp"
#include "grader/report_helpers.hpp"

using namespace blossom;

namespace {

// Squared 64-bit words of exact arithmetic (see ExactBudget): 100 million are about a second.
constexpr std::uint64_t most_work = 20'000'000;
constexpr std::size_t most_bytes_for_a_part = 2048;  // of its feedback

std::string repeated(std::string_view text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

// Grades within the bounds, or fails.
Grade graded_within_bounds(const Grader& grader, const std::string& text) {
  const ExactBudget budget(most_work);
  Grade grade;
  REQUIRE_NOTHROW(grade = grade_text(grader, text));
  CHECK(grade.score() >= 0);
  CHECK(grade.score() <= 1);
  CHECK(grade.reason.size() <= 400);
  CHECK(grade.notes.size() <= 11);
  for (const std::string& note : grade.notes) CHECK(note.size() <= 400);
  for (const PartGrade& part : grade.parts) CHECK(part.feedback.size() <= most_bytes_for_a_part);
  std::string written;
  write_json(grade, written);
  CHECK(written.size() <= 20'000 + grade.parts.size() * (most_bytes_for_a_part + 400));
  return grade;
}

// The same literal for every number of every part.
std::string all_numbers(const Exercise& exercise, const std::string& literal) {
  std::map<std::string, std::string> other;
  for (const Part& part : exercise.parts) {
    std::string numbers = literal;
    for (std::size_t i = 1; i < part.right.size(); ++i) numbers += ", " + literal;
    other[part.name] = part.is_single() ? literal : "[" + numbers + "]";
  }
  return all_answers(exercise, other);
}

// A degree whose triangle has 25 levels: what grows from step to step grows longest here.
std::string long_triangle() {
  std::string points;
  for (int i = 0; i <= 25; ++i)
    points += (i > 0 ? ", [" : "[") + std::to_string(i) + ", " + std::to_string(i * i % 7) + "]";
  return R"({"curve": {"degree": 25, "points": [)" + points + R"(]}, "u": "3/7"})";
}

bool is_clean(std::string_view text, std::string& offending) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    const std::string_view character = text.substr(i, std::max<std::size_t>(length, 1));
    const auto byte = static_cast<unsigned char>(character[0]);
    const bool line_break = byte == '\n' || byte == '\r' || byte == '\t';
    const bool control = byte < 0x20 || byte == 0x7F || (byte == 0xC2 && length == 2 && (character[1] & 0xE0) == 0x80);
    if (length == 0 || (control && !line_break)) {
      offending = printable(text.substr(i - std::min<std::size_t>(i, 30), 60));
      return false;
    }
    i += length;
  }
  return true;
}

}  // namespace

TEST_CASE("numbers of 400 digits throughout cost a bounded amount of exact arithmetic", "[hostile]") {
  const std::vector<std::string> literals{
      "\"" + repeated("9", 400) + "\"",
      "\"" + repeated("7", 199) + "/" + repeated("3", 200) + "\"",
      "\"0." + repeated("142857", 66) + "\"",
      "\"1/" + repeated("9", 398) + "\"",
      "1e308",
      "1e-400",
      "\"123456789/987654321\"",  // short enough to be carried on exactly
      "\"1/99999999999999999\"",  // likewise
      "\"0.00000000000000001\"",
      "0." + repeated("0", 100) + "1",
  };
  std::vector<std::unique_ptr<Grader>> graders;
  for (const char* tolerance : {R"(, "tolerance": {"decimals": 6})", R"(, "tolerance": "exact")"})
    graders.push_back(
        grader_of(exercise_text("de_casteljau", long_triangle(), R"([{"value": "P[*][*]", "points": 1}])", tolerance)));
  for (const Standard& s : standards)
    graders.push_back(grader_of(exercise_text(s.algorithm, s.inputs, s.ask, R"(, "tolerance": {"decimals": 6})")));
  for (const auto& grader : graders) {
    for (const std::string& literal : literals) {
      INFO(grader->exercise().run.algorithm->id << " " << literal.substr(0, 40));
      const std::string text = answers_text(all_numbers(grader->exercise(), literal));
      const Grade grade = graded_within_bounds(*grader, text);
      CHECK(grade.score() < 1);
    }
  }
}

TEST_CASE("knots at the end of what a double holds have no place where a share is largest, and do no harm",
          "[hostile]") {
  const auto grader = grader_of(exercise_text(
      "interpolation", R"({"points": [[0, 0], [1, 2], [3, 3], [5, 2], [6, 0], [7, 1]],
      "degree": 3, "parametrization": "universal"})",
      R"([{"value": "U", "points": 1}, {"value": "t[*]", "points": 1}])", R"(, "tolerance": {"decimals": 3})"));
  for (
      const std::string knots :
      {R"(["1e308", "1e308", "1e308", "1e308", "1.2e308", "1.5e308", "1.7e308", "1.7e308", "1.7e308", "1.7e308"])",
       R"(["-1.7e308", "-1.7e308", "-1.7e308", "-1.7e308", 0, "1.5e308", "1.7e308", "1.7e308", "1.7e308", "1.7e308"])"}) {
    std::map<std::string, std::string> other{{"U", knots}};
    for (const Part& part : grader->exercise().parts)
      if (part.name != "U") other[part.name] = "5";
    CHECK(graded_within_bounds(*grader, answers_text(all_answers(grader->exercise(), other))).score() < 1);
  }
}

TEST_CASE("numbers whose squares overflow end nothing, and nothing follows from them", "[hostile]") {
  const Grader removal = shipped("34-knot-removal");
  for (const char* answers : {R"({"removal[1].alpha[2]": "1e308", "removal[1].L[1]": ["1e308", 0]})",
                              R"({"removal[1].alpha[3]": "1e308", "removal[1].b": "1e21"})"})
    CHECK(grade_answers_to(removal, answers).score() == 0);

  // The sum of the lengths is infinite: that 0 is a share of it earns nothing.
  const Grader lengths = shipped("70-chord-length");
  CHECK(verdict(grade_answers_to(lengths, R"({"d[1]": "1e308", "d[2]": "1e308", "t[1]": 0})"), "t[1]") == "wrong");
}

TEST_CASE("one long number at the beginning of a long computation is not carried on exactly", "[hostile]") {
  const auto grader = grader_of(exercise_text("de_casteljau", long_triangle(), R"([{"value": "P[*][*]", "points": 1}])",
                                              R"(, "tolerance": {"significant": 3})"));
  std::map<std::string, std::string> other;
  const std::string fraction = "\"" + repeated("7", 199) + "/" + repeated("3", 199) + "1\"";
  for (const char* name : {"P[1][0]", "P[1][12]", "P[2][3]"}) other[name] = "[" + fraction + ", " + fraction + "]";
  const Grade grade = graded_within_bounds(*grader, answers_text(all_answers(grader->exercise(), other)));
  CHECK(verdict(grade, "P[1][0]") != "correct");
  CHECK(verdict(grade, "P[1][5]") == "correct");
}

TEST_CASE("as many values and names as there may be cost no more than a few notes", "[hostile]") {
  const auto grader = grader_of(exercise_text(
      "de_boor", de_boor_inputs, R"([{"value": "k", "points": 1}, {"value": "P[1..3][*]", "points": 1}])"));
  const auto with_names = [&](std::size_t count, auto&& name) {
    std::string answers = R"({"k": 4)";
    for (std::size_t i = 0; i < count; ++i) answers += ", " + json_quote(name(i)) + ": 1";
    return answers_text(answers + "}");
  };
  const auto check = [&](const std::string& text) {
    const Grade grade = graded_within_bounds(*grader, text);
    INFO(grade.reason);
    CHECK(verdict(grade, "k") == "correct");
    CHECK(grade.notes.size() == 11);
    CHECK(grade.notes.back().find("more were ignored") != std::string::npos);
  };
  check(with_names(4000, [](std::size_t i) { return "x" + std::to_string(i); }));
  // Near to what is asked, so that each might be meant.
  check(with_names(3000, [](std::size_t i) { return "P[1][2]" + std::string(i % 3, ' ') + std::to_string(i); }));
  // The same beginning, and only the last byte different from the neighbour's.
  check(with_names(200, [](std::size_t i) { return repeated("k", 300) + std::to_string(i); }));
  // A few that are very long.
  check(with_names(12, [](std::size_t i) { return repeated("P[1][2]", 700) + std::to_string(i); }));
  // A part's array with all values there may be.
  const Grade grade = graded_within_bounds(*grader, answers_text("{\"P[1][2]\": [0" + repeated(",0", 4090) + "]}"));
  CHECK(verdict(grade, "P[1][2]") == "invalid");
}

TEST_CASE("names with one hash, and a name in every spelling, are told apart", "[hostile]") {
  const auto grader = grader_of(exercise_text("de_boor", de_boor_inputs, R"([{"value": "k", "points": 1}])"));
  // The keys of one object: compared by text, whatever their hash.
  CHECK(graded_within_bounds(*grader, answers_text(R"({"k": 4, "K": 5, "k ": 5, "\u041a": 5})")).score() == 1);
  CHECK(graded_within_bounds(*grader, answers_text(R"({"\u006b": 4})")).score() == 1);
  CHECK(graded_within_bounds(*grader, answers_text(R"({"\u006b": 4, "k": 4})")).reason.find("duplicate key") !=
        std::string::npos);
  CHECK(graded_within_bounds(*grader, answers_text(R"({"k\u0000": 4})")).score() == 0);
}

TEST_CASE("a mistake in a file of the largest size is said in a sentence", "[hostile]") {
  const auto grader = grader_of(exercise_text("de_boor", de_boor_inputs, R"([{"value": "k", "points": 1}])"));
  const std::size_t size = submission_limits.bytes;
  for (const std::string& text :
       {repeated("[", size), repeated("{\"\":", size / 4), "\"" + repeated("x", size - 1), repeated("9", size),
        "{\"" + repeated("k", size - 4) + "\"}", "\"" + repeated("\\ud800", size / 7), repeated("\xFF", size),
        repeated(" ", size), repeated("-", size), "[" + repeated("1,", size / 2 - 1)}) {
    INFO(text.substr(0, 10));
    const Grade grade = graded_within_bounds(*grader, text);
    CHECK_FALSE(grade.reason.empty());
    CHECK(grade.score() == 0);
  }
}

TEST_CASE("whatever is typed, every format is clean text, and what is for browsers holds no tags of students",
          "[hostile]") {
  std::string controls;  // as a student may get them in: escaped in JSON
  for (int c = 0; c < 0x20; ++c) controls += "\\u00" + std::string(c < 16 ? "0" : "1") + "0123456789abcdef"[c % 16];
  controls += "\\u007f\\u0080\\u009b2J\\u2028\\u202e\\ufeff";
  const std::string tag = "<script>alert('evil')</script>\\\"><img src=x onerror=evil()>]]>-->&amp;{{evil}}";
  const std::vector<std::string> submissions{
      answers_text("{\"k\": \"" + controls + "\", \"C\": [\"" + tag + "\", 1]}"),
      answers_text("{\"" + controls + "\": 1, \"" + tag + "\": 2, \"k\": 5}"),
      answers_text("{\"k\": 5, \"" + tag.substr(0, 30) + "\": {}}"),
      R"({"schema": ")" + tag + R"(", "exercise": "test", "answers": {}})",
      R"({"schema": "blossom.answers/1", "exercise": ")" + controls + R"(", "answers": {}})",
      "{\"" + tag,
      std::string("\x1b[31m<script>\0", 14),
      "\xff\xfe<script>",
  };
  std::vector<Student> students;
  for (const std::string& name : {std::string("<script>alert('evil')</script>"), std::string("a\x1b[2J\x7f\x01\"'"),
                                  std::string("\xc2\x9b\xe2\x80\xae\xff\xc0"), std::string("a\0b", 3)}) {
    Student student;
    student.id = student.name = student.login = student.sis_id = student.lms_id = student.email = student.section =
        name;
    students.push_back(student);
  }
  for (const char* level : {"none", "verdict", "hint", "full"}) {
    auto examiner = examiner_of(exercise_text("de_boor", de_boor_inputs,
                                              R"([{"value": "k", "points": 1}, {"value": "C", "points": 1}])",
                                              R"(, "feedback": ")" + std::string(level) + "\""));
    for (const ReportFormat* format : report_formats()) {
      for (const Student& student : students) {
        std::vector<StudentResult> results;
        for (const std::string& text : submissions)
          results.push_back(
              grade_student(examiner, student, {submission(text, student.name), submission("", "b\x1b<script>")}));
        for (std::size_t i = 0; i < results.size(); ++i) {
          const bool alone = format->scope == ReportFormat::Scope::student;
          const std::string out = alone ? report(*format, {results[i]}) : report(*format, results);
          std::string offending;
          const bool clean = is_clean(out, offending);
          INFO(format->name << " " << level << ", submission " << i << " of " << printable(student.id) << offending);
          CHECK(clean);
          if (format->extension == "html" || format->extension == "xml") {
            CHECK(out.find("<script>alert") == std::string::npos);
            CHECK(out.find("<img src=x") == std::string::npos);
            CHECK(out.find("b<script>") == std::string::npos);
          }
          if (format->extension == "json") CHECK(JsonDocument::parse("report", out));
          if (!alone) break;
        }
      }
    }
  }
}

TEST_CASE("rounding of earlier values does not grant everything after them", "[hostile]") {
  // C = (wx/w, wy/w): half a unit of the last digit of w = 0.00001 is half of w, which would allow any C.
  const auto grader = shipped("45-de-boor-nurbs");
  const auto carried = [&](const std::string& P, const std::string& C) {
    return verdict(grade_answers_to(grader, R"({"P[2][3]": )" + P + R"(, "C": )" + C + "}"), "C") == "carried";
  };
  CHECK(carried("[0.0001, 0.0000, 0.00001]", "[10, 0]"));
  CHECK_FALSE(carried("[0.0001, 0.0000, 0.00001]", "[9, 3]"));
  CHECK_FALSE(carried("[0.0001, 0.0000, 0.00001]", "[12.5, -3.3]"));
  // What two digits allow: 3.25/1.3749 is 2.36381; 2.1249/1.3749 is 1.54549.
  CHECK(carried("[3.25, 2.1249, 1.3749]", "[2.3639, 1.5455]"));
}

TEST_CASE("an exercise whose right answers cannot be handed in is refused", "[hostile]") {
  const auto complaints = [](const std::string& inputs, const std::string& tolerance) {
    const auto document = JsonDocument::parse(
        "f", exercise_text("de_casteljau", inputs, R"([{"value": "P[*][*]", "points": 1}])", tolerance));
    REQUIRE(document);
    return to_string(read_exercise(*document).diagnostics);
  };
  // Numbers that grow with each of 25 levels.
  std::string points;
  for (int i = 0; i <= 25; ++i)
    points += (i > 0 ? ", [" : "[") + std::to_string(i) + ", \"1/" + std::to_string(1'000'003 + i * i) + "\"]";
  const auto inputs = [&](const std::string& u) {
    return R"({"curve": {"degree": 25, "points": [)" + points + R"(]}, "u": ")" + u + "\"}";
  };
  const std::string long_u = "12345678901234567/98765432109876543";
  CHECK(complaints(inputs(long_u), R"(, "tolerance": {"significant": 4})").empty());
  CHECK(complaints(inputs(long_u), R"(, "tolerance": "exact")").find("has more digits than can be typed") !=
        std::string::npos);

  // A point of two coordinates is three values.
  std::string many = "[0, 0]", knots = "0, 0";
  for (int i = 1; i < 1500; ++i) many += ", [" + std::to_string(i) + ", 1]", knots += ", " + std::to_string(i);
  const auto document =
      JsonDocument::parse("f", exercise_text("knot_insertion",
                                             R"({"curve": {"degree": 1, "knots": [)" + knots +
                                                 ", 1499], \"points\": [" + many + R"(]}, "u": "1/2", "times": 1})",
                                             R"([{"value": "Q[*]", "points": 1}])"));
  REQUIRE(document);
  CHECK(to_string(read_exercise(*document).diagnostics).find("asks for more than can be handed in") !=
        std::string::npos);
}
