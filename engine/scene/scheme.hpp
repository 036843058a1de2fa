#pragma once
// The triangular computing scheme of a part of a run: which values are its cells, and where they stand. It is worked
// out once for each part and looked up at every step.

#include <map>
#include <memory>

#include "scene/display_list.hpp"
#include "scene/source.hpp"

namespace blossom {

struct Scheme {
  struct Cell {
    ValueId value = 0;
    int column = 0;
    double row = 0;  // in units of one cell, from the top; each level stands between the points it comes from
  };
  std::vector<Cell> cells;           // by column, and from above in each
  std::vector<std::size_t> columns;  // where each begins in `cells`, and the end of the last
  double rows = 0;

  int column_count() const { return static_cast<int>(columns.size()) - 1; }
  const Cell* find(ValueId) const;  // nullptr: no cell
  // The cell that a step makes; else the next one that is made; else the last.
  const Cell& current(const TraceGraph&, std::uint32_t step) const;

  // What stands in each cell in full size, and how wide (in ems) the widest of each column is.
  struct Texts {
    std::vector<RichText> names;
    std::vector<std::string> values;
    std::vector<double> name_ems, value_ems;
  };
  const Texts& texts(const StepSource&) const;

 private:
  std::vector<std::pair<ValueId, std::size_t>> by_value_;
  std::vector<std::pair<std::uint32_t, std::size_t>> by_step_;  // of the cells that are made
  mutable std::unique_ptr<Texts> texts_;
  friend Scheme make_scheme(const StepSource&, std::uint32_t phase);
};

// Of a phase that is an algorithm, or of the whole run (absent): the points or numbers that its algorithm's table puts
// into the scheme; where the table puts none, the points of degree elevation. Column 0 are the points they come from,
// or the number all others come from. No cells when there is no such value.
Scheme make_scheme(const StepSource&, std::uint32_t phase);

// The schemes of a run, each made when it is first asked for.
class Schemes {
 public:
  // Of the innermost part around the step that has one; nullptr if none has.
  const Scheme* at(const StepSource&, std::uint32_t step);

 private:
  std::map<std::uint32_t, Scheme> made_;
};
const Scheme* scheme_at(const StepSource&, std::uint32_t step);

}  // namespace blossom
