#pragma once
// What the edits share: how a changed input is checked, and how others are made to fit it.

#include "player/edit.hpp"

namespace blossom::edits {

// The edited inputs if what is read of the text of the changed one is valid and the algorithm can take all of them.
// The other inputs are as they were, and valid.
Edited checked(const Algorithm&, Inputs<Exact> edited, std::string_view changed);
// The same, after the others were made to fit (see edit.hpp).
Edited checked_and_fitted(const Algorithm&, Inputs<Exact> edited, std::string_view changed);
// Only what the algorithm demands of inputs that are each valid alone.
Edited fitting(const Algorithm&, Inputs<Exact> edited);
// Makes the other inputs fit this one, where that is possible.
void fit_others(const Algorithm&, Inputs<Exact>&, std::string_view to);

Edited refused(std::string path, std::string message);

// The inputs with another number at a path (see number_at), read as a file's, the others as they are.
Edited with_number_at(const Algorithm&, const Inputs<Exact>&, std::string_view path, const Exact&, bool fit_others);

// "curve", "profiles[2]"
std::string path_of(const Inputs<Exact>&, const CurveAddress&);
Curve<Exact>* find_curve(Inputs<Exact>&, const CurveAddress&);  // nullptr: there is none

// Whether the other inputs are made to fit after a change.
enum class Others { stay, fit };
// Puts what `change` makes of the curve in its place. What it says is wrong is said of the input.
template <class Change>
Edited change_curve(const Algorithm& algorithm, Inputs<Exact> inputs, const CurveAddress& address, Others others,
                    Change&& change) {
  Curve<Exact>* curve = find_curve(inputs, address);
  const std::string path = path_of(inputs, address);
  if (curve == nullptr) return refused(path, "there is no such curve");
  edit::EditedCurve edited = change(std::move(*curve));
  for (Diagnostic& each : edited.diagnostics) each.path = path + (each.path.empty() ? "" : "." + each.path);
  if (!edited) return std::move(edited.diagnostics);
  *curve = std::move(*edited);
  if (others == Others::fit) fit_others(algorithm, inputs, address.input);
  return fitting(algorithm, std::move(inputs));
}

inline Diagnostic wrong(std::string path, std::string message) {
  return {"", 0, 0, std::move(path), std::move(message)};
}

}  // namespace blossom::edits
