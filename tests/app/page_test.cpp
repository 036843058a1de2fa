// A student's page in a browser: what `blossom-grade` writes, opened, clicked through and compared with itself.

#include "browser.hpp"

using namespace blossom::test;

namespace {

// Clicks and types as a student would, and writes what it found into the document. It is added to a copy of the page.
const char* const probe = R"js(
const squeeze = (text) => text.replace(/\s+/g, " ").trim();
const section = document.querySelector("section.run");
const rows = [...section.querySelectorAll("table.steps tbody tr")];
const player = section.querySelector(".player");
const now = player.querySelector(".told"), output = player.querySelector("output"), range = player.querySelector("input");
const shows = (step, how) => {
  const row = rows[step];
  check(`${how}: ${output.textContent} at step ${step + 1}`, output.textContent === `${step + 1} of ${rows.length}`);
  check(`${how}: slider at step ${step + 1}`, +range.value === step + 1);
  [...row.cells].slice(1).forEach((cell, i) => {
    const block = now.children[i];
    check(`${how}: step ${step + 1}, column ${i}: "${squeeze(block.textContent)}"`,
      squeeze(block.textContent).endsWith(squeeze(cell.textContent)));
  });
};
const click = (go) => player.querySelector(`button[data-go=${go}]`).click();
const key = (name, target) => target.dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true, cancelable: true }));
const last = rows.length - 1;
const steps = JSON.parse(section.querySelector("script.picture").textContent).steps;

check("the player is seen", !player.hidden && player.getBoundingClientRect().height > 100);
check("the table is closed", !section.querySelector("details.all").open);
shows(0, "at first");
for (let i = 0; i <= last; ++i) {
  shows(i, "next");
  for (const svg of section.querySelectorAll("svg.picture")) {
    check(`picture of step ${i + 1} has points`, svg.querySelectorAll("circle").length >= 4);
    const marked = svg.querySelectorAll(".current:not(text), .mistake.now").length;
    check(`picture of step ${i + 1} marks its point`, marked === (steps[i].v === undefined ? 0 : 1));
  }
  const box = [...section.querySelectorAll("svg.picture text")].map((text) => text.getBoundingClientRect());
  const frame = [...section.querySelectorAll("svg.picture")].map((svg) => svg.getBoundingClientRect());
  check(`labels of step ${i + 1} are inside`, box.every((b) => frame.some((f) => b.left >= f.left - 1 && b.right <= f.right + 1 && b.top >= f.top - 1 && b.bottom <= f.bottom + 1)));
  click("next");
}
shows(last, "next at the end");
click("back"); shows(last - 1, "back");
click("first"); shows(0, "first");
click("back"); shows(0, "back at the beginning");
click("last"); shows(last, "last");
key("ArrowLeft", document.body); shows(last - 1, "arrow left");
key("ArrowRight", document.body); shows(last, "arrow right");
key("Home", document.body); shows(last, "Home outside of the player");
key("Home", player); shows(0, "Home");
key("End", player); shows(last, "End");
range.value = 3; range.dispatchEvent(new Event("input")); shows(2, "slider");
dispatchEvent(new Event("beforeprint"));
check("all is open in print", [...document.querySelectorAll("details")].every((each) => each.open));
check("the last step in print", output.textContent === `${rows.length} of ${rows.length}`);
dispatchEvent(new Event("afterprint"));
shows(2, "after print");
check("nothing was loaded", performance.getEntriesByType("resource").length === 0);
check("it is not wider than its window", document.documentElement.scrollWidth <= innerWidth);
const report = document.createElement("pre");
report.id = "findings";
report.textContent = `steps ${rows.length} checks ${checks}\n` + found.join("\n");
document.body.append(report);
)js";

}  // namespace

TEST_CASE("in a browser, each step shows what the document says of it", "[app][page]") {
  const std::string browser = chromium();
  if (browser.empty()) {
    WARN("test skipped: chromium is not installed");
    return;
  }
  const std::string window = GENERATE("1280,1000", "500,900");
  const std::string exercise = GENERATE("22-de-boor", "28-knot-insertion");
  const Scratch scratch;
  const std::string answers =
      exercise == "22-de-boor"
          ? "exercises/demo-class/early-slip.json"
          : scratch.write("answers.json", R"({"schema": "blossom.answers/1", "exercise": "knot-insertion",
                                              "answers": {"k": 3, "alpha[1][2]": 0.25, "alpha[1][3]": "</script>"}})");
  const auto graded = run_program("blossom-grade", {"exercises/" + exercise + ".json", answers, "--format", "html"});
  SHOW(graded);
  REQUIRE(contains(graded.out, "</body>"));
  std::string page = graded.out;
  page.insert(page.rfind("</body>"), "<script>" + std::string(probe_start) + probe + "</script>");

  const Ended shown = browse(browser, page, window);
  const std::string findings = between(shown.out, "<pre id=\"findings\">", "</pre>");
  CAPTURE(exercise, window, findings, shown.err);
  std::smatch numbers;
  REQUIRE(std::regex_search(findings, numbers, std::regex("steps ([0-9]+) checks ([0-9]+)")));
  const int steps = std::stoi(numbers[1]), checks = std::stoi(numbers[2]);
  CHECK(steps >= 10);
  CHECK(checks >= 8 * steps);
  CHECK_FALSE(contains(findings, "FAULT"));
}
