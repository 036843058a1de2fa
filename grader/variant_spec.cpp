#include "grader/variant_spec.hpp"

#include <algorithm>
#include <charconv>
#include <numeric>

#include "algorithms/selector.hpp"
#include "base/json_write.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_slots = 4096;
constexpr std::size_t most_choices = 100'000;
constexpr int most_size = 1'000'000;  // of a drawn number
constexpr int most_denominator = 10'000;

// A place that "at" names: where, and as what it is called in messages.
struct Place {
  JsonPath path;
  std::string name;
  const Json* json;
  bool in_points = false;  // an item of an array "points"
};

// Follows a path, which may name several places, through the inputs.
class PathReader {
 public:
  PathReader(const Cursor& at, std::string_view text) : at_(&at), rest_(text) {}

  // Nothing, with a diagnostic, if the path leads nowhere.
  std::vector<Place> read(const Json& inputs) {
    places_ = {{{}, "", &inputs}};
    bool first = true;
    while (!rest_.empty()) {
      const bool ok = rest_[0] == '[' ? !first && read_index() : read_member(first);
      if (!ok) return {};
      first = false;
    }
    if (first) at_->error("must be a path into \"inputs\", such as \"curve.points[1..2]\" or \"u\"");
    return first ? std::vector<Place>{} : std::move(places_);
  }

 private:
  bool refuse(const std::string& why) const {
    at_->error(why);
    return false;
  }

  bool read_member(bool first) {
    if (!first) {
      if (rest_[0] != '.') return refuse("has no . or [ where a part ends, before " + excerpt(rest_));
      rest_.remove_prefix(1);
    }
    const std::size_t end = std::min(rest_.find_first_of(".["), rest_.size());
    const std::string_view key = rest_.substr(0, end);
    rest_.remove_prefix(end);
    std::vector<Place> found;
    for (const Place& place : places_) {
      const std::string where = place.name.empty() ? "\"inputs\"" : excerpt(place.name);
      if (place.json->kind != Json::Kind::object) return refuse(where + " has no members; it is no object");
      const auto& keys = place.json->keys;
      const auto member = std::ranges::find(keys, key);
      if (member == keys.end()) {
        const auto near = did_you_mean(key, keys);
        return refuse(where + " has no member " + excerpt(key) +
                      (near ? "; did you mean " + excerpt(*near) + "?" : ""));
      }
      const auto index = static_cast<std::size_t>(member - keys.begin());
      found.push_back(place);
      step(found.back(), index, (place.name.empty() ? "" : ".") + std::string(key));
    }
    places_ = std::move(found);
    return true;
  }

  // [3], [1..3] or [*]
  bool read_index() {
    const std::size_t end = rest_.find(']');
    if (end == std::string_view::npos) return refuse("has a [ without a ]");
    const std::string_view inside = rest_.substr(1, end - 1);
    rest_.remove_prefix(end + 1);
    std::size_t from = 0, to = 0;
    if (inside != "*") {
      const std::size_t dots = inside.find("..");
      const auto number = [](std::string_view text, std::size_t& n) {
        const auto read = std::from_chars(text.data(), text.data() + text.size(), n);
        return read.ec == std::errc() && read.ptr == text.data() + text.size();
      };
      const bool is_index = dots == std::string_view::npos
                                ? number(inside, from) && number(inside, to)
                                : number(inside.substr(0, dots), from) && number(inside.substr(dots + 2), to);
      if (!is_index || to < from)
        return refuse("has the index " + excerpt(inside) + "; it must be a number, a range such as 1..3, or *");
    }
    std::vector<Place> found;
    for (const Place& place : places_) {
      if (place.json->kind != Json::Kind::array) return refuse(excerpt(place.name) + " has no items; it is no array");
      const std::size_t size = place.json->items.size();
      const std::size_t last = inside == "*" ? size - 1 : to;
      if (size == 0 || last >= size)
        return refuse(excerpt(place.name) + " has " + std::to_string(size) + " items, from 0 on; there is no item " +
                      std::to_string(last));
      for (std::size_t i = from; i <= last; ++i) {
        if (found.size() == most_slots) return refuse("names more than " + std::to_string(most_slots) + " places");
        found.push_back(place);
        step(found.back(), i, "[" + std::to_string(i) + "]");
      }
    }
    places_ = std::move(found);
    return true;
  }

  static void step(Place& place, std::size_t index, const std::string& name) {
    place.in_points = place.json->kind == Json::Kind::array && place.name.ends_with("points");
    place.path.push_back(static_cast<std::uint32_t>(index));
    place.json = &place.json->items[index];
    place.name += name;
  }

  const Cursor* at_;
  std::string_view rest_;
  std::vector<Place> places_;
};

bool is_number(const Json& json) {
  return json.kind == Json::Kind::number || (json.kind == Json::Kind::string && Exact::parse(json.text));
}

std::optional<Exact> small_number(const Cursor& at) {
  auto x = at.number();
  if (!x) return std::nullopt;
  if (!(abs(*x) <= Exact(most_size))) {
    at.error("must be from -" + std::to_string(most_size) + " to " + std::to_string(most_size));
    return std::nullopt;
  }
  return x;
}

std::optional<Choices> read_integers(const Cursor& at) {
  if (!at.expect_array(2, 2)) return std::nullopt;
  const auto from = at[0].integer(-most_size, most_size), to = at[1].integer(-most_size, most_size);
  if (!from || !to) return std::nullopt;
  if (*to < *from) {
    at.error("must be [from, to], the smaller number first");
    return std::nullopt;
  }
  Choices choices;
  choices.count = static_cast<std::uint64_t>(*to - *from) + 1;
  choices.from = *from;
  return choices;
}

// All fractions of these denominators, each in lowest terms, in ascending order.
std::optional<Choices> read_fractions(const Cursor& at) {
  if (!at.expect_object({"denominators", "from", "to"})) return std::nullopt;
  const auto list = at.required("denominators");
  const auto from_at = at.required("from"), to_at = at.required("to");
  const auto from = from_at ? small_number(*from_at) : std::nullopt, to = to_at ? small_number(*to_at) : std::nullopt;
  if (!list || !list->expect_array(1, 100) || !from || !to) return std::nullopt;
  std::vector<Exact> values;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const auto q = (*list)[i].integer(1, most_denominator);
    if (!q) return std::nullopt;
    const Exact size = (*to - *from) * Exact(*q);
    if (size > Exact(static_cast<int>(most_choices))) {
      (*list)[i].error("gives more than " + std::to_string(most_choices) + " fractions");
      return std::nullopt;
    }
    // The first numerator at or above `from`.
    auto p = static_cast<std::int64_t>(std::floor((*from * Exact(*q)).to_double())) - 1;
    while (Exact::ratio(p, *q) < *from) ++p;
    for (; Exact::ratio(p, *q) <= *to; ++p)
      if (std::gcd(p, static_cast<std::int64_t>(*q)) == 1) values.push_back(Exact::ratio(p, *q));
  }
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  if (values.empty()) {
    at.error("there is no such fraction from " + format_brief(*from) + " to " + format_brief(*to));
    return std::nullopt;
  }
  Choices choices;
  choices.count = values.size();
  for (const Exact& x : values) choices.table.push_back(json_number(x));
  return choices;
}

// One for each coordinate.
std::vector<Choices> read_grid(const Cursor& at) {
  if (!at.expect_object({"from", "to", "step"})) return {};
  const auto from = at.required("from"), to = at.required("to");
  Exact step = 1;
  if (const auto s = at.optional("step")) {
    const auto x = small_number(*s);
    if (!x) return {};
    if (*x <= Exact(0)) {
      s->error("must be greater than 0");
      return {};
    }
    step = *x;
  }
  if (!from || !to || !from->expect_array(2, 3) || !to->expect_array(from->size(), from->size())) return {};
  std::vector<Choices> coordinates;
  for (std::size_t i = 0; i < from->size(); ++i) {
    const auto a = small_number((*from)[i]), b = small_number((*to)[i]);
    if (!a || !b) return {};
    const Exact steps = (*b - *a) / step;
    if (steps < Exact(0) || steps > Exact(most_size)) {
      (*to)[i].error(steps < Exact(0) ? "must not be less than \"from\"" : "is more than a million steps away");
      return {};
    }
    Choices& made = coordinates.emplace_back();
    made.count = static_cast<std::uint64_t>(std::floor(steps.to_double())) + 1;
    made.from = *a;
    made.step = step;
  }
  return coordinates;
}

class VaryReader {
 public:
  VaryReader(const Cursor& inputs, const Exercise& exercise) : inputs_(&inputs), exercise_(&exercise) {}

  void read(const Cursor& at) {
    if (!at.expect_object({"inputs", "require", "denominator", "likeness", "tolerance", "except"})) return;
    find_curves();
    if (const auto list = at.required("inputs"); list && list->expect_array(1, most_slots))
      for (std::size_t i = 0; i < list->size(); ++i) read_range((*list)[i], i);
    if (const auto list = at.optional("require"); list && list->expect_array())
      for (std::size_t i = 0; i < list->size(); ++i) read_requirement((*list)[i]);
    if (const auto n = at.optional("denominator"))
      if (const auto most = n->integer(1, 1'000'000'000)) vary.denominator = Exact(*most);
    if (const auto x = at.optional("likeness"))
      if (auto likeness = small_number(*x)) {
        if (*likeness < Exact(1)) x->error("must be at least 1: how many times as much to write as in the model");
        vary.likeness = std::move(*likeness);
      }
    if (const auto tolerance = at.optional("tolerance")) vary.tolerance = read_tolerance(*tolerance);
    vary.except.assign(exercise_->run.algorithm->misconceptions.size(), std::vector<char>(exercise_->parts.size(), 0));
    if (const auto list = at.optional("except"); list && list->expect_array())
      for (std::size_t i = 0; i < list->size(); ++i) read_exception((*list)[i]);
  }

  Vary vary;

 private:
  // The curves among the inputs, by their paths.
  void find_curves() {
    const Json& inputs = inputs_->json();
    for (const InputSpec& spec : exercise_->run.algorithm->inputs) {
      const auto key = std::ranges::find(inputs.keys, spec.name);
      if (key == inputs.keys.end()) continue;
      const auto index = static_cast<std::uint32_t>(key - inputs.keys.begin());
      if (spec.type == InputSpec::Type::curve) {
        vary.points_of.push_back({index});
        if (vary.knots_of.empty()) vary.knots_of = {index};
      }
      if (spec.type == InputSpec::Type::curves)
        for (std::uint32_t i = 0; i < inputs.items[index].items.size(); ++i) vary.points_of.push_back({index, i});
    }
  }

  void read_range(const Cursor& at, std::size_t entry) {
    if (!at.expect_object({"at", "integers", "fractions", "grid", "choose", "not"})) return;
    std::size_t kinds = 0;
    for (const char* kind : {"integers", "fractions", "grid", "choose"}) kinds += at.optional(kind) ? 1 : 0;
    if (kinds != 1) at.error("must have one of \"integers\", \"fractions\", \"grid\" and \"choose\"");
    const auto path = at.required("at");
    const auto text = path ? path->string() : std::nullopt;
    if (!text || kinds != 1) return;
    const auto places = PathReader(*path, *text).read(inputs_->json());
    if (places.empty()) return;

    std::vector<Choices> read;
    if (const auto grid = at.optional("grid")) {
      for (const Place& place : places)
        if (!place.in_points || place.json->kind != Json::Kind::array)
          return grid->error("is for points; " + excerpt(place.name) + " is none: give integers, fractions or choose");
      read = read_grid(*grid);
      for (const Place& place : places)
        if (!read.empty() && place.json->items.size() != read.size())
          return grid->error("has " + std::to_string(read.size()) + " coordinates, but " + excerpt(place.name) +
                             " has " + std::to_string(place.json->items.size()));
    } else if (const auto choose = at.optional("choose")) {
      if (!choose->expect_array(1, most_choices)) return;
      read.emplace_back().count = choose->size();
      read.back().table = choose->json().items;
    } else {
      const auto integers = at.optional("integers");
      const auto numbers = integers ? *integers : *at.optional("fractions");
      for (const Place& place : places)
        if (!is_number(*place.json))
          return numbers.error("is for numbers; " + excerpt(place.name) + " is none" + hint(place));
      auto choices = integers ? read_integers(numbers) : read_fractions(numbers);
      if (choices) read.push_back(std::move(*choices));
    }
    if (read.empty()) return;
    if (const auto no = at.optional("not")) read_not(*no, places);
    for (const Place& place : places) add(*path, place, entry, read.size());
    for (Choices& choices : read) vary.choices.push_back(std::move(choices));
  }

  static std::string hint(const Place& place) {
    if (place.json->kind != Json::Kind::array) return "";
    return place.in_points ? "; for points there is \"grid\""
                           : ": for each of its items it takes " + excerpt(place.name + "[*]");
  }

  // A place takes one draw, or one for each coordinate.
  void add(const Cursor& at, const Place& place, std::size_t entry, std::size_t coordinates) {
    const std::size_t first = vary.choices.size();
    for (const auto& [path, name] : taken_) {
      const std::size_t common = std::min(path.size(), place.path.size());
      if (!std::equal(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(common), place.path.begin())) continue;
      return at.error(excerpt(place.name) + " is drawn twice: " + excerpt(name) + " varies already");
    }
    taken_.emplace_back(place.path, place.name);
    if (vary.slots.size() + coordinates > most_slots)
      return at.error("more than " + std::to_string(most_slots) + " numbers vary");
    const bool is_grid = coordinates > 1;
    for (std::size_t c = 0; c < coordinates; ++c) {
      Slot slot{place.path, first + c, entry, c, place.name};
      if (is_grid) {
        slot.path.push_back(static_cast<std::uint32_t>(c));
        slot.name += "[" + std::to_string(c) + "]";
      }
      vary.slots.push_back(std::move(slot));
    }
  }

  void read_not(const Cursor& at, const std::vector<Place>& places) {
    const auto text = at.string();
    if (!text) return;
    if (*text != "a knot") return at.error("must be \"a knot\", not " + excerpt(*text));
    if (vary.knots_of.empty()) return at.error("there is no curve among the inputs whose knots these could be");
    for (const Place& place : places) {
      if (!is_number(*place.json)) return at.error("is for numbers; " + excerpt(place.name) + " is none");
      vary.no_knots.push_back(place.path);
    }
  }

  void read_requirement(const Cursor& at) {
    const auto text = at.string();
    if (!text) return;
    std::vector<std::string> known;
    std::string message = "must be one of";
    for (const Requirement& r : requirements()) {
      message += (known.empty() ? " " : ", ") + json_quote(r.words);
      known.emplace_back(r.words);
      if (r.words != *text) continue;
      if (r.only_in_plane && exercise_->run.trace.dimension == 3)
        return at.error("is for points in the plane; these have 3 coordinates");
      if (vary.points_of.empty()) return at.error("there is no curve among the inputs");
      vary.require.push_back(&r);
      return;
    }
    const auto near = did_you_mean(*text, known);
    at.error(message + ", not " + excerpt(*text) + (near ? "; did you mean " + json_quote(*near) + "?" : ""));
  }

  void read_exception(const Cursor& at) {
    if (!at.expect_object({"misconception", "value"})) return;
    const auto id_at = at.required("misconception"), value_at = at.required("value");
    const auto id = id_at ? id_at->string() : std::nullopt, value = value_at ? value_at->string() : std::nullopt;
    if (!id || !value) return;
    const auto& known = exercise_->run.algorithm->misconceptions;
    const auto found = std::ranges::find(known, *id, &Misconception::id);
    if (found == known.end()) {
      std::vector<std::string> ids;
      std::string message = "is no misconception of this algorithm; there are";
      for (const Misconception& m : known) {
        message += (ids.empty() ? " " : ", ") + std::string(m.id);
        ids.emplace_back(m.id);
      }
      const auto near = did_you_mean(*id, ids);
      id_at->error(near ? "is no misconception of this algorithm; did you mean " + excerpt(*near) + "?" : message);
    }
    std::string problem;
    const auto selector = Selector::parse(*value, problem);
    if (!selector) return value_at->error(excerpt(*value) + " is no selector: " + problem);
    bool any = false;
    for (std::size_t i = 0; i < exercise_->parts.size(); ++i) {
      if (!selector->matches(exercise_->run.trace, exercise_->parts[i].value)) continue;
      any = true;
      if (found != known.end()) vary.except[static_cast<std::size_t>(found - known.begin())][i] = 1;
    }
    if (!any) value_at->error(excerpt(*value) + " selects nothing that is asked");
  }

  const Cursor* inputs_;
  const Exercise* exercise_;
  std::vector<std::pair<JsonPath, std::string>> taken_;
};

}  // namespace

Json Choices::value(std::uint64_t n) const {
  if (!table.empty()) return table[static_cast<std::size_t>(n)];
  return json_number(from + step * Exact(static_cast<std::int64_t>(n)));
}

const Json& at_path(const Json& inputs, const JsonPath& path) {
  static const Json null;
  const Json* json = &inputs;
  for (const std::uint32_t index : path) {
    if (index >= json->items.size()) return null;
    json = &json->items[index];
  }
  return *json;
}

Json& at_path(Json& inputs, const JsonPath& path) {
  Json* json = &inputs;
  for (const std::uint32_t index : path) json = &json->items[index];
  return *json;
}

Vary read_vary(const Cursor& vary, const Cursor& inputs, const Exercise& exercise) {
  VaryReader reader(inputs, exercise);
  reader.read(vary);
  return std::move(reader.vary);
}

}  // namespace blossom
