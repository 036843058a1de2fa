#include "player/shelf.hpp"

#include <algorithm>
#include <new>
#include <optional>

#include "lesson/catalog.hpp"
#include "lesson/file_kind.hpp"
#include "studio/scene_file.hpp"

namespace blossom {
namespace fs = std::filesystem;
namespace {

// For a surface, the result itself. For what goes through a triangular scheme, the last point of that scheme before the
// result: all of the construction is to be seen, and nothing covers it yet. Phases that are another algorithm have
// schemes of their own, which are not what the lesson is about.
std::uint32_t most_telling_step(const Recording& recording) {
  const TraceGraph& graph = recording.graph();
  const StepSource& source = recording.source();
  if (std::holds_alternative<Surface<double>>(source.outcome)) return recording.last();
  for (std::uint32_t step = recording.last(); step-- > 0;) {
    const ValueId v = graph.main_value(step);
    if (v == absent || graph.is_input(v) || &source.algorithm_at(step) != source.algorithm) continue;
    const ValueSpec* spec = source.spec(v);
    if (spec != nullptr && spec->tableau && graph.value(v).kind == ValueKind::point) return step;
  }
  return recording.last();
}

bool belongs_on_the_shelf(FileKind kind) {
  return kind == FileKind::lesson || kind == FileKind::exercise || kind == FileKind::unknown;
}

Checked<ShelfItem> read_item(JsonDocument json, const fs::path& file, const std::stop_token& stop) {
  auto document = read_document(std::move(json));
  if (!document) return document.diagnostics;
  ShelfItem item;
  item.file = file;
  item.id = document->id();
  item.title = document->title();
  item.kind = document->kind;
  const std::string name = file.stem().string();
  const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
  if (digits < name.size() && name[digits] == '-') item.number = name.substr(0, digits);
  if (document->lesson) {
    for (const auto& [language, title] : document->lesson->title.texts())
      if (!language.empty()) item.elsewhere += printable(title) + "\n";
    item.unit = printable(document->lesson->unit);
    item.summary = printable(document->lesson->summary);
    item.minutes = document->lesson->minutes;
    item.exercises = document->lesson->exercises;
  } else if (document->grader) {
    item.unit = printable(document->grader->exercise().unit);
    item.summary = printable(plain_text(read_prose(document->grader->exercise().prompt)));
  }
  if (stop.stop_requested()) return Diagnostics();
  auto recording = Recording::make(*document->algorithm, document->inputs, false);
  if (!recording) return recording.diagnostics;
  item.recording = std::move(*recording);
  // An exercise asks what the construction is.
  if (document->kind != Document::Kind::exercise) item.telling_step = most_telling_step(*item.recording);
  return item;
}

// Without an item and without diagnostics: a file that is of another kind, or the loading was stopped.
Checked<ShelfItem> load_item(const fs::path& file, const std::stop_token& stop) {
  try {
    auto json = JsonDocument::load(file);
    if (!json) return json.diagnostics;
    if (stop.stop_requested() || !belongs_on_the_shelf(file_kind(json->root()))) return Diagnostics();
    return read_item(std::move(*json), file, stop);
  } catch (const std::bad_alloc&) {
    return Diagnostics{{file.string(), 0, 0, "", "there is not enough memory for it"}};
  }
}

std::vector<fs::path> files_of(const fs::path& folder, Diagnostics& diagnostics) {
  std::error_code error;
  if (folder.empty() || fs::status(folder, error).type() == fs::file_type::not_found) return {};
  return json_files(fs::absolute(folder, error).lexically_normal(), diagnostics);  // as those that are open are named
}

}  // namespace

Shelf::Shelf(fs::path lessons, fs::path exercises)
    : thread_([this, lessons = std::move(lessons), exercises = std::move(exercises)](const std::stop_token& stop) {
        load(stop, lessons, exercises);
      }) {}

Shelf::~Shelf() = default;  // the thread, which is the last member, is asked to stop and waited for first

void Shelf::load(const std::stop_token& stop, const fs::path& lessons, const fs::path& exercises) {
  for (const fs::path& folder : {lessons, exercises}) {
    Diagnostics unreadable;
    const auto files = files_of(folder, unreadable);
    {
      const std::scoped_lock lock(mutex_);
      diagnostics_.insert(diagnostics_.end(), unreadable.begin(), unreadable.end());
    }
    for (const fs::path& file : files) {
      if (stop.stop_requested()) break;
      auto item = load_item(file, stop);
      const std::scoped_lock lock(mutex_);
      ++version_;
      diagnostics_.insert(diagnostics_.end(), item.diagnostics.begin(), item.diagnostics.end());
      if (item) items_.push_back(std::make_shared<const ShelfItem>(std::move(*item)));
    }
  }
  if (!lessons.empty()) load_scenes(stop, lessons / "scenes");
  const std::scoped_lock lock(mutex_);
  ++version_;
  done_ = true;
  loaded_.notify_all();
}

void Shelf::load_scenes(const std::stop_token& stop, const fs::path& folder) {
  Diagnostics wrong;
  for (const fs::path& file : files_of(folder, wrong)) {
    if (stop.stop_requested()) return;
    std::shared_ptr<const Workspace> workspace;
    try {
      const auto json = JsonDocument::load(file);
      if (!json || file_kind(json->root()) != FileKind::scene) continue;
      auto scene = read_scene(*json);
      wrong.insert(wrong.end(), scene.diagnostics.begin(), scene.diagnostics.end());
      if (scene) workspace = std::make_shared<const Workspace>(std::move(*scene));
    } catch (const std::bad_alloc&) {
      wrong.push_back({file.string(), 0, 0, "", "there is not enough memory for it"});
    }
    const std::scoped_lock lock(mutex_);
    ++version_;
    if (workspace) scenes_.push_back({file, std::move(workspace)});
  }
  const std::scoped_lock lock(mutex_);
  diagnostics_.insert(diagnostics_.end(), wrong.begin(), wrong.end());
}

std::vector<ShelfScene> Shelf::scenes() const {
  const std::scoped_lock lock(mutex_);
  return scenes_;
}

std::vector<std::shared_ptr<const ShelfItem>> Shelf::items() const {
  const std::scoped_lock lock(mutex_);
  return items_;
}

Diagnostics Shelf::diagnostics() const {
  const std::scoped_lock lock(mutex_);
  return diagnostics_;
}

bool Shelf::done() const {
  const std::scoped_lock lock(mutex_);
  return done_;
}

std::uint64_t Shelf::version() const {
  const std::scoped_lock lock(mutex_);
  return version_;
}

void Shelf::wait() {
  std::unique_lock lock(mutex_);
  loaded_.wait(lock, [this] { return done_; });
}

}  // namespace blossom
