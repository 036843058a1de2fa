#pragma once
// One open document: its inputs as they are edited, the run of them, and where one is in it. After every edit the run
// is recorded anew and one stays at the same step: the one that makes the value one was looking at. A value that an
// edit takes away and a later one brings back is found again.

#include "player/document.hpp"
#include "player/edit.hpp"
#include "player/field.hpp"
#include "player/history.hpp"
#include "scene/recording.hpp"
#include "trace/timeline.hpp"

namespace blossom {

class Session {
 public:
  static Checked<std::unique_ptr<Session>> open(Document, bool exact);

  const Document& document() const { return document_; }
  const Algorithm& algorithm() const { return *document_.algorithm; }
  const Inputs<Exact>& inputs() const { return history_.current(); }
  const Recording& recording() const { return *recording_; }
  std::shared_ptr<const Recording> shared_recording() const { return recording_; }
  std::uint64_t version() const { return version_; }  // another one for every recording there ever was
  bool edited() const { return !(inputs() == document_.inputs); }
  bool unsaved() const { return !saved_ || !(inputs() == *saved_); }
  void mark_saved() { saved_ = inputs(); }
  void mark_never_saved() { saved_.reset(); }  // what is open is nowhere but here

  // Where one is.
  const Timeline& timeline() const { return *timeline_; }
  std::uint32_t step() const { return timeline_->position(); }
  std::uint32_t last() const { return timeline_->last(); }
  // Moves by any function of the timeline: move([](Timeline& t) { return t.forward(); }). True if the step changed.
  template <class Move>
  bool move(Move&& how) {
    const bool moved = how(*timeline_);
    if (moved) {
      remember_place();
      history_.end_gesture();  // what is typed or dragged after a step is an edit of its own
    }
    return moved;
  }
  bool seek(std::uint32_t step) {
    return move([=](Timeline& t) { return t.seek(step); });
  }
  // The step that makes the value of this name, if there is one.
  bool seek(const std::string& value);

  // What is said here: the lesson's words, or the algorithm's own. A lesson's words are about its own numbers: where
  // the inputs were edited the algorithm's own words come first, and these stand in `lesson`.
  struct Words {
    std::string text;
    std::string lesson;  // what the lesson says, written for its own numbers; empty while these are what one sees
  };
  Words words() const;
  void speak(std::string language) { language_ = std::move(language); }
  // Whether the inputs differ from the document's only in what sliders of its beats move: what a beat with sliders says
  // is meant for those numbers, too.
  bool only_slid() const;
  // Whether something is unsaved that one would miss: sliders are moved again in a moment.
  bool would_be_missed() const { return !saved_ || (unsaved() && !only_slid()); }
  const std::vector<Beat>& beats() const { return beats_; }
  const Beat* beat() const;  // of this step
  std::vector<std::uint32_t> bookmarks() const { return bookmarks_; }
  void set_bookmarks(std::vector<std::uint32_t>);
  void toggle_bookmark();

  // An edit: taken, or refused and nothing changes but rejected(). `what` is for "Undo ..."; see History for gestures.
  bool edit(Edited, const std::string& what, const std::string& gesture = {});
  // The number at a path of the inputs set. A control point of weight 0 has no place: where this gives it a weight
  // again, it comes back to where it was last.
  Edited with_number_at(std::string_view path, const Exact&) const;
  void end_gesture();
  void cancel_gesture();  // what it did is undone, and not to be redone
  const Diagnostics& rejected() const { return rejected_; }
  void forget_rejected() { rejected_.clear(); }
  bool undo();
  bool redo();
  const History<Inputs<Exact>>& history() const { return history_; }
  bool revert();                            // to the document's inputs, as an edit
  FieldTexts& fields() { return fields_; }  // what is typed and not applied
  const FieldTexts& fields() const { return fields_; }

  bool exact() const { return exact_; }  // as wished; recording().source().exact is what is
  void set_exact(bool);

  // The file again, as it is now on disk: at the same step, edits kept in the history below the new inputs.
  // Diagnostics, and nothing changed, if it cannot be run.
  Diagnostics reload(Document);

  // Predicting.
  Prediction* prediction() { return prediction_.get(); }
  const Prediction* prediction() const { return prediction_.get(); }
  Diagnostics start_prediction();  // from the beginning
  void stop_prediction() { prediction_.reset(); }

 private:
  Session(Document, bool exact);
  Diagnostics record(const Inputs<Exact>&, bool in_gesture);  // nothing changes if it fails
  void take(std::shared_ptr<const Recording>);
  void remember_place();
  std::uint32_t place_again() const;
  bool show_history();

  Document document_;
  std::string language_;  // empty: the lesson's own
  History<Inputs<Exact>> history_;
  std::optional<Inputs<Exact>> saved_;
  std::shared_ptr<const Recording> recording_;
  std::unique_ptr<Timeline> timeline_;
  std::vector<Beat> beats_;
  std::vector<std::uint32_t> bookmarks_;
  Diagnostics rejected_;
  FieldTexts fields_;
  std::unique_ptr<Prediction> prediction_;
  bool exact_ = true;
  bool exact_failed_ = false;  // the last try was too large for it
  double exact_seconds_ = 0;   // what it took
  std::uint64_t version_ = 0;

  struct Place {
    std::string value;  // that the step makes
    std::string phase;  // that it introduces
    std::uint32_t step = 0;
  };
  Place place_;
};

}  // namespace blossom
