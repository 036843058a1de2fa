#pragma once
// What the edits share: how a changed input is checked, and how others are made to fit it.

#include "player/edit.hpp"

namespace blossom::edits {

// The edited inputs if what is read of the text of the changed one is valid and the algorithm can take all of them.
// The other inputs are as they were, and valid.
Edited checked(const Algorithm&, Inputs<Exact> edited, std::string_view changed);
// The same, after the others were made to fit (see edit.hpp).
Edited checked_and_fitted(const Algorithm&, Inputs<Exact> edited, std::string_view changed);
// The same, where of several curves only this one was changed.
Edited checked_and_fitted(const Algorithm&, Inputs<Exact> edited, const CurveAddress& changed);
// Only what the algorithm demands of inputs that are each valid alone.
Edited fitting(const Algorithm&, Inputs<Exact> edited);
// Makes the other inputs fit this one, where that is possible.
void fit_others(const Algorithm&, Inputs<Exact>&, std::string_view to);

Edited refused(std::string path, std::string message);

// "curve", "profiles[2]"
std::string path_of(const Inputs<Exact>&, const CurveAddress&);
Curve<Exact>* find_curve(Inputs<Exact>&, const CurveAddress&);  // nullptr: there is none

// Does `change` to a copy of the curve, checks, and fits the others. `change(curve, path)` returns what is wrong, if it
// cannot be done.
template <class Change>
Edited change_curve(const Algorithm& algorithm, Inputs<Exact> inputs, const CurveAddress& address, Change&& change) {
  Curve<Exact>* curve = find_curve(inputs, address);
  const std::string path = path_of(inputs, address);
  if (curve == nullptr) return refused(path, "there is no such curve");
  if (std::optional<Diagnostic> wrong = change(*curve, path)) return Diagnostics{*std::move(wrong)};
  return checked_and_fitted(algorithm, std::move(inputs), address);
}

inline Diagnostic wrong(std::string path, std::string message) {
  return {"", 0, 0, std::move(path), std::move(message)};
}

}  // namespace blossom::edits
