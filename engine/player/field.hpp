#pragma once
// What somebody types into the fields of the window, until it is applied: a field shows the model's value, or the text
// typed over it, and what is wrong with that text. A field's id is the path of what it shows, as diagnostics have it:
// "u", "curve.points[2][0]", "profiles[1].knots[4]".

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/exact.hpp"

namespace blossom {

class FieldTexts {
 public:
  // The texts are about the value that was there when they were typed: as soon as the model has another one they are
  // void, and the field shows that one.
  const std::string& text(std::string_view id, const std::string& value) const;
  const std::string& error(std::string_view id, const std::string& value) const;  // empty: nothing is wrong

  void type(std::string_view id, const std::string& value, std::string text);  // not applied yet
  void refuse(std::string_view id, const std::string& value, std::string text, std::string error);
  void drop(std::string_view id);  // back to the value
  // An edit was taken: what was said of refused buttons and choices (`text` as the value is) is over.
  void accept(std::string_view id);
  void clear() { entries_.clear(); }

  bool empty() const { return entries_.empty(); }
  // Is there a text of this field, or of one whose id goes on behind it? (A row of a table is wanted while it has one.)
  bool holds(std::string_view prefix) const;
  // Is this said by any of them?
  bool says(std::string_view error) const;

 private:
  struct Entry {
    std::string value, text, error;
  };
  const Entry* current(std::string_view id, const std::string& value) const;
  std::map<std::string, Entry, std::less<>> entries_;
};

// The number that somebody typed; blanks do not count, and the typographic minus of our own labels is one.
std::optional<Exact> typed_number(std::string_view text);
inline constexpr std::string_view number_wanted = "Type a number such as 2/5, -0.5 or 3.";

// The exact number as short as people write it: parameters, knots and weights as fractions of small denominators or
// decimals ("2/5", "0.37"), coordinates as decimals where they are exact ("2.5"), anything else as a fraction.
enum class NumberStyle { parameter, coordinate };
std::string number_text(const Exact&, NumberStyle = NumberStyle::parameter);

// One up (or down) in the last place of a decimal, or in the numerator of a fraction; nothing if the text is no number.
std::optional<std::string> nudged(std::string_view text, int by);

}  // namespace blossom
