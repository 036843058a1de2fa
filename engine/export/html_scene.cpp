#include "export/html_scene.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/typeset.hpp"
#include "base/utf8.hpp"
#include "export/html_text.hpp"
#include "render/painter.hpp"
#include "scene/panel_parts.hpp"
#include "scene/panels.hpp"
#include "scene/scheme.hpp"

namespace blossom {
namespace {

// Pictures for two columns on a desk and for a phone in one's hand, where letters have the same size. Below those of
// curves there are knots.
struct Size {
  double width, height;
};
constexpr Size wide{760, 540}, wide_above_knots{760, 440}, small{360, 310};
constexpr double smallest_text = 10.5;
constexpr double basis_height = 112;
constexpr std::size_t longest_formula = 220;  // a knot vector of hundreds of knots is not for a line
constexpr std::size_t longest_cell = 44;
constexpr std::size_t most_indents = 6;  // of code, as the style sheet has them
// What asking one person for a value is about: more numbers are typed into one field.
constexpr std::size_t most_fields = 4;

std::string shortened_end(const std::string& text, std::size_t most = longest_formula) {
  std::size_t at = 0, count = 0;
  for (; at < text.size() && count < most; ++count) at += std::max<std::size_t>(utf8_length(text, at), 1);
  return at < text.size() ? text.substr(0, at) + " ..." : text;
}

// Things that several steps show, each written once and called by its number.
template <class Key>
class Once {
 public:
  template <class Make>
  std::size_t operator()(const Key& key, Make&& make) {
    const auto [found, added] = index_.emplace(key, index_.size());
    if (added) html_ += make(found->second);
    return found->second;
  }
  const std::string& html() const { return html_; }
  bool empty() const { return index_.empty(); }

 private:
  std::map<Key, std::size_t> index_;
  std::string html_;
};

// Where the pictures of a step and of its stops are seen from; nothing: where the beats say.
struct Cameras {
  std::optional<Camera> desk, small;
};

class SceneWriter {
 public:
  using Codes = Once<const Algorithm*>;

  SceneWriter(HtmlPage& page, const StoryScene& scene, Codes& codes)
      : page_(page), scene_(scene), source_(scene.source()), graph_(*source_.graph), codes_(codes) {
    knots_ = source_.curves.size() == 1 && knot_axis(source_, 0, 0, wide.width).has_value();
    result_ = knots_ && resulting_knots(source_, scene.recording->last()) != absent;
  }

  // `sliders`: what stands under the words, and the JSON of its stops.
  void add(const StoryStep& told, const Cameras& cameras = {}, const HtmlScene& sliders = {}) {
    const Algorithm& algorithm = source_.algorithm_at(told.step);
    const std::size_t code = codes_(&algorithm, [&](std::size_t i) { return code_html(algorithm, i); });
    std::string step = "{\"n\":" + std::to_string(told.step);
    if (told.beat != nullptr) step += ",\"b\":1";
    if (told.beat != nullptr && told.beat->waits)
      step += ",\"p\":-1";
    else if (told.beat != nullptr && told.beat->seconds > 0)
      step += ",\"p\":" + format_short(told.beat->seconds, 2);
    step += ",\"w\":" + picture(told.step, desk(), cameras.desk) + ",\"s\":" + picture(told.step, small, cameras.small);
    if (knots_) step += ",\"k\":" + knots(told.step, wide.width) + ",\"l\":" + knots(told.step, small.width);
    step += ",\"c\":" + std::to_string(code) + ",\"f\":" + std::to_string(told.line);
    add_values(step, told.step);
    const bool asks = page_.checkpoints && told.question;
    if (asks) step += ",\"q\":" + question_json(*told.question);
    if (!sliders.json.empty()) step += ",\"a\":" + sliders.json;
    steps_json_ += (steps_json_.empty() ? "" : ",\n") + step + "}";
    steps_html_ += step_html(told, algorithm, asks, sliders.html);
  }

  // With what its sliders can show. False: stop.
  bool add_with_stops(const StoryStep& told, const std::function<bool()>& done) {
    const StepSliders* sliders = page_.sliders.of(told);
    if (sliders == nullptr) return add(told), done();
    std::vector<std::optional<StoryScene>> stops;
    for (std::size_t i = 0; i < sliders->count(); ++i) {
      const bool own = i == sliders->own();
      stops.push_back(own ? std::nullopt : page_.sliders.run(scene_, told, i));
      if (!own && !done()) return false;
    }
    const auto camera = [&](Size size) { return common_camera(scene_, told.step, stops, size.width, size.height); };
    const Cameras cameras{camera(desk()), camera(small)};
    std::string places;
    for (std::size_t i = 0; i < stops.size(); ++i) {
      const bool own = i == sliders->own();
      places += (places.empty() ? "" : ",") + (own ? "null" : stops[i] ? std::to_string(page_.stops.size()) : "-1");
      if (stops[i]) {
        SceneWriter writer(page_, *stops[i], codes_);
        writer.add(stops[i]->steps.front(), cameras);
        page_.stops.push_back(writer.stop());
        stops[i].reset();
      }
      if (!own && !done()) return false;
    }
    add(told, cameras, {sliders_html(told, *sliders), sliders_json(*sliders, places)});
    return done();
  }

  HtmlScene scene(std::size_t number) const {
    const std::string id = "scene" + std::to_string(number);
    HtmlScene made;
    made.html = "<section class=\"scene\" id=\"" + id + "\">\n";
    if (!scene_.heading.empty()) made.html += "<h2>" + html_escape(scene_.heading) + "</h2>\n";
    made.html += "<details class=\"all\" open>\n<summary>" + std::string(page_.words("steps")) +
                 "</summary>\n<ol class=\"steps\"";
    if (!scene_.steps.empty()) made.html += " start=\"" + std::to_string(scene_.steps.front().step) + "\"";
    made.html += ">\n" + steps_html_ + "</ol>\n</details>\n" + parts(codes_.html()) + "</section>\n";
    made.json = "{\"id\":" + json_quote(scene_.id) + ",\"title\":" + json_quote(scene_.heading) + ",";
    made.json += sizes_and_steps() + "}";
    return made;
  }

  HtmlScene stop() const {
    return {"<template class=\"stop\">\n" + steps_html_ + parts("") + "</template>\n", "{" + sizes_and_steps() + "}"};
  }

 private:
  // What the steps share.
  std::string parts(const std::string& codes) const {
    return "<div class=\"parts\">\n" + codes + schemes_.html() +
           "<template class=\"values\"><table class=\"values\"><tbody>\n" + rows_.html() +
           "</tbody></table></template>\n</div>\n";
  }
  std::string sizes_and_steps() const {
    const auto size = [](double width, double height) {
      return "[" + format_short(width, 0) + "," + format_short(height, 0) + "]";
    };
    std::string json =
        "\"size\":{\"w\":" + size(wide.width, desk().height) + ",\"s\":" + size(small.width, small.height);
    if (knots_) json += ",\"k\":" + size(wide.width, knots_height()) + ",\"l\":" + size(small.width, knots_height());
    return json + "},\"steps\":[\n" + steps_json_ + "\n]";
  }

  // ---- pictures -----------------------------------------------------------------------------------------------------

  std::string painted(View view) {
    for (Label& label : view.labels)
      label.size_scale = std::max(label.size_scale, smallest_text / HtmlLooks::probe()[label.role].text_size);
    HtmlCanvas canvas(page_.looks);
    paint_view(view, HtmlLooks::probe(), page_.fonts, canvas, 1, {0, 0}, {0, 0, view.width, view.height});
    return page_.numbers_of(std::move(canvas).take());
  }
  std::string picture(std::uint32_t step, Size size, const std::optional<Camera>& camera) {
    return painted(camera ? scene_.picture(step, size.width, size.height, *camera)
                          : scene_.picture(step, size.width, size.height));
  }

  Size desk() const { return knots_ ? wide_above_knots : wide; }
  double knots_height() const { return basis_height + (result_ ? knot_lines_height : knot_line_height) + 4; }
  std::string knots(std::uint32_t step, double width) {
    Sheet sheet;
    sheet.view.width = width;
    sheet.view.height = knots_height();
    const Emphasis none;
    add_basis(sheet, source_, step, none, 0, 0, width, basis_height);
    add_knot_line(sheet, source_, step, none, 0, basis_height, width - basis_bar_room, 0, true, result_);
    return painted(sheet.view);
  }

  // ---- values -------------------------------------------------------------------------------------------------------

  RichText name_of(ValueId v) const {
    const ValueRecord& record = graph_.value(v);
    return typeset_name(record.name, source_.algorithm_at(record.step));
  }

  void add_values(std::string& step, std::uint32_t k) {
    const Scheme* scheme = scheme_at(source_, k);
    const ValueId main = graph_.main_value(k);
    const bool made = main != absent && !graph_.is_input(main);
    if (made) step += ",\"v\":" + std::to_string(main);
    if (scheme != nullptr) {
      const std::size_t number = schemes_(scheme, [&](std::size_t i) { return scheme_html(*scheme, i); });
      step += ",\"t\":" + std::to_string(number);
      if (made) add_operands(step, *scheme, main);
      return;
    }
    Sheet table;
    add_value_table(table, source_, k, {}, 0, 0, wide.width);
    std::string values;
    for (const Spot& spot : table.spots) {
      const std::size_t row = rows_(spot.link.id, [&](std::size_t) { return row_html(spot.link.id); });
      values += (values.empty() ? "" : ",") + std::to_string(row);
    }
    step += ",\"g\":[" + values + "]";
    std::string now;
    for (std::size_t i = 0; made && i < table.spots.size(); ++i)
      if (graph_.value(table.spots[i].link.id).step == k) now += (now.empty() ? "" : ",") + std::to_string(i);
    if (!now.empty()) step += ",\"h\":[" + now + "]";
  }

  void add_operands(std::string& step, const Scheme& scheme, ValueId v) const {
    const auto from = graph_.operands(v);
    const auto weights = parts::weights_of(source_, v);
    std::string operands, shares;
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (scheme.find(from[i]) == nullptr) continue;
      operands += (operands.empty() ? "" : ",") + std::to_string(from[i]);
      shares += (shares.empty() ? "" : ",") + json_quote(weights[i]);
    }
    if (!operands.empty()) step += ",\"o\":[" + operands + "],\"x\":[" + shares + "]";
  }

  std::string row_html(ValueId v) const {
    return "<tr><th scope=\"row\">" + html_names(name_of(v)) + "</th><td>" +
           html_escape(shortened_end(source_.value_text(v))) + "</td></tr>\n";
  }

  // Each cell is two rows high, so that it can stand between the two it comes from.
  std::string scheme_html(const Scheme& scheme, std::size_t number) const {
    const auto line_of = [](const Scheme::Cell& cell) { return std::max(std::lround(2 * cell.row), 0L); };
    long lines = 0;
    for (const auto& cell : scheme.cells) lines = std::max(lines, line_of(cell) + 2);
    std::vector<std::string> rows(static_cast<std::size_t>(lines));
    const auto gap = [&](long from, long to) {
      if (from < to) rows[static_cast<std::size_t>(from)] += "<td rowspan=\"" + std::to_string(to - from) + "\"></td>";
    };
    for (int column = 0; column < scheme.column_count(); ++column) {
      long at = 0;
      for (std::size_t i = scheme.columns[static_cast<std::size_t>(column)];
           i < scheme.columns[static_cast<std::size_t>(column) + 1]; ++i) {
        const Scheme::Cell& cell = scheme.cells[i];
        gap(at, line_of(cell));
        rows[static_cast<std::size_t>(line_of(cell))] += cell_html(cell.value, column == 0);
        at = line_of(cell) + 2;
      }
      gap(at, lines);
    }
    std::string html = "<table class=\"scheme\" data-t=\"" + std::to_string(number) + "\">\n<caption>" +
                       std::string(page_.words("scheme")) + "</caption>\n<thead><tr>";
    for (int column = 0; column < scheme.column_count(); ++column)
      html += "<th scope=\"col\">" + filled(page_.words("level"), "n", std::to_string(column)) + "</th>";
    html += "</tr></thead>\n<tbody>\n";
    for (const std::string& row : rows) html += "<tr>" + row + "</tr>\n";
    return html + "</tbody>\n</table>\n";
  }

  std::string cell_html(ValueId v, bool at_edge) const {
    return "<td rowspan=\"2\"" + std::string(at_edge ? " class=\"edge\"" : "") + " data-v=\"" + std::to_string(v) +
           "\" data-s=\"" + std::to_string(graph_.value(v).step) + "\"><div><b>" + html_names(name_of(v)) +
           "</b> <span>" + html_escape(parts::shortened(source_.value_text(v), longest_cell)) + "</span></div></td>";
  }

  // ---- words --------------------------------------------------------------------------------------------------------

  std::string code_html(const Algorithm& algorithm, std::size_t number) const {
    std::string html = "<ol class=\"code\" data-c=\"" + std::to_string(number) + "\" lang=\"en\" aria-label=\"" +
                       html_escape(page_.words("code")) + "\">\n";
    for (const std::string_view line : algorithm.pseudo_code) {
      const std::size_t blanks = std::min(line.find_first_not_of(' '), line.size());
      html += "<li><code class=\"in" + std::to_string(std::min<std::size_t>(blanks / 2, most_indents)) + "\">" +
              html_escape(line.substr(blanks)) + "</code></li>\n";
    }
    return html + "</ol>\n";
  }

  std::string step_html(const StoryStep& told, const Algorithm& algorithm, bool asks,
                        const std::string& sliders) const {
    std::string html =
        "<li data-step=\"" + std::to_string(told.step) + "\" value=\"" + std::to_string(told.step) + "\"";
    if (told.line > 0) html += " data-line=\"" + std::to_string(told.line) + "\"";
    html += ">\n";
    if (!told.phase.empty()) html += "<p class=\"phase\">" + html_typeset(told.phase, algorithm) + "</p>\n";
    html += "<div class=\"say\">" + html_prose(told.prose, algorithm) + "</div>\n" + formula_html(told.step, algorithm);
    if (asks) html += question_html(*told.question, algorithm);
    return html + sliders + "</li>\n";
  }

  std::string formula_html(std::uint32_t step, const Algorithm& algorithm) const {
    const ValueId v = graph_.main_value(step);
    if (v == absent || graph_.is_input(v)) return {};
    const std::string own = source_.own_name(v), value = source_.value_text(v);
    const RichText name = own.find('.') == std::string::npos ? typeset_name(graph_.value(v).name, algorithm)
                                                             : typeset_text(own, algorithm);
    std::string html = "<div class=\"formula\">\n<p class=\"value\">" + html_names(name) + " = <b>" +
                       html_escape(shortened_end(value)) + "</b></p>\n";
    const auto line = [&](std::string_view style, const std::string& text) {
      html += "<p class=\"" + std::string(style) + "\">" + html_typeset(shortened_end(text), algorithm) + "</p>\n";
    };
    const std::string formula = source_.formula(v), numbers = source_.numbers(v), made = source_.made_text(v);
    line("names", "= " + formula);
    if (numbers != formula && numbers != value) line("numbers", "= " + numbers);
    // Of a rational curve it is the homogeneous point that equals this; the point itself stands above.
    if (made != value) line("numbers", "= " + made.substr(0, made.find(": ")));
    if (const std::string polar = source_.polar(v); !polar.empty())
      line("polar", std::string(page_.words("blossom")) + " " + polar);
    return html + "</div>\n";
  }

  // ---- sliders ------------------------------------------------------------------------------------------------------

  std::string number_text(const Exact& x) const {
    return source_.exact ? format_brief(x) : format_short(x.to_double(), 4);
  }

  std::string sliders_json(const StepSliders& sliders, const std::string& stops) const {
    std::string values, start;
    for (const StepSliders::Scale& scale : sliders.scales) {
      std::string texts;
      for (const Exact& x : scale.values) texts += (texts.empty() ? "" : ",") + json_quote(number_text(x));
      values += (values.empty() ? "[" : ",[") + texts + "]";
      start += (start.empty() ? "" : ",") + std::to_string(scale.own);
    }
    return "{\"values\":[" + values + "],\"start\":[" + start + "],\"stops\":[" + stops + "]}";
  }

  std::string sliders_html(const StoryStep& told, const StepSliders& sliders) const {
    const Algorithm& algorithm = source_.algorithm_at(told.step);
    std::string html = "<template class=\"sliders\">\n";
    for (std::size_t i = 0; i < sliders.scales.size(); ++i) {
      const Slider& slider = told.beat->sliders[i];
      const StepSliders::Scale& scale = sliders.scales[i];
      const std::string label = slider.label.empty() ? slider.input : printable(slider.label.in(scene_.language));
      const std::string now = html_escape(number_text(scale.values[scale.own]));
      const auto end = [&](const Exact& x) {
        return "<span aria-hidden=\"true\">" + html_escape(number_text(x)) + "</span>";
      };
      html += "<div class=\"slider\"><p>" + html_typeset(label, algorithm) + " = <b>" + now + "</b></p>\n<div>" +
              end(scale.values.front()) + "<input type=\"range\" min=\"0\" max=\"" +
              std::to_string(scale.values.size() - 1) + "\" step=\"1\" value=\"" + std::to_string(scale.own) +
              "\" aria-label=\"" + html_escape(label) + "\" aria-valuetext=\"" + now + "\">" +
              end(scale.values.back()) + "</div></div>\n";
    }
    return html + "</template>\n";
  }

  // ---- questions ----------------------------------------------------------------------------------------------------

  std::string question_html(const StoryStep::Question& asked, const Algorithm& algorithm) const {
    const auto block = [&](std::string_view tag, const std::string& attributes, const Prose& prose) {
      return "<" + std::string(tag) + " " + attributes + ">" + html_prose(prose, algorithm) + "</" + std::string(tag) +
             ">\n";
    };
    std::string html = "<div class=\"ask\">\n<p class=\"head\">" + std::string(page_.words("question")) + "</p>\n";
    html += block("div", "class=\"words\"", asked.ask);
    if (!asked.options.empty()) {
      html += "<ol type=\"a\" class=\"options\">\n";
      for (const Prose& option : asked.options) html += block("li", "class=\"option\"", option);
      html += "</ol>\n";
    }
    html += block("template", "class=\"right\"", asked.right) + block("template", "class=\"wrong\"", asked.wrong);
    for (const Prose& feedback : asked.feedback) html += block("template", "class=\"feedback\"", feedback);
    return html + "<div class=\"room\"></div>\n</div>\n";
  }

  std::string question_json(const StoryStep::Question& asked) const {
    const Checkpoint& checkpoint = *asked.checkpoint;
    std::string json = "{\"id\":" + json_quote(checkpoint.id) +
                       ",\"kind\":" + json_quote(checkpoint_kind_name(checkpoint.kind)) +
                       ",\"answer\":" + json_quote(asked.answer);
    if (!asked.numbers.empty()) {
      std::string numbers;
      for (const double x : asked.numbers)
        numbers += (numbers.empty() ? "" : ",") + (std::isfinite(x) ? format_number(x) : "null");
      json += ",\"numbers\":[" + numbers + "]";
      if (asked.numbers.size() <= most_fields) json += ",\"fields\":" + std::to_string(asked.numbers.size());
    }
    if (checkpoint.kind == Checkpoint::Kind::predict) json += ",\"decimals\":" + std::to_string(checkpoint.decimals);
    if (const auto value = graph_.find(checkpoint.value); value && graph_.value(*value).kind == ValueKind::integer)
      json += ",\"whole\":1";
    if (checkpoint.kind == Checkpoint::Kind::span) json += spans_json(checkpoint);
    return json + "}";
  }

  // The spans of the curve that are not empty, to be picked: [index, "[1/4, 1/2)"].
  std::string spans_json(const Checkpoint& checkpoint) const {
    if (source_.curves.size() != 1 || checkpoint.value.empty() || checkpoint.value[0] != 'k') return {};
    const auto& curve = source_.curves[0];
    constexpr std::size_t most_spans = 24;
    std::string spans;
    std::size_t count = 0;
    for (int i = curve.degree; i <= curve.n(); ++i) {
      const double from = curve.knots[static_cast<std::size_t>(i)], to = curve.knots[static_cast<std::size_t>(i) + 1];
      if (!(from < to)) continue;
      spans += (count++ == 0 ? "[" : ",[") + std::to_string(i) + "," +
               json_quote("[" + knot_text(i) + ", " + knot_text(i + 1) + (i == curve.n() ? "]" : ")")) + "]";
    }
    return count == 0 || count > most_spans ? std::string() : ",\"spans\":[" + spans + "]";
  }
  std::string knot_text(int i) const {
    const auto v = graph_.find("U[" + std::to_string(i) + "]");
    return v ? source_.value_text(*v) : format_short(source_.curves[0].knots[static_cast<std::size_t>(i)], 4);
  }

  HtmlPage& page_;
  const StoryScene& scene_;
  const StepSource& source_;
  const TraceGraph& graph_;
  Codes& codes_;
  bool knots_ = false, result_ = false;
  Once<const Scheme*> schemes_;
  Once<ValueId> rows_;
  std::string steps_html_, steps_json_;
};

}  // namespace

std::string HtmlPage::numbers_of(std::vector<std::string> of_picture) {
  std::string numbers;
  for (std::string& element : of_picture) {
    const auto [found, added] = index.try_emplace(element, elements.size());
    if (added) elements.push_back(std::move(element));
    numbers += (numbers.empty() ? "" : ",") + std::to_string(found->second);
  }
  return "[" + numbers + "]";
}

std::optional<HtmlScene> html_scene(HtmlPage& page, const StoryScene& scene, std::size_t number,
                                    const std::function<bool()>& told) {
  SceneWriter::Codes codes;
  SceneWriter writer(page, scene, codes);
  for (const StoryStep& step : scene.steps)
    if (!writer.add_with_stops(step, told)) return std::nullopt;
  return writer.scene(number);
}

}  // namespace blossom
