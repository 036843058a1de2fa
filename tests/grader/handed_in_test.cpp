// What one student handed in, from files and folders that may hold anything; and what Gradescope says of it.

#include <sys/stat.h>

#include <filesystem>

#include "grader/handed_in.hpp"
#include "grader/helpers.hpp"
#include "scratch.hpp"

using namespace blossom;
using blossom::test::Scratch;
namespace fs = std::filesystem;

TEST_CASE("of a folder the answers files are read, below it too, by name; other files are told of") {
  const Scratch folder;
  fs::create_directories(folder / "b/deep");
  fs::create_directories(folder / "__MACOSX");
  folder.write("c.JSON", "3");
  folder.write("a.json", "1");
  folder.write("b/deep/x.json", "2");
  folder.write("notes.txt", "?");
  folder.write(".DS_Store", "?");
  fs::create_directories(folder / ".tries");
  folder.write(".tries/a.json", "?");
  folder.write("__MACOSX/._a.json", "?");
  const HandedIn found = read_handed_in({folder.path()});
  std::vector<std::string> read;
  for (const auto& one : found.submissions) read.push_back(one.source + " " + one.text + one.problem);
  CHECK(read == std::vector<std::string>{"a.json 1", "b/deep/x.json 2", "c.JSON 3"});
  REQUIRE(found.refused.size() == 2);
  CHECK(found.refused[0].source == ".tries");
  CHECK(found.refused[1].source == "notes.txt");
  CHECK(found.refused[0].kind == Incident::Kind::refused);
}

TEST_CASE("links, pipes and folders named *.json are not read, and huge files not whole") {
  const Scratch folder, elsewhere;
  fs::create_symlink("/etc/passwd", folder / "a.json");
  fs::create_directory_symlink("/etc", folder / "b.json");
  fs::create_directories(folder / "c.json");
  REQUIRE(mkfifo((folder / "d.json").c_str(), 0600) == 0);
  folder.write("e.json", std::string(10u << 20, ' '));
  const HandedIn found = read_handed_in({folder.path()});
  std::vector<std::string> read;
  for (const auto& one : found.submissions) {
    CHECK(one.text.size() <= submission_limits.bytes + 1);
    read.push_back(one.source + " " + one.problem);
  }
  CHECK(read == std::vector<std::string>{"a.json is a symbolic link, which is not read",
                                         "b.json is a symbolic link, which is not read",
                                         "d.json is no file: a device, a pipe or a folder", "e.json "});
  // A file that is named itself is read through a link; one that is not there says so.
  fs::create_symlink(elsewhere.write("good.json", "1"), elsewhere / "link.json");
  const HandedIn named = read_handed_in({elsewhere / "link.json", elsewhere / "none.json"});
  REQUIRE(named.submissions.size() == 2);
  CHECK(named.submissions[0].text == "1");
  CHECK(named.submissions[1].problem.starts_with("cannot be read: "));
}

TEST_CASE("a folder of very many entries is not looked at to its end") {
  const Scratch folder;
  for (int i = 0; i < 1100; ++i) folder.write("a" + std::to_string(i) + ".json", "");
  const HandedIn found = read_handed_in({folder.path()});
  CHECK(found.submissions.size() == 1000);
  REQUIRE(found.refused.size() == 1);
  CHECK(found.refused[0].text == "only 1000 entries of it were looked at");
}

namespace {

Checked<SubmissionMetadata> metadata(const std::string& text) {
  const auto document = JsonDocument::parse("submission_metadata.json", text);
  REQUIRE(document);
  return read_submission_metadata(*document);
}

}  // namespace

TEST_CASE("Gradescope's metadata: who, when, and until when") {
  const auto plain = metadata(R"({
    "id": 123456, "created_at": "2018-07-01T14:22:32.365935-07:00",
    "assignment": {"due_date": "2018-07-31T23:00:00.000000-07:00", "group_size": 4, "group_submission": true, "id": 25828,
      "course_id": 1234, "late_due_date": null, "release_date": "2018-07-02T00:00:00.000000-07:00",
      "title": "Programming Assignment 1", "total_points": "20.0"},
    "submission_method": "upload",
    "users": [{"email": "student@example.com", "id": 1234, "name": "Student User"}, {"email": "b@example.com", "id": 1}],
    "previous_submissions": [{"submission_time": "x", "score": 0.0, "results": {"score": 1e300}}]})");
  REQUIRE(plain);
  CHECK(plain->student.id == "student@example.com");
  CHECK(plain->student.email == "student@example.com");
  CHECK(plain->student.lms_id == "1234");
  CHECK(plain->student.name == "Student User");
  CHECK(plain->submitted == parse_time("2018-07-01T14:22:32-07:00"));
  CHECK(plain->student.due == parse_time("2018-07-31T23:00:00-07:00"));

  const auto extended = metadata(R"({
    "created_at": "2018-07-01T14:22:32.365935-07:00", "assignment": {"due_date": "2018-07-31T23:00:00.000000-07:00"},
    "users": [{"email": "a@example.com", "sid": "0017", "id": 9,
               "assignment": {"due_date": "2018-08-02T23:00:00.000000-07:00"}}]})");
  REQUIRE(extended);
  CHECK(extended->student.id == "0017");
  CHECK(extended->student.sis_id == "0017");
  CHECK(extended->student.due == parse_time("2018-08-02T23:00:00-07:00"));

  const auto without_date = metadata(R"({"created_at": "2018-07-01T14:22:32Z", "users": [{"id": 9}],
                                         "assignment": {"due_date": null}})");
  REQUIRE(without_date);
  CHECK(without_date->student.id == "9");
  CHECK_FALSE(without_date->student.due);
}

TEST_CASE("metadata of another form is a mistake with its place") {
  const auto says = [](const std::string& text) {
    const auto read = metadata(text);
    CHECK_FALSE(read);
    return to_string(read.diagnostics);
  };
  CHECK(says("[]").find("users: must be an array") != std::string::npos);
  CHECK(says(R"({"users": []})").find("users: must be an array of at least one") != std::string::npos);
  CHECK(says(R"({"users": [{"name": "x"}], "created_at": "2018-07-01T14:22:32Z"})").find("users[0]: must have") !=
        std::string::npos);
  CHECK(says(R"({"users": [{"id": 1}], "created_at": "yesterday"})").find("created_at: must be a time") !=
        std::string::npos);
}
