#include "player/checkpoints.hpp"

#include <algorithm>
#include <numeric>

#include "base/json_write.hpp"
#include "player/field.hpp"

namespace blossom {
namespace {

constexpr JsonLimits answer_limits{1u << 16, 4, 10'000};

bool is_value(const Checkpoint& checkpoint) {
  return checkpoint.kind == Checkpoint::Kind::predict || checkpoint.kind == Checkpoint::Kind::span;
}

// The answer marked; of what cannot be read the note says why.
std::pair<Verdict, Checkpoints::Marked> marked(const Lesson& lesson, const Checkpoints::Item& item,
                                               const std::string& answer, std::string_view language) {
  const auto document = JsonDocument::parse("answer", answer, answer_limits);
  if (!document) return {Verdict::invalid, {answer, false, {}, "The answer is too long."}};
  auto mark = mark_checkpoint(lesson, item.scene, item.checkpoint, document->root(), language);
  return {mark.verdict, {answer, mark.verdict == Verdict::correct, std::move(mark.words), std::move(mark.note)}};
}

std::string number_json(const std::string& typed) {
  const auto x = typed_number(typed);
  return x ? write_json(json_number(*x)) : json_quote(typed);
}

}  // namespace

Checkpoints::Checkpoints(std::shared_ptr<const Lesson> lesson) : lesson_(std::move(lesson)) {
  for (std::size_t scene = 0; scene < lesson_->scene_count(); ++scene)
    for (const Beat& beat : lesson_->scene_at(scene).beats)
      if (beat.checkpoint) items_.push_back({scene, beat.step, *beat.checkpoint, {}, {}, false});
}

std::optional<std::size_t> Checkpoints::find(std::string_view id) const {
  const auto found = std::ranges::find_if(items_, [&](const Item& item) { return item.checkpoint.id == id; });
  return found == items_.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - items_.begin()));
}

std::size_t Checkpoints::answered() const {
  return static_cast<std::size_t>(std::ranges::count_if(items_, [](const Item& i) { return i.first.has_value(); }));
}

std::size_t Checkpoints::right() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(items_, [](const Item& item) { return item.first && item.first->right; }));
}

// ---- the reply ------------------------------------------------------------------------------------------------------

void Checkpoints::look_at(std::size_t item, std::size_t size) {
  if (reply_.item == item && reply_.size == size) return;
  reply_ = {};
  reply_.item = item;
  reply_.size = size;
  if (items_[item].checkpoint.kind == Checkpoint::Kind::order) {
    reply_.order.resize(items_[item].checkpoint.items.size());
    std::iota(reply_.order.begin(), reply_.order.end(), 0u);
  }
}

bool Checkpoints::takes() const {
  return reply_.item < items_.size() && (!items_[reply_.item].first || reply_.trying_again);
}

void Checkpoints::type(std::size_t number, std::string text) {
  if (reply_.numbers.size() <= number) reply_.numbers.resize(number + 1);
  reply_.numbers[number] = std::move(text);
  reply_.meant.clear();
  reply_.problem.clear();
}

void Checkpoints::type(std::vector<std::string> numbers) { click(std::move(numbers), {}); }

void Checkpoints::click(std::vector<std::string> numbers, std::vector<std::string> meant) {
  reply_.numbers = std::move(numbers);
  reply_.meant = std::move(meant);
  reply_.problem.clear();
}

void Checkpoints::choose(std::size_t choice) {
  if (!takes()) return;
  const Checkpoint& checkpoint = items_[reply_.item].checkpoint;
  if (choice >= checkpoint.choices.size() + checkpoint.items.size()) return;
  reply_.choice = choice;
  reply_.problem.clear();
}

namespace {

bool is_lettered(const Checkpoint& checkpoint) { return !checkpoint.choices.empty() || !checkpoint.items.empty(); }

// The option that a key names.
std::optional<std::size_t> option_of(const Checkpoint& checkpoint, std::string_view key) {
  if (key.size() != 1 || key[0] < 'A' || key[0] > 'Z') return std::nullopt;
  const auto letter = static_cast<std::size_t>(key[0] - 'A');
  return letter < checkpoint.choices.size() + checkpoint.items.size() ? std::optional(letter) : std::nullopt;
}

}  // namespace

bool Checkpoints::wants_key(std::string_view key) const {
  if (!takes()) return false;
  const Checkpoint& checkpoint = items_[reply_.item].checkpoint;
  if (option_of(checkpoint, key)) return true;
  if (key == "Up" || key == "Down") return !checkpoint.items.empty() && reply_.choice.has_value();
  return key == "Enter" && checkpoint.kind != Checkpoint::Kind::line;
}

void Checkpoints::key(std::string_view key, std::string_view language) {
  if (!wants_key(key)) return;
  const Checkpoint& checkpoint = items_[reply_.item].checkpoint;
  if (const auto option = option_of(checkpoint, key)) return choose(*option);
  if (key == "Enter") {
    if (is_lettered(checkpoint))
      submit(language);
    else
      reply_.wants_keyboard = true;
    return;
  }
  const auto place = std::ranges::find(reply_.order, *reply_.choice) - reply_.order.begin();
  move(static_cast<std::size_t>(place), key == "Up" ? -1 : 1);
}

void Checkpoints::move(std::size_t place, int by) {
  const auto to = static_cast<std::ptrdiff_t>(place) + by;
  if (!takes() || place >= reply_.order.size() || to < 0 || to >= static_cast<std::ptrdiff_t>(reply_.order.size()))
    return;
  std::swap(reply_.order[place], reply_.order[static_cast<std::size_t>(to)]);
  reply_.problem.clear();
}

void Checkpoints::try_again() {
  if (reply_.item >= items_.size() || !items_[reply_.item].first) return;
  reply_.trying_again = reply_.wants_keyboard = true;
  reply_.choice.reset();
  reply_.numbers.clear();
  reply_.meant.clear();
}

std::string Checkpoints::reply_text() const {
  const Checkpoint& checkpoint = items_[reply_.item].checkpoint;
  if (checkpoint.kind == Checkpoint::Kind::choice)
    return json_quote(reply_.choice ? letter_of(*reply_.choice) : std::string());
  if (checkpoint.kind == Checkpoint::Kind::order) {
    std::string letters;
    for (const std::size_t shown : reply_.order) letters += letter_of(shown);
    return json_quote(letters);
  }
  std::string list;
  for (const std::string& number : reply_.meant.empty() ? reply_.numbers : reply_.meant)
    list += (list.empty() ? "" : ", ") + number_json(number);
  return reply_.size == 1 ? list : "[" + list + "]";
}

bool Checkpoints::submit(std::string_view language) {
  if (!takes()) return false;
  const Checkpoint& checkpoint = items_[reply_.item].checkpoint;
  const auto refuse = [&](std::string why) {
    reply_.problem = std::move(why);
    reply_.wants_keyboard = true;
    return false;
  };
  if (checkpoint.kind == Checkpoint::Kind::choice && !reply_.choice) return refuse("Choose one first.");
  if (checkpoint.kind == Checkpoint::Kind::line) return refuse("Pick a line of the code.");
  if (is_value(checkpoint)) {
    const bool missing = reply_.numbers.size() < std::max<std::size_t>(reply_.size, 1);
    if (missing || std::ranges::any_of(reply_.numbers, [](const auto& text) { return !typed_number(text); }))
      return refuse(std::string(number_wanted));
  }
  return take(reply_text(), language);
}

bool Checkpoints::submit_line(int line, std::string_view language) {
  return takes() && items_[reply_.item].checkpoint.kind == Checkpoint::Kind::line &&
         take(std::to_string(line), language);
}

bool Checkpoints::take(const std::string& answer, std::string_view language) {
  Item& item = items_[reply_.item];
  auto [verdict, mark] = marked(*lesson_, item, answer, language);
  if (verdict == Verdict::invalid) {
    reply_.problem = mark.note;
    reply_.wants_keyboard = true;
    return false;
  }
  (item.first ? item.again : item.first) = std::move(mark);
  item.skipped = false;
  reply_.trying_again = false;
  reply_.problem.clear();
  return true;
}

void Checkpoints::skip(std::size_t item) {
  if (item < items_.size() && items_[item].open()) items_[item].skipped = true;
}

// ---- files ----------------------------------------------------------------------------------------------------------

std::map<std::string, std::string> Checkpoints::answers() const {
  std::map<std::string, std::string> answers;
  for (const Item& item : items_)
    if (item.first) answers.emplace(item.checkpoint.id, item.first->answer);
  return answers;
}

std::vector<std::string> Checkpoints::skipped() const {
  std::vector<std::string> ids;
  for (const Item& item : items_)
    if (item.skipped) ids.push_back(item.checkpoint.id);
  return ids;
}

void Checkpoints::restore(const std::map<std::string, std::string>& answers, const std::vector<std::string>& skipped,
                          std::string_view language) {
  for (Item& item : items_) {
    if (const auto known = answers.find(item.checkpoint.id); known != answers.end())
      if (auto [verdict, mark] = marked(*lesson_, item, known->second, language); verdict != Verdict::invalid)
        item.first = std::move(mark);
    item.skipped = !item.first && std::ranges::find(skipped, item.checkpoint.id) != skipped.end();
  }
}

std::string Checkpoints::answers_file() const {
  std::string text;
  for (const Item& item : items_)
    if (item.first)
      text += (text.empty() ? "\n    " : ",\n    ") + json_quote(item.checkpoint.id) + ": " + item.first->answer;
  return "{\n  \"schema\": \"blossom.answers/1\",\n  \"exercise\": " + json_quote(lesson_ ? lesson_->id : "") +
         ",\n  \"answers\": {" + text + (text.empty() ? "" : "\n  ") + "}\n}\n";
}

}  // namespace blossom
