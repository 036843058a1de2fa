// A document written as a new lesson.

#include <algorithm>

#include "algorithms/selector.hpp"
#include "base/json_write.hpp"
#include "lesson/lesson.hpp"
#include "player/document.hpp"
#include "player/edit_parts.hpp"

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

using Members = std::vector<std::pair<std::string, Json>>;

std::vector<Json> strings(const std::vector<std::string>& texts) {
  std::vector<Json> items;
  for (const std::string& text : texts) items.push_back(json_string(text));
  return items;
}

// The keys that say what is run and what is said and asked of it.
void add_run(Members& members, const Algorithm& algorithm, const Inputs<Exact>& inputs, std::vector<Json> beats,
             const std::vector<std::string>& asks, Marking marking) {
  members.emplace_back("algorithm", json_string(algorithm.id));
  members.emplace_back("inputs", json_of(inputs));
  members.emplace_back("beats", json_array(std::move(beats)));
  Members predict;
  if (!asks.empty()) predict.emplace_back("ask", json_array(strings(asks)));
  if (marking != Marking::at_once) predict.emplace_back("marking", json_string(marking_name(marking)));
  if (!predict.empty()) members.emplace_back("predict", json_object(std::move(predict)));
}

// A scene that is not edited, as its file has it.
std::vector<Json> beats_of(const LessonScene& scene, const Languages& languages) {
  std::vector<Json> written;
  std::vector<Place> everywhere;  // one beat of those at every such step is enough
  for (const Beat& beat : scene.beats) {
    if (std::ranges::find(everywhere, beat.at) != everywhere.end()) continue;
    if (beat.at.kind == Place::Kind::every) everywhere.push_back(beat.at);
    written.push_back(write_beat(beat, languages));
  }
  return written;
}

// What of a document can be said in a run with these inputs. The run is in double precision where that can be, which
// has the same steps and names and is quick.
class Writer {
 public:
  Writer(const Document& document, const Inputs<Exact>& inputs) : document_(document), inputs_(inputs) {
    if (auto run = record<double>(*document.algorithm, inputs))
      rounded_.emplace(std::move(*run));
    else if (auto exact = record<Exact>(*document.algorithm, inputs))
      exact_.emplace(std::move(*exact));
  }

  std::vector<Json> beats() const {
    std::vector<Json> written;
    if (document_.lesson) {
      const TraceGraph* trace = graph();
      const LessonScene& scene = *document_.lesson_scene();
      std::vector<Place> everywhere;
      for (const Beat& beat : trace != nullptr ? resolve_beats(scene, *trace) : scene.beats) {
        if (std::ranges::find(everywhere, beat.at) != everywhere.end() || !can_say(beat)) continue;
        if (beat.at.kind == Place::Kind::every) everywhere.push_back(beat.at);
        written.push_back(write(beat));
      }
    }
    // A lesson says something at least once.
    if (written.empty()) {
      Beat first;
      first.say = opening();
      written.push_back(write(std::move(first)));
    }
    return written;
  }

  std::vector<std::string> asks() const {
    std::vector<std::string> asks = document_.asks;
    std::erase_if(asks, [&](const std::string& ask) { return !can_ask(ask); });
    return asks;
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

  bool can_say(const Beat& beat) const {
    return std::ranges::all_of(beat.say.texts(), [&](const auto& text) { return can_say(text.second, beat.step); });
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

  // What of the beat is there in this run.
  Json write(Beat beat) const {
    if (const TraceGraph* trace = graph(); trace != nullptr) {
      std::erase_if(beat.selectors,
                    [&](const std::string& selector) { return selected_up_to({selector}, beat.step, *trace).empty(); });
      const auto later = [&](const std::string& name) {
        const auto value = trace->find(name);
        return value && trace->value(*value).step > beat.step;
      };
      if (beat.checkpoint && !beat.checkpoint->value.empty() && !later(beat.checkpoint->value)) beat.checkpoint.reset();
      const bool is_last = beat.step + 1 >= trace->step_count();
      if (beat.checkpoint && beat.checkpoint->kind == Checkpoint::Kind::line && is_last) beat.checkpoint.reset();
      if (beat.checkpoint && !can_ask(*beat.checkpoint, beat.step)) beat.checkpoint.reset();
      if (beat.camera)
        std::erase_if(beat.camera->fit, [&](const std::string& selector) {
          return selected_up_to({selector}, trace->step_count() - 1, *trace).empty();
        });
      for (Slider& slider : beat.sliders) reach_own(slider);
      std::erase_if(beat.sliders, [&](const Slider& slider) { return !can_slide(slider); });
    }
    return write_beat(beat, languages());
  }
  Languages languages() const { return document_.lesson ? document_.lesson->languages : Languages{}; }

  // Its range with the number that it begins at now, which an edit may have put outside.
  void reach_own(Slider& slider) const {
    const auto own = number_at(inputs_, slider.input);
    if (!own) return;
    slider.from = std::min(slider.from, *own);
    slider.to = std::max(slider.to, *own);
  }

  // A slider of these inputs still, at both of its ends.
  bool can_slide(const Slider& slider) const {
    const auto goes_to = [&](const Exact& end) {
      const auto edited = edits::with_number_at(*document_.algorithm, inputs_, slider.input, end, false);
      return edited && (record<double>(*document_.algorithm, *edited) || record<Exact>(*document_.algorithm, *edited));
    };
    return number_at(inputs_, slider.input) && goes_to(slider.from) && goes_to(slider.to);
  }

  bool can_ask(const Checkpoint& checkpoint, std::uint32_t step) const {
    std::vector<const LocalText*> texts{&checkpoint.ask, &checkpoint.right, &checkpoint.wrong};
    for (const LocalText& item : checkpoint.items) texts.push_back(&item);
    for (const Checkpoint::Choice& choice : checkpoint.choices) {
      texts.push_back(&choice.text);
      texts.push_back(&choice.feedback);
    }
    return std::ranges::all_of(texts, [&](const LocalText* text) {
      return std::ranges::all_of(text->texts(), [&](const auto& each) { return can_say(each.second, step); });
    });
  }

  const Document& document_;
  const Inputs<Exact>& inputs_;
  std::optional<Rounded> rounded_;
  std::optional<Fractions> exact_;
};

void add_edited(Members& members, const Document& document, const Inputs<Exact>& inputs) {
  const Writer writer(document, inputs);
  add_run(members, *document.algorithm, inputs, writer.beats(), writer.asks(), document.marking);
}

}  // namespace

std::string as_lesson(const Document& document, const Inputs<Exact>& inputs, const std::string& id,
                      const std::string& title, const std::map<std::size_t, Inputs<Exact>>& edited) {
  Members members;
  const auto add = [&](const char* key, const std::string& text) {
    if (!is_blank(text)) members.emplace_back(key, json_string(text));
  };
  const Languages languages = document.lesson ? document.lesson->languages : Languages{};
  const auto add_local = [&](const char* key, const LocalText& text) {
    if (!text.empty()) members.emplace_back(key, write_local_text(text, languages));
  };
  const auto add_list = [&](const char* key, std::vector<Json> items) {
    if (!items.empty()) members.emplace_back(key, json_array(std::move(items)));
  };
  const Json& root = document.json.root();
  if (const Json* schema = document.lesson ? root.find("$schema") : nullptr) members.emplace_back("$schema", *schema);
  add("schema", "blossom.lesson/1");
  add("id", as_id(id));
  LocalText called(printable(is_blank(title) ? document.title() : title));
  if (document.lesson)  // what it is called in other languages stays
    for (std::size_t i = 1; i < document.lesson->title.texts().size(); ++i)
      called.add(document.lesson->title.texts()[i].first, document.lesson->title.texts()[i].second);
  add_local("title", called);
  if (document.lesson) {
    add_local("unit", document.lesson->unit);
    add_local("summary", document.lesson->summary);
    add("source", document.lesson->source);
    if (document.lesson->minutes > 0)
      members.emplace_back("minutes", json_number(std::to_string(document.lesson->minutes)));
    if (languages.own != Languages{}.own) add("language", languages.own);
    add_list("languages", strings(languages.others));
    std::vector<Json> objectives;
    for (const LocalText& objective : document.lesson->objectives)
      objectives.push_back(write_local_text(objective, languages));
    add_list("objectives", std::move(objectives));
    add_list("prerequisites", strings(document.lesson->prerequisites));
    add_list("exercises", strings(document.lesson->exercises));
  } else if (document.grader) {
    add("unit", document.grader->exercise().unit);
    add("source", document.grader->exercise().source);
  }
  if (document.lesson && document.lesson->scene_count() > 1) {
    std::vector<Json> scenes;
    for (std::size_t i = 0; i < document.lesson->scene_count(); ++i) {
      const LessonScene& scene = document.lesson->scene_at(i);
      Members parts{{"id", json_string(scene.scene)}, {"title", write_local_text(scene.heading, languages)}};
      const auto of_scene = edited.find(i);
      if (i == document.scene) {
        add_edited(parts, document, inputs);
      } else if (of_scene != edited.end()) {
        Document other = document;
        other.show_scene(i);
        add_edited(parts, other, of_scene->second);
      } else {
        add_run(parts, *scene.algorithm, scene.inputs, beats_of(scene, languages), scene.asks, scene.marking);
      }
      scenes.push_back(json_object(std::move(parts)));
    }
    members.emplace_back("scenes", json_array(std::move(scenes)));
  } else {
    add_edited(members, document, inputs);
  }
  return write_json(json_object(std::move(members))) + "\n";
}

}  // namespace blossom
