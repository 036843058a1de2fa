#include "player/state.hpp"

#include <algorithm>
#include <map>

#include "player/studio_state.hpp"

namespace blossom {
namespace {

std::string yes(bool b) { return b ? "yes" : "no"; }

std::string number(double x) { return format_short(x, 4); }

std::string link_text(const Player& player, const Link& link) {
  static constexpr const char* kinds[] = {"none", "value",     "line",  "phase",  "step",
                                          "knot", "parameter", "basis", "object", "handle"};
  if (!link) return "none";
  if (link.kind == Link::Kind::object && player.studio() != nullptr) return thing_text(*player.studio(), link);
  const std::string kind = kinds[static_cast<std::size_t>(link.kind)];
  if (link.kind == Link::Kind::parameter) return "u";
  if (link.kind != Link::Kind::value || player.session() == nullptr) return kind + " " + std::to_string(link.id);
  return player.session()->recording().graph().name(link.id);
}

std::string joined(const std::vector<std::uint32_t>& numbers) {
  std::string text;
  for (const std::uint32_t n : numbers) text += (text.empty() ? "" : " ") + std::to_string(n);
  return text;
}

std::string dialog_name(Dialog dialog) {
  static constexpr const char* names[] = {
      "none",      "open",        "save_lesson", "save_picture",  "save_answers",    "settings",
      "shortcuts", "palette",     "go_to",       "recover",       "unsaved",         "save_scene",
      "step_with", "import_file", "export_file", "export_lesson", "save_checkpoints"};
  return names[static_cast<std::size_t>(dialog)];
}

using Reader = std::string (*)(Player&);
using SessionReader = std::string (*)(const Session&);

const std::map<std::string, Reader, std::less<>>& of_player() {
  static const std::map<std::string, Reader, std::less<>> readers{
      {"open", [](Player& p) { return yes(p.session() != nullptr); }},
      {"studio",
       [](Player& p) {
         return std::string(p.in_studio() ? "yes" : p.stepping_from_studio() ? "behind" : "no");
       }},
      {"theme", [](Player& p) { return p.settings.theme; }},
      {"text-scale", [](Player& p) { return number(p.settings.text_scale); }},
      {"tab", [](Player& p) { return p.tab; }},
      {"focus", [](Player& p) { return p.focus.empty() ? "none" : p.focus; }},
      {"dialog", [](Player& p) { return dialog_name(p.dialog); }},
      {"problems", [](Player& p) { return to_string(p.problems().list); }},
      {"notice", [](Player& p) { return p.notice(); }},
      {"clipboard", [](Player& p) { return p.desk().clipboard(); }},
      {"speed", [](Player& p) { return number(p.settings.speed); }},
      {"snap", [](Player& p) { return yes(p.settings.snap); }},
      {"quit", [](Player& p) { return yes(p.wants_to_quit()); }},
      {"shelf", [](Player& p) { return std::to_string(p.shelf() != nullptr ? p.shelf()->items().size() : 0); }},
      {"scene", [](Player& p) { return std::to_string(p.scene() + 1) + " of " + std::to_string(p.scene_count()); }},
      {"heading", [](Player& p) { return p.scene_heading(p.scene()); }},
      {"language", [](Player& p) { return p.settings.language.empty() ? "own" : p.settings.language; }},
      {"waits", [](Player& p) { return yes(p.waits_here()); }},
      {"refused", [](Player& p) { return p.slide_refused().why; }},
      {"exporting", [](Player& p) { return yes(p.exporting() != nullptr); }},
      {"checkpoint",
       [](Player& p) {
         const auto item = p.checkpoint();
         return item ? p.checkpoints().item(*item).checkpoint.id : std::string("none");
       }},
      {"skips", [](Player& p) { return yes(p.asks_to_skip()); }},
      {"checkpoints",
       [](Player& p) {
         std::string text;
         for (const auto& item : p.checkpoints().items())
           text += (text.empty() ? "" : " ") + item.checkpoint.id + "=" +
                   (item.first     ? item.first->right ? "right" : "wrong"
                    : item.skipped ? "skipped"
                                   : "open");
         return text;
       }},
      {"lost", [](Player& p) { return std::to_string(p.lost_work().size()); }},
      {"camera",
       [](Player& p) {
         const Camera c = p.shown_camera();
         return number(c.centre.x) + " " + number(c.centre.y) + " " + number(c.centre.z) + " " + number(c.height) +
                " " + number(c.azimuth) + " " + number(c.elevation) + (c.perspective ? " perspective" : "");
       }},
  };
  return readers;
}

// These need an open document.
const std::map<std::string, Reader, std::less<>>& of_open() {
  static const std::map<std::string, Reader, std::less<>> readers{
      {"motion", [](Player& p) { return number(p.motion()); }},
      {"hovered", [](Player& p) { return link_text(p, p.hovered()); }},
      {"pinned", [](Player& p) { return link_text(p, p.pinned()); }},
      {"focused", [](Player& p) { return link_text(p, p.focused); }},
      {"lit",
       [](Player& p) {
         std::string text;
         for (const ValueId v : p.emphasis().lit)
           text += (text.empty() ? "" : " ") + p.session()->recording().graph().name(v);
         return text;
       }},
      {"shares",
       [](Player& p) {
         std::string text;
         for (const auto& [v, share] : p.emphasis().shares)
           text += (text.empty() ? "" : " ") + p.session()->recording().graph().name(v) + "=" + number(share);
         return text;
       }},
      {"title", [](Player& p) { return p.title(); }},
      {"edited-in", [](Player& p) { return yes(p.unsaved()); }},
      {"why",
       [](Player& p) {
         const auto v = p.why_asked();
         return v ? p.session()->recording().graph().name(*v) : std::string("none");
       }},
  };
  return readers;
}

const std::map<std::string, SessionReader, std::less<>>& of_session() {
  static const std::map<std::string, SessionReader, std::less<>> readers{
      {"kind",
       [](const Session& s) {
         static constexpr const char* kinds[] = {"lesson", "exercise", "inputs"};
         return std::string(kinds[static_cast<std::size_t>(s.document().kind)]);
       }},
      {"step", [](const Session& s) { return std::to_string(s.step()); }},
      {"last", [](const Session& s) { return std::to_string(s.last()); }},
      {"line", [](const Session& s) { return std::to_string(s.recording().source().line(s.step())); }},
      {"narration", [](const Session& s) { return s.words().text; }},
      {"exact", [](const Session& s) { return yes(s.recording().source().exact); }},
      {"edited", [](const Session& s) { return yes(s.edited()); }},
      {"unsaved", [](const Session& s) { return yes(s.unsaved()); }},
      {"undo", [](const Session& s) { return s.history().undo_what(); }},
      {"redo", [](const Session& s) { return s.history().redo_what(); }},
      {"rejected", [](const Session& s) { return to_string(s.rejected()); }},
      {"playing", [](const Session& s) { return yes(s.timeline().playing()); }},
      {"bookmarks", [](const Session& s) { return joined(s.bookmarks()); }},
      {"marks", [](const Session& s) { return joined(s.timeline().marks()); }},
      {"loop",
       [](const Session& s) {
         const auto loop = s.timeline().loop();
         return loop ? std::to_string(loop->first) + " " + std::to_string(loop->second) : std::string("none");
       }},
      {"predicting", [](const Session& s) { return yes(s.prediction() != nullptr); }},
      {"phase",
       [](const Session& s) {
         const TraceGraph& graph = s.recording().graph();
         std::string path;
         for (const std::uint32_t phase : graph.phase_path(graph.step(s.step()).phase))
           path += (path.empty() ? "" : ".") + graph.phases()[phase].label();
         return path;
       }},
  };
  return readers;
}

// What one is asked, and what is written in its fields.
std::optional<std::string> of_question(const Player& player, const std::string& key) {
  const auto asked = player.asked();
  if (key == "doubt") {
    const Player::Doubt doubt = player.doubt();
    return doubt == Player::Doubt::none ? "none" : (doubt == Player::Doubt::stop ? "stop" : "finish");
  }
  if (!asked) return std::nullopt;
  if (key == "asked") return player.session()->prediction()->questions()[*asked].name;
  if (key == "draft") {
    std::string text;
    if (player.draft().question == *asked)
      for (const std::string& number : player.draft().numbers) text += (text.empty() ? "" : " ") + number;
    return text;
  }
  return std::nullopt;
}

std::optional<std::string> of_prediction(const Session& session, const std::string& key) {
  const Prediction* prediction = session.prediction();
  if (prediction == nullptr) return std::nullopt;
  if (key == "question") {
    const auto open = prediction->open();
    return open ? prediction->questions()[*open].name : "none";
  }
  if (key == "answered") {
    std::size_t count = 0;
    for (std::size_t i = 0; i < prediction->questions().size(); ++i) count += prediction->attempt(i) ? 1 : 0;
    return std::to_string(count) + " / " + std::to_string(prediction->questions().size());
  }
  if (key == "verdicts") {
    std::string text;
    for (std::size_t i = 0; i < prediction->questions().size(); ++i)
      if (const auto mark = prediction->mark(i))
        text += (text.empty() ? "" : " ") + prediction->questions()[i].name + "=" +
                std::string(verdict_name(mark->verdict));
    return text;
  }
  if (key == "finished") return yes(prediction->finished());
  if (key == "score") {
    const auto grade = prediction->grade();
    return grade ? number(grade->score()) : "none";
  }
  if (key == "shown") return std::to_string(prediction->shown());
  if (key == "undos") return std::to_string(prediction->undos());
  return std::nullopt;
}

std::optional<std::string> of_inputs(const Player& player, const std::string& key) {
  const Inputs<Exact>& inputs = player.session()->inputs();
  if (const auto found = inputs.values.find(key); found != inputs.values.end())
    return write_input<Exact>(found->second);
  const auto curves = curves_of(inputs);
  if (curves.empty()) return std::nullopt;
  const auto& curve = curve_at(inputs, curves[std::min(player.curve, curves.size() - 1)]);
  if (key == "degree") return std::to_string(curve.degree);
  if (key == "points") return std::to_string(curve.points.size());
  if (key == "kind-of-curve") return std::string(curve_kind_name(kind_of(curve)));
  if (key == "knots") {
    std::string text;
    for (const Exact& u : curve.knots) text += (text.empty() ? "" : " ") + u.to_string();
    return text;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> state_of(Player& player, const std::string& key) {
  if (player.in_studio()) {
    if (key == "hovered") return link_text(player, player.hovered());
    if (key == "focused") return link_text(player, player.focused);
    if (auto found = studio_state_of(*player.studio(), key)) return found;
  }
  if (const auto found = of_player().find(key); found != of_player().end()) return found->second(player);
  if (player.session() == nullptr) return std::nullopt;
  const Session& session = *player.session();
  if (const auto found = of_open().find(key); found != of_open().end()) return found->second(player);
  if (const auto found = of_session().find(key); found != of_session().end()) return found->second(session);
  const TraceGraph& graph = session.recording().graph();
  if (key.starts_with("value ")) {
    const auto v = graph.find(key.substr(6));
    return v ? std::optional(session.recording().source().value_text(*v)) : std::nullopt;
  }
  if (key.starts_with("point ")) {
    const auto v = graph.find(key.substr(6));
    if (!v || !session.recording().source().points[*v]) return std::nullopt;
    const auto at = to_page(player.shown_camera(), player.view_size(), *session.recording().source().points[*v]);
    return at ? std::optional(number(at->x) + " " + number(at->y)) : std::nullopt;
  }
  if (auto found = of_prediction(session, key)) return found;
  if (auto found = of_question(player, key)) return found;
  return of_inputs(player, key);
}

std::vector<std::string> state_keys() {
  std::vector<std::string> keys;
  const auto add = [&](const std::string& key) {
    if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
  };
  for (const auto& [key, reader] : of_player()) keys.push_back(key);
  for (const auto& [key, reader] : of_open()) keys.push_back(key);
  for (const auto& [key, reader] : of_session()) keys.push_back(key);
  for (const std::string& key : studio_state_keys()) add(key);
  for (const char* key : {"question", "answered", "verdicts", "asked", "draft", "doubt", "finished", "score", "shown",
                          "undos", "u", "degree", "points", "kind-of-curve", "knots"})
    add(key);
  return keys;
}

}  // namespace blossom
