#include "lesson/starter.hpp"

#include <algorithm>
#include <set>

#include "algorithms/selector.hpp"
#include "base/json_write.hpp"
#include "lesson/lesson.hpp"
#include "lesson/slider_check.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_kinds = 4;   // of values that get a beat, between the start and the end
constexpr std::size_t most_asked = 60;  // values of an exercise

using Members = std::vector<std::pair<std::string, Json>>;

std::pair<std::string, Json> comment(std::string_view text) { return {"$comment", json_string(text)}; }

Run<Exact> run_of(const Algorithm& algorithm, const Json& inputs) {
  const auto document = JsonDocument::parse("inputs", write_json(inputs));
  Diagnostics diagnostics;
  return *record<Exact>(algorithm, *read_inputs(algorithm, Cursor(*document, diagnostics)));
}

// "column[1].P[1][0]" with * for as many of the last indices as leave its step the first.
std::string selector_of(const TraceGraph& trace, ValueId value) {
  const std::string name = trace.name(value);
  std::vector<std::size_t> opened;
  for (std::size_t i = 0; i < name.size(); ++i)
    if (name[i] == '[') opened.push_back(i);
  for (std::size_t kept = 0; kept < opened.size(); ++kept) {
    std::string text = name.substr(0, opened[kept]);
    for (std::size_t at = opened[kept]; at < name.size();) {
      const std::size_t close = name.find(']', at);
      const std::size_t next = std::min(name.find('[', close), name.size());
      text += "[*]" + name.substr(close + 1, next - close - 1);
      at = next;
    }
    if (step_of({Place::Kind::value, 0, text}, trace) == trace.value(value).step) return text;
  }
  return name;
}

// Whether this can be said at a step as it stands.
bool can_be_said(std::string_view text, const Narrator<Exact>& narrator, std::uint32_t step) {
  std::vector<std::string> unknown;
  std::vector<ProseMistake> mistakes;
  read_prose(narrator.fill(text, step, &unknown), &mistakes);
  return unknown.empty() && mistakes.empty();
}

struct StartingBeat {
  std::uint32_t step = 0;
  std::string at, say;
  std::string highlight = {};
};

std::string words_at(const Narrator<Exact>& narrator, std::uint32_t step, std::string_view wanted) {
  for (const std::string_view text : {wanted, std::string_view("{name} = {value}")})
    if (can_be_said(text, narrator, step)) return std::string(text);
  return "Say here what happens at this step.";
}

// The start, the first value of each kind, the end.
std::vector<StartingBeat> beats_of(const Narrator<Exact>& narrator) {
  const auto& trace = narrator.trace();
  const std::uint32_t last = trace.step_count() - 1;
  std::vector<StartingBeat> beats{{0, "start", words_at(narrator, 0, narrator.text_template(0))}};
  std::set<const ValueSpec*> seen;
  const auto add = [&](ValueId v) {
    const std::uint32_t step = trace.value(v).step;
    if (step >= last || std::ranges::any_of(beats, [&](const StartingBeat& b) { return b.step == step; })) return;
    beats.push_back(
        {step, selector_of(trace, v), words_at(narrator, step, narrator.text_template(step)), trace.name(v)});
  };
  for (ValueId v = 0; v < trace.value_count() && beats.size() <= most_kinds; ++v) {
    if (trace.is_input(v)) continue;
    if (seen.insert(narrator.algorithm_at(trace.value(v).step).spec(trace.value(v).name)).second) add(v);
  }
  // Where there are few kinds, some more of the same.
  for (ValueId v = 0; v < trace.value_count() && beats.size() < 3; ++v)
    if (!trace.is_input(v)) add(v);
  std::ranges::sort(beats, {}, &StartingBeat::step);
  beats.push_back({last, "end", words_at(narrator, last, "The end: {name} = {value}.")});
  return beats;
}

// What a student may be asked to predict: a number or a point that is usually asked, else any.
std::optional<ValueId> value_to_predict(const Narrator<Exact>& narrator) {
  const auto& trace = narrator.trace();
  const auto can_be_typed = [&](ValueId v) {
    const ValueKind kind = trace.value(v).kind;
    return !trace.is_input(v) && trace.value(v).step > 0 && kind != ValueKind::list;
  };
  for (const std::string_view ask : narrator.run().algorithm->asks) {
    std::string error;
    if (const auto selector = Selector::parse(ask, error))
      for (const ValueId v : selector->select(trace))
        if (can_be_typed(v)) return v;
  }
  for (ValueId v = 0; v < trace.value_count(); ++v)
    if (can_be_typed(v)) return v;
  return std::nullopt;
}

Json checkpoint_of(const Narrator<Exact>& narrator, std::optional<ValueId> value) {
  if (!value)
    return json_object({comment("A question. Exactly one of the choices is right; each may have feedback of its own."),
                        {"id", json_string("first-question")},
                        {"kind", json_string("choice")},
                        {"ask", json_string("What comes next?")},
                        {"choices", json_array({json_object({{"text", json_string("What is computed.")},
                                                             comment("The right one."),
                                                             {"right",
                                                              [] {
                                                                Json yes;
                                                                yes.kind = Json::Kind::boolean;
                                                                yes.boolean = true;
                                                                return yes;
                                                              }()}}),
                                                json_object({{"text", json_string("What is given.")},
                                                             {"feedback", json_string("That is known already.")}})})}});
  const std::string name = narrator.trace().name(*value);
  return json_object(
      {comment("A question that is asked before the lesson goes on. Kinds: predict (a value that comes later), span, "
               "line (which line of the pseudo-code comes next), order, choice."),
       {"id", json_string("first-question")},
       {"kind", json_string("predict")},
       {"value", json_string(name)},
       {"decimals", json_number("3")},
       {"ask", json_string("What will " + name + " be?")},
       {"right", json_string("Yes.")},
       {"wrong", json_string("Not yet: look at what it is made from.")}});
}

// From where to where the first number among the inputs may be moved; null: there is none, or it may not.
std::optional<Json> slider_of(const Algorithm& algorithm, const Json& inputs) {
  const auto is_valid = [&](const Json& changed) {
    const auto document = JsonDocument::parse("inputs", write_json(changed));
    Diagnostics diagnostics;
    const auto read = read_inputs(algorithm, Cursor(*document, diagnostics));
    return read && record<Exact>(algorithm, *read);
  };
  for (const InputSpec& spec : algorithm.inputs) {
    const Json* number = inputs.find(spec.name);
    const auto x =
        spec.type == InputSpec::Type::number && number != nullptr ? Exact::parse(number->text) : std::nullopt;
    if (!x) continue;
    const auto end = [&](const std::vector<Exact>& wanted, bool below) -> std::optional<Exact> {
      for (const Exact& to : wanted) {
        if (below ? *x < to : to < *x) continue;
        Json changed = inputs;
        *find_number(changed, spec.name) = json_number(to);
        if (is_valid(changed)) return to;
      }
      return std::nullopt;
    };
    const auto from = end({Exact(0), *x / Exact(2), *x * Exact::ratio(3, 4), *x}, true);
    const auto to = end({Exact(1), *x * Exact(2), *x * Exact::ratio(3, 2), *x * Exact::ratio(5, 4), *x}, false);
    if (!from || !to || !(*from < *to)) continue;
    return json_object({comment("The student may move this input from one number to the other. A path such as "
                                "curve.points[1][0] moves a coordinate."),
                        {"input", json_string(spec.name)},
                        {"from", json_number(*from)},
                        {"to", json_number(*to)}});
  }
  return std::nullopt;
}

void add_head(Members& members, const Algorithm& algorithm, const Start& start, const char* schema) {
  if (!start.schema.empty()) members.emplace_back("$schema", json_string(start.schema));
  members.emplace_back("schema", json_string(schema));
  members.emplace_back("id", json_string(start.id));
  members.emplace_back("title", json_string(algorithm.title));
}

}  // namespace

std::string starting_lesson(const Algorithm& algorithm, const Json& inputs, const Start& start) {
  const Run<Exact> run = run_of(algorithm, inputs);
  const Narrator<Exact> narrator(run);
  Members members;
  members.push_back(
      comment("A start for a lesson. A $comment is for who reads the file and may stand in any object, or be deleted. "
              "`blossom lint` names every mistake, `blossom play` shows the lesson and reloads it whenever it is "
              "saved."));
  add_head(members, algorithm, start, "blossom.lesson/1");
  members.emplace_back("unit", json_string("My course"));
  members.emplace_back("summary", json_string(algorithm.summary));
  if (!algorithm.source.empty()) members.emplace_back("source", json_string(algorithm.source));
  members.emplace_back("minutes", json_number("10"));
  members.emplace_back("language", json_string(start.language));
  members.emplace_back("objectives",
                       json_array({json_string("Explain each step of: " + std::string(algorithm.title))}));
  members.emplace_back("algorithm", json_string(algorithm.id));
  members.emplace_back("inputs", inputs);

  const auto beats = beats_of(narrator);
  const auto value = value_to_predict(narrator);
  const std::uint32_t asked_at = value ? narrator.trace().value(*value).step : 1;
  std::size_t asks = 0;  // the last beat before the value
  for (std::size_t i = 0; i < beats.size(); ++i)
    if (beats[i].step < asked_at) asks = i;
  std::vector<Json> written;
  for (std::size_t i = 0; i < beats.size(); ++i) {
    const StartingBeat& beat = beats[i];
    const bool is_first = i == 0, is_second = i == 1, is_last = i + 1 == beats.size();
    Members parts;
    if (is_first)
      parts.push_back(
          comment("A beat: what is said at one step instead of the algorithm's own words. \"start\" is the step that "
                  "shows the inputs."));
    else if (is_last)
      parts.push_back(comment("The last step."));
    else if (is_second)
      parts.push_back(
          comment("The first step that makes a value of this name; * is any index. Also {\"last\": selector}, "
                  "{\"every\": selector}, {\"level\": r}, {\"phase\": label}, {\"after\": label}. In \"say\", "
                  "{P[1][0]} is the value of that name, {name} and {value} are the step's own, as are the others that "
                  "lessons/GUIDE.md lists; **bold**, *emphasis*, "
                  "lists and $formulas$ as in Markdown."));
    parts.emplace_back("at", json_string(beat.at));
    parts.emplace_back("say", json_string(beat.say));
    if (!beat.highlight.empty()) parts.emplace_back("highlight", json_array({json_string(beat.highlight)}));
    if (is_first && narrator.trace().dimension == 3)
      parts.emplace_back("camera", json_object({comment("From where it is seen, in degrees. It stays until a beat says "
                                                        "otherwise."),
                                                {"azimuth", json_number("-60")},
                                                {"elevation", json_number("25")}}));
    if (is_last)
      if (auto slider = slider_of(algorithm, inputs)) parts.emplace_back("sliders", json_array({*std::move(slider)}));
    if (i == asks && asked_at > beat.step) parts.emplace_back("checkpoint", checkpoint_of(narrator, value));
    written.push_back(json_object(std::move(parts)));
  }
  members.emplace_back("beats", json_array(std::move(written)));
  return write_json(json_object(std::move(members))) + "\n";
}

std::string starting_exercise(const Algorithm& algorithm, const Json& inputs, const Start& start) {
  const Run<Exact> run = run_of(algorithm, inputs);
  const auto& trace = run.trace;
  Members members;
  members.push_back(
      comment("A start for an exercise. A $comment is for who reads the file and may stand in any object, or be "
              "deleted. `blossom lint` names every mistake; `blossom-grade` grades answers against it."));
  add_head(members, algorithm, start, "blossom.exercise/1");
  members.emplace_back("prompt", json_string("Do it by hand: " + std::string(algorithm.title) +
                                             ". Hand in the values that are asked for, to three decimals."));
  members.emplace_back("unit", json_string("My course"));
  if (!algorithm.source.empty()) members.emplace_back("source", json_string(algorithm.source));
  members.emplace_back("algorithm", json_string(algorithm.id));
  members.emplace_back("inputs", inputs);

  std::vector<Json> asks;
  std::set<ValueId> asked;
  const auto ask = [&](const std::string& text, const std::vector<ValueId>& values) {
    std::vector<ValueId> open;
    for (const ValueId v : values)
      if (!trace.is_input(v)) open.push_back(v);
    const bool again = std::ranges::any_of(open, [&](ValueId v) { return asked.contains(v); });
    if (open.empty() || again || asked.size() + open.size() > most_asked) return;
    asked.insert(open.begin(), open.end());
    Members parts;
    if (asks.empty())
      parts.push_back(comment("The points are for each value that the selector selects; * is any index."));
    parts.emplace_back("value", json_string(text));
    parts.emplace_back("points", json_number("1"));
    asks.push_back(json_object(std::move(parts)));
  };
  for (const std::string_view text : algorithm.asks) {
    std::string error;
    if (const auto selector = Selector::parse(text, error)) ask(std::string(text), selector->select(trace));
  }
  for (ValueId v = 0; asks.empty() && v < trace.value_count(); ++v) ask(trace.name(v), {v});
  members.emplace_back("ask", json_array(std::move(asks)));
  members.emplace_back(
      "tolerance", json_object({comment("Or \"exact\", or {\"significant\": 4}."), {"decimals", json_number("3")}}));
  members.emplace_back("partial",
                       json_object({comment("The share of the points for a known wrong rule, and for a wrong "
                                            "sign or exchanged digits."),
                                    {"misconception", json_string("1/4")},
                                    {"slip", json_string("1/2")}}));
  members.emplace_back("feedback", json_string("full"));
  return write_json(json_object(std::move(members))) + "\n";
}

}  // namespace blossom
