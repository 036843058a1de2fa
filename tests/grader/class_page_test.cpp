// The page an instructor gets: its figures against ones worked out by hand, and what it points at.

#include <map>

#include "grader/page/class_page.hpp"
#include "helpers.hpp"

using namespace blossom;

namespace {

struct PartOf {
  std::string value, verdict;
  double points = 0;
  std::string answer = "1", more = {};  // further members, each after a comma
};

std::string exercise_json(const std::vector<PartOf>& parts, const std::string& more = "",
                          const std::string& explanation = "") {
  double sum = 0;
  std::string text;
  for (const PartOf& part : parts) {
    sum += part.points;
    text += (text.empty() ? "" : ",") + (R"({"value":)" + json_quote(part.value)) + R"(,"verdict":)" +
            json_quote(part.verdict) + R"(,"points":)" + format_number(part.points) +
            R"(,"max_points":1,"feedback":"told","answer":)" + part.answer + part.more + "}";
  }
  const std::string most = std::to_string(parts.size());
  return R"({"exercise":"e1","points":)" + format_number(sum) + R"(,"max_points":)" + most + R"(,"state":"graded")" +
         more + R"(,"grade":{"schema":"blossom.grade/1","exercise":"e1","points":)" + format_number(sum) +
         R"(,"max_points":)" + most + R"(,"parts":[)" + text + "]" + explanation + "}}";
}

std::string result_json(const std::string& id, double score, const std::string& exercise,
                        const std::string& incidents = "") {
  return R"({"schema":"blossom.result/1","assignment":"a1","student":{"id":)" + json_quote(id) + R"(,"name":)" +
         json_quote("Name of " + id) + R"(},"score":)" + format_number(score) + R"(,"points":)" +
         format_number(10 * score) + R"(,"max_points":10,"exercises":[)" + exercise + R"(],"incidents":[)" + incidents +
         "]}";
}

class Class {
 public:
  void add(const std::string& result, const std::string& page = "") {
    const auto document = JsonDocument::parse("results.jsonl", result);
    INFO(to_string(document.diagnostics));
    REQUIRE(document);
    statistics.add(document->root(), page);
  }
  const std::string& html() {
    statistics.finish();
    return files["class.html"];
  }
  JsonDocument json() const {
    auto document = JsonDocument::parse("figures", statistics.json());
    INFO(to_string(document.diagnostics));
    REQUIRE(document);
    return std::move(*document);
  }

  std::map<std::string, std::string> files;
  ClassStatistics statistics{"A class", [this](const std::string& file, std::string_view html) { files[file] = html; }};
};

const Json& at(const Json& json, std::string_view key) {
  const Json* found = json.find(key);
  REQUIRE(found != nullptr);
  return *found;
}
double number(const Json& json, std::string_view key) { return std::stod(at(json, key).text); }

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("difficulty and discrimination are the mean share and the correlation with all other points", "[class]") {
  // Shares of a, b, c by student:      1 1 1 | 1 1 0 | 0 0 1 | 0 0 0
  // Rest of a (b + c over 2):          1, 1/2, 1/2, 0: with a = 1 1 0 0
  //   means 1/2, 1/2; covariance sums 1/2*1/2 + 0 + 0 + 1/2*1/2 = 1/2; variances 1 and 1/2: r = (1/2) / sqrt(1/2)
  // Rest of c: 1, 1, 0, 0 with c = 1 0 1 0: covariance 0.
  Class of;
  const int shares[4][3] = {{1, 1, 1}, {1, 1, 0}, {0, 0, 1}, {0, 0, 0}};
  for (int s = 0; s < 4; ++s) {
    std::vector<PartOf> parts;
    for (int i = 0; i < 3; ++i)
      parts.push_back({std::string(1, static_cast<char>('a' + i)), shares[s][i] == 1 ? "correct" : "wrong",
                       static_cast<double>(shares[s][i])});
    of.add(result_json("s" + std::to_string(s), 0.5, exercise_json(parts)));
  }
  const auto json = of.json();
  const auto& items = at(json.root(), "items").items;
  REQUIRE(items.size() == 3);
  CHECK(number(items[0], "difficulty") == 0.5);
  CHECK(number(items[0], "discrimination") == Approx(std::sqrt(0.5)));
  CHECK(number(items[1], "discrimination") == Approx(std::sqrt(0.5)));
  CHECK(number(items[2], "discrimination") == Approx(0).margin(1e-12));
}

TEST_CASE("where nothing varies there is no discrimination", "[class]") {
  Class of;
  for (const std::string id : {"s1", "s2", "s3"})
    of.add(result_json(id, 1, exercise_json({{"a", "correct", 1}, {"b", "correct", 1}})));
  const auto json = of.json();
  CHECK(at(at(json.root(), "items").items[0], "discrimination").kind == Json::Kind::null);
  CHECK(has(of.html(), "<td class=\"number\">–</td>"));
}

TEST_CASE("scores are counted in twentieths, the full score in the last", "[class]") {
  Class of;
  const double scores[] = {0, 0.049, 0.05, 0.5, 0.95, 1};
  for (std::size_t i = 0; i < std::size(scores); ++i)
    of.add(result_json("s" + std::to_string(i), scores[i], exercise_json({{"a", "correct", 1}})));
  const auto json = of.json();
  std::vector<int> counts;
  for (const Json& bin : at(json.root(), "histogram").items) counts.push_back(std::stoi(bin.text));
  CHECK(counts == std::vector<int>{2, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 2});
  CHECK(number(json.root(), "mean_score") == Approx((0.049 + 0.05 + 0.5 + 0.95 + 1) / 6));
  CHECK(number(json.root(), "median_score") == Approx((0.05 + 0.5) / 2));  // of the two in the middle
}

TEST_CASE("a mistake is counted by students and by values, with an example", "[class]") {
  Class of;
  const std::string swapped = R"(,"misconception":"swapped-weights")";
  const std::string all =
      R"(,"explanation":{"misconceptions":["swapped-weights"],"covered":2,"wrong":2,"chance":0.001})";
  of.add(result_json("s1", 0,
                     exercise_json(
                         {{"a", "misconception", 0, "[3, \"1/2\"]", swapped}, {"b", "misconception", 0, "2", swapped}},
                         "", all)),
         "students/s1.html");
  of.add(result_json("s2", 0.5, exercise_json({{"a", "misconception", 0, "4", swapped}, {"b", "correct", 1}})));
  const auto json = of.json();
  const Json& counted = at(json.root(), "mistakes").items.at(0);
  CHECK(at(counted, "word").text == "swapped-weights");
  CHECK(number(counted, "students") == 2);
  CHECK(number(counted, "values") == 3);
  CHECK(number(counted, "explains") == 2);  // in both nothing else is wrong
  const std::string& page = of.html();
  CHECK(has(page, "the weights are swapped"));
  CHECK(has(
      page,
      "<a href=\"students/s1.html\">s1</a>, e1: <span class=\"value\" title=\"a\"><code>a</code></span> = (3, 1/2)"));
}

TEST_CASE("a slip that is all that is wrong explains the submission", "[class]") {
  const std::string slip = R"(,"note":"arithmetic")";
  Class of;
  of.add(result_json("s1", 0.5, exercise_json({{"a", "slip", 0, "3", slip}, {"b", "carried", 1}})));
  of.add(result_json("s2", 0,
                     exercise_json({{"a", "slip", 0, "3", slip}, {"b", "wrong", 0, "1", R"(,"note":"unknown")"}})));
  const auto json = of.json();
  const Json& counted = at(json.root(), "mistakes").items.at(0);
  REQUIRE(at(counted, "word").text == "arithmetic");
  CHECK(number(counted, "students") == 2);
  CHECK(number(counted, "explains") == 1);
}

TEST_CASE("names are typeset as on the student's page, with what is typed beside them", "[class]") {
  auto document = JsonDocument::parse("e.json", exercise_text("de_casteljau", R"({"curve": {"degree": 2,
      "points": [[0, 0], [3, 9], [9, 15]]}, "u": "1/3"})",
                                                              R"([{"value": "P[1][*]", "points": 1}])"));
  REQUIRE(document);
  auto assignment = read_assignment(*document);
  REQUIRE(assignment);
  assignment->items[0].exercise.id = "e1";
  std::string page;
  ClassStatistics statistics(
      "A class", [&](const std::string&, std::string_view html) { page = html; }, &*assignment);
  const auto result = JsonDocument::parse("r", result_json("s1", 1, exercise_json({{"P[1][0]", "correct", 1}})));
  REQUIRE(result);
  statistics.add(result->root(), "");
  statistics.finish();
  CHECK(has(page, "title=\"P[1][0]\"><span class=\"v\"><i>P</i>"));
  CHECK(has(page, "<code>P[1][0]</code>"));
}

TEST_CASE("the same wrong answers are pointed at where no mistake explains them", "[class]") {
  const auto alike = [](Class& of) { return of.json().root().find("alike")->items.size(); };
  const std::vector<PartOf> odd{{"a", "wrong", 0, "7"}, {"b", "wrong", 0, "8"}, {"c", "wrong", 0, "[9, 9]"}};

  SECTION("of two students, three values") {
    Class of;
    of.add(result_json("s1", 0, exercise_json(odd)), "students/s1.html");
    of.add(
        result_json("s2", 0, exercise_json({{"a", "wrong", 0, "7"}, {"b", "wrong", 0, "8"}, {"c", "wrong", 0, "1"}})));
    of.add(result_json("s3", 0, exercise_json(odd)), "students/s3.html");
    const auto json = of.json();
    const auto& groups = at(json.root(), "alike").items;
    REQUIRE(groups.size() == 1);
    CHECK(at(groups[0], "first").items.at(0).text == "s1");
    CHECK(at(groups[0], "first").items.at(1).text == "s3");
    CHECK(has(of.html(), "<a href=\"students/s1.html\">s1</a>, <a href=\"students/s3.html\">s3</a>"));
  }
  SECTION("not two values, where everybody has the same numbers") {
    Class of;
    for (const std::string id : {"s1", "s2"}) of.add(result_json(id, 0, exercise_json({odd[0], odd[1]})));
    CHECK(alike(of) == 0);
  }
  SECTION("two are enough where everybody has other numbers") {
    Class of;
    for (const std::string id : {"s1", "s2"})
      of.add(result_json(id, 0, exercise_json({odd[0], odd[1]}, R"(,"varies":true)")));
    CHECK(alike(of) == 1);
    CHECK(has(of.html(), "with different numbers"));
  }
  SECTION("somebody else's right answers, where everybody has other numbers") {
    Class of;
    const std::string varies = R"(,"varies":true)";
    of.add(result_json("s6", 0, exercise_json({odd[0], odd[1]}, varies)));
    of.add(result_json("s1", 1, exercise_json({{"a", "correct", 1, "7"}, {"b", "correct", 1, "8"}}, varies)));
    of.add(result_json("s2", 0, exercise_json({{"a", "correct", 1, "1"}, {"b", "wrong", 0, "8"}}, varies)));
    CHECK(alike(of) == 1);
    CHECK(has(of.html(), "the answers of s6 are those of s1</strong>, which are right for s1's numbers"));
  }
  SECTION("not what is right for the numbers of all") {
    Class of;
    for (const std::string id : {"s1", "s2"})
      of.add(
          result_json(id, 1, exercise_json({{"a", "correct", 1, "7"}, {"b", "correct", 1, "8"}}, R"(,"varies":true)")));
    CHECK(alike(of) == 0);
  }
  SECTION("not what a misconception explains or what is carried over") {
    Class of;
    for (const std::string id : {"s1", "s2"})
      of.add(result_json(id, 0,
                         exercise_json({{"a", "misconception", 0, "7", R"(,"misconception":"m")"},
                                        {"b", "carried", 1, "8"},
                                        {"c", "carried", 1, "9"},
                                        {"d", "wrong", 0, "5"}})));
    CHECK(alike(of) == 0);
  }
  SECTION("not what many have in common") {
    Class of;
    for (int i = 0; i < 40; ++i) of.add(result_json("s" + std::to_string(i), 0, exercise_json(odd)));
    CHECK(alike(of) == 0);
  }
}

TEST_CASE("what cannot be explained or read is listed", "[class]") {
  Class of;
  of.add(result_json("s1", 0,
                     exercise_json({{"a", "wrong", 0}, {"b", "wrong", 0}, {"c", "wrong", 0}}, "",
                                   R"(,"explanation":{"misconceptions":[],"covered":0,"wrong":3,"chance":1})")));
  of.add(result_json("s2", 0, R"({"exercise":"e1","points":0,"max_points":3,"state":"missing"})",
                     R"({"kind":"failed","exercise":"e1","text":"the grader died of signal 11"})"));
  const std::string& page = of.html();
  CHECK(has(page, "3 of 3 answers are wrong"));
  CHECK(has(page, "the grader failed: the grader died of signal 11"));
}

TEST_CASE("incidents are told in words, each with its file, what is nobody's among them", "[class]") {
  Class of;
  of.add(result_json("s1", 0, exercise_json({{"a", "correct", 1}}),
                     R"({"kind":"misplaced","source":"s1/skinning.json","text":"no exercise"},)"
                     R"({"kind":"duplicate","exercise":"e1","source":"s1/a.json","text":"does not count"})"));
  of.statistics.add_stray("unlisted", "visitor", "visitor.json", "nobody on the roster is known as it");
  const std::string& page = of.html();
  CHECK(has(page, "1 handed in more than once, 1 for no exercise of this assignment, 1 from nobody on the roster"));
  CHECK(has(page, "href=\"incidents.csv\""));
  CHECK(has(page, "for no exercise of this assignment, s1/skinning.json: no exercise"));
  CHECK(has(page, "<li>visitor: from nobody on the roster, visitor.json: nobody on the roster is known as it"));
}

TEST_CASE("a large class has its students on pages of a thousand", "[class]") {
  Class of;
  const std::string exercise = exercise_json({{"a", "correct", 1}});
  for (int i = 0; i < 2500; ++i) {
    const std::string id = "s" + std::to_string(i);
    of.add(result_json(id, 1, exercise), "students/" + id + ".html");
  }
  const std::string& page = of.html();
  CHECK(of.files.size() == 4);
  CHECK(has(page, "href=\"class/3.html\""));
  CHECK_FALSE(has(page, "students/s7.html"));
  CHECK(has(of.files["class/1.html"], "href=\"../students/s999.html\""));
  CHECK(has(of.files["class/2.html"], "href=\"../students/s1000.html\""));
  CHECK_FALSE(has(of.files["class/3.html"], "Next page"));
}

TEST_CASE("names and answers on the class page are text", "[class]") {
  Class of;
  const std::string hostile = "</td><script>alert(1)</script>";
  of.add(result_json(hostile, 0, exercise_json({{hostile, "slip", 0, json_quote(hostile), R"(,"note":"</b>")"}})),
         "students/%3C\".html");
  const std::string& page = of.html();
  CHECK_FALSE(has(page, "<script"));
  CHECK_FALSE(has(page, "</b>"));
  CHECK(has(page, "href=\"students/%253C&quot;.html\""));
}

TEST_CASE("the same class makes the same bytes", "[class]") {
  Class a, b;
  for (Class* of : {&a, &b})
    for (int i = 0; i < 20; ++i)
      of->add(
          result_json("s" + std::to_string(i), i / 20.0, exercise_json({{"a", i % 3 == 0 ? "wrong" : "correct", 1}})));
  CHECK(a.html() == b.html());
  CHECK(a.statistics.json() == b.statistics.json());
}
