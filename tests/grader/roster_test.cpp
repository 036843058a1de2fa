// Rosters of our own, and as Canvas and Moodle export them.

#include "grader/roster.hpp"

#include <sys/stat.h>

#include <fstream>
#include <stdexcept>

#include "scratch.hpp"

using namespace blossom;

namespace {

struct Class {
  test::Scratch folder;
  Checked<Roster> roster;
  explicit Class(const std::string& text) : roster(Roster::load(folder.write("class.csv", text))) {
    INFO(to_string(roster.diagnostics));
    REQUIRE(roster);
  }
  std::string found(std::string_view key) const {
    const auto index = roster->find(key);
    return index ? roster->student(*index).id : "nobody";
  }
};

// What is wrong with a roster of this text, without the folder it is in.
std::string mistakes(const std::string& text) {
  const test::Scratch folder;
  auto roster = Roster::load(folder.write("class.csv", text));
  CHECK_FALSE(roster);
  for (Diagnostic& d : roster.diagnostics) d.file = "class.csv";
  return to_string(roster.diagnostics);
}

}  // namespace

TEST_CASE("a roster of our own: all columns, in any order and spelling", "[roster]") {
  const Class c(
      "Last_Name,FIRST NAME,Shoe size,ID,login,SIS ID,lms-id,E-Mail,Section,Due\r\n"
      "Lovelace,Ada,37,s17,ada,A100,4711,ada@example.edu,A,2026-10-01T23:59:00+02:00\r\n"
      "\r\n"
      "\"Hopper\",\"Grace\",,s18,grace,,4712,,\"B, late\",\r\n");
  REQUIRE(c.roster->size() == 2);
  const Student ada = c.roster->student(0);
  CHECK(ada.id == "s17");
  CHECK(ada.name == "Lovelace, Ada");
  CHECK(ada.login == "ada");
  CHECK(ada.sis_id == "A100");
  CHECK(ada.lms_id == "4711");
  CHECK(ada.email == "ada@example.edu");
  CHECK(ada.section == "A");
  CHECK(ada.due == parse_time("2026-10-01T21:59:00Z"));
  const Student grace = c.roster->student(1);
  CHECK(grace.section == "B, late");
  CHECK(grace.email == "");
  CHECK_FALSE(grace.due);
}

TEST_CASE("the id alone is enough, with any separator, blanks around it or a byte order mark", "[roster]") {
  CHECK(Class("id\ns17\ns18\n").roster->size() == 2);
  CHECK(Class("\xEF\xBB\xBFid;name\n s17 ;Ada\n").roster->student(0).id == "s17");
  // Where two files were put together it stands inside, and is a part of the cell each time it is read.
  const Class joined("id\n\xEF\xBB\xBFs17\ns18\n");
  CHECK(joined.roster->student(0).id == "\xEF\xBB\xBFs17");
  CHECK(joined.roster->find("\xEF\xBB\xBFs17") == std::size_t{0});
  CHECK(Class("name\tid\nAda\ts17\n\t\n").roster->student(0).name == "Ada");
  CHECK(Class("id,name\ns17\ns18,Grace,,\n").roster->student(0).name == "");
  CHECK(Class("id,name\ns17,\"Ada\nLovelace\"\n").roster->student(0).name == "Ada Lovelace");
}

TEST_CASE("somebody is found by each name, exactly, then ignoring case", "[roster]") {
  const Class c(
      "id,login,sis id,lms id,email\n"
      "s17,ada,A100,4711,Ada@example.edu\n"
      "s18,grace,A101,4712,none\n"
      "s19,Emmy,A102,s17,none\n"
      "s20,emmy,A103,4714,EMMY@example.edu\n");
  CHECK(c.found("s17") == "s17");  // an id comes before what another one is also known by
  CHECK(c.found("S18") == "s18");
  CHECK(c.found("ada") == "s17");
  CHECK(c.found("A101") == "s18");
  CHECK(c.found("4714") == "s20");
  CHECK(c.found("ada@EXAMPLE.edu") == "s17");
  CHECK(c.found("Emmy") == "s19");
  CHECK(c.found("emmy") == "s20");
  CHECK(c.found("EMMY") == "nobody");  // two are called so
  CHECK(c.found("none") == "nobody");
  CHECK(c.found("") == "nobody");
  CHECK(c.found("s1") == "nobody");
  CHECK(c.found("s17 ") == "nobody");
  CHECK(c.found(std::string_view("s17\0", 4)) == "nobody");
}

TEST_CASE("a gradebook exported by Canvas is a roster", "[roster]") {
  const Class c(
      "Student,ID,SIS User ID,SIS Login ID,Section,Bezier curves (9001),Current Score\n"
      ",,,,,Manual Posting,\n"
      "    Points Possible,,,,,10,(read only)\n"
      "\"Lovelace, Ada\",4711,A100,ada,CS3621 L01,9.5,95\n"
      "\"Hopper, Grace\",4712,A101,grace,\"CS3621 L01 and CS3621 L02\",,\n"
      "\"Student, Test\",4799,,0123456789abcdef0123456789abcdef01234567,CS3621 L01,,\n");
  REQUIRE(c.roster->size() == 2);
  const Student ada = c.roster->student(0);
  CHECK(ada.id == "4711");
  CHECK(ada.lms_id == "4711");
  CHECK(ada.sis_id == "A100");
  CHECK(ada.login == "ada");
  CHECK(ada.name == "Lovelace, Ada");
  CHECK(ada.section == "CS3621 L01");
  CHECK(c.found("grace") == "4712");
  CHECK(c.found("4799") == "nobody");
}

TEST_CASE("a grading worksheet and a list of users exported by Moodle are rosters", "[roster]") {
  const Class worksheet(
      "Identifier,\"Full name\",\"Email address\",Status,Grade,\"Maximum Grade\",\"Last modified (submission)\"\n"
      "\"Participant 4711\",\"Ada Lovelace\",ada@example.edu,\"No submission - \",,10.00,-\n"
      "\"Teilnehmer/in4712\",\"Grace Hopper\",grace@example.edu,,,10.00,-\n");
  REQUIRE(worksheet.roster->size() == 2);
  CHECK(worksheet.roster->student(0).id == "4711");
  CHECK(worksheet.roster->student(0).lms_id == "4711");
  CHECK(worksheet.roster->student(0).name == "Ada Lovelace");
  CHECK(worksheet.found("grace@example.edu") == "4712");

  const Class users(
      "Username,\"First name\",Surname,\"ID number\",\"Email address\",Groups\n"
      "ada,Ada,Lovelace,A100,ada@example.edu,L01\n");
  CHECK(users.roster->student(0).id == "ada");
  CHECK(users.roster->student(0).name == "Lovelace, Ada");
  CHECK(users.found("A100") == "ada");
}

TEST_CASE("every mistake of a roster is told at once, with its line", "[roster]") {
  CHECK(
      mistakes("id,name,due\n"
               "s17,Ada,tomorrow\n"
               ",Grace,\n"
               "s18,Hopper, Grace,2026-10-01T00:00:00Z\n"
               "S17,Emmy,\n"
               "s17,\"Sophie\nGermain\",\n"
               "s20,\"open\n") ==
      "class.csv:2: due must be a time with its offset from UTC such as \"2026-10-01T23:59:00+02:00\", not "
      "\"tomorrow\"\n"
      "class.csv:3: no id for \"Grace\"\n"
      "class.csv:4: due must be a time with its offset from UTC such as \"2026-10-01T23:59:00+02:00\", not \"Grace\"\n"
      "class.csv:4: 4 cells where the header has 3; a cell that has a comma in it stands in quotation marks\n"
      "class.csv:5: the id \"S17\" stands in line 2 already, ignoring case; each student has an id of their own\n"
      "class.csv:6: the id \"s17\" stands in line 2 already, ignoring case; each student has an id of their own\n"
      "class.csv:8: a quotation mark that is never closed; end the cell with \"\n");
  CHECK(mistakes("id\n" + std::string(65, 'x') + "\n") ==
        "class.csv:2: the id \"" + std::string(40, 'x') + "...\" is too long; at most 64 bytes\n");
  CHECK(mistakes("") == "class.csv: is empty; the first row has the names of the columns\n");
  CHECK(mistakes("id,name\n") == "class.csv: has no students\n");
  CHECK(mistakes("id,name,Full name\ns17,a,b\n") ==
        "class.csv:1: columns \"name\" and \"Full name\" mean the same; keep one of them\n");
  CHECK(mistakes("surname,mail\nLovelace,x\n").starts_with("class.csv:1: missing column \"id\"; a roster has"));
}

TEST_CASE("what is no file is no roster, and does not keep anybody waiting", "[roster]") {
  const test::Scratch folder;
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  for (const char* name : {"pipe", ".", "absent.csv"}) CHECK_FALSE(Roster::load(folder / name));
  CHECK_FALSE(Roster::load("/dev/zero"));
}

TEST_CASE("a roster that changes while it is in use is not trusted", "[roster]") {
  const Class c("id,name\ns17,Ada\ns18,Grace\n");
  CHECK(c.roster->student(1).name == "Grace");
  c.folder.write("class.csv", "id,name\n");
  CHECK_THROWS_AS(c.roster->student(1), std::runtime_error);
  CHECK_THROWS_AS(c.roster->find("s18"), std::runtime_error);
}

TEST_CASE("a name that very many share finds nobody, and all others are found", "[roster]") {
  std::string text = "id,email\n";
  for (int i = 0; i < 20'000; ++i) text += "s" + std::to_string(i) + ",nobody@example.edu\n";
  const Class c(text);
  CHECK(c.roster->size() == 20'000);
  CHECK(c.found("nobody@example.edu") == "nobody");
  for (int i = 0; i < 20'000; i += 7) {
    const std::string id = "s" + std::to_string(i);
    REQUIRE(c.roster->find(id) == static_cast<std::size_t>(i));
    REQUIRE(c.roster->student(static_cast<std::size_t>(i)).id == id);
  }
}

TEST_CASE("a hundred thousand mistakes are 10,000 lines", "[roster]") {
  std::string text = "id,due\n";
  for (int i = 0; i < 50'000; ++i) text += "same,soon\n";
  const test::Scratch folder;
  CHECK(Roster::load(folder.write("class.csv", text)).diagnostics.size() == 10'000);
}

TEST_CASE("a learning platform's number is looked for among such numbers alone", "[roster]") {
  const auto match = [](const Class& c, std::vector<StudentKey> keys) {
    const Roster::Match one = c.roster->match(keys);
    return one.index ? c.roster->student(*one.index).id : one.ambiguous ? "ambiguous" : "nobody";
  };
  const auto number = [](std::string text) { return StudentKey{std::move(text), StudentKey::Kind::lms_number}; };
  const Class c("id,name,lms id\n17,Ann,4711\n20,Bob,17\n21,Cem,21\n");
  CHECK(match(c, {number("17")}) == "20");
  CHECK(match(c, {{"17"}}) == "17");
  CHECK(match(c, {number("20")}) == "nobody");
  CHECK(match(c, {number("21")}) == "21");
  CHECK(match(c, {{"bob_17_99_a"}, number("17")}) == "20");
  CHECK(match(c, {{"17"}, number("17")}) == "ambiguous");
  CHECK(match(c, {}) == "nobody");

  // Where there are none, any column may have it, but only once.
  const Class plain("id,name,login\n17,Ann,x\n20,Bob,17\n21,Cem,y\n");
  CHECK(match(plain, {number("17")}) == "ambiguous");
  CHECK(match(plain, {number("21")}) == "21");
  CHECK(match(Class("Student,ID,SIS User ID,SIS Login ID,Section\nAnn,5,17,ann,A\nBob,17,6,bob,A\n"), {number("17")}) ==
        "17");
}

TEST_CASE("a name is the same with its accents composed or apart", "[roster]") {
  const Class c("id,name\n\u00c9va,E\n");
  CHECK(c.found("E\u0301va") == "\u00c9va");
  CHECK(c.found("e\u0301va") == "nobody");  // only A to Z have no case
  CHECK(mistakes("id\n\u00c9va\nE\u0301va\n").find("stands in line 2 already") != std::string::npos);
}

TEST_CASE("a roster that is JSON is said to be", "[roster]") {
  CHECK(mistakes(" [{\"id\": \"s17\"}]") ==
        "class.csv: is JSON; a roster is CSV: a row of titles such as id,name and a row for each student\n");
}
