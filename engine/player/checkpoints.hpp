#pragma once
// The questions that a lesson's beats ask, over all of its scenes: what was answered, what it is worth, and the answer
// that is being made. The first answer to a question is marked at once and stands, for the mark may tell what is right;
// who was wrong may try again, which changes nothing of that. A question may be skipped and answered later.

#include <map>
#include <memory>

#include "grader/lesson_grader.hpp"
#include "lesson/lesson.hpp"

namespace blossom {

class Checkpoints {
 public:
  struct Marked {
    std::string answer;  // as an answers file has it
    bool right = false;
    std::string words;  // what the lesson says to it, a text of prose.hpp; may be empty
    std::string note;   // what the grader says of it, plain; may be empty
  };
  struct Item {
    std::size_t scene = 0;
    std::uint32_t step = 0;  // in the lesson's own run
    Checkpoint checkpoint;
    std::optional<Marked> first;  // which counts
    std::optional<Marked> again;  // the last of further ones
    bool skipped = false;

    bool open() const { return !first && !skipped; }
    const Marked* last() const { return again ? &*again : first ? &*first : nullptr; }
  };

  Checkpoints() = default;
  explicit Checkpoints(std::shared_ptr<const Lesson>);

  const std::vector<Item>& items() const { return items_; }  // in the order in which they are asked
  const Item& item(std::size_t i) const { return items_[i]; }
  std::optional<std::size_t> find(std::string_view id) const;
  std::size_t answered() const;
  std::size_t right() const;  // at the first time

  // The answer that is being made to the question one looks at; another question begins an empty one.
  struct Reply {
    std::size_t item = SIZE_MAX;
    std::vector<std::string> numbers;   // of a value, as typed
    std::vector<std::string> meant;     // what a click counts as that is near enough; empty: what the numbers say
    std::size_t size = 0;               // how many these are; 0: any number of them
    std::vector<std::size_t> order;     // shown items, as one has put them
    std::optional<std::size_t> choice;  // of an order: the shown item that keys move
    std::string problem;                // why it was not taken
    bool trying_again = false;
    bool wants_keyboard = false;
  };
  const Reply& reply() const { return reply_; }
  void look_at(std::size_t item, std::size_t size);
  void keyboard_given() { reply_.wants_keyboard = false; }
  void type(std::size_t number, std::string text);
  void type(std::vector<std::string> numbers);
  void click(std::vector<std::string> numbers, std::vector<std::string> meant);
  void choose(std::size_t choice);
  void move(std::size_t place, int by);  // of an order: the item at this place goes up or down
  // What a key does while one is asked: a letter chooses, arrows move what is chosen of an order, Enter answers, or
  // asks for the keyboard where something is to be typed. Other keys are not for the question.
  bool wants_key(std::string_view key) const;
  void key(std::string_view key, std::string_view language = {});
  // Whether an answer may be given now: to what is answered only after try_again().
  bool takes() const;
  void try_again();
  // Marks the reply. False: it is no answer, and its `problem` says why. What is said to it is in this language.
  bool submit(std::string_view language = {});
  bool submit_line(int line, std::string_view language = {});

  void skip(std::size_t item);

  // {"schema": "blossom.answers/1", "exercise": the lesson's id, "answers": {...}}: the first answers.
  std::string answers_file() const;
  // As they are remembered: what is no answer to these questions is passed over.
  std::map<std::string, std::string> answers() const;
  std::vector<std::string> skipped() const;
  void restore(const std::map<std::string, std::string>& answers, const std::vector<std::string>& skipped,
               std::string_view language = {});

 private:
  std::string reply_text() const;
  bool take(const std::string& answer, std::string_view language);

  std::shared_ptr<const Lesson> lesson_;
  std::vector<Item> items_;
  Reply reply_;
};

}  // namespace blossom
