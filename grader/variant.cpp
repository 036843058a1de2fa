#include "grader/variant.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "base/json_write.hpp"
#include "grader/variant_trial.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_draws = 20'000;  // for one variant

std::string demand_text(const VariantMaker::Prepared& prepared, const Demand& demand) {
  const auto& part = prepared.model.parts[demand.part].name;
  switch (demand.kind) {
    case Demand::Kind::no_knot:
      return "what must not be a knot is one";
    case Demand::Kind::requirement:
      return json_quote(prepared.vary.require[demand.index]->words) + " is not met";
    case Demand::Kind::inputs:
      return "the algorithm does not take the inputs";
    case Demand::Kind::same_steps:
      return "the run has not the model's steps and values";
    case Demand::Kind::not_zero:
      return part + " is 0 (or a ratio of 1)";
    case Demand::Kind::no_input:
      return part + " is one of the inputs";
    case Demand::Kind::no_operand:
      return part + " is what it is made from";
    case Demand::Kind::denominators:
      return part + " has too large a denominator";
    case Demand::Kind::likeness:
      return "there is too much or too little to write";
    case Demand::Kind::misconception:
      return json_quote(prepared.model.run.algorithm->misconceptions[demand.index].id) + " gives the right value of " +
             part;
    case Demand::Kind::exercise:
      return "the exercise is in order no longer";
  }
  return "";
}

// How often each demand was not met, and what was said of it the last time.
struct Count {
  std::size_t times = 0;
  std::string why;
};
using Counts = std::map<Demand, Count>;

// What failed most, as far as it is worth saying.
std::string most_often(const VariantMaker::Prepared& prepared, const Counts& counts, std::size_t draws) {
  std::vector<std::pair<std::size_t, Demand>> order;
  for (const auto& [demand, count] : counts) order.emplace_back(count.times, demand);
  std::ranges::stable_sort(order, std::greater(), [](const auto& entry) { return entry.first; });
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(order.size(), 3); ++i)
    text += (i == 0 ? "" : "; ") + demand_text(prepared, order[i].second) + " (in " + std::to_string(order[i].first) +
            " of " + std::to_string(draws) + " draws)";
  return text;
}

Diagnostics at_vary(const VariantMaker::Prepared& prepared, const std::vector<std::string>& messages) {
  Diagnostics diagnostics;
  const Cursor root(prepared.document, diagnostics);
  const auto vary = root.optional("vary");
  for (const auto& message : messages) vary->error(message);
  return diagnostics;
}

// What draws that come to values have in each place that varies.
class Seen {
 public:
  explicit Seen(const VariantMaker::Prepared& prepared) : prepared_(&prepared) {}

  void add(const Json& inputs) {
    const auto& slots = prepared_->vary.slots;
    first_.resize(slots.size());
    varies_.resize(slots.size());
    for (std::size_t i = 0; i < slots.size(); ++i) {
      if (varies_[i]) continue;
      std::string here = write_json(at_path(inputs, slots[i].path));
      if (first_[i].empty())
        first_[i] = std::move(here);
      else
        varies_[i] = here != first_[i];
    }
  }

  // Ranges of more values than one that are always the same.
  Diagnostics check(std::size_t draws) const {
    constexpr std::size_t least = 20;
    Diagnostics diagnostics;
    if (draws < least) return diagnostics;
    const Cursor list = *Cursor(prepared_->document, diagnostics).optional("vary")->optional("inputs");
    for (std::size_t i = 0; i < first_.size(); ++i) {
      const Slot& slot = prepared_->vary.slots[i];
      if (!varies_[i] && prepared_->vary.choices[slot.choices].count > 1)
        list[slot.entry].error(slot.name + " never varies: in each of " + std::to_string(draws) +
                               " draws that have the model's steps it is " + printable(first_[i]));
    }
    return diagnostics;
  }

 private:
  const VariantMaker::Prepared* prepared_;
  std::vector<std::string> first_;
  std::vector<bool> varies_;
};

// Whether it is about the values of a run, not about how one comes to it.
bool is_of_values(Demand::Kind kind) { return kind > Demand::Kind::same_steps; }

// Demands that were met in none of so many draws, a message for each; those of one misconception together.
std::vector<std::string> never_met(const VariantMaker::Prepared& prepared, const Counts& counts, std::size_t draws) {
  std::vector<std::string> messages;
  const std::string in_each = " in each of " + std::to_string(draws) + " draws";
  const auto is_never = [&](const auto& entry) {
    return is_of_values(entry.first.kind) && entry.second.times >= draws;
  };
  const auto next = [&](auto it) { return std::find_if(it, counts.end(), is_never); };
  for (auto it = next(counts.begin()); it != counts.end();) {
    const Demand demand = it->first;
    const std::string last = "; in the last, " + it->second.why;
    std::string parts = prepared.model.parts[demand.part].name;
    for (it = next(std::next(it)); it != counts.end() && demand.kind == Demand::Kind::misconception &&
                                   it->first.kind == demand.kind && it->first.index == demand.index;
         it = next(std::next(it)))
      parts += ", " + prepared.model.parts[it->first.part].name;
    if (demand.kind == Demand::Kind::misconception)
      messages.push_back(json_quote(prepared.model.run.algorithm->misconceptions[demand.index].id) +
                         " gives the right value of " + parts + in_each + last +
                         ". Vary more, ask for something else, or name the pair in \"except\"");
    else
      messages.push_back("no draw is acceptable:" + in_each + " " + demand_text(prepared, demand) + last);
  }
  return messages;
}

}  // namespace

VariantMaker::VariantMaker(const JsonDocument& exercise) : prepared_(std::make_shared<const Prepared>(exercise)) {}

Checked<JsonDocument> VariantMaker::make(std::string_view student_id, std::string_view secret) const {
  VariantStream stream(secret, prepared_->model.id, student_id);
  Json inputs = prepared_->inputs;
  Counts unmet;
  for (std::size_t i = 0; i < most_draws; ++i) {
    draw(prepared_->vary, stream, inputs);
    Trial trial(*prepared_, inputs);
    const bool good = trial.acceptable([&](const Demand& demand, const auto&) {
      ++unmet[demand].times;
      return false;
    });
    if (good) return std::move(trial.document());
  }
  return at_vary(*prepared_, {"no variant for " + excerpt(student_id) + " was found in " + std::to_string(most_draws) +
                              " draws: " + most_often(*prepared_, unmet, most_draws)});
}

Diagnostics VariantMaker::check() const {
  constexpr std::size_t sample = 64, most = 4000, rare = 200, enough = 20;
  VariantStream stream("", prepared_->model.id, "");
  Json inputs = prepared_->inputs;
  Counts unmet;
  Seen seen(*prepared_);
  std::size_t draws = 0, acceptable = 0, sampled = 0;
  // Of those that come to values, each demand is looked at for itself, so that all that is never met is named.
  for (; sampled < sample && draws < most; ++draws) {
    draw(prepared_->vary, stream, inputs);
    Trial trial(*prepared_, inputs);
    std::map<Demand, std::string> here;
    trial.acceptable([&](const Demand& demand, const auto& why) {
      if (!here.contains(demand)) here[demand] = why();
      return is_of_values(demand.kind);
    });
    for (auto& [demand, why] : here) {
      ++unmet[demand].times;
      unmet[demand].why = std::move(why);
    }
    acceptable += here.empty() ? 1 : 0;
    if (!trial.exercise()) continue;
    ++sampled;
    seen.add(inputs);
  }
  if (sampled == 0) {
    const auto& [demand, count] =
        *std::ranges::max_element(unmet, {}, [](const auto& entry) { return entry.second.times; });
    return at_vary(*prepared_,
                   {"no draw is acceptable: of " + std::to_string(draws) + " draws, in " + std::to_string(count.times) +
                    " " + demand_text(*prepared_, demand) + "; in the last of them, " + count.why});
  }
  if (auto never = check_ranges(*prepared_); !never.empty()) return never;
  if (auto never = seen.check(sampled); !never.empty()) return never;
  if (const auto messages = never_met(*prepared_, unmet, sampled); !messages.empty())
    return at_vary(*prepared_, messages);
  for (; acceptable < enough && draws < most; ++draws) {
    draw(prepared_->vary, stream, inputs);
    acceptable += Trial(*prepared_, inputs).acceptable([&](const Demand& demand, const auto&) {
      ++unmet[demand].times;
      return false;
    });
  }
  if (acceptable * rare >= draws) return {};
  return at_vary(*prepared_, {"only " + std::to_string(acceptable) + " of " + std::to_string(draws) +
                              " draws are acceptable, fewer than one in " + std::to_string(rare) + "; most often " +
                              most_often(*prepared_, unmet, draws)});
}

bool varies(const JsonDocument& exercise) { return exercise.root().find("vary") != nullptr; }

Checked<JsonDocument> make_variant(const JsonDocument& exercise, std::string_view student_id, std::string_view secret) {
  if (!varies(exercise)) return exercise;
  return VariantMaker(exercise).make(student_id, secret);
}

Diagnostics check_variants(const JsonDocument& exercise) {
  return varies(exercise) ? VariantMaker(exercise).check() : Diagnostics{};
}

Checked<std::string> load_secret(const std::filesystem::path& path) {
  constexpr std::size_t least = 16, most = 4096;
  const auto refuse = [&](const std::string& why) { return Diagnostics{{path.string(), 0, 0, "", why}}; };
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    return refuse(error ? "cannot be read: " + error.message() : "is no regular file");
  std::ifstream in(path, std::ios::binary);
  std::string secret(most + 3, '\0');
  in.read(secret.data(), static_cast<std::streamsize>(secret.size()));
  if (in.bad() || (!in && !in.eof())) return refuse("cannot be read");
  secret.resize(static_cast<std::size_t>(in.gcount()));
  if (secret.ends_with('\n')) {
    secret.pop_back();
    if (secret.ends_with('\r')) secret.pop_back();
  }
  if (secret.size() < least || secret.size() > most)
    return refuse("a secret has at least " + std::to_string(least) + " bytes and at most " + std::to_string(most) +
                  "; this one has " + (secret.size() > most ? "more" : std::to_string(secret.size())));
  return secret;
}

}  // namespace blossom
