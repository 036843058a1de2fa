// The sliders of a lesson's page in a browser: moved to each of their stops, and compared with the run of these
// numbers.
#define BLOSSOM_BIN_DIR ""
#include <set>

#include "base/json_write.hpp"
#include "export/lesson_page.hpp"
#include "export/slider_stops.hpp"
#include "lesson/slider_check.hpp"
#include "scene/panels.hpp"
#include "scene/scheme.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

// Two sliders; a knot that may come in where there are two already but for the middle of the slider; a question.
const char* const moved_lesson = R"({
  "schema": "blossom.lesson/1", "id": "moved", "title": "Moved",
  "scenes": [
    {"id": "two", "title": "Two sliders", "algorithm": "de_casteljau",
     "inputs": {"curve": {"degree": 2, "points": [[0, 0], [2, 4], [4, 0]]}, "u": "1/4"},
     "beats": [
       {"at": "start", "say": "It begins.",
        "sliders": [{"input": "u", "from": 0, "to": 1, "step": "1/2"},
                    {"input": "curve.points[1][1]", "from": 0, "to": 40, "step": 10, "label": "y of P_1"}],
        "checkpoint": {"id": "end", "kind": "predict", "value": "C", "ask": "Where does it end for u = {u}?"}},
       {"at": "P[1][0]", "say": "The first point is {value}.", "highlight": ["P[0][0..1]"]},
       {"at": "C", "say": "C = {C} for u = {u}.",
        "sliders": [{"input": "curve.points[1][1]", "from": 0, "to": 40, "step": 10, "label": "y of P_1"},
                    {"input": "u", "from": 0, "to": 1, "step": "1/2"}]}]},
    {"id": "gap", "title": "A gap", "algorithm": "knot_insertion",
     "inputs": {"curve": {"degree": 2, "knots": [0, 0, 0, 1, 1, 2, 2, 2],
                          "points": [[0, 0], [2, 8], [8, 8], [12, 2], [14, 6]]}, "u": "1/2"},
     "beats": [{"at": "k", "say": "The span is {k}, for u = {u}.",
                "sliders": [{"input": "u", "from": "1/2", "to": "3/2", "step": "1/4"}]}]}]
})";

const Json& inputs_of(const JsonDocument& document, const Lesson& lesson, std::size_t scene) {
  const Json* scenes = document.root().find("scenes");
  return *(lesson.scene_count() > 1 || scenes != nullptr ? scenes->items[scene] : document.root()).find("inputs");
}

// What the lesson says at a beat when its file has other inputs; "null" if it cannot be run so.
std::string fact_of(const Lesson& lesson, std::size_t which, const Beat& beat, const Json& inputs) {
  Lesson moved = lesson;
  static_cast<LessonScene&>(moved) = lesson.scene_at(which);
  moved.others.clear();
  const auto document = JsonDocument::parse("", write_json(inputs));
  REQUIRE(document);
  Diagnostics unused;
  auto read = read_inputs(*moved.algorithm, Cursor(*document, unused));
  if (!read) return "null";
  moved.inputs = *std::move(read);
  const auto story = make_story(moved, {});
  if (!story) return "null";
  const StoryScene& scene = story->scenes[0];
  const StepSource& source = scene.source();
  for (const StoryStep& told : scene.steps) {
    if (told.beat == nullptr || !(told.beat->at == beat.at) || !(told.beat->say == beat.say)) continue;
    std::string fact = "{\"say\":" + json_quote(letters_of(told.prose, source.algorithm_at(told.step)));
    const ValueId v = source.graph->main_value(told.step);
    if (v != absent && !source.graph->is_input(v))
      fact += ",\"value\":" + json_quote(without_blanks(source.value_text(v)));
    std::string values;
    const auto add = [&](ValueId id) {
      const std::string text = without_blanks(source.value_text(id));
      if (text.size() < 40)
        values += (values.empty() ? "" : ",") + ("[" + std::to_string(id) + "," + json_quote(text) + "]");
    };
    if (const Scheme* scheme = scheme_at(source, told.step)) {
      for (const auto& cell : scheme->cells) add(cell.value);
      return fact + ",\"cells\":[" + values + "]}";
    }
    Sheet table;
    add_value_table(table, source, told.step, {}, 0, 0, 760);
    for (const Spot& spot : table.spots) add(spot.link.id);
    return fact + ",\"rows\":[" + values + "]}";
  }
  return "null";
}

// Of each step with sliders what the run says at each of their stops: [{"scene", "at", "values": [[text]], "facts"}].
std::string cases_of(const JsonDocument& document, const Lesson& lesson, const Story& story) {
  const SliderStops plan(story);
  std::string cases;
  for (std::size_t s = 0; s < story.scenes.size(); ++s)
    for (std::size_t i = 0; i < story.scenes[s].steps.size(); ++i) {
      const StoryStep& step = story.scenes[s].steps[i];
      const StepSliders* sliders = plan.of(step);
      if (sliders == nullptr) continue;
      std::string values, facts;
      for (const auto& scale : sliders->scales) {
        std::string texts;
        for (const Exact& x : scale.values) texts += (texts.empty() ? "" : ",") + json_quote(x.to_string());
        values += (values.empty() ? "[" : ",[") + texts + "]";
      }
      for (std::size_t stop = 0; stop < sliders->count(); ++stop) {
        Json inputs = inputs_of(document, lesson, s);
        for (std::size_t k = 0; k < sliders->scales.size(); ++k)
          *find_number(inputs, step.beat->sliders[k].input) = json_number(sliders->values(stop)[k]);
        facts += (facts.empty() ? "" : ",") + fact_of(lesson, s, *step.beat, inputs);
      }
      cases += (cases.empty() ? "" : ",") + ("{\"scene\":" + std::to_string(s) + ",\"at\":" + std::to_string(i) +
                                             ",\"own\":" + std::to_string(sliders->own()) + ",\"values\":[" + values +
                                             "],\"facts\":[" + facts + "]}");
    }
  return "[" + cases + "]";
}

const char* const probe = R"js(
const squeeze = (text) => text.replace(/\s+/g, "");
const $ = (selector) => document.querySelector(selector);
const bar = $(".bar input"), where = $(".bar output");
const go = (scene, at) => {
  $(`.scenes button[data-scene="${scene}"]`)?.click();
  bar.value = at;
  bar.dispatchEvent(new Event("input"));
};
const inputs = () => [...document.querySelectorAll(".sliders input")];
const move = (input, to) => { input.value = to; input.dispatchEvent(new Event("input")); };
const seen = () => [".told", ".card.formula", ".card.scheme", "#picture"].map((each) => $(each).innerHTML).join();
const placed = ({values}, stop) => values.map((list, i) => {
  const after = values.slice(i + 1).reduce((count, each) => count * each.length, 1);
  return Math.floor(stop / after) % list.length;
});

for (const each of cases) {
  go(each.scene, each.at);
  const own = seen(), place = where.textContent, question = $(".question").innerHTML;
  const words = $(".told .say").textContent;
  check("there are sliders", !$(".sliders").hidden && inputs().length === each.values.length);
  check("they are named", inputs().every((input) => input.getAttribute("aria-label").length > 0));
  check("not moved at first", $(".away").hidden);
  inputs().forEach((input, i) => check("begins at " + input.value, +input.value === placed(each, each.own)[i]));
  if (question && $(".question input")) $(".question input").value = "7";
  const different = new Set();
  each.facts.forEach((fact, stop) => {
    const at = `scene ${each.scene}, step ${each.at}, stop ${stop}: `;
    const to = placed(each, stop);
    // From the lesson's own numbers, where the stop of each slider alone may have no step.
    if (fact === null && each.values.length === 1) {
      move(inputs()[0], to[0]);
      check(at + "is passed over", inputs()[0].value != to[0] && each.facts[inputs()[0].value] !== null);
      fact = each.facts[inputs()[0].value];
    } else {
      inputs().forEach((input, i) => move(input, to[i]));
    }
    if (fact === null) return;
    inputs().forEach((input, i) => {
      const text = each.values[i][input.value];
      check(at + "number", input.getAttribute("aria-valuetext") === text);
      check(at + "number seen", input.closest(".slider").querySelector("b").textContent === text);
    });
    const said = squeeze($(".told .say").textContent);
    if (fact.say) check(at + `words: ${said} is not ${fact.say}`, said === fact.say);
    const value = $(".card.formula .value");
    check(at + "a formula where something is made", (value !== null) === (fact.value !== undefined));
    if (value && fact.value.length < 200) check(at + "value " + value.textContent, squeeze(value.textContent).endsWith("=" + fact.value));
    for (const [v, text] of fact.cells ?? []) {
      const cell = $(`.card.scheme td[data-v="${v}"] > div > span`);
      check(at + `cell ${v}: ${cell?.textContent} is not ${text}`, cell && squeeze(cell.textContent) === text);
    }
    if (fact.rows) {
      const rows = [...document.querySelectorAll(".card.scheme table.values td")].map((cell) => squeeze(cell.textContent));
      for (const [, text] of fact.rows) check(at + `row ${text}`, rows.includes(text));
    }
    const moved = stop !== each.own;
    if (placed(each, stop).every((wanted, i) => +inputs()[i].value === wanted)) {
      check(at + "the question", $(".question").hidden === moved);
      check(at + "the way back", $(".away").hidden !== moved);
    }
    check(at + "the step", where.textContent === place);
    check(at + "the picture's name", !words || $("#picture").getAttribute("aria-label").includes($(".told .say").textContent.trim().slice(0, 8)));
    check(at + "something is drawn", $("#picture").querySelectorAll("path, circle").length >= 3);
    check(at + "not wider than the window", document.documentElement.scrollWidth <= innerWidth);
    different.add(seen());
  });
  check("what is seen differs", different.size > 2);

  // Back by its button, and by leaving.
  const away = (each.own + 1) % each.facts.length;
  const out = () => inputs().forEach((input, i) => move(input, placed(each, away)[i]));
  out();
  check("moved", !$(".away").hidden && $(".told").getAttribute("aria-live") === "off");
  $(".away button").click();
  check("back to the lesson's numbers", seen() === own && $(".away").hidden);
  check("the focus stays", document.activeElement === inputs()[0]);
  if (question && $(".question input")) check("what was typed stays", $(".question input").value === "7");
  out();
  const other = each.at > 0 ? "back" : "next";
  $(`.bar button[data-go=${other}]`).click();
  check("another step", where.textContent !== place && $(".told").getAttribute("aria-live") === "polite");
  $(`.bar button[data-go=${other === "back" ? "next" : "back"}]`).click();
  check("the lesson's own numbers again", seen() === own && $(".away").hidden);

  // Keys and fingers on a slider are the slider's.
  const input = inputs()[0];
  for (const key of ["ArrowLeft", "ArrowRight", "ArrowUp", "Home", "End", "PageUp", "PageDown"]) {
    const event = new KeyboardEvent("keydown", {key, bubbles: true, cancelable: true});
    input.dispatchEvent(event);
    check(key + " is the slider's", !event.defaultPrevented && where.textContent === place);
  }
  const touch = (x) => new Touch({identifier: 1, target: input, clientX: x, clientY: 100});
  input.dispatchEvent(new TouchEvent("touchstart", {touches: [touch(200)], changedTouches: [touch(200)], bubbles: true}));
  input.dispatchEvent(new TouchEvent("touchend", {changedTouches: [touch(80)], bubbles: true}));
  check("a finger on the slider does not step", where.textContent === place);

  // On paper the lesson's own numbers stand, whatever is shown.
  out();
  dispatchEvent(new Event("beforeprint"));
  check("every scheme is in print", document.querySelectorAll(".parts table.scheme").length === schemes);
  dispatchEvent(new Event("afterprint"));
  check("still moved after print", each.facts[away] === null || !$(".away").hidden);
}
const report = document.createElement("pre");
report.id = "findings";
report.textContent = `checks ${checks} stops ${cases.reduce((count, each) => count + each.facts.length, 0)}\n` + found.join("\n");
(window.frameElement ? parent.document : document).body.append(report);
)js";

struct Loaded {
  JsonDocument document;
  Lesson lesson;
  Story story;
};

Loaded loaded(Checked<JsonDocument> document) {
  REQUIRE(document);
  auto lesson = load_lesson(*document);
  INFO(to_string(lesson.diagnostics));
  REQUIRE(lesson);
  auto story = make_story(*lesson, {});
  REQUIRE(story);
  return {std::move(*document), std::move(*lesson), std::move(*story)};
}
Loaded loaded(const std::string& name) {
  return loaded(name.empty() ? JsonDocument::parse("moved.json", moved_lesson)
                             : JsonDocument::load("lessons/" + name + ".json"));
}

std::vector<std::string> notes_of(const Story& story) {
  const Scratch scratch;
  LessonExportOptions options;
  options.theme = &light_theme();
  const auto exported = find_lesson_format("html")->write(story, scratch / "page.html", options);
  REQUIRE(exported);
  return exported->notes;
}

}  // namespace

TEST_CASE("in a browser, sliders show what the run of their numbers shows", "[export][html][sliders]") {
  const std::string browser = chromium();
  if (browser.empty()) {
    WARN("test skipped: chromium is not installed");
    return;
  }
  // Questions beside sliders, a triangular scheme, tables of values, two and three sliders, one with a gap.
  const std::string name = GENERATE("", "01-parametric-curves", "22-de-boor", "42-weights", "80-blossoms");
  const std::string window = name == "22-de-boor" ? "360,740" : "1280,800";
  const Loaded shown = loaded(name);
  const std::string page = page_of(shown.story), own = page.substr(0, page.find("<template class=\"stop\">"));
  const std::string script = std::string(probe_start) +
                             "const cases = " + cases_of(shown.document, shown.lesson, shown.story) +
                             ", schemes = " + std::to_string(count_of(own, "<table class=\"scheme\"")) + ";" + probe;
  const Ended ended = browse(browser, with_probe(page, script), window);
  const std::string findings = between(ended.out, "<pre id=\"findings\">", "</pre>");
  CAPTURE(name, findings);
  std::smatch numbers;
  REQUIRE(std::regex_search(findings, numbers, std::regex("checks ([0-9]+) stops ([0-9]+)")));
  CHECK(std::stoi(numbers[2]) >= 4);
  CHECK(std::stoi(numbers[1]) > 8 * std::stoi(numbers[2]));
  CHECK_FALSE(contains(findings, "FAULT"));
}

TEST_CASE("sliders stop at their ends and at the lesson's number, evenly and not too often", "[export][sliders]") {
  const auto scales = [](const std::string& sliders, const std::string& u = "1/4") {
    const Story story = story_of(R"({"schema": "blossom.lesson/1", "id": "x", "title": "x", "algorithm": "de_casteljau",
      "inputs": {"curve": {"degree": 1, "points": [[0, 0], [2, 4]]}, "u": ")" +
                                 u + R"("}, "beats": [{"at": "end", "say": "x", "sliders": [)" + sliders + "]}]}");
    std::vector<std::string> texts;
    const SliderStops stops(story);
    for (const auto& scale : stops.of(story.scenes[0].steps.back())->scales) {
      std::string text;
      for (std::size_t i = 0; i < scale.values.size(); ++i)
        text += (i == 0 ? "" : " ") + std::string(i == scale.own ? "*" : "") + scale.values[i].to_string();
      texts.push_back(text);
    }
    return texts;
  };
  CHECK(scales(R"({"input": "u", "from": 0, "to": 1, "step": "1/4"})")[0] == "0 *1/4 1/2 3/4 1");
  CHECK(scales(R"({"input": "u", "from": 0, "to": 1, "step": "1/2"})")[0] == "0 *1/4 1/2 1");
  CHECK(scales(R"({"input": "u", "from": 0, "to": 1, "step": "2/5"})")[0] == "0 *1/4 2/5 4/5 1");
  // Every fourth hundredth; every eighth of a step that is too fine.
  CHECK(scales(R"({"input": "u", "from": 0, "to": 1})", "1/25")[0].starts_with("0 *1/25 2/25 3/25 4/25 1/5 "));
  const std::string fine = scales(R"({"input": "u", "from": 0, "to": 1, "step": "1/256"})", "1/32")[0];
  CHECK(fine.starts_with("0 *1/32 1/16 3/32 "));
  CHECK(std::ranges::count(fine, ' ') == 32);
  const std::string finest = scales(R"({"input": "u", "from": 0, "to": 1, "step": 1e-300})")[0];
  CHECK(std::ranges::count(finest, ' ') <= 32);
  CHECK(scales(R"({"input": "u", "from": 0, "to": 1, "step": 1e-9})")[0].ends_with(" 1"));
  // 17 stops of two sliders are too many.
  const std::string x = R"({"input": "curve.points[1][0]", "from": 0, "to": 4, "step": "1/4"})";
  const auto two = scales(R"({"input": "u", "from": 0, "to": 1, "step": "1/16"}, )" + x);
  CHECK(two[0] == "0 1/8 *1/4 3/8 1/2 5/8 3/4 7/8 1");
  CHECK(two[1] == "0 1/2 1 3/2 *2 5/2 3 7/2 4");
  const std::string y = R"({"input": "curve.points[0][1]", "from": -1, "to": 1, "step": "1/3"})";
  const std::string z = R"({"input": "curve.points[0][0]", "from": -1, "to": 1, "step": "1/3"})";
  for (const std::string& text : scales(x + "," + y + "," + z + R"(, {"input": "u", "from": 0, "to": 1})"))
    CHECK(std::ranges::count(text, ' ') == 2);
}

TEST_CASE("a page says what its sliders cannot do", "[export][html][sliders]") {
  CHECK(notes_of(story_of(short_lesson)).empty());
  const auto gap = notes_of(loaded("").story);
  REQUIRE(gap.size() == 1);
  CHECK(gap[0] ==
        "its sliders pass over 1 of 50 stops, where the run fails, takes too long or does not come to the same beat");
  const auto coarse = notes_of(loaded("01-parametric-curves").story);
  REQUIRE(coarse.size() == 1);
  CHECK(contains(coarse[0], "the sliders of one step stop at fewer numbers than in the window"));
}

TEST_CASE("a lesson with sliders at every step is written with a bounded number of runs", "[export][html][sliders]") {
  std::string points;
  for (int i = 0; i <= 25; ++i) points += (i == 0 ? "[" : ",[") + std::to_string(i) + ",1]";
  const Story story = story_of(R"({"schema": "blossom.lesson/1", "id": "x", "title": "x", "algorithm": "de_casteljau",
    "inputs": {"curve": {"degree": 25, "points": [)" +
                               points + R"(]}, "u": "1/4"}, "beats": [{"at": {"every": "P[*][*]"}, "say": "{value}",
    "sliders": [{"input": "u", "from": 0, "to": 1, "step": "1/10"}]}]})");
  SliderStops stops(story);
  CHECK(stops.count() <= 600);
  CHECK(contains(notes_of(story).back(), "are left out: a page holds at most 600 runs"));
  std::size_t told = 0, of = 0;
  const Scratch scratch;
  LessonExportOptions options;
  options.theme = &light_theme();
  options.progress = [&](std::size_t done, std::size_t all) {
    CHECK(done == ++told);
    of = all;
    return done < 40;
  };
  const auto exported = find_lesson_format("html")->write(story, scratch / "page.html", options);
  CHECK_FALSE(exported);
  CHECK(told == 40);
  CHECK(of == story.step_count() + 2 * stops.count());
  CHECK(scratch.count() == 0);
}
