// Texts in several languages.

#include "lesson/local_text.hpp"

#include "base/json_write.hpp"
#include "lesson_text.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

const std::string two = R"({"schema": "blossom.lesson/1", "id": "a", "language": "de", "languages": ["en", "fr"],
"title": {"de": "Titel", "en": "Title", "fr": "Titre"}, )";

}  // namespace

TEST_CASE("a text is shown in the language that is asked for, and else in the lesson's own") {
  const auto lesson =
      lesson_of(R"({"at": "end", "say": {"de": "Punkt {C}", "en": "point {C}", "fr": "point {C}"}})", parabola, two);
  CHECK(lesson.title.own() == "Titel");
  CHECK(lesson.title.in("en") == "Title");
  CHECK(lesson.title.in("pt") == "Titel");
  CHECK(lesson.title.in("") == "Titel");
  CHECK(lesson.title.has("fr"));
  CHECK_FALSE(lesson.title.has("pt"));
  const auto run = record<Exact>(*lesson.algorithm, lesson.inputs);
  const Narrator<Exact> narrator(*run);
  CHECK(lesson.narration(narrator, 4) == "Punkt (1, 3/2)");
  CHECK(lesson.narration(narrator, 4, "en") == "point (1, 3/2)");
  CHECK(lesson.narration(narrator, 4, "pt") == "Punkt (1, 3/2)");
}

TEST_CASE("a plain text is in the lesson's own language, which is English unless it is said") {
  const auto lesson = lesson_of(beat("\"start\"", "Look."));
  CHECK(lesson.languages.own == "en");
  CHECK(lesson.languages.others.empty());
  CHECK(lesson.title.in("en") == "A lesson");
  CHECK(LocalText().empty());
  CHECK(LocalText().in("de").empty());
}

TEST_CASE("missing translations are named, and languages that were not promised") {
  CHECK(mistakes("{\"at\": \"start\", \"say\": \"Schau.\"},\n"
                 "{\"at\": \"P[1][0]\", \"say\": {\"de\": \"Schau.\", \"en\": \" \", \"es\": \"Mira.\"}},\n"
                 "{\"at\": \"P[1][1]\", \"say\": {\"en\": \"Look.\", \"fr\": \"Vois.\"}},\n"
                 "{\"at\": \"end\", \"say\": {\"German\": \"Schau.\", \"de\": \"Schau.\", \"en\": \"{X}\", \"fr\": "
                 "\"\"}}",
                 parabola, two) ==
        "lesson.json:4:34: beats[0].say: has no text in \"en\", which \"languages\" promises\n"
        "lesson.json:4:34: beats[0].say: has no text in \"fr\", which \"languages\" promises\n"
        "lesson.json:5:26: beats[1].say: has no text in \"fr\", which \"languages\" promises\n"
        "lesson.json:5:49: beats[1].say.en: must not be empty\n"
        "lesson.json:5:54: beats[1].say: the lesson is not in \"es\"; \"languages\" says which it is in\n"
        "lesson.json:6:26: beats[2].say: must have a text in the lesson's own language, \"de\"\n"
        "lesson.json:7:23: beats[3].say: must be a language such as \"en\" or \"de\", not \"German\"\n"
        "lesson.json:7:65: beats[3].say.en: \"{X}\" names nothing at step 4; the values of this run are u, P[0][0..2], "
        "P[1][0..1], P[2][0], C\n"
        "lesson.json:7:78: beats[3].say.fr: must not be empty\n");
}

TEST_CASE("languages are named by two or three letters, each once") {
  CHECK(mistakes(beat("\"start\""), parabola,
                 R"({"schema": "blossom.lesson/1", "id": "a", "title": "T", "language": "English",
"languages": ["en-GB", "de", "de", 7], )")
            .find("\"English\"") != std::string::npos);
  const auto told = mistakes(beat("\"start\""), parabola,
                             R"({"schema": "blossom.lesson/1", "id": "a", "title": "T", "language": "English",
"languages": ["en-GB", 7], )");
  CHECK(told ==
        "lesson.json:1:69: language: must be a language such as \"en\" or \"de\", not \"English\"\n"
        "lesson.json:2:15: languages[0]: must be a language such as \"en\" or \"de\", not \"en-GB\"\n"
        "lesson.json:2:24: languages[1]: must be a string, not 7\n");
}

TEST_CASE("texts are written as they are read") {
  Languages languages{"en", {"de"}};
  const auto document = parsed(R"({"en": "A", "de": "B"})");
  Diagnostics diagnostics;
  const auto text = read_local_text(Cursor(document, diagnostics), languages);
  REQUIRE(text);
  CHECK(write_json(write_local_text(*text, languages)) == R"({"en": "A", "de": "B"})");
  CHECK(write_json(write_local_text(LocalText("A"), languages)) == "\"A\"");
}

TEST_CASE("mistakes in the languages themselves are told once, not at every text") {
  const std::string head = header + "\"languages\": [\"German\"], ";
  CHECK(mistakes("{\"at\": \"start\", \"say\": {\"en\": \"Look.\", \"de\": \"Schau.\"}}", parabola, head) ==
        "lesson.json:1:85: languages[0]: must be a language such as \"en\" or \"de\", not \"German\"\n");
}
