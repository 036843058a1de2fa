#include "lesson/checkpoint.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "base/json_write.hpp"
#include "lesson/beat.hpp"
#include "lesson/document.hpp"
#include "lesson/names.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_choices = 8;
constexpr std::array<std::string_view, 5> kind_names{"predict", "span", "line", "order", "choice"};

std::optional<Checkpoint::Kind> read_kind(const Cursor& at) {
  const auto text = at.string();
  if (!text) return std::nullopt;
  for (std::size_t i = 0; i < kind_names.size(); ++i)
    if (*text == kind_names[i]) return static_cast<Checkpoint::Kind>(i);
  at.error(R"(must be "predict", "span", "line", "order" or "choice", not )" + excerpt(*text));
  return std::nullopt;
}

std::vector<std::string> keys_of(Checkpoint::Kind kind) {
  std::vector<std::string> keys{"id", "kind", "ask", "points", "right", "wrong"};
  if (kind == Checkpoint::Kind::predict || kind == Checkpoint::Kind::span) keys.emplace_back("value");
  if (kind == Checkpoint::Kind::predict) keys.emplace_back("decimals");
  if (kind == Checkpoint::Kind::order) keys.emplace_back("items");
  if (kind == Checkpoint::Kind::choice) keys.emplace_back("choices");
  return keys;
}

// Reads the parts of a checkpoint, each with its mistakes.
class Reader {
 public:
  Reader(const Cursor& at, const Languages& languages, const Narrator<Exact>* narrator,
         std::optional<std::uint32_t> step)
      : at_(at), languages_(languages), narrator_(narrator), step_(step) {}

  LocalText text(const Cursor& at) const {
    auto text = read_local_text(at, languages_);
    if (!text) return {};
    check_template(at, *text, languages_, narrator_, step_);
    return *std::move(text);
  }
  LocalText optional_text(const Cursor& parent, std::string_view key) const {
    const auto at = parent.optional(key);
    return at ? text(*at) : LocalText();
  }

  void value(Checkpoint& made) const {
    const bool span = made.kind == Checkpoint::Kind::span;
    const auto at = span ? at_.optional("value") : at_.required("value");
    const auto name = at ? at->string() : std::optional<std::string>(span ? "k" : "");
    if (!name || name->empty()) return;
    made.value = *name;
    if (narrator_ == nullptr) return;
    const Cursor& blamed = at ? *at : at_;
    const TraceGraph& trace = narrator_->trace();
    const auto value = trace.find(*name);
    if (!value) {
      blamed.error("no value of this run is called " + excerpt(*name) + meant_values(*name, trace));
      return;
    }
    if (span && trace.value(*value).rule != &rule_info<FindSpan>)
      return blamed.error(excerpt(*name) + " is no index of a knot span");
    if (const std::uint32_t made_at = trace.value(*value).step; step_ && made_at <= *step_)
      blamed.error("nobody can be asked for " + excerpt(*name) + " here: it is made at step " +
                   std::to_string(made_at) + " and this is step " + std::to_string(*step_) +
                   "; ask at an earlier step");
  }

  void line(Checkpoint& made) const {
    if (narrator_ == nullptr || !step_) return;
    if (*step_ + 1 >= narrator_->trace().step_count()) {
      at_.error("nobody can be asked which line comes next: this is the last step");
      return;
    }
    made.line = narrator_->line(*step_ + 1);
    if (made.line == 0) at_.error("the next step stands at no line of the pseudo-code; ask at another step");
  }

  void items(Checkpoint& made) const {
    const auto items = at_.required("items");
    if (!items || !items->expect_array(2, most_choices)) return;
    for (std::size_t i = 0; i < items->size(); ++i) made.items.push_back(text((*items)[i]));
    check_different(made.items, [&](std::size_t i) { return (*items)[i]; });
  }

  void choices(Checkpoint& made) const {
    const auto choices = at_.required("choices");
    if (!choices || !choices->expect_array(2, most_choices)) return;
    const std::size_t mistakes = choices->error_count();
    for (std::size_t i = 0; i < choices->size(); ++i) {
      const Cursor choice = (*choices)[i];
      if (!choice.expect_object({"text", "feedback", "right"})) continue;
      Checkpoint::Choice read;
      if (const auto words = choice.required("text")) read.text = text(*words);
      read.feedback = optional_text(choice, "feedback");
      if (const auto right = choice.optional("right")) read.right = right->boolean().value_or(false);
      made.choices.push_back(std::move(read));
    }
    if (choices->errors_since(mistakes)) return;
    std::vector<LocalText> texts;
    for (const auto& choice : made.choices) texts.push_back(choice.text);
    check_different(texts, [&](std::size_t i) { return *(*choices)[i].optional("text"); });
    const auto right = std::ranges::count_if(made.choices, [](const auto& choice) { return choice.right; });
    if (right != 1) choices->error("must have exactly one choice with \"right\": true, not " + std::to_string(right));
  }

 private:
  // Of two that read the same, in any language, nobody could know which is meant.
  void check_different(const std::vector<LocalText>& texts, const auto& cursor_at) const {
    for (std::size_t i = 0; i < texts.size(); ++i)
      for (std::size_t before = 0; before < i; ++before) {
        const auto same = [&](const auto& text) { return texts[before].in(text.first) == text.second; };
        if (texts[i].empty() || std::ranges::none_of(texts[i].texts(), same)) continue;
        cursor_at(i).error("reads the same as the one at " + std::to_string(before) + "; nobody can tell them apart");
        break;
      }
  }

  const Cursor& at_;
  const Languages& languages_;
  const Narrator<Exact>* narrator_;
  std::optional<std::uint32_t> step_;
};

}  // namespace

std::string_view checkpoint_kind_name(Checkpoint::Kind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

std::vector<std::size_t> shown_order(const Checkpoint& checkpoint) {
  std::vector<std::size_t> order(checkpoint.items.size());
  std::iota(order.begin(), order.end(), 0u);
  // FNV-1a of the id drives a Fisher-Yates shuffle.
  std::uint32_t hash = 2166136261u;
  for (const char c : checkpoint.id) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[(hash >> 8) % i]);
    hash = hash * 16777619u + 1;
  }
  if (order.size() > 1 && std::ranges::is_sorted(order)) std::rotate(order.begin(), order.begin() + 1, order.end());
  return order;
}

std::string letter_of(std::size_t place) { return std::string(1, static_cast<char>('a' + place)); }

std::string right_letters(const Checkpoint& checkpoint) {
  switch (checkpoint.kind) {
    case Checkpoint::Kind::choice:
      for (std::size_t i = 0; i < checkpoint.choices.size(); ++i)
        if (checkpoint.choices[i].right) return letter_of(i);
      return {};
    case Checkpoint::Kind::order: {
      std::string letters(checkpoint.items.size(), '?');
      const auto shown = shown_order(checkpoint);
      for (std::size_t place = 0; place < shown.size(); ++place) letters[shown[place]] = letter_of(place)[0];
      return letters;
    }
    case Checkpoint::Kind::line:
      return std::to_string(checkpoint.line);
    case Checkpoint::Kind::predict:
    case Checkpoint::Kind::span:
      break;
  }
  return {};
}

std::optional<Checkpoint> read_checkpoint(const Cursor& at, const Languages& languages, const Narrator<Exact>* narrator,
                                          std::optional<std::uint32_t> step) {
  if (!at.is(Json::Kind::object)) {
    at.expect_object({"id", "kind", "ask"});
    return std::nullopt;
  }
  const auto kind_at = at.required("kind");
  const auto kind = kind_at ? read_kind(*kind_at) : std::nullopt;
  if (!kind) return std::nullopt;
  const std::size_t mistakes = at.error_count();
  at.expect_object(keys_of(*kind));
  Checkpoint made;
  made.kind = *kind;
  const Reader reader(at, languages, narrator, step);
  if (const auto id = at.required("id")) made.id = read_id(*id).value_or("");
  if (const auto ask = at.required("ask")) made.ask = reader.text(*ask);
  made.right = reader.optional_text(at, "right");
  made.wrong = reader.optional_text(at, "wrong");
  if (const auto points = at.optional("points")) {
    made.points = points->number().value_or(Exact(1));
    if (made.points < Exact(0) || Exact(1000) < made.points) points->error("must be from 0 to 1000");
  }
  if (const auto decimals = at.optional("decimals")) made.decimals = decimals->integer(0, 12).value_or(made.decimals);
  switch (*kind) {
    case Checkpoint::Kind::predict:
    case Checkpoint::Kind::span:
      reader.value(made);
      break;
    case Checkpoint::Kind::line:
      reader.line(made);
      break;
    case Checkpoint::Kind::order:
      reader.items(made);
      break;
    case Checkpoint::Kind::choice:
      reader.choices(made);
      break;
  }
  if (at.errors_since(mistakes)) return std::nullopt;
  return made;
}

Json write_checkpoint(const Checkpoint& checkpoint, const Languages& languages) {
  std::vector<std::pair<std::string, Json>> members{{"id", json_string(checkpoint.id)},
                                                    {"kind", json_string(checkpoint_kind_name(checkpoint.kind))},
                                                    {"ask", write_local_text(checkpoint.ask, languages)}};
  const auto add = [&](const char* key, const LocalText& text) {
    if (!text.empty()) members.emplace_back(key, write_local_text(text, languages));
  };
  if (checkpoint.points != Exact(1)) members.emplace_back("points", json_number(checkpoint.points));
  if (!checkpoint.value.empty()) members.emplace_back("value", json_string(checkpoint.value));
  if (checkpoint.kind == Checkpoint::Kind::predict && checkpoint.decimals != Checkpoint().decimals)
    members.emplace_back("decimals", json_number(std::to_string(checkpoint.decimals)));
  if (!checkpoint.items.empty()) {
    std::vector<Json> items;
    for (const LocalText& item : checkpoint.items) items.push_back(write_local_text(item, languages));
    members.emplace_back("items", json_array(std::move(items)));
  }
  if (!checkpoint.choices.empty()) {
    std::vector<Json> choices;
    for (const Checkpoint::Choice& choice : checkpoint.choices) {
      std::vector<std::pair<std::string, Json>> parts{{"text", write_local_text(choice.text, languages)}};
      if (!choice.feedback.empty()) parts.emplace_back("feedback", write_local_text(choice.feedback, languages));
      if (choice.right) {
        Json yes;
        yes.kind = Json::Kind::boolean;
        yes.boolean = true;
        parts.emplace_back("right", std::move(yes));
      }
      choices.push_back(json_object(std::move(parts)));
    }
    members.emplace_back("choices", json_array(std::move(choices)));
  }
  add("right", checkpoint.right);
  add("wrong", checkpoint.wrong);
  return json_object(std::move(members));
}

}  // namespace blossom
