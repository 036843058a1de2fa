#pragma once
// Fields of the inputs: number fields whose text stays while it is wrong, what is wrong right below, and edits that go
// to where they were made.

#include <functional>

#include "player/ui/ui.hpp"

namespace blossom {

// The edit of one input from what was typed; made when it is applied, of the inputs as they are then.
using NumberEdit = std::function<Edited(const Session&, const Exact&)>;
using PlainEdit = std::function<Edited(const Session&)>;

struct NumberField {
  std::string path;  // of the input, as diagnostics have it; the field's id
  std::string name;  // for scripts and in "Undo ...": "u", "P0 x"
  Exact value;
  NumberStyle style = NumberStyle::parameter;
  float width = 0;     // pixels
  bool quiet = false;  // what need not be looked at, such as the weight 1 of a polynomial curve
};

class InputFields {
 public:
  explicit InputFields(Ui& ui) : ui_(ui), session_(*ui.player().session()), texts_(session_.fields()) {}

  // `edit(session, x)` is called when a number is to be applied. True while the mouse is over it.
  template <class Edit>
  bool number(const NumberField& field, Edit&& edit) {
    return number_(field, [&] { return NumberEdit(edit); });
  }
  // Sends an edit of a button or a list; what is refused is said at `path`. A slider held is a gesture.
  void send(const std::string& path, const std::string& what, PlainEdit, const std::string& gesture = {});

  // What is wrong there: the text typed into it, or an edit made elsewhere, of which diagnostics have this path.
  const std::string& problem(const std::string& path, const std::string& value = {}) const;
  // A frame around the last item if something is wrong there, and the message is kept for say().
  void mark(const std::string& path, const std::string& value = {});
  // The messages kept since the last call, over the width of the panel.
  void say();
  void say(const std::string& message);
  bool wanted(std::string_view prefix) const;  // something in there must be on the screen
  // What was refused and has no field here.
  void say_rest(const std::function<bool(const std::string& path)>& has_field);
  void set_wrap(float width) { wrap_ = width; }  // pixels

 private:
  bool number_(const NumberField&, const std::function<NumberEdit()>&);
  void apply(const NumberField&, const std::string& value, const std::string& text, const NumberEdit&,
             const std::string& gesture);

  Ui& ui_;
  const Session& session_;
  const FieldTexts& texts_;
  std::vector<std::string> kept_;
  float wrap_ = 0;
};

// P₁₂: for labels and tooltips of Dear ImGui, which sets no subscripts of its own.
std::string with_subscript(std::string_view letter, std::size_t index);

}  // namespace blossom
