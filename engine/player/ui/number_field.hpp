#pragma once
// Fields of a form: number fields whose text stays while it is wrong, what is wrong right below, and edits that go to
// where they were made. Forms are about the inputs of what one steps through, or about a scene of the studio.

#include <functional>

#include "player/ui/ui.hpp"

namespace blossom {

// An edit of the inputs; made when it is applied, of the inputs as they are then.
using PlainEdit = std::function<Edited(const Session&)>;

// Whom a form is about.
class FieldModel {
 public:
  virtual ~FieldModel() = default;
  virtual std::string_view panel() const = 0;    // names of fields begin with it
  virtual FieldTexts* texts(Player&) const = 0;  // nullptr: it is not open any more
  virtual const FieldTexts& texts(const Player&) const = 0;
  virtual const Diagnostics& rejected(const Player&) const = 0;  // of the last edit
  virtual void forget_rejected(Player&) const = 0;
};
const FieldModel& inputs_model();

// What a number that was typed does; false: it was refused.
using TakeNumber = std::function<bool(Player&, const Exact&, const std::string& what, const std::string& gesture)>;
using TakeEdit = std::function<bool(Player&, const std::string& what, const std::string& gesture)>;

struct NumberField {
  std::string path;  // of the input, as diagnostics have it; the field's id
  std::string name;  // for scripts and in "Undo ...": "u", "P0 x"
  Exact value;
  NumberStyle style = NumberStyle::parameter;
  float width = 0;     // pixels
  bool quiet = false;  // what need not be looked at, such as the weight 1 of a polynomial curve
};

class Fields {
 public:
  Fields(Ui& ui, const FieldModel& model)
      : ui_(ui), model_(model), texts_(model.texts(ui.player())), rejected_(model.rejected(ui.player())) {}

  // True while the mouse is over it. `make()` gives the TakeNumber, if one is needed.
  template <class Make>
  bool number_field(const NumberField& field, const Make& make) {
    return number_(field, make);
  }
  // Sends an edit of a button or a list; what is refused is said at `path`. A slider held is a gesture.
  void send_edit(const std::string& path, const std::string& what, TakeEdit, const std::string& gesture = {});

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
  bool number_(const NumberField&, const std::function<TakeNumber()>&);
  void apply(const NumberField&, const std::string& value, const std::string& text, const TakeNumber&,
             const std::string& gesture);

  Ui& ui_;
  const FieldModel& model_;
  const FieldTexts& texts_;
  const Diagnostics& rejected_;
  std::vector<std::string> kept_;
  float wrap_ = 0;
};

// Of the inputs of what is open.
class InputFields : public Fields {
 public:
  explicit InputFields(Ui& ui) : Fields(ui, inputs_model()) {}

  // `edit(session, x)` is called when a number is to be applied.
  template <class Edit>
  bool number(const NumberField& field, Edit&& edit) {
    return number_field(field, [&]() -> TakeNumber {
      return [edit](Player& player, const Exact& x, const std::string& what, const std::string& gesture) {
        return player.edit(edit(*player.session(), x), what, gesture);
      };
    });
  }
  void send(const std::string& path, const std::string& what, PlainEdit edit, const std::string& gesture = {}) {
    send_edit(
        path, what,
        [edit = std::move(edit)](Player& player, const std::string& said, const std::string& held) {
          return player.edit(edit(*player.session()), said, held);
        },
        gesture);
  }
};

// P₁₂: for labels and tooltips of Dear ImGui, which sets no subscripts of its own.
std::string with_subscript(std::string_view letter, std::size_t index);

}  // namespace blossom
