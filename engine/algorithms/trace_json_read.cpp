#include <charconv>
#include <limits>

#include "algorithms/trace_json_parts.hpp"

namespace blossom {

using stored::homogeneous, stored::parse_fraction, stored::read_scalar, stored::read_scalars, stored::ResultReader;

namespace {

inline constexpr int max_phase_depth = 32;
inline constexpr int max_step = std::numeric_limits<int>::max();

bool is_word(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '_';
  });
}

}  // namespace

class TraceReader {
 public:
  template <Scalar S>
  static std::optional<Run<S>> read(const Cursor& at, const Algorithm& algorithm) {
    Run<S> run;
    run.algorithm = &algorithm;
    const std::size_t before = at.error_count();
    if (const auto inputs = at.required("inputs"))
      if (const auto exact = read_inputs(algorithm, *inputs)) run.inputs = convert<S>(*exact);
    if (const auto dimension = at.required("dimension")) run.trace.dimension = dimension->integer(2, 3).value_or(2);
    if (const auto rational = at.required("rational")) run.trace.rational = rational->boolean().value_or(false);
    if (const auto result = at.required("result"))
      if (auto outcome = ResultReader<S>(run.trace.dimension).read(*result)) run.outcome = std::move(*outcome);
    const auto phases = at.required("phases");
    const auto steps = at.required("steps");
    const auto values = at.required("values");
    if (!phases || !steps || !values || !phases->expect_array() || !steps->expect_array(1) || !values->expect_array())
      return std::nullopt;
    // Values stand in steps and those in phases: where one of these is wrong, what follows would only be wrong too.
    Reader<S> reader(run.trace);
    if (!reader.phases(*phases, steps->size()) || !reader.steps(*steps) || !reader.values(*values)) return std::nullopt;
    return at.errors_since(before) ? std::nullopt : std::optional(std::move(run));
  }

 private:
  template <Scalar S>
  class Reader {
   public:
    explicit Reader(Trace<S>& trace) : trace_(trace) {}

    bool phases(const Cursor& all, std::size_t steps) {
      const std::size_t before = all.error_count();
      std::vector<std::uint32_t> open;  // at the first step of the next phase
      for (std::size_t i = 0; i < all.size(); ++i) {
        const Cursor at = all[i];
        PhaseRecord record;
        if (!read_phase(at, record, static_cast<int>(steps) - 1)) return false;
        while (!open.empty() && trace_.phases_[open.back()].last_step < record.first_step) open.pop_back();
        if (record.parent != (open.empty() ? absent : open.back())) {
          at.error(open.empty() ? "must have no parent: it begins outside of all phases before it"
                                : "must have the parent " + std::to_string(open.back()) + ", in which it begins");
          return false;
        }
        if (!open.empty() && trace_.phases_[open.back()].last_step < record.last_step) {
          at.error("must end no later than its parent");
          return false;
        }
        if (i > 0 && record.first_step <= trace_.phases_.back().first_step) {
          at.error("must begin after the phase before it");
          return false;
        }
        open.push_back(static_cast<std::uint32_t>(i));
        if (open.size() > max_phase_depth) {
          at.error("nested too deep; at most " + std::to_string(max_phase_depth) + " phases");
          return false;
        }
        trace_.phases_.push_back(std::move(record));
      }
      return !all.errors_since(before);
    }

    bool steps(const Cursor& all) {
      const std::size_t before = all.error_count();
      std::size_t next = 0;
      std::uint32_t phase = absent;
      std::vector<std::string> labels;
      for (std::size_t k = 0; k < all.size(); ++k) {
        const std::uint32_t around = phase;
        while (phase != absent && trace_.phases_[phase].last_step < k) phase = trace_.phases_[phase].parent;
        if (next < trace_.phases_.size() && trace_.phases_[next].first_step == k)
          phase = static_cast<std::uint32_t>(next++);
        if (phase != around || k == 0) {
          labels.clear();
          for (const std::uint32_t p : trace_.phase_path(phase)) labels.push_back(trace_.phases_[p].label());
        }
        trace_.steps_.push_back({0, phase});
        read_step(all[k], k, labels);
      }
      return !all.errors_since(before);
    }

    bool values(const Cursor& all) {
      const std::size_t before = all.error_count();
      std::vector<std::pair<ValueId, Cursor>> labelled;
      std::uint32_t filled = 0;  // steps that know their first value
      bool sound = true;         // operands are all there and of the right kinds
      for (std::size_t i = 0; i < all.size(); ++i) {
        const Cursor at = all[i];
        const auto v = static_cast<ValueId>(i);
        ValueRecord record;
        record.numbers_at = static_cast<std::uint32_t>(trace_.numbers_.size());
        record.operands_at = static_cast<std::uint32_t>(trace_.operands_.size());
        if (!at.expect_object({"name", "kind", "value", "weight", "homogeneous", "approximate", "step", "retired",
                               "rule", "from", "polar"})) {
          sound = false;
          continue;
        }
        const std::uint32_t at_least = trace_.values_.empty() ? 0 : trace_.values_.back().step;
        if (const auto step = at.required("step")) {
          const auto k = step->integer(static_cast<int>(at_least), static_cast<int>(trace_.step_count()) - 1);
          record.step = k ? static_cast<std::uint32_t>(*k) : at_least;
          if (k && trace_.introduced_by(record.step) != absent)
            step->error("must be a step that makes values; step " + std::to_string(*k) + " introduces a phase");
        } else {
          record.step = at_least;
        }
        while (filled <= record.step) trace_.steps_[filled++].first_value = v;
        read_kind_and_numbers(at, record);
        if (!read_rule(at, record)) sound = false;
        trace_.values_.push_back(record);
        read_name(at, v);
        if (const auto retired = at.optional("retired"))
          if (const auto k = retired->integer(static_cast<int>(record.step), static_cast<int>(trace_.step_count()) - 1))
            trace_.retired_by_step_.emplace_back(v, static_cast<std::uint32_t>(*k));
        if (const auto label = at.optional("polar")) {
          labelled.emplace_back(v, *label);
          if (record.rule == nullptr || record.rule->polar == Polar::none) read_label(*label, v);
        }
      }
      while (filled < trace_.step_count()) trace_.steps_[filled++].first_value = trace_.value_count();
      if (!sound || all.errors_since(before)) return false;
      // A label that follows from others must be what follows.
      const auto labels = trace_.polar_labels();
      for (const auto& [v, at] : labelled)
        if (const std::string right = labels[v].empty() ? "" : to_string(labels[v]); at.json().text != right)
          at.error(right.empty() ? "must be left out: the operands of this value have no such labels"
                                 : "must be " + json_quote(right));
      return !all.errors_since(before);
    }

   private:
    static bool read_phase(const Cursor& at, PhaseRecord& record, int last) {
      const std::size_t before = at.error_count();
      if (!at.expect_object({"id", "index", "scoped", "algorithm", "parent", "first_step", "last_step"})) return false;
      if (const auto id = at.required("id"))
        if (auto text = id->string()) {
          if (text->empty() || text->size() > 32 || !is_word(*text))
            id->error("must be 1 to 32 letters, digits and underscores");
          record.id = std::move(*text);
        }
      if (const auto index = at.optional("index")) record.index = index->integer(0, max_step).value_or(0);
      if (const auto scoped = at.optional("scoped")) record.scoped = scoped->boolean().value_or(false);
      if (const auto algorithm = at.optional("algorithm"))
        if (auto text = algorithm->string()) {
          if (find_algorithm(*text) == nullptr) unknown(*algorithm, "algorithm", *text, algorithm_ids());
          record.algorithm = std::move(*text);
        }
      if (const auto parent = at.optional("parent"))
        record.parent = static_cast<std::uint32_t>(parent->integer(0, max_step).value_or(0));
      const auto first = at.required("first_step");
      if (const auto k = first ? first->integer(0, last) : std::nullopt)
        record.first_step = static_cast<std::uint32_t>(*k);
      const auto end = at.required("last_step");
      if (const auto k = end ? end->integer(static_cast<int>(record.first_step), last) : std::nullopt)
        record.last_step = static_cast<std::uint32_t>(*k);
      return !at.errors_since(before);
    }

    static void read_step(const Cursor& at, std::size_t k, const std::vector<std::string>& labels) {
      if (!at.expect_object({"index", "kind", "line", "phase", "text"})) return;
      if (const auto index = at.required("index")) index->integer(static_cast<int>(k), static_cast<int>(k));
      if (const auto kind = at.required("kind")) kind->string();
      if (const auto line = at.required("line")) line->integer(0, max_step);
      if (const auto text = at.required("text")) text->string();
      const auto phase = at.required("phase");
      if (!phase || !phase->expect_array(labels.size(), labels.size())) return;
      for (std::size_t i = 0; i < labels.size(); ++i)
        if (const auto label = (*phase)[i].string(); label && *label != labels[i])
          (*phase)[i].error("must be " + json_quote(labels[i]) + ", the phase that this step is in");
    }

    static void unknown(const Cursor& at, std::string_view what, const std::string& text,
                        const std::vector<std::string>& known) {
      std::string message = "there is no " + std::string(what) + " " + excerpt(text);
      if (const auto near = did_you_mean(text, known)) message += "; did you mean " + json_quote(*near) + "?";
      at.error(std::move(message));
    }

    void read_kind_and_numbers(const Cursor& at, ValueRecord& record) {
      const auto kind_at = at.required("kind");
      const auto value_at = at.required("value");
      const auto kind_text = kind_at ? kind_at->string() : std::nullopt;
      if (!kind_text || !value_at) return;
      constexpr std::array kinds{ValueKind::integer, ValueKind::scalar, ValueKind::point, ValueKind::vector,
                                 ValueKind::list};
      const auto kind = std::ranges::find(kinds, *kind_text, kind_name);
      if (kind == kinds.end()) {
        std::vector<std::string> known;
        for (const ValueKind k : kinds) known.emplace_back(kind_name(k));
        unknown(*kind_at, "kind", *kind_text, known);
        return;
      }
      record.kind = *kind;
      std::optional<std::vector<S>> numbers;
      switch (record.kind) {
        case ValueKind::integer:
        case ValueKind::scalar:
          if (auto x = read_scalar<S>(*value_at)) {
            if (int whole = 0; record.kind == ValueKind::integer && !detail::to_int(*x, whole))
              value_at->error("must be a whole number");
            numbers.emplace(1, std::move(*x));
          }
          break;
        case ValueKind::point:
          numbers = read_point(at, *value_at);
          break;
        case ValueKind::vector:
          numbers = read_scalars<S>(*value_at, 4, 4);
          break;
        case ValueKind::list:
          numbers = read_scalars<S>(*value_at, 0, SIZE_MAX);
          break;
      }
      for (const std::string_view key : {"weight", "homogeneous"})
        if (const auto extra = at.optional(key); extra && record.kind != ValueKind::point)
          extra->error("must be left out: a " + *kind_text + " has none");
      if (!numbers) return;
      if (const auto approximate = at.optional("approximate")) mark_approximate(*approximate, *numbers);
      for (const S& x : *numbers) trace_.numbers_.push_back(x);
    }

    std::optional<std::vector<S>> read_point(const Cursor& at, const Cursor& value_at) const {
      const auto dimension = static_cast<std::size_t>(trace_.dimension);
      const auto xyz = read_scalars<S>(value_at, dimension, dimension);
      std::optional<S> w = S(1);
      if (trace_.rational) {
        const auto weight = at.required("weight");
        w = weight ? read_scalar<S>(*weight) : std::nullopt;
      } else if (const auto weight = at.optional("weight")) {
        weight->error("must be left out: the trace is not rational");
      }
      const auto four_at = at.optional("homogeneous");
      const auto four = four_at ? read_scalars<S>(*four_at, 4, 4) : std::nullopt;
      if (!xyz || !w || (four_at && !four)) return std::nullopt;
      if (!four) {
        const auto P = homogeneous(*xyz, *w, trace_.rational);
        return std::vector<S>{P.x, P.y, P.z, P.w};
      }
      // The value shown must be what the four numbers say.
      const bool divide = trace_.rational && !((*four)[3] == S(0));
      bool same = !trace_.rational || (*four)[3] == *w;
      for (std::size_t i = 0; i < dimension; ++i)
        same = same && (divide ? S((*four)[i] / (*four)[3]) : (*four)[i]) == (*xyz)[i];
      // What is known in double precision only is not divided back exactly.
      if (!same && !(std::same_as<S, Exact> && at.optional("approximate")))
        four_at->error("must be the homogeneous form of value and weight");
      return four;
    }

    static void mark_approximate(const Cursor& at, std::vector<S>& numbers) {
      if constexpr (std::same_as<S, double>) {
        at.error("must be left out: the trace is not exact");
      } else {
        const auto mark = [&](S& x) {
          if (std::isfinite(x.to_double())) x = Exact::approximate(x.to_double());
        };
        if (at.is(Json::Kind::boolean)) {
          if (at.json().boolean) std::ranges::for_each(numbers, mark);
        } else if (at.expect_array(1, numbers.size())) {
          for (std::size_t i = 0; i < at.size(); ++i)
            if (const auto which = at[i].integer(0, static_cast<int>(numbers.size()) - 1))
              mark(numbers[static_cast<std::size_t>(*which)]);
        }
      }
    }

    // False when the operands cannot be used.
    bool read_rule(const Cursor& at, ValueRecord& record) {
      const auto rule_at = at.required("rule");
      const auto from = at.required("from");
      const auto text = rule_at ? rule_at->string() : std::nullopt;
      if (!text || !from || !from->expect_array()) return false;
      bool all = true;
      std::vector<ValueKind> kinds;
      for (std::size_t i = 0; i < from->size(); ++i) {
        const auto name = (*from)[i].string();
        const auto found = name ? ids_.find(*name) : ids_.end();
        if (found != ids_.end()) {
          trace_.operands_.push_back(found->second);
          kinds.push_back(trace_.values_[found->second].kind);
        } else {
          if (name) (*from)[i].error("there is no value " + excerpt(*name) + " before this one");
          all = false;
        }
      }
      if (*text == "input") {
        if (from->size() != 0) from->error("must be empty: an input is made from nothing");
        return from->size() == 0;
      }
      record.rule = find_rule(*text);
      if (record.rule == nullptr) {
        std::vector<std::string> known{"input"};
        for (const Algorithm* algorithm : algorithms())
          for (const RuleInfo* rule : algorithm->rules) known.emplace_back(rule->name);
        unknown(*rule_at, "rule", *text, known);
        return false;
      }
      if (record.rule->makes != record.kind) {
        rule_at->error("makes a value of kind " + std::string(kind_name(record.rule->makes)) + ", not " +
                       std::string(kind_name(record.kind)));
        return false;
      }
      if (all && !record.rule->accepts(kinds)) {
        from->error("these are not the operands of the rule " + json_quote(*text) + ": " +
                    std::string(record.rule->formula));
        return false;
      }
      return all;
    }

    // scope.symbol[i][j]: the scope is that of the value's phase, or of what is around its innermost scoped phase.
    void read_name(const Cursor& at, ValueId v) {
      const auto name_at = at.required("name");
      const auto text = name_at ? name_at->string() : std::nullopt;
      if (!text) return;
      Name& name = trace_.values_[v].name;
      const std::size_t dot = text->rfind('.');
      const std::string_view local = std::string_view(*text).substr(dot == std::string::npos ? 0 : dot + 1);
      const std::string_view symbol = local.substr(0, local.find('['));
      bool good = Symbol::fits(symbol) && is_word(symbol);
      name.symbol = Symbol::of(symbol);
      for (std::size_t i = symbol.size(); good && i < local.size();) {
        int index = 0;
        const auto read = std::from_chars(local.data() + i + 1, local.data() + local.size(), index);
        good = local[i] == '[' && read.ec == std::errc() && read.ptr < local.data() + local.size() &&
               *read.ptr == ']' && name.arity < 2;
        if (!good) break;
        name.index[name.arity++] = index;
        i = static_cast<std::size_t>(read.ptr - local.data()) + 1;
      }
      if (!good) {
        name_at->error("must be 1 to 8 letters, digits and underscores, with up to two indices: P[1][0]");
        return;
      }
      if (trace_.name(v) != *text) {
        name.outer = 1;
        if (trace_.name(v) != *text) {
          name_at->error("must begin with the scope of its phase, " + json_quote(scope_of(v)) +
                         ", and its indices must be plain");
          return;
        }
      }
      if (!ids_.emplace(*text, v).second) name_at->error("there is a value " + excerpt(*text) + " already");
    }

    std::string scope_of(ValueId v) {
      trace_.values_[v].name.outer = 0;
      return trace_.scope(v);
    }

    // b(1, 2, 2) or b(1, 2; 0, 0)
    void read_label(const Cursor& at, ValueId v) {
      const auto text = at.string();
      if (!text) return;
      const auto wrong = [&] {
        at.error("must be a polar label such as \"b(0, 2/5, 1)\" of up to " + std::to_string(max_degree) +
                 " arguments");
      };
      if (!text->starts_with("b(") || !text->ends_with(")")) return wrong();
      std::vector<S> arguments[2];
      int direction = 0;
      for (std::string_view rest = std::string_view(*text).substr(2, text->size() - 3);;) {
        const std::size_t end = rest.find_first_of(",;");
        const std::string_view word = rest.substr(0, end);
        auto x = parse_fraction(word);
        if (!x || arguments[direction].size() == max_degree || !std::isfinite(x->to_double())) return wrong();
        if (word.find_first_of(".e") != std::string_view::npos) x = Exact::approximate(x->to_double());
        arguments[direction].push_back(from_exact<S>(*x));
        if (end == std::string_view::npos) break;
        if (rest[end] == ';' && ++direction > 1) return wrong();
        rest.remove_prefix(std::min(end + 2, rest.size()));
      }
      trace_.polar_seeds_.push_back(
          {Trace<S>::PolarSeed::Kind::net, v, static_cast<std::uint32_t>(trace_.polar_numbers_.size()),
           static_cast<std::int32_t>(arguments[0].size()), static_cast<std::int32_t>(arguments[1].size())});
      for (const auto& list : arguments)
        trace_.polar_numbers_.insert(trace_.polar_numbers_.end(), list.begin(), list.end());
    }

    Trace<S>& trace_;
    std::unordered_map<std::string, ValueId> ids_;
  };
};

Checked<StoredTrace> read_trace(const JsonDocument& document) {
  Diagnostics diagnostics;
  const Cursor at(document, diagnostics);
  if (!at.expect_object(
          {"schema", "algorithm", "inputs", "exact", "dimension", "rational", "phases", "steps", "values", "result"}))
    return diagnostics;
  if (const auto schema = at.required("schema"))
    if (const auto text = schema->string(); text && *text != "blossom.trace/1")
      schema->error("must be \"blossom.trace/1\", not " + excerpt(*text));
  const Algorithm* algorithm = nullptr;
  if (const auto id = at.required("algorithm"))
    if (const auto text = id->string(); text && (algorithm = find_algorithm(*text)) == nullptr) {
      const auto near = did_you_mean(*text, algorithm_ids());
      id->error("there is no algorithm " + excerpt(*text) + (near ? "; did you mean " + json_quote(*near) + "?" : ""));
    }
  const auto exact_at = at.required("exact");
  const auto exact = exact_at ? exact_at->boolean() : std::nullopt;
  if (algorithm == nullptr || !exact) return diagnostics;
  const auto read = [&]<Scalar S>(S) -> Checked<StoredTrace> {
    auto run = TraceReader::read<S>(at, *algorithm);
    if (!run || !diagnostics.empty()) return diagnostics;
    return StoredTrace(std::move(*run));
  };
  return *exact ? read(Exact()) : read(0.0);
}

}  // namespace blossom
