// JSON Lines and folders.

#include "grader/batch/source.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "base/json.hpp"
#include "batch/sources.hpp"
#include "scratch.hpp"

using namespace blossom;
namespace fs = std::filesystem;

namespace {

const std::string answers = R"({"schema": "blossom.answers/1", "exercise": "e", "answers": {"k": 4}})";

std::string problem(const std::string& line, const SourceLimits& limits = {}) {
  const Found found = read_line(line, limits);
  CHECK(found.submission.text.empty());
  return found.submission.problem;
}

struct Folder : test::Scratch {
  using Scratch::write;
  // With the folders it is in.
  std::string put(const std::string& name, const std::string& content) const {
    fs::create_directories(fs::path(*this / name).parent_path());
    return write(name, content);
  }
};

}  // namespace

TEST_CASE("a line with a submission as an object or as a string", "[lines]") {
  Found found = read_line(R"({"student": "s17", "submitted": "2026-10-01T23:59:00+02:00", "source": "a/b.json",
    "submission": )" + answers +
                          "}");
  CHECK(found.keys == std::vector<StudentKey>{{"s17"}});
  CHECK(found.submission.submitted == parse_time("2026-10-01T21:59:00Z"));
  CHECK(found.submission.source == "a/b.json");
  CHECK(found.submission.text == answers);
  CHECK(found.submission.problem == "");
  CHECK_FALSE(found.refused);

  found = read_line(R"({ "submission" : )" + json_quote(answers + "\n\xC3\xA9") + R"( , "student" :"s\u0031\u0037"})");
  CHECK(found.keys == std::vector<StudentKey>{{"s17"}});
  CHECK(found.submission.text == answers + "\n\xC3\xA9");
  CHECK_FALSE(found.submission.submitted);

  // What stands inside is not looked at: it may be anything, and whoever grades it will say so.
  CHECK(read_line(R"({"student": "s17", "submission": {"student": "s18", "x": [,], 01, "\q"}})").submission.text ==
        R"({"student": "s18", "x": [,], 01, "\q"})");
  CHECK(read_line(R"({"student": "s17", "submission": "no answers"})").submission.text == "no answers");
}

TEST_CASE("a line that is an answers file itself is its own text, with blanks for what is not the student's",
          "[lines]") {
  const auto text = [](const std::string& line) {
    const Found found = read_line(line);
    CHECK(found.submission.problem == "");
    CHECK(found.keys == std::vector<StudentKey>{{"s17"}});
    return found.submission.text;
  };
  CHECK(text(R"({"student": "s17", "schema": 1, "a": {"student": 2}})") ==
        R"({                  "schema": 1, "a": {"student": 2}})");
  CHECK(text(R"({"schema": 1,"student":"s17"})") == R"({"schema": 1                })");
  CHECK(text(R"({"student":"s17"})") == R"({               })");
  // In any order and wherever they stand, what is left is JSON with all else at its place.
  std::vector<std::string> members = {R"("student": "s17")", R"("submitted":"2026-10-01T21:59:00Z")",
                                      R"("source": "x,y")", R"("schema": "blossom.answers/1")",
                                      R"("answers": {"k" : [1, "}"]})"};
  std::ranges::sort(members);
  do {
    std::string line = "{ ";
    for (const std::string& member : members) line += (line.size() > 2 ? " , " : "") + member;
    line += " }";
    const Found found = read_line(line);
    INFO(found.submission.text);
    REQUIRE(found.submission.text.size() == line.size());
    CHECK(found.submission.submitted == parse_time("2026-10-01T21:59:00Z"));
    CHECK(found.submission.source == "x,y");
    const auto read = JsonDocument::parse("", found.submission.text);
    REQUIRE(read);
    CHECK(read->root().keys.size() == 2);
    CHECK(found.submission.text.find("\"schema\"") == line.find("\"schema\""));
  } while (std::ranges::next_permutation(members).found);
}

TEST_CASE("a line that is nobody's says why", "[lines]") {
  const auto nobodys = [](const std::string& line) {
    CHECK(read_line(line).keys.empty());
    return problem(line);
  };
  CHECK(nobodys("") == "the document is empty; expected a value");
  CHECK(nobodys("[1, 2]") == "must be an object with the key \"student\"");
  CHECK(nobodys("{") == "the document ends too early; expected a key in double quotes");
  CHECK(nobodys(R"({"student": "s17"} x)") == "unexpected \"x\"; expected the end of the document");
  CHECK(nobodys("{}") == "missing key \"student\"");
  CHECK(nobodys(R"({"students": "s17"})") == "missing key \"student\"");
  CHECK(nobodys(R"({"student": 17})") == "\"student\": must be a string");
  CHECK(nobodys(R"({"student": null})") == "\"student\": must be a string");
  CHECK(nobodys(R"({"student": ""})") == "\"student\" must be the ID of a student, not \"\"");
  CHECK(nobodys(R"({"student": "a\nb"})") == "\"student\" must be the ID of a student, not \"a\\x0Ab\"");
  CHECK(nobodys(R"({"student": "\q"})").starts_with("\"student\": line 1, column 3: an unknown escape"));
  CHECK(nobodys(R"({"student": "a", "student": "b"})") ==
        "duplicate key \"student\"; each key may stand once in an object");
  CHECK(nobodys(R"({"student": "a", "stud\u0065nt": "b"})") ==
        "duplicate key \"student\"; each key may stand once in an object");
  CHECK(nobodys(R"({"student": ")" + std::string(300, 'x') + "\"}").starts_with("\"student\" must be the ID"));
  CHECK(nobodys("{\"student\": \"\xFF\"}").find("invalid UTF-8") != std::string::npos);
}

TEST_CASE("a line of somebody that cannot be taken is theirs, with the reason", "[lines]") {
  const auto of_s17 = [](const std::string& rest, const SourceLimits& limits = {}) {
    const std::string line = R"({"student": "s17", )" + rest + "}";
    CHECK(read_line(line, limits).keys == std::vector<StudentKey>{{"s17"}});
    return problem(line, limits);
  };
  CHECK(of_s17(R"("submission": 3)") == "\"submission\" must be the answers file, as an object or as a string");
  CHECK(of_s17(R"("submission": [])") == "\"submission\" must be the answers file, as an object or as a string");
  CHECK(of_s17(R"("submission": {}, "submited": "x")") == "unknown key \"submited\"; did you mean \"submitted\"?");
  CHECK(of_s17(R"("submission": {}, "term": "x")") ==
        R"(unknown key "term"; the keys beside "submission" are "student", "submitted" and "source")");
  CHECK(of_s17(R"("submission": {}, "submitted": "yesterday")") ==
        "\"submitted\" must be a time with its offset from UTC such as \"2026-10-01T23:59:00+02:00\", not "
        "\"yesterday\"");
  CHECK(of_s17(R"("submission": {}, "source": 3)") == "\"source\": must be a string");
  const std::string large = R"("submission": ")" + std::string(101, 'x') + "\"";
  CHECK(of_s17(large, {100}) == "too large; a submission has at most 100 bytes");
  CHECK(of_s17(R"("answers": ")" + std::string(101, 'x') + "\"", {100}).starts_with("too large"));
  CHECK(problem(std::string(4297, ' '), {100}) == "too long; a line has at most 4296 bytes");
}

TEST_CASE("no line of random members gets past the reader without a student or a problem", "[lines]") {
  const unsigned seed = 4;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  const std::vector<std::string> members = {R"("student":"s17")",   R"("submission": {"a": ["]", 1]})",
                                            R"("submission": "x")", R"("submitted": "2026-10-01T21:59:00Z")",
                                            R"("source": "\"")",    R"("stud\u0065nt": "s17")",
                                            R"("answers": {})",     R"("a": [{"student": "s18"}])"};
  const std::string pieces = std::string("{}[],:\"\\ 1\xFF\r", 12) + '\0';
  int somebodys = 0;
  for (int i = 0; i < 50'000; ++i) {
    std::string line = "{";
    for (std::size_t n = random() % 4; n > 0; --n) line += members[random() % members.size()] + (n > 1 ? ", " : "");
    line += "}";
    for (std::size_t n = random() % 3; n > 0; --n) {
      const std::size_t at = random() % line.size();
      line.replace(at, random() % 2, random() % 3, pieces[random() % pieces.size()]);
      if (line.empty()) line = "{";
    }
    const Found found = read_line(line);
    INFO(line);
    REQUIRE((found.keys.size() == 1 || !found.submission.problem.empty()));
    REQUIRE((found.submission.problem.empty() || found.submission.text.empty()));
    // Whatever is JSON with a student is somebody's.
    const auto read = JsonDocument::parse("", line);
    if (read && read->root().kind == Json::Kind::object && read->root().find("student") != nullptr &&
        read->root().find("student")->text == "s17") {
      REQUIRE(found.keys == std::vector<StudentKey>{{"s17"}});
      ++somebodys;
    }
  }
  CHECK(somebodys > 1000);
}

TEST_CASE("a file of lines: blank ones skipped, bad ones told with their number, the last without an end", "[lines]") {
  const Folder folder;
  const std::string good = R"({"student": "s1", "submission": {}})";
  const std::string path = folder.write(
      "class.jsonl", "\xEF\xBB\xBF" + good + "\r\n\n \t\r\nnonsense\n{\"student\": \"s2\"," + std::string(5000, ' ') +
                         "\"submission\":{}}\n" + std::string(200'000, 'x') + "\n" + good);
  CHECK(lines_of(read_all(path, {100})) ==
        "s1 < : {}\n"
        " <  ! line 4: unexpected \"nonsense\"; expected a value: a number, a \"string\", [...], {...}, true, false or "
        "null\n"
        " <  ! line 5: too long; a line has at most 4296 bytes\n"
        " <  ! line 6: too long; a line has at most 4296 bytes\n"
        "s1 < : {}\n");
  const auto source = open_submissions(path);
  CHECK((*source)->progress() == 0.0);
  read_all(**source);
  CHECK((*source)->progress() == 1.0);
  CHECK(read_all(folder.write("empty.jsonl", "")).found.empty());
  CHECK(read_all(folder.write("long.jsonl", std::string(300'000, 'x'))).found.size() == 1);
}

TEST_CASE("lines come whole wherever the reader's buffer ends", "[lines]") {
  const Folder folder;
  std::string text;
  std::vector<std::string> students;
  for (int i = 0; i < 5000; ++i) {
    students.push_back("s" + std::to_string(i));
    text += R"({"student": ")" + students.back() + R"(", "submission": ")" + std::string(i % 97, 'x') + "\"}\n";
  }
  const Everything all = read_all(folder.write("class.jsonl", text));
  REQUIRE(all.found.size() == students.size());
  for (std::size_t i = 0; i < students.size(); ++i) {
    REQUIRE(all.found[i].keys.front().text == students[i]);
    REQUIRE(all.found[i].submission.text.size() == i % 97);
  }
}

TEST_CASE("a folder: whose it is by the first name of the path, in the order of names", "[folder]") {
  const Folder folder;
  folder.put("s2.json", "two");
  folder.put("s10/deeper/b.JSON", "b");
  folder.put("s10/a.json", "a");
  folder.put("s1.json", "");
  folder.put("lovelaceada_LATE_4711_99_a.json", "canvas, late");
  folder.put("lovelaceada_4711_99_4712_100_a.json", "canvas");
  folder.put("Ada Lovelace_4711_assignsubmission_file_/a.json", "moodle");
  for (const char* clutter : {".DS_Store", ".git/config.json", "__MACOSX/s1.json", "Thumbs.db", "s10/.hidden.json"})
    folder.put(clutter, "x");
  fs::create_directories(folder / "empty");
  CHECK(lines_of(read_all(folder.path())) ==
        "Ada Lovelace_4711_assignsubmission_file_|#4711 < "
        "Ada Lovelace_4711_assignsubmission_file_/a.json: moodle\n"
        "lovelaceada_4711_99_4712_100_a|#4711 < lovelaceada_4711_99_4712_100_a.json: canvas\n"
        "lovelaceada_LATE_4711_99_a|#4711 < lovelaceada_LATE_4711_99_a.json: canvas, late\n"
        "s1 < s1.json: \n"
        "refused s10 < s10/.hidden.json ! not read: its name begins with a point, which hides it\n"
        "s10 < s10/a.json: a\n"
        "s10 < s10/deeper/b.JSON: b\n"
        "s2 < s2.json: two\n");
}

TEST_CASE("a name that somebody chose does not make them somebody else", "[folder]") {
  const Folder folder;
  folder.put("Eve_4712_assignsubmission_file__4711_assignsubmission_file_/a.json", "moodle");
  folder.put("eve_4711_x_4712_99_a.json", "canvas");
  folder.put("s17/s18.json", "another's name inside");
  folder.put("_4711_assignsubmission_file_/a.json", "no name");
  folder.put("x_17_18_y_4711_assignsubmission_file_/a.json", "a full name like Canvas's names");
  folder.put("x_17_18_y_4711_assignsubmission_file_a.json", "the same as a file");
  folder.put("bob_17_99_a_4711_assignsubmission_file_.json", "Canvas's, with a name like Moodle's");
  folder.put("bob_17_99_a/a.json", "Canvas has no folders");
  CHECK(lines_of(read_all(folder.path())) ==
        "Eve_4712_assignsubmission_file__4711_assignsubmission_file_ < "
        "Eve_4712_assignsubmission_file__4711_assignsubmission_file_/a.json: moodle\n"
        "_4711_assignsubmission_file_ < _4711_assignsubmission_file_/a.json: no name\n"
        "bob_17_99_a < bob_17_99_a/a.json: Canvas has no folders\n"
        "bob_17_99_a_4711_assignsubmission_file_ < bob_17_99_a_4711_assignsubmission_file_.json: Canvas's, with a name "
        "like Moodle's\n"
        "eve_4711_x_4712_99_a < eve_4711_x_4712_99_a.json: canvas\n"
        "s17 < s17/s18.json: another's name inside\n"
        "x_17_18_y_4711_assignsubmission_file_|#4711 < x_17_18_y_4711_assignsubmission_file_/a.json: a full name like "
        "Canvas's names\n"
        "x_17_18_y_4711_assignsubmission_file_a < x_17_18_y_4711_assignsubmission_file_a.json: the same as a file\n");
}

TEST_CASE("in a folder nothing is followed, nothing waited for, and all that is not read is told", "[folder]") {
  const Folder outside, folder;
  outside.put("secret.json", "secret");
  folder.put("s1/a.json", "a");
  fs::create_symlink(outside / "secret.json", folder / "s1/b.json");
  fs::create_symlink(outside.path(), folder / "s2");
  fs::create_symlink(".", folder / "s3");
  REQUIRE(mkfifo((folder / "s4.json").c_str(), 0600) == 0);
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{AF_UNIX, {}};
  const std::string name = folder / "s5.json";
  name.copy(address.sun_path, sizeof address.sun_path - 1);
  REQUIRE(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
  ::close(socket);
  folder.put("s6/a.txt", "text");
  folder.put("s7.json", std::string(101, 'x'));
  folder.put("s8.json", std::string(100, 'x'));
  folder.put("s9\n\x1B[31m.json", "coloured");
  folder.put("sA\xFF.json", "no UTF-8");
  fs::create_hard_link(folder / "s1/a.json", folder / "sB.json");
  CHECK(lines_of(read_all(folder.path(), {100})) ==
        "s1 < s1/a.json: a\n"
        "refused s1 < s1/b.json ! not read: a symbolic link\n"
        "refused s2 < s2 ! not read: a symbolic link\n"
        "refused s3 < s3 ! not read: a symbolic link\n"
        "refused s4 < s4.json ! not read: a pipe\n"
        "refused s5 < s5.json ! not read: a socket\n"
        "refused s6 < s6/a.txt ! not read: the name of a submission ends in .json\n"
        "s7 < s7.json ! too large; a submission has at most 100 bytes\n"
        "s8 < s8.json: " +
            std::string(100, 'x') +
            "\n"
            "s9\\x0A\\x1B[31m < s9\\x0A\\x1B[31m.json: coloured\n"
            "sA\\xFF < sA\\xFF.json: no UTF-8\n"
            "sB < sB.json: a\n");
}

TEST_CASE("a folder has at most so many entries and so many folders inside each other", "[folder]") {
  const Folder folder;
  folder.put("s1/2/3/a.json", "deep");
  folder.put("s1/2/b.json", "less deep");
  SourceLimits limits;
  limits.depth = 2;
  CHECK(lines_of(read_all(folder.path(), limits)) ==
        "refused s1 < s1/2/3 ! not read: more than 2 folders inside each other\n"
        "s1 < s1/2/b.json: less deep\n");
  limits.entries = 3;
  for (int i = 0; i < 3; ++i) folder.put("s2/" + std::to_string(i) + ".json", "x");
  const Everything all = read_all(folder.path(), limits);
  CHECK(all.failure == "more than 3 entries; nothing of \"s1/2/\" and what follows was read");
}

TEST_CASE("a file without permission is somebody's, unread; its time is when it was handed in", "[folder]") {
  const Folder folder;
  const std::string path = folder.put("s1.json", "x");
  const timespec times[2] = {{1'790'000'000, 0}, {1'790'000'000, 999}};
  REQUIRE(::utimensat(AT_FDCWD, path.c_str(), times, 0) == 0);
  CHECK(read_all(folder.path()).found.at(0).submission.submitted == Time(std::chrono::seconds(1'790'000'000)));
  ::chmod(path.c_str(), 0);
  if (::access(path.c_str(), R_OK) != 0)
    CHECK(lines_of(read_all(folder.path())) == "s1 < s1.json ! cannot be read: Permission denied\n");
}

TEST_CASE("what is no folder, archive or JSON Lines is not opened", "[source]") {
  const Folder folder;
  REQUIRE(mkfifo((folder / "pipe.jsonl").c_str(), 0600) == 0);
  folder.write("answers.json", "{}");
  CHECK_FALSE(open_submissions(folder / "absent"));
  CHECK_FALSE(open_submissions(folder / "pipe.jsonl"));
  CHECK_FALSE(open_submissions("/dev/zero"));
  CHECK_FALSE(open_submissions(folder / "answers.json"));
}
