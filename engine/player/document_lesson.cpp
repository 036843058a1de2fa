// A document written as a new lesson.

#include <algorithm>

#include "algorithms/selector.hpp"
#include "base/json_write.hpp"
#include "lesson/lesson.hpp"
#include "player/document.hpp"
#include "player/edit.hpp"

namespace blossom {
namespace {

// What read_id accepts, as near to the text as can be: "My curve (2)" becomes "my-curve-2".
std::string as_id(std::string_view text) {
  constexpr std::size_t longest = 64;
  std::string id;
  for (const char c : text) {
    const char lower = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (('a' <= lower && lower <= 'z') || ('0' <= lower && lower <= '9'))
      id += lower;
    else if (!id.empty() && id.back() != '-')
      id += '-';
    if (id.size() == longest) break;
  }
  while (!id.empty() && id.back() == '-') id.pop_back();
  return id.empty() ? "lesson" : id;
}

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\n") == std::string_view::npos; }

Json parsed(const std::string& text) { return JsonDocument::parse("", text)->root(); }

// What of a document can be said in a run with these inputs. The run is in double precision where that can be, which
// has the same steps and names and is quick.
class Writer {
 public:
  Writer(const Document& document, const Inputs<Exact>& inputs) : document_(document) {
    if (auto run = record<double>(*document.algorithm, inputs))
      rounded_.emplace(std::move(*run));
    else if (auto exact = record<Exact>(*document.algorithm, inputs))
      exact_.emplace(std::move(*exact));
  }

  std::vector<Json> beats() const {
    std::vector<Json> written;
    if (document_.lesson) {
      const TraceGraph* trace = graph();
      for (const Beat& beat : trace != nullptr ? resolve_beats(*document_.lesson, *trace) : document_.lesson->beats)
        if (can_say(beat.say, beat.step)) written.push_back(write_beat(beat));
    }
    // A lesson says something at least once.
    if (written.empty()) written.push_back(write_beat({0, opening(), {}, {}, {}}));
    return written;
  }

  std::optional<Json> predict() const {
    std::vector<Json> asks;
    for (const std::string& ask : document_.asks)
      if (can_ask(ask)) asks.push_back(json_string(ask));
    std::vector<std::pair<std::string, Json>> members;
    if (!asks.empty()) members.emplace_back("ask", json_array(std::move(asks)));
    if (document_.marking != Marking::at_once)
      members.emplace_back("marking", json_string(marking_name(document_.marking)));
    if (members.empty()) return std::nullopt;
    return json_object(std::move(members));
  }

 private:
  struct Rounded {
    explicit Rounded(Run<double> r) : run(std::move(r)), narrator(run) {}
    Run<double> run;
    Narrator<double> narrator;
  };
  struct Fractions {
    explicit Fractions(Run<Exact> r) : run(std::move(r)), narrator(run) {}
    Run<Exact> run;
    Narrator<Exact> narrator;
  };

  const TraceGraph* graph() const {
    if (rounded_) return &rounded_->run.trace;
    return exact_ ? &exact_->run.trace : nullptr;
  }

  bool can_say(const std::string& say, std::uint32_t step) const {
    if (is_blank(say) || open_brace(say)) return false;
    if (rounded_) return unresolved(say, rounded_->narrator, step).empty();
    return !exact_ || unresolved(say, exact_->narrator, step).empty();
  }

  bool can_ask(const std::string& ask) const {
    const TraceGraph* trace = graph();
    if (trace == nullptr) return true;
    std::string error;
    const auto selector = Selector::parse(ask, error);
    for (ValueId v = 0; selector && v < trace->value_count(); ++v)
      if (!trace->is_input(v) && selector->matches(*trace, v)) return true;
    return false;
  }

  // An exercise's prompt, or what the algorithm says of its inputs.
  std::string opening() const {
    if (document_.grader && can_say(document_.grader->exercise().prompt, 0)) return document_.grader->exercise().prompt;
    const std::string given(document_.algorithm->given_narration);
    return can_say(given, 0) ? given : std::string(document_.algorithm->summary);
  }

  Json write_beat(const Beat& beat) const {
    std::vector<std::pair<std::string, Json>> members{{"at", parsed(write_place(beat.at))},
                                                      {"say", json_string(beat.say)}};
    std::vector<Json> selectors;
    for (const std::string& selector : beat.selectors)
      if (graph() == nullptr || !selected_up_to({selector}, beat.step, *graph()).empty())
        selectors.push_back(json_string(selector));
    if (!selectors.empty()) members.emplace_back("highlight", json_array(std::move(selectors)));
    return json_object(std::move(members));
  }

  const Document& document_;
  std::optional<Rounded> rounded_;
  std::optional<Fractions> exact_;
};

}  // namespace

std::string as_lesson(const Document& document, const Inputs<Exact>& inputs, const std::string& id,
                      const std::string& title) {
  std::vector<std::pair<std::string, Json>> members;
  const auto add = [&](const char* key, const std::string& text) {
    if (!is_blank(text)) members.emplace_back(key, json_string(text));
  };
  const Json& root = document.json.root();
  if (const Json* schema = document.lesson ? root.find("$schema") : nullptr) members.emplace_back("$schema", *schema);
  add("schema", "blossom.lesson/1");
  add("id", as_id(id));
  add("title", printable(is_blank(title) ? document.title() : title));
  if (document.lesson) {
    add("unit", document.lesson->unit);
    add("summary", document.lesson->summary);
    add("source", document.lesson->source);
    if (document.lesson->minutes > 0)
      members.emplace_back("minutes", json_number(std::to_string(document.lesson->minutes)));
  } else if (document.grader) {
    add("unit", document.grader->exercise().unit);
    add("source", document.grader->exercise().source);
  }
  add("algorithm", std::string(document.algorithm->id));
  members.emplace_back("inputs", json_of(inputs));
  const Writer writer(document, inputs);
  members.emplace_back("beats", json_array(writer.beats()));
  if (auto predict = writer.predict()) members.emplace_back("predict", std::move(*predict));
  return write_json(json_object(std::move(members))) + "\n";
}

}  // namespace blossom
