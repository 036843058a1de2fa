#include "grader/examiner.hpp"

#include <algorithm>

#include "grader/digest.hpp"

namespace blossom {
namespace {

// As many as one student has at once, in any assignment of a usual size.
constexpr std::size_t most_kept = 8;

}  // namespace

Examiner::Examiner(Assignment assignment, std::string secret, Time now)
    : assignment_(std::move(assignment)), secret_(std::move(secret)), now_(now) {
  sha256_hex({});  // what it needs of the system it asks for now, outside of any sandbox
  for (std::size_t i = 0; i < assignment_.items.size(); ++i) {
    const Assignment::Item& item = assignment_.items[i];
    varies_.push_back(blossom::varies(item.document));
    shared_.emplace_back();
    makers_.emplace_back();
    if (varies_.back()) {
      makers_.back().emplace(item.document);
      continue;
    }
    Exercise exercise = item.exercise;
    exercise.feedback = assignment_.feedback_at(i, now_);
    shared_.back() = std::make_shared<const Grader>(std::move(exercise));
  }
}

Checked<std::shared_ptr<const Grader>> Examiner::grader(std::size_t item, const std::string& student_id) {
  if (!varies_[item]) return shared_[item];
  const auto made =
      std::ranges::find_if(made_, [&](const Made& known) { return known.item == item && known.student == student_id; });
  if (made != made_.end()) return made->grader;
  const JsonDocument& model = assignment_.items[item].document;
  if (secret_.empty())
    return Diagnostics{
        {model.name(), 0, 0, "vary", "each student has numbers of their own here: the course's secret is needed"}};
  const auto variant = makers_[item]->make(student_id, secret_);
  if (!variant) return variant.diagnostics;
  auto exercise = read_exercise(*variant);
  if (!exercise) return exercise.diagnostics;
  exercise->feedback = assignment_.feedback_at(item, now_);
  auto grader = std::make_shared<const Grader>(std::move(*exercise));
  if (made_.size() == most_kept) made_.erase(made_.begin());
  made_.push_back({item, student_id, grader});
  return std::shared_ptr<const Grader>(std::move(grader));
}

}  // namespace blossom
