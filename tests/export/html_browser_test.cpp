// The page of a lesson in a browser, as a student sees it: clicked, typed and scrubbed through to the end, and compared
// with the run.
#define BLOSSOM_BIN_DIR ""
#include "base/json_write.hpp"
#include "export/lesson_page.hpp"
#include "scene/scheme.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

std::string list_of(const std::vector<ValueId>& values) {
  std::string list;
  for (const ValueId v : values) list += (list.empty() ? "" : ",") + std::to_string(v);
  return "[" + list + "]";
}

// Of each step what the run itself knows: [{"n", "say", "value", "line", "made": [cells], "later", "now", "from"}].
std::string facts_of(const Story& story) {
  std::string scenes;
  for (const StoryScene& scene : story.scenes) {
    const StepSource& source = scene.source();
    const TraceGraph& graph = *source.graph;
    std::string steps;
    for (const StoryStep& told : scene.steps) {
      const ValueId v = graph.main_value(told.step);
      const bool made = v != absent && !graph.is_input(v);
      std::string step = "{\"n\":" + std::to_string(told.step) + ",\"line\":" + std::to_string(source.line(told.step)) +
                         ",\"say\":" + json_quote(letters_of(told.prose, source.algorithm_at(told.step)));
      if (made) step += ",\"value\":" + json_quote(without_blanks(source.value_text(v)));
      if (told.line > 0) {
        std::string code(source.algorithm_at(told.step).pseudo_code[static_cast<std::size_t>(told.line) - 1]);
        step += ",\"code\":" + json_quote(without_blanks(code));
      }
      if (const Scheme* scheme = scheme_at(source, told.step)) {
        std::vector<ValueId> there, later, from;
        for (const auto& cell : scheme->cells)
          (graph.value(cell.value).step <= told.step ? there : later).push_back(cell.value);
        if (made)
          for (const ValueId o : graph.operands(v))
            if (scheme->find(o) != nullptr) from.push_back(o);
        step += ",\"there\":" + list_of(there) + ",\"later\":" + list_of(later) + ",\"from\":" + list_of(from);
        if (made && scheme->find(v) != nullptr) step += ",\"now\":" + std::to_string(v);
      }
      steps += (steps.empty() ? "" : ",") + step + "}";
    }
    scenes += (scenes.empty() ? "[" : ",[") + steps + "]";
  }
  return "[" + scenes + "]";
}

// Clicks and types as a student would, and writes what it found into the document. It is added to a copy of the page.
const char* const probe = R"js(
const squeeze = (text) => text.replace(/\s+/g, "");
const $ = (selector) => document.querySelector(selector);
const range = $(".bar input"), where = $(".bar output");
const lists = [...document.querySelectorAll("section.scene")].map((section) => [...section.querySelectorAll("ol.steps > li")]);
const click = (go) => $(`.bar button[data-go=${go}]`).click();
const key = (name) => document.body.dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true, cancelable: true }));
const ids = (selector) => [...document.querySelectorAll(".card.scheme " + selector)].map((cell) => +cell.dataset.v).sort((a, b) => a - b).join();
const sorted = (list) => [...list].sort((a, b) => a - b).join();

const shows = (s, i, how) => {
  const fact = facts[s][i], item = lists[s][i], last = facts[s].at(-1).n;
  const at = `${how}, scene ${s}, step ${fact.n}: `;
  check(at + "place " + where.textContent, where.textContent === `${fact.n} / ${last}`);
  check(at + "slider", +range.value === i);
  check(at + "the list's number", +item.dataset.step === fact.n);
  const said = squeeze($(".told .say").textContent);
  check(at + "words", said.length > 0 && said === squeeze(item.querySelector(".say").textContent));
  if (fact.say) check(at + `words of the run: ${said} is not ${fact.say}`, said === fact.say);
  check(at + "the picture's name", $("#picture").getAttribute("aria-label").includes($(".told .say").textContent.trim().split("\n")[0].slice(0, 12)));
  const value = $(".card.formula .value");
  check(at + "a formula where something is made", (value !== null) === (fact.value !== undefined));
  if (value && fact.value.length < 200) check(at + "value " + value.textContent, squeeze(value.textContent).endsWith("=" + fact.value));
  const marked = $(".card.code li[aria-current]");
  check(at + "line", fact.line === 0 ? !marked : marked && [...marked.parentNode.children].indexOf(marked) + 1 === fact.line);
  if (marked) check(at + "code", squeeze(marked.textContent) === fact.code);
  if (fact.there) {
    check(at + "cells that are there", ids("td[data-v]:not(.later)") === sorted(fact.there));
    check(at + "cells to come", ids("td.later") === sorted(fact.later));
    check(at + "operands", ids("td.from") === sorted(new Set(fact.from)));
    check(at + "the step's cell", ids("td.now") === (fact.now === undefined ? "" : String(fact.now)));
    if (fact.now !== undefined && fact.value.length < 40) check(at + "the cell's value", squeeze($("td.now > div > span").textContent) === fact.value);
  } else check(at + "no scheme", $(".card.scheme table.scheme") === null);
  check(at + "something is drawn", $("#picture").querySelectorAll("path, circle").length >= 3);
};

const lastScene = facts.length - 1, lastStep = facts[lastScene].length - 1;
check("the player is seen", $("#picture").getBoundingClientRect().height > 100);
for (let s = 0; s < facts.length; ++s)
  for (let i = 0; i < facts[s].length; ++i) {
    shows(s, i, "next");
    const frame = $("figure.picture").getBoundingClientRect();
    for (const text of document.querySelectorAll("#picture text.letters")) {
      const b = text.getBoundingClientRect();
      check(`label ${text.textContent} of step ${i} is inside`, b.left >= frame.left - 6 && b.right <= frame.right + 6);
    }
    check("not wider than the window at step " + i, document.documentElement.scrollWidth <= innerWidth);
    click("next");
  }
shows(lastScene, lastStep, "next at the end");
click("back");
if (lastStep > 0) shows(lastScene, lastStep - 1, "back");
key("End"); shows(lastScene, lastStep, "End");
key("Home"); shows(lastScene, 0, "Home");
if (lastStep > 0) { key("ArrowRight"); shows(lastScene, 1, "arrow right"); key("ArrowLeft"); shows(lastScene, 0, "arrow left"); }
if (lastScene > 0) {
  key("ArrowLeft"); shows(lastScene - 1, facts[lastScene - 1].length - 1, "arrow left into the scene before");
  $(".scenes button").click(); shows(0, 0, "the first tab");
}
while (!(range.value === "0" && (lastScene === 0 || $(".scenes button[aria-current]").dataset.scene === "0"))) click("back");
for (const i of [facts[0].length - 1, Math.floor(facts[0].length / 2), 0]) {
  range.value = i;
  range.dispatchEvent(new Event("input"));
  shows(0, i, "slider");
}
const beats = lesson_steps.flatMap((steps, s) => steps.flatMap((b, i) => (b ? [[s, i]] : [])));
for (const [s, i] of beats.filter(([s, i]) => s > 0 || i > 0)) { key("PageDown"); shows(s, i, "page down"); }
$(".scenes button")?.click();
key("Home");

const swipe = (by) => {
  const area = $("figure.picture");
  const touch = (x) => new Touch({ identifier: 1, target: area, clientX: x, clientY: 100 });
  area.dispatchEvent(new TouchEvent("touchstart", { touches: [touch(200)], changedTouches: [touch(200)], bubbles: true }));
  area.dispatchEvent(new TouchEvent("touchend", { changedTouches: [touch(200 + by)], bubbles: true }));
};
swipe(-80); shows(0, 1, "a swipe to the left");
swipe(-20); shows(0, 1, "a touch");
swipe(80); shows(0, 0, "a swipe to the right");

click("play");
check("it plays", $(".play").getAttribute("aria-label") !== $(".play").dataset.idle);
key(" ");
key("?");
check("help opens", $("#keys").open);
$("#keys").close();

$("#theme").click(); $("#theme").click();
check("dark", document.documentElement.dataset.theme === "dark");
check("dark paper", getComputedStyle(document.documentElement).backgroundColor === "rgb(20, 24, 31)");
$("#theme").click(); $("#theme").click();
check("as the system", document.documentElement.dataset.theme === undefined);

dispatchEvent(new Event("beforeprint"));
check("all is open in print", [...document.querySelectorAll("details")].every((each) => each.open));
check("each step has its picture in print", document.querySelectorAll("ol.steps > li > figure.print svg").length === lists.flat().length);
check("every scheme is in print", document.querySelectorAll(".parts table.scheme").length === schemes);
dispatchEvent(new Event("afterprint"));
shows(0, 0, "after print");
check("nothing stays of it", document.querySelectorAll("figure.print").length === 0);

// ---- questions ----
const form = () => $(".asked form"), verdict = () => $(".asked .feedback");
const type = (texts) => {
  [...form().querySelectorAll("input")].forEach((input, i) => { input.value = texts[i]; });
  form().requestSubmit();
};
const order = (letters) => {
  const list = form().querySelector(".order");
  for (const letter of letters)
    for (let i = 0; i < 9; ++i) {
      const item = list.querySelector(`[data-letter=${letter}]`);
      if (!item.nextElementSibling) break;
      item.querySelectorAll(".arrow")[1].click();
    }
  form().requestSubmit();
};
const give = (question, answer) => {
  if (question.kind === "choice" || question.kind === "line") form().querySelector(`[data-answer="${answer}"]`).click();
  else if (question.kind === "order") order(answer);
  else type(answer);
};
let blob = null;
URL.createObjectURL = (made) => { blob = made; return "#saved"; };
HTMLAnchorElement.prototype.click = function () { check("the file's name", this.download.endsWith("-answers.json")); };
const isShown = (question) => questions.indexOf(question) % 2 === 0;
for (const question of questions) {
  $(`.scenes button[data-scene="${question.scene}"]`)?.click();
  range.value = question.at;
  range.dispatchEvent(new Event("input"));
  const at = `question ${question.id}: `;
  check(at + "is asked", form() !== null);
  if (question.nonsense) { type(question.nonsense); check(at + "nonsense is no answer", verdict().classList.contains("open")); }
  give(question, question.wrong);
  check(at + "wrong: " + verdict().textContent, verdict().classList.contains("wrong"));
  if (question.says) check(at + "feedback: " + verdict().textContent, verdict().textContent.includes(question.says));
  if (isShown(question)) verdict().querySelector("[data-do=show]").click();
  for (const right of question.right) {
    give(question, right);
    check(at + "right: " + right + " " + verdict().textContent, verdict().classList.contains("right"));
  }
  click("next"); click("back");
  if (question.at + 1 < facts[question.scene].length) check(at + "is remembered", verdict().classList.contains("right"));
}
let kept = "{}";
try { kept = localStorage.getItem("blossom/answers/all-questions") ?? "{}"; } catch { kept = null; /* a frame has no store */ }
if (kept !== null && questions.length > 0) check("answers are kept", Object.keys(JSON.parse(kept)).length === questions.length);
const dots = [...document.querySelectorAll(".dots button")].map((dot) => dot.className).join();
// Whose answer was shown is not right by that.
check("a mark for each question: " + dots, questions.length === 0 || dots === questions.map((question) => isShown(question) ? "wrong" : "right").join());
check("a score where there are questions", $(".score").hidden === (document.querySelector(".ask") === null));
check("nothing was loaded", performance.getEntriesByType("resource").length === 0);
check("nothing of the lesson became a script or a link", document.querySelectorAll("script").length === 3 && !document.querySelector("a[href^=javascript], img, iframe") && window.x === undefined);
check("not wider than the window", document.documentElement.scrollWidth <= innerWidth);
const report = (saved) => {
  const made = document.createElement("pre");
  made.id = "findings";
  made.textContent = `width ${innerWidth} checks ${checks}\n` + found.join("\n") + "\nSAVED" + saved + "SAVED";
  (window.frameElement ? parent.document : document).body.append(made);
};
if (questions.length > 0) { $("[data-do=save]").click(); blob.text().then(report); } else report("");
)js";

struct Browsed {
  std::string findings;
  std::string saved;  // the answers file
};

Browsed probed(const std::string& browser, const Story& story, const std::string& window,
               const std::string& questions) {
  const std::string page = page_of(story), document = page.substr(0, page.find("<template class=\"stop\">"));
  std::string beats;
  for (const StoryScene& scene : story.scenes) {
    beats += beats.empty() ? "[" : ",[";
    for (const StoryStep& step : scene.steps) beats += step.beat != nullptr ? "1," : "0,";
    beats += "]";
  }
  const std::string script = std::string(probe_start) + "const facts = " + facts_of(story) +
                             ", questions = " + questions + ", lesson_steps = [" + beats +
                             "], schemes = " + std::to_string(count_of(document, "<table class=\"scheme\"")) + ";" +
                             probe;
  const Ended shown = browse(browser, with_probe(page, script), window);
  Browsed browsed{between(shown.out, "<pre id=\"findings\">", "</pre>"), {}};
  browsed.saved = between(browsed.findings, "SAVED", "SAVED");
  return browsed;
}

}  // namespace

TEST_CASE("in a browser, the page steps, scrubs, prints and shows what the run knows", "[export][html]") {
  const std::string browser = chromium();
  if (browser.empty()) {
    WARN("test skipped: chromium is not installed");
    return;
  }
  struct Case {
    std::string lesson, window;
  };
  // A curve with its scheme, a rational one, a surface in space, one with parts within parts, and several scenes.
  const auto [lesson, window] =
      GENERATE(Case{"22-de-boor", "360,740"}, Case{"22-de-boor", "1280,800"}, Case{"45-de-boor-nurbs", "360,740"},
               Case{"60-ruled-hyperboloid", "1280,800"}, Case{"63-vase", "360,740"}, Case{"", "1280,800"},
               Case{"22-de-boor", "740,360"});
  const Story story = lesson.empty() ? story_of(all_questions) : shipped(lesson);
  const Browsed browsed = probed(browser, story, window, "[]");
  CAPTURE(lesson, window, browsed.findings);
  std::smatch numbers;
  REQUIRE(std::regex_search(browsed.findings, numbers, std::regex("width ([0-9]+) checks ([0-9]+)")));
  CHECK(numbers[1] == window.substr(0, window.find(',')));
  CHECK(static_cast<std::size_t>(std::stoi(numbers[2])) > 10 * story.step_count());
  CHECK_FALSE(contains(browsed.findings, "FAULT"));
}

TEST_CASE("in a browser, questions are marked at once and saved as an answers file", "[export][html]") {
  const std::string browser = chromium();
  if (browser.empty()) {
    WARN("test skipped: chromium is not installed");
    return;
  }
  const std::string window = GENERATE("360,740", "1280,800");
  const Story story = story_of(all_questions);
  const Checkpoint* order = nullptr;
  for (const StoryStep& step : story.scenes[0].steps)
    if (step.question && step.question->checkpoint->kind == Checkpoint::Kind::order) order = step.question->checkpoint;
  REQUIRE(order != nullptr);
  const std::string right = right_letters(*order), wrong{right[1], right[0], right[2]};
  // P[1][2] = (34/5, 8); the ratio alpha[2][3] = (2/5 - 1/4)/(1/2 - 1/4) = 3/5. Steps: k, s, alpha, alpha, P, P, ...
  std::map<std::string, std::string> at;
  for (const StoryStep& step : story.scenes[0].steps)
    if (step.question) at[step.question->checkpoint->id] = std::to_string(step.step);
  const std::string questions =
      R"([{"id": "span", "kind": "span", "scene": 0, "at": )" + at["span"] +
      R"(, "wrong": ["2"], "right": [["3"]], "says": "Count from 0.", "nonsense": ["3.5"]},
          {"id": "line", "kind": "line", "scene": 0, "at": )" +
      at["line"] +
      R"(, "wrong": "3", "right": ["2"]},
          {"id": "value", "kind": "predict", "scene": 0, "at": )" +
      at["value"] +
      R"(, "wrong": ["6.79", "8"], "right": [["6,8", "8"], ["6.804", "8.0"], ["34/5", "+16/2"]], "nonsense": ["x", "8"]},
          {"id": "ratio", "kind": "predict", "scene": 0, "at": )" +
      at["ratio"] +
      R"(, "wrong": ["2/5"], "right": [["0.6"], ["3/5"]], "nonsense": ["3/0"]},
          {"id": "order", "kind": "order", "scene": 0, "at": )" +
      at["order"] + ", \"wrong\": \"" + wrong + "\", \"right\": [\"" + right + R"("]},
          {"id": "choice", "kind": "choice", "scene": 0, "at": )" +
      at["choice"] + R"(, "wrong": "a", "right": ["b"], "says": "Only p + 1."}])";
  const Browsed browsed = probed(browser, story, window, questions);
  CAPTURE(window, browsed.findings);
  REQUIRE(contains(browsed.findings, "checks"));
  CHECK_FALSE(contains(browsed.findings, "FAULT"));
  const auto document = JsonDocument::parse("answers.json", browsed.saved);
  REQUIRE(document);
  CHECK(
      without_blanks(browsed.saved) ==
      R"({"schema":"blossom.answers/1","exercise":"all-questions","answers":{"span":3,"line":2,"value":["34/5","16/2"],)"
      R"("ratio":"3/5","order":")" +
          right + R"(","choice":"b"}})");
}

TEST_CASE("a page as it is written runs its own script and nothing else", "[export][html]") {
  const std::string browser = chromium();
  if (browser.empty()) {
    WARN("test skipped: chromium is not installed");
    return;
  }
  std::string page = page_of(story_of(short_lesson));
  const Ended as_written = browse(browser, page, "800,600");
  CHECK(contains(between(as_written.out, "<html", ">"), "scripted"));
  CHECK(contains(as_written.out, "0 / "));
  page.insert(
      page.rfind("</body>"),
      "<script>document.body.append('intruder')</script><img src=x onerror=\"document.body.append('intruder')\">");
  const Ended attacked = browse(browser, page, "800,600");
  CHECK(contains(attacked.out, "0 / "));
  CHECK(count_of(attacked.out, "intruder") == count_of(page, "intruder"));
}

TEST_CASE("a page is dark where the reader's system is, until the reader says otherwise", "[export][html]") {
  const std::string browser = chromium();
  if (browser.empty()) {
    WARN("test skipped: chromium is not installed");
    return;
  }
  const std::string page = with_probe(page_of(story_of(short_lesson)), R"(
    const ground = () => getComputedStyle(document.documentElement).backgroundColor;
    const system = ground();
    document.querySelector("#theme").click();
    document.body.append(`<${system}><${ground()}>`);)");
  const std::string white = "rgb(255, 255, 255)", dark = "rgb(20, 24, 31)";
  CHECK(contains(browse(browser, page, "800,600", "preferredColorScheme=0").out, "&lt;" + dark + "&gt;&lt;" + white));
  CHECK(contains(browse(browser, page, "800,600", "preferredColorScheme=1").out, "&lt;" + white + "&gt;&lt;" + white));
}
