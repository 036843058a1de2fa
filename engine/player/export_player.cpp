// A lesson exported from the window.
#include <unistd.h>

#include "player/player.hpp"

namespace blossom {
namespace fs = std::filesystem;

// What is open, as a file that another process can read: its own, or one with what was edited.
void Player::export_lesson(const std::string& format, const fs::path& out, std::vector<std::string> options) {
  if (!session_ || (export_ && export_->running())) return;
  const Document& document = session_->document();
  const auto edits = parked_edits();
  fs::path file = document.file, scratch;
  const bool as_it_is =
      document.kind == Document::Kind::lesson && !file.empty() && !session_->edited() && edits.empty();
  if (!as_it_is) {
    std::error_code error;
    const fs::path folder = fs::temp_directory_path(error);
    scratch = folder / ("blossom-export-" + std::to_string(getpid()) + ".json");
    const auto written =
        write_file(scratch, as_lesson(document, session_->inputs(), document.id(), document.title(), edits));
    if (!written) return show_problems("The lesson could not be exported", written.diagnostics);
    file = scratch;
  }
  std::vector<std::string> arguments{"export", file.string(), "--to",       format,
                                     "--out",  out.string(),  "--progress", "lines"};
  arguments.insert(arguments.end(), std::make_move_iterator(options.begin()), std::make_move_iterator(options.end()));
  export_.reset();
  export_.emplace(options_.program, std::move(arguments), out, std::move(scratch));
  if (!export_->running()) take_export_news();
}

// True if something is new.
bool Player::take_export_news() {
  if (!export_) return false;
  if (export_->running() && !export_->poll()) return false;
  if (export_->running()) return true;
  const auto ended = std::move(export_);
  export_.reset();
  if (ended->stopped())
    notice("The export was stopped; nothing was written.");
  else if (!ended->wrong().empty())
    show_problems("The lesson could not be exported", ended->wrong());
  else
    notice("Exported: " +
           (ended->notes().empty() ? printable(ended->out().string()) : printable(ended->notes().front())));
  return true;
}

void Player::cancel_export() {
  if (!export_) return;
  export_->stop();
  take_export_news();
}

void Player::wait_for_export() {
  if (!export_) return;
  export_->wait();
  take_export_news();
}

}  // namespace blossom
