#include "lesson/beat.hpp"

#include <algorithm>
#include <charconv>

#include "algorithms/selector.hpp"
#include "base/json_write.hpp"
#include "lesson/document.hpp"
#include "lesson/names.hpp"
#include "lesson/prose.hpp"

namespace blossom {
namespace {

constexpr double longest_pause = 60;              // seconds
constexpr std::ptrdiff_t most_hull_points = 200;  // in space the time grows with their square

std::optional<std::vector<ValueId>> read_selection(const Cursor& at, const TraceGraph* trace) {
  const auto text = at.string();
  if (!text) return std::nullopt;
  std::string error;
  const auto selector = Selector::parse(*text, error);
  if (!selector) {
    at.error("is no selector: " + error);
    return std::nullopt;
  }
  if (trace == nullptr) return std::nullopt;
  auto values = selector->select(*trace);
  if (values.empty()) {
    at.error(why_nowhere({Place::Kind::last, 0, *text}, *trace));
    return std::nullopt;
  }
  return values;
}

// Reads the parts of the beats of one run.
class Reader {
 public:
  Reader(const Languages& languages, const Narrator<Exact>* narrator, const Cursor* inputs)
      : languages_(languages), narrator_(narrator), inputs_(inputs) {}

  const TraceGraph* trace() const { return narrator_ != nullptr ? &narrator_->trace() : nullptr; }

  std::optional<std::uint32_t> step(const Cursor& at, Beat& beat) const {
    auto place = read_place(at);
    if (!place) return std::nullopt;
    beat.at = *std::move(place);
    if (trace() == nullptr) return std::nullopt;
    if (const auto step = step_of(beat.at, *trace())) return step;
    const auto& keys = at.json().keys;
    const auto key = std::ranges::find_if(keys, [](const std::string& k) { return k != "$comment"; });
    (keys.empty() ? at : at.member(static_cast<std::size_t>(key - keys.begin()))).error(why_nowhere(beat.at, *trace()));
    return std::nullopt;
  }

  void say(const Cursor& at, std::optional<std::uint32_t> step, Beat& beat) const {
    auto text = read_local_text(at, languages_);
    if (!text) return;
    beat.say = *std::move(text);
    if (!step || beat.at.kind != Place::Kind::every) {
      check_template(at, beat.say, languages_, narrator_, step);
      return;
    }
    // What is said at every such step has to fit all of them; one mistake is told once.
    const std::size_t mistakes = at.error_count();
    for (const std::uint32_t each : steps_of(beat.at, *trace())) {
      check_template(at, beat.say, languages_, narrator_, each);
      if (at.errors_since(mistakes)) return;
    }
  }

  void highlight(const Cursor& at, std::optional<std::uint32_t> step, Beat& beat) const {
    if (!at.expect_array(1)) return;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const auto values = read_selection(at[i], trace());
      if (!values || !step) continue;
      beat.selectors.push_back(at[i].json().text);
      if (const std::uint32_t first = trace()->value(values->front()).step; first > *step)
        at[i].error("nothing of it is made yet at step " + std::to_string(*step) + "; the first comes at step " +
                    std::to_string(first));
    }
    if (step) beat.highlights = selected_up_to(beat.selectors, *step, *trace());
  }

  void hull(const Cursor& at, std::optional<std::uint32_t> step, Beat& beat) const {
    if (!at.expect_array(0)) return;
    beat.hulls.emplace();
    for (std::size_t i = 0; i < at.size(); ++i) {
      const auto values = read_selection(at[i], trace());
      if (!values || !step) continue;
      beat.hulls->push_back(at[i].json().text);
      const auto points =
          std::ranges::count(*values, ValueKind::point, [&](ValueId v) { return trace()->value(v).kind; });
      if (points != std::ssize(*values))
        at[i].error("must select points, not " + trace()->name(*std::ranges::find_if(*values, [&](ValueId v) {
          return trace()->value(v).kind != ValueKind::point;
        })));
      else if (points > most_hull_points)
        at[i].error("selects " + std::to_string(points) + " points; a hull is drawn of at most " +
                    std::to_string(most_hull_points));
    }
  }

  void camera(const Cursor& at, Beat& beat) const {
    if (!at.expect_object({"fit", "azimuth", "elevation", "zoom"})) return;
    BeatCamera camera;
    const auto number = [&](const char* key, double from, double to) -> std::optional<double> {
      const auto here = at.optional(key);
      const auto value = here ? here->number() : std::nullopt;
      if (!value) return std::nullopt;
      const double x = value->to_double();
      if (from <= x && x <= to) return x;
      here->error("must be from " + format_brief(Exact::approximate(from)) + " to " +
                  format_brief(Exact::approximate(to)));
      return std::nullopt;
    };
    camera.azimuth = number("azimuth", -360, 360);
    camera.elevation = number("elevation", -89, 89);
    camera.zoom = number("zoom", 0.1, 20).value_or(1);
    if (const auto fit = at.optional("fit"); fit && fit->expect_array(1))
      for (std::size_t i = 0; i < fit->size(); ++i)
        if (const auto values = read_selection((*fit)[i], trace())) {
          camera.fit.push_back((*fit)[i].json().text);
          const auto is_somewhere = [&](ValueId v) { return trace()->value(v).kind == ValueKind::point; };
          if (std::ranges::none_of(*values, is_somewhere)) (*fit)[i].error("must select points, which are to be seen");
        }
    beat.camera = camera;
  }

  void pause(const Cursor& at, Beat& beat) const {
    if (at.is(Json::Kind::string) && at.json().text == "wait") {
      beat.waits = true;
      return;
    }
    const bool may_be_number = at.is(Json::Kind::number) || at.is(Json::Kind::string);
    const auto seconds = may_be_number ? Exact::parse(at.json().text) : std::nullopt;
    if (seconds && Exact(0) < *seconds && seconds->to_double() <= longest_pause)
      beat.seconds = seconds->to_double();
    else
      at.error(R"(must be "wait" or a number of seconds above 0, up to 60)");
  }

  void sliders(const Cursor& at, Beat& beat) const {
    if (!at.expect_array(1, 4)) return;
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (!at[i].expect_object({"input", "from", "to", "step", "label"})) continue;
      auto slider = this->slider(at[i]);
      if (!slider) continue;
      const auto same = [&](const Slider& other) { return other.input == slider->input; };
      if (std::ranges::any_of(beat.sliders, same))
        at[i].optional("input")->error(excerpt(slider->input) + " has a slider here already");
      beat.sliders.push_back(*std::move(slider));
    }
  }

 private:
  std::optional<Slider> slider(const Cursor& at) const {
    const std::size_t mistakes = at.error_count();
    Slider made;
    if (const auto input = at.required("input"))
      if (auto path = input->string()) {
        made.input = *std::move(path);
        if (inputs_ != nullptr) check_input(*input, made.input);
      }
    const auto from = at.required("from"), to = at.required("to");
    if (from) made.from = from->number().value_or(Exact(0));
    if (to) made.to = to->number().value_or(made.from + 1);
    if (from && to && !(made.from < made.to)) to->error("must be above \"from\"");
    if (const auto step = at.optional("step")) {
      made.step = step->number();
      if (made.step && !(Exact(0) < *made.step && *made.step <= made.to - made.from))
        step->error("must be above 0 and at most \"to\" - \"from\"");
    }
    if (const auto label = at.optional("label")) made.label = read_local_text(*label, languages_).value_or(LocalText());
    if (at.errors_since(mistakes)) return std::nullopt;
    return made;
  }

  // "curve.points[1][0]": keys and places from the inputs down to a number; nullptr, with a mistake, if it leads to
  // none.
  void check_input(const Cursor& at, const std::string& path) const {
    const Json* here = &inputs_->json();
    std::string_view rest = path;
    const auto stop = [&](const std::string& why, std::string_view what) {
      at.error(why + (what == path ? "" : ", in " + excerpt(path)));
    };
    while (!rest.empty()) {
      if (rest.front() == '[') {
        const std::size_t end = rest.find(']');
        std::size_t index = 0;
        const char* const last = rest.data() + std::min(end, rest.size());
        const auto [stopped, error] = std::from_chars(rest.data() + 1, last, index);
        if (end == std::string_view::npos || error != std::errc() || stopped != last ||
            here->kind != Json::Kind::array || index >= here->items.size())
          return stop("the inputs have no such place", "");
        here = &here->items[index];
        rest.remove_prefix(end + 1);
        continue;
      }
      if (rest.front() == '.') rest.remove_prefix(1);
      const std::string_view key = rest.substr(0, rest.find_first_of(".["));
      if (key.empty()) return stop("must be a path such as \"u\" or \"curve.points[1][0]\"", "");
      const Json* next = here->kind == Json::Kind::object ? here->find(key) : nullptr;
      if (next == nullptr) {
        const bool inside = here->kind == Json::Kind::object;
        const auto near = inside ? did_you_mean(key, here->keys) : std::nullopt;
        std::string what = "the inputs have no " + excerpt(key);
        if (near)
          what += "; did you mean " + excerpt(*near) + "?";
        else
          for (std::size_t i = 0; inside && i < here->keys.size(); ++i)
            what += (i == 0 ? "; there is " : ", ") + excerpt(here->keys[i]);
        return stop(what, key);
      }
      here = next;
      rest.remove_prefix(key.size());
    }
    const bool number = here->kind == Json::Kind::number || here->kind == Json::Kind::string;
    if (path.empty() || !number) stop("must lead to one number of the inputs", "");
  }

  const Languages& languages_;
  const Narrator<Exact>* narrator_;
  const Cursor* inputs_;
};

// Beats go in the order of their steps, one at each; those at "every" step stand back.
void check_order(const Cursor& where, const std::vector<Beat>& before, const Beat& beat) {
  if (beat.at.kind == Place::Kind::every) return;
  for (auto last = before.rbegin(); last != before.rend(); ++last) {
    if (last->at.kind == Place::Kind::every) continue;
    if (beat.step == last->step)
      where.error("stands at step " + std::to_string(beat.step) + " as the beat before does; one beat for each step");
    else if (beat.step < last->step)
      where.error("stands at step " + std::to_string(beat.step) + ", but the beat before at step " +
                  std::to_string(last->step) + ": beats go in the order of the steps");
    return;
  }
}

// A beat at "every" step of which each has a beat of its own, or one at an earlier "every", is never shown.
void check_shadowed(const std::vector<std::pair<Cursor, std::size_t>>& every, const std::vector<Beat>& beats,
                    const TraceGraph& trace) {
  std::vector<std::uint32_t> taken;
  for (const Beat& beat : beats)
    if (beat.at.kind != Place::Kind::every) taken.push_back(beat.step);
  for (const auto& [where, i] : every) {
    const auto steps = steps_of(beats[i].at, trace);
    std::ranges::sort(taken);
    if (std::ranges::all_of(steps, [&](std::uint32_t step) { return std::ranges::binary_search(taken, step); }))
      where.error("is never shown: at each of its steps another beat stands");
    taken.insert(taken.end(), steps.begin(), steps.end());
  }
}

// What to say of a placeholder that names nothing at a step.
std::string why_unknown(const std::string& placeholder, const Narrator<Exact>& narrator, std::uint32_t step) {
  const TraceGraph& trace = narrator.trace();
  const std::string named = excerpt("{" + placeholder + "}");
  const auto words = placeholder_words();
  if (step == 0 && (std::ranges::find(words, placeholder) != words.end() || placeholder.starts_with('@')))
    return named +
           " is about the value that a step makes, and the start makes none; name the one you mean, such as \"{" +
           trace.name(0) + "}\"";
  const std::string_view name =
      std::string_view(placeholder).substr(placeholder.starts_with('#') || placeholder.starts_with('~') ? 1 : 0);
  const std::string message = named + " names nothing at step " + std::to_string(step);
  if (const auto later = trace.find(name); later && trace.value(*later).step > step)
    return message + ": it is made at step " + std::to_string(trace.value(*later).step);
  return message + meant_values(name, trace, words);
}

}  // namespace

void check_template(const Cursor& at, const LocalText& text, const Languages& languages,
                    const Narrator<Exact>* narrator, std::optional<std::uint32_t> step) {
  for (const auto& [language, words] : text.texts()) {
    const auto in_language = at.is(Json::Kind::object) ? at.optional(language.empty() ? languages.own : language)
                                                       : std::optional<Cursor>(at);
    const Cursor& here = in_language ? *in_language : at;
    if (const auto open = open_brace(words)) {
      here.error("a { has no } behind it, at " + excerpt(std::string_view(words).substr(*open)));
      continue;
    }
    if (!step || narrator == nullptr) continue;
    std::vector<std::string> unknown;
    const std::string filled = narrator->fill(words, *step, &unknown);
    for (const std::string& placeholder : unknown) here.error(why_unknown(placeholder, *narrator, *step));
    std::vector<ProseMistake> mistakes;
    read_prose(filled, &mistakes);
    for (const ProseMistake& mistake : mistakes) {
      const std::string_view rest = std::string_view(filled).substr(std::min(mistake.at, filled.size()));
      // A placeholder that is left standing in a formula is told already.
      if (!unknown.empty() && (rest.starts_with("\\value{") || rest.starts_with("\\name{"))) continue;
      here.error(mistake.what + ", at " + excerpt(rest));
    }
  }
}

std::vector<Beat> read_beats(const Cursor& at, const Languages& languages, const Narrator<Exact>* narrator,
                             const Cursor* inputs) {
  std::vector<Beat> beats;
  if (!at.expect_array(1)) return beats;
  const Reader reader(languages, narrator, inputs);
  std::vector<std::pair<Cursor, std::size_t>> every;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Cursor beat = at[i];
    if (!beat.expect_object({"at", "say", "highlight", "hull", "camera", "pause", "sliders", "checkpoint"})) continue;
    Beat made;
    const auto where = beat.required("at");
    const auto step = where ? reader.step(*where, made) : std::nullopt;
    if (const auto say = beat.required("say")) reader.say(*say, step, made);
    if (const auto highlight = beat.optional("highlight")) reader.highlight(*highlight, step, made);
    if (const auto hull = beat.optional("hull")) reader.hull(*hull, step, made);
    if (const auto camera = beat.optional("camera")) reader.camera(*camera, made);
    if (const auto pause = beat.optional("pause")) reader.pause(*pause, made);
    if (const auto sliders = beat.optional("sliders")) reader.sliders(*sliders, made);
    if (const auto checkpoint = beat.optional("checkpoint")) {
      if (made.at.kind == Place::Kind::every)
        checkpoint->error("must stand at one step, not at every one; put it into a beat of its own");
      made.checkpoint = read_checkpoint(*checkpoint, languages, narrator, step);
    }
    if (!step) continue;
    made.step = *step;
    check_order(*where, beats, made);
    if (made.at.kind == Place::Kind::every) every.emplace_back(*where, beats.size());
    beats.push_back(std::move(made));
  }
  if (narrator != nullptr) check_shadowed(every, beats, narrator->trace());
  return beats;
}

Json write_beat(const Beat& beat, const Languages& languages) {
  std::vector<std::pair<std::string, Json>> members{{"at", JsonDocument::parse("", write_place(beat.at))->root()},
                                                    {"say", write_local_text(beat.say, languages)}};
  const auto strings = [](const std::vector<std::string>& texts) {
    std::vector<Json> items;
    for (const std::string& text : texts) items.push_back(json_string(text));
    return json_array(std::move(items));
  };
  const auto number = [](double x) { return json_number(format_number(x)); };
  if (!beat.selectors.empty()) members.emplace_back("highlight", strings(beat.selectors));
  if (beat.hulls) members.emplace_back("hull", strings(*beat.hulls));
  if (beat.camera) {
    std::vector<std::pair<std::string, Json>> camera;
    if (!beat.camera->fit.empty()) camera.emplace_back("fit", strings(beat.camera->fit));
    if (beat.camera->azimuth) camera.emplace_back("azimuth", number(*beat.camera->azimuth));
    if (beat.camera->elevation) camera.emplace_back("elevation", number(*beat.camera->elevation));
    if (beat.camera->zoom != 1) camera.emplace_back("zoom", number(beat.camera->zoom));
    members.emplace_back("camera", json_object(std::move(camera)));
  }
  if (beat.waits) members.emplace_back("pause", json_string("wait"));
  if (beat.seconds > 0) members.emplace_back("pause", number(beat.seconds));
  if (!beat.sliders.empty()) {
    std::vector<Json> sliders;
    for (const Slider& slider : beat.sliders) {
      std::vector<std::pair<std::string, Json>> parts{
          {"input", json_string(slider.input)}, {"from", json_number(slider.from)}, {"to", json_number(slider.to)}};
      if (slider.step) parts.emplace_back("step", json_number(*slider.step));
      if (!slider.label.empty()) parts.emplace_back("label", write_local_text(slider.label, languages));
      sliders.push_back(json_object(std::move(parts)));
    }
    members.emplace_back("sliders", json_array(std::move(sliders)));
  }
  if (beat.checkpoint) members.emplace_back("checkpoint", write_checkpoint(*beat.checkpoint, languages));
  return json_object(std::move(members));
}

}  // namespace blossom
