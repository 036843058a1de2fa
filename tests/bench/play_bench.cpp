// blossom-bench-play: what the frames of the player's window take, at 1280 x 720, off screen with OSMesa's software
// rasteriser; and the memory of what is open. A person's events go through the whole window, and every frame is divided
// into its parts. Each series of frames is played several times from a fresh start and of each frame the least time
// counts, so that what else the machine does is left out; medians and slowest frames are of these.
//
// blossom-bench-play [WORDS]: only series whose names contain WORDS.

#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>

#include "player/ui/ui.hpp"
#include "render/headless_context.hpp"
#include "studio/scene_file.hpp"

namespace {

using namespace blossom;
namespace fs = std::filesystem;

constexpr int repeats = 3;
const fs::path source_dir = BLOSSOM_SOURCE_DIR;

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "blossom-bench-play: %s\n", what.c_str());
  std::exit(1);
}

template <class T>
T taken(Checked<T> checked) {
  if (!checked) fail(to_string(checked.diagnostics));
  return std::move(*checked);
}

class NoDesk final : public Desk {
 public:
  void set_clipboard(const std::string&) override {}
  std::string clipboard() override { return {}; }
  bool choose_file(bool, const fs::path&, std::function<void(fs::path)>) override { return false; }
  Checked<bool> save_picture(const Scene&, const fs::path&) override { return Diagnostics(); }
};

// The OpenGL that all windows of this program draw with.
struct OpenGl {
  std::unique_ptr<HeadlessContext> context = taken(make_headless_context("osmesa"));
  GlFunctions functions = taken(load_gl_functions([this](const char* name) { return context->address_of(name); }));
  void (*finish)() = context->address_of("glFinish");
  std::shared_ptr<const Fonts> fonts = taken(Fonts::load());
};

struct Frame {
  FrameParts parts;
  double rasterising = 0;  // processor time of all threads
};

// The whole window with one document.
class OpenPlayer {
 public:
  OpenPlayer(OpenGl& gl, const Document& document)
      : gl_(gl), player_({{}, source_dir / "lessons", source_dir / "exercises", false}, desk_) {
    player_.settings.reduced_motion = true;  // every step is one frame
    Stopwatch watch;
    if (!player_.open(document)) fail(to_string(player_.problems().list));
    opening_ = watch.lap();
    ui_ = taken(Ui::create(player_, gl.functions, gl.context->is_es(), gl.fonts));
    ui_->resize(1280, 720, 1);
    watch.lap();
    first_ = frame();
    for (int i = 0; i < 5; ++i) frame();
  }

  Frame frame() {
    Stopwatch watch(CLOCK_PROCESS_CPUTIME_ID);
    player_.advance(1.0 / 60);
    ui_->frame(1.0 / 60);
    Frame made{ui_->frame_parts(), 0};
    gl_.finish();
    made.rasterising = watch.lap() - made.parts.own();
    return made;
  }
  Frame frame(Event event) {
    ui_->feed(std::move(event));
    return frame();
  }
  // A frame in which the player changes so, before anything is drawn; that counts as well.
  template <class Change>
  Frame frame_with(Change&& change) {
    Stopwatch watch;
    change(player_);
    const double changing = watch.lap();
    Frame made = frame();
    made.parts.changes += changing;
    return made;
  }

  Player& player() { return player_; }
  glm::dvec2 place(const std::string& name) const {
    const auto found = ui_->things().find(name);
    if (found == ui_->things().end()) fail("there is no " + name + " on the screen");
    return {found->second.x + found->second.width / 2, found->second.y + found->second.height / 2};
  }
  PixelRect rect(const std::string& name) const { return ui_->things().at(name); }
  std::vector<glm::dvec2> places(const std::string& beginning) const {
    std::vector<glm::dvec2> found;
    for (const auto& [name, rect] : ui_->things())
      if (name.starts_with(beginning)) found.emplace_back(rect.x + rect.width / 2, rect.y + rect.height / 2);
    return found;
  }
  double opening() const { return opening_; }
  const Frame& first_frame() const { return first_; }

 private:
  OpenGl& gl_;
  NoDesk desk_;
  Player player_;
  std::unique_ptr<Ui> ui_;
  double opening_ = 0;
  Frame first_;
};

Event event(Event::Kind kind, glm::dvec2 at = {}) {
  Event made;
  made.kind = kind;
  made.x = at.x;
  made.y = at.y;
  return made;
}

using Series = std::function<std::vector<Frame>(OpenPlayer&)>;

// ---- the table ------------------------------------------------------------------------------------------------------

std::string wanted;

// Of a name, or of a part of the names of several.
bool any_wanted(const std::string& name) {
  return name.find(wanted) != std::string::npos || wanted.find(name) != std::string::npos;
}

void head() {
  std::printf(
      "| milliseconds, median / slowest | frames | changes | panels | painting | **own work** | rasterising |\n");
  std::printf("|---|--:|--:|--:|--:|--:|--:|\n");
}

void row(const std::string& name, const std::vector<Frame>& frames) {
  std::printf("| %s | %zu |", name.c_str(), frames.size());
  const auto column = [&](const char* format, auto&& of) {
    std::vector<double> all;
    for (const Frame& frame : frames) all.push_back(of(frame));
    std::sort(all.begin(), all.end());
    std::printf(format, all[all.size() / 2] * 1e3, all.back() * 1e3);
  };
  column(" %.2f / %.2f |", [](const Frame& f) { return f.parts.changes; });
  column(" %.2f / %.2f |", [](const Frame& f) { return f.parts.panels; });
  column(" %.2f / %.2f |", [](const Frame& f) { return f.parts.painting; });
  column(" **%.2f / %.2f** |", [](const Frame& f) { return f.parts.own(); });
  column(" %.1f / %.1f |\n", [](const Frame& f) { return f.rasterising; });
  std::fflush(stdout);
}

void measure(OpenGl& gl, const std::string& name, const Document& document, const Series& series) {
  if (name.find(wanted) == std::string::npos) return;
  std::vector<Frame> best;
  for (int r = 0; r < repeats; ++r) {
    OpenPlayer window(gl, document);
    const auto frames = series(window);
    if (best.empty()) best = frames;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const auto least = [&](double& kept, double now) { kept = std::min(kept, now); };
      least(best[i].parts.changes, frames[i].parts.changes);
      least(best[i].parts.panels, frames[i].parts.panels);
      least(best[i].parts.painting, frames[i].parts.painting);
      least(best[i].rasterising, frames[i].rasterising);
    }
  }
  if (!best.empty()) row(name, best);  // there may be nothing to point at
}

// ---- what a person does ---------------------------------------------------------------------------------------------

// Around in a circle, one move of the mouse for each frame: a frame shows the last edit and makes the next.
std::vector<Frame> drag(OpenPlayer& window, const std::string& thing) {
  const glm::dvec2 from = window.place(thing);
  window.frame(event(Event::Kind::move, from));
  window.frame(event(Event::Kind::press));
  std::vector<Frame> frames;
  for (int i = 0; i < 120; ++i) {
    const double angle = 0.1 * i;
    const auto frame =
        window.frame(event(Event::Kind::move, from + 40.0 * glm::dvec2(std::cos(angle), std::sin(angle))));
    if (i >= 10) frames.push_back(frame);
  }
  window.frame(event(Event::Kind::release));
  return frames;
}

std::vector<Frame> scrub(OpenPlayer& window) {
  const PixelRect slider = window.rect("timeline slider");
  const auto at = [&](double share) {
    return glm::dvec2{slider.x + 12 + share * (slider.width - 24), slider.y + slider.height / 3};
  };
  window.frame(event(Event::Kind::move, at(0)));
  window.frame(event(Event::Kind::press));
  std::vector<Frame> frames;
  for (int i = 1; i <= 100; ++i)
    frames.push_back(window.frame(event(Event::Kind::move, at(i <= 50 ? i / 50.0 : 2 - i / 50.0))));
  window.frame(event(Event::Kind::release));
  return frames;
}

std::vector<Frame> steps(OpenPlayer& window, std::uint32_t from, bool forward) {
  window.frame_with([&](Player& p) { p.seek(from); });
  std::vector<Frame> frames;
  for (int i = 0; i < 100; ++i)
    frames.push_back(
        window.frame_with([&](Player& p) { p.move([&](Timeline& t) { return forward ? t.forward() : t.back(); }); }));
  return frames;
}

std::vector<Frame> seeks(OpenPlayer& window, const std::string& tab) {
  window.player().tab = tab;
  std::mt19937 random(7);
  std::uniform_int_distribution<std::uint32_t> any(0, window.player().session()->last());
  std::vector<Frame> frames;
  for (int i = 0; i < 40; ++i) frames.push_back(window.frame_with([&](Player& p) { p.seek(any(random)); }));
  return frames;
}

// The mouse from one spot of a panel to another.
std::vector<Frame> hover(OpenPlayer& window, const std::string& panel, double share_of_steps) {
  window.player().tab = panel == "phases" ? "phases" : "tableau";
  window.frame_with([&](Player& p) { p.seek(static_cast<std::uint32_t>(share_of_steps * p.session()->last())); });
  for (int i = 0; i < 3; ++i) window.frame();
  auto places = window.places(panel + " ");
  std::mt19937 random(11);
  std::shuffle(places.begin(), places.end(), random);
  if (places.size() > 20) places.resize(20);
  std::vector<Frame> frames;
  for (const auto& at : places) {
    frames.push_back(window.frame(event(Event::Kind::move, at)));
    frames.push_back(window.frame());
  }
  return frames;
}

// ---- documents ------------------------------------------------------------------------------------------------------

Document lesson(const std::string& name) { return taken(open_document(source_dir / "lessons" / (name + ".json"))); }

// 20 cubic profiles of 30 points: over one knot vector, or each over its own.
Document skinning(bool own_knots) {
  std::string profiles, first_knots;
  for (unsigned l = 1; l <= 20; ++l) {
    std::mt19937 random(l);
    std::uniform_real_distribution<double> height(-1, 1), span(0.5, 1.5);
    double u = 0;
    std::string knots = "0,0,0,0", points;
    for (int i = 4; i <= 30; ++i) knots += "," + format_short(u += span(random), 6);
    for (int i = 0; i < 3; ++i) knots += "," + format_short(u, 6);
    if (first_knots.empty()) first_knots = knots;
    for (int i = 0; i < 30; ++i)
      points += (i > 0 ? ",[" : "[") + std::to_string(i) + "," + format_short(height(random), 3) + "," +
                format_short(height(random) + 2.0 * l, 3) + "]";
    profiles += (l > 1 ? ",\n{\"degree\":3,\"knots\":[" : "{\"degree\":3,\"knots\":[") +
                (own_knots ? knots : first_knots) + "],\"points\":[" + points + "]}";
  }
  const std::string inputs = "{\"degree_v\":3,\"profiles\":[" + profiles + "]}";
  return taken(read_document(std::move(*JsonDocument::parse("skinning", inputs)), "skinning"));
}

// In the studio: a bicubic surface of so many points each way, with hills; its faces and its net are shown.
Workspace hilly_scene(int count) {
  Surface<Exact> surface = planar_surface(count, count, 3, 3, Exact(10));
  std::mt19937 random(3);
  std::uniform_int_distribution<int> tenths(-10, 10);
  for (HPoint<Exact>& point : surface.points) point.z = Exact::ratio(tenths(random), 10);
  Workspace scene;
  scene.id = "hills";
  scene.title = "Hills";
  SceneObject object;
  object.name = "hills";
  object.geometry = std::move(surface);
  object.shows = usual_shows(object.geometry);
  scene.objects.push_back(std::move(object));
  return scene;
}

std::vector<Frame> drag_in_studio(OpenPlayer& window, Workspace scene, const std::string& point) {
  window.player().open_scene(std::move(scene));
  for (int i = 0; i < 5; ++i) window.frame();
  return drag(window, "view " + point);
}

void whole_window(OpenGl& gl, const std::string& name, const Document& document) {
  if (!any_wanted(name)) return;
  const auto last_step = [&] {
    OpenPlayer window(gl, document);
    return window.player().session()->last();
  }();
  std::printf("| **%s: %u steps** | | | | | | |\n", name.c_str(), last_step + 1);
  const auto at = [&](double share) { return static_cast<std::uint32_t>(share * last_step); };
  measure(gl, name + ": opened, first frame", document, [](OpenPlayer& w) {
    Frame first = w.first_frame();
    first.parts.changes += w.opening();
    return std::vector{first};
  });
  measure(gl, name + ": step by step", document, [&](OpenPlayer& w) { return steps(w, at(0.5), true); });
  measure(gl, name + ": step by step back", document, [&](OpenPlayer& w) { return steps(w, at(0.9), false); });
  measure(gl, name + ": the last steps", document, [&](OpenPlayer& w) { return steps(w, last_step - 99, true); });
  measure(gl, name + ": scrubbed to the end and back", document, scrub);
  for (const char* tab : {"tableau", "inputs", "basis", "phases", "why"})
    measure(gl, name + ": random seeks, " + tab, document, [&](OpenPlayer& w) { return seeks(w, tab); });
  for (const double share : {0.7, 1.0})
    for (const char* panel : {"viewport", "tableau", "phases", "code"})
      measure(gl, name + ": pointing in " + panel + " at " + format_short(100 * share, 0) + " %", document,
              [&](OpenPlayer& w) { return hover(w, panel, share); });
}

// ---- memory ---------------------------------------------------------------------------------------------------------

double resident_megabytes() {
  std::ifstream file("/proc/self/statm");
  double all = 0, resident = 0;
  file >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

// In a process of its own: what one document leaves behind is not there for the next.
void memory_row(const std::string& name, const std::function<Document()>& document) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    OpenGl gl;
    OpenPlayer window(gl, document());
    const Session& session = *window.player().session();
    std::printf("| %s | %u | %s | %.2f | %.0f |\n", name.c_str(), session.last() + 1,
                session.recording().source().exact ? "fractions" : "decimals",
                static_cast<double>(session.recording().memory_bytes()) / 1e6, resident_megabytes());
    std::fflush(stdout);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (status != 0) fail(name + " could not be opened");
}

void memory() {
  std::printf("| opened and drawn | steps | numbers | trace, MB | resident, MB |\n|---|--:|---|--:|--:|\n");
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(source_dir / "lessons"))
    if (entry.path().extension() == ".json" && entry.path().stem().string().find("schema") == std::string::npos)
      names.push_back(entry.path().stem());
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) memory_row(name, [&] { return lesson(name); });
  memory_row("skinning 20 x 30, equal knots", [] { return skinning(false); });
  memory_row("skinning 20 x 30, own knots", [] { return skinning(true); });
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1) wanted = argv[1];
  if (any_wanted("memory")) memory();
  OpenGl gl;
  head();
  const Document de_boor = lesson("22-de-boor");
  measure(gl, "22-de-boor: a control point dragged", de_boor,
          [](OpenPlayer& w) { return drag(w, "viewport P[0][3]"); });
  measure(gl, "22-de-boor: dragged at the last step", de_boor, [](OpenPlayer& w) {
    w.frame_with([](Player& p) { p.seek(p.session()->last()); });
    w.frame();
    return drag(w, "viewport P[0][3]");
  });
  measure(gl, "22-de-boor: step by step", de_boor, [](OpenPlayer& w) { return steps(w, 0, true); });
  measure(gl, "studio: a point of a 20 x 20 surface dragged", de_boor,
          [](OpenPlayer& w) { return drag_in_studio(w, hilly_scene(20), "hills P[10][10]"); });
  measure(gl, "studio: the vase follows its profile", de_boor, [](OpenPlayer& w) {
    return drag_in_studio(w, taken(load_scene(source_dir / "lessons/scenes/vase.json")), "profile P[2]");
  });
  whole_window(gl, "equal knots", skinning(false));
  whole_window(gl, "own knots", skinning(true));
}
