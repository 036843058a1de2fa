#pragma once
// A checkpoint: a question that a beat asks before the run goes on. Of all kinds "id", "kind", "ask" and "points"?, and
// what is said to a right and a wrong answer, "right"? and "wrong"?.
//
//   predict   {"value": "P[1][1]", "decimals"?: 3}    what will this value be? A value that comes later
//   span      {"value"?: "k"}                         in which knot span? Answered by its index, or by picking it
//   line      {}                                      which line of the pseudo-code comes next?
//   order     {"items": [text, ...]}                  in the right order; they are shown in another one
//   choice    {"choices": [{"text", "feedback"?, "right"?: true}, ...]}    one of them is right
//
// In an answers file a checkpoint's answer stands under its id: a value as exercises have it, a span's index, a line's
// number, the letters of an order ("cab" or ["c", "a", "b"]) as they are shown, the letter of a choice.

#include "algorithms/narrate.hpp"
#include "lesson/local_text.hpp"

namespace blossom {

struct Checkpoint {
  enum class Kind : std::uint8_t { predict, span, line, order, choice };
  struct Choice {
    LocalText text;
    LocalText feedback;
    bool right = false;
  };

  std::string id;
  Kind kind = Kind::choice;
  LocalText ask;           // a template of the beat's step
  LocalText right, wrong;  // likewise; empty: nothing but that it is right or wrong
  Exact points = 1;
  std::string value;             // of predict and span: its name in the run
  int decimals = 3;              // that count, of predict
  int line = 0;                  // the right one, of line
  std::vector<LocalText> items;  // of order, in the right order
  std::vector<Choice> choices;
};

std::string_view checkpoint_kind_name(Checkpoint::Kind);

// Of an order: which item (of Checkpoint::items) stands at each place when it is asked. A function of the id and the
// number of items alone, never the right order.
std::vector<std::size_t> shown_order(const Checkpoint&);
// "a", "b", ...: what the choice, or the item shown at this place, is called.
std::string letter_of(std::size_t place);
// The right answer of a checkpoint that is not about a value, as an answers file has it: a letter, letters or a line.
std::string right_letters(const Checkpoint&);

// Nothing, with diagnostics, if it is wrong. `step` is its beat's; both may be missing while other things are wrong,
// and then only its form is checked. Where it stands it must be worth asking: a value that is made later, a step that
// comes.
std::optional<Checkpoint> read_checkpoint(const Cursor&, const Languages&, const Narrator<Exact>*,
                                          std::optional<std::uint32_t> step);
// As it stands in a file.
Json write_checkpoint(const Checkpoint&, const Languages&);

}  // namespace blossom
