#pragma once
// A lesson made ready to be told: its scenes run, its words filled in and read, step by step. Every export tells the
// same story in its own way.

#include <memory>
#include <string>
#include <vector>

#include "export/story_links.hpp"
#include "scene/recording.hpp"

namespace blossom {

// One step of one scene.
struct StoryStep {
  std::uint32_t step = 0;
  const Beat* beat = nullptr;  // of this step, if it has one
  std::string words;           // what is said, filled in, as its file has it: a text of prose.hpp
  Prose prose;                 // the same, read
  bool own_words = true;       // false: said in another language than the story's
  std::string phase;           // "Profile 1: raise the degree › decompose"; empty: in none
  int line = 0;                // of the pseudo-code of algorithm_at(step); 0: none
  // Of its beat's checkpoint, filled in at this step and in the story's language.
  struct Question {
    const Checkpoint* checkpoint = nullptr;
    Prose ask, right, wrong;
    std::vector<Prose> options;   // choices, or the items as they are shown; options[i] is called letter_of(i)
    std::vector<Prose> feedback;  // of choices; some may be empty
    std::string answer;           // the right one, as text: "(16, 20)", "4", "b", "cab"
    std::vector<double> numbers;  // of a value: what is right, as it is typed
  };
  std::optional<Question> question;
};

// Of a choice: which of the options is right.
std::optional<std::size_t> right_option(const StoryStep::Question&);
// The key in PageWords of what stands before the room for an answer: "index", "asked".
std::string_view asked_word(Checkpoint::Kind);

struct StoryScene {
  std::string id;       // empty: the only one
  std::string heading;  // likewise
  std::shared_ptr<const Recording> recording;
  std::vector<Beat> beats{};       // by step
  std::vector<StoryStep> steps{};  // those that are told
  std::string language = "en";     // of the page's own words, where they exist in it
  Inputs<Exact> inputs{};          // of the recording

  const StepSource& source() const { return recording->source(); }
  const StepScenes& scenes() const { return recording->scenes(); }
  // The geometry at a step as a view of this size, with what its beat highlights, seen as the beats say. Motion: how
  // far the step has come (ViewportOptions). Glide: how far the camera has come from that of the step before.
  View picture(std::uint32_t step, double width, double height, double motion = 1, double glide = 1) const;
  // Seen from elsewhere than the beats say.
  View picture(std::uint32_t step, double width, double height, const Camera& from) const;
  // From where the beats want a step to be seen.
  Camera seen_from(std::uint32_t step, double width, double height) const;
  // Whether the camera is another one than at the step before.
  bool glides(std::uint32_t step) const;
  // The whole page: picture, pseudo-code, formula, scheme, knots and words.
  Scene page(const StoryStep&, const std::string& title, double width, double height, double motion = 1,
             double glide = 1) const;

 private:
  std::optional<Camera> camera(std::uint32_t step, double width, double height) const;
  ViewportOptions look(std::uint32_t step, double motion = 1) const;
};

struct StoryOptions {
  std::string language;                        // empty, or none of the lesson's: its own
  std::uint32_t first = 0, last = UINT32_MAX;  // of each scene's steps
  std::optional<std::size_t> scene;            // only this one
  bool exact = true;                           // in fractions where that can be
  const CourseTitles* titles = nullptr;        // of what the lesson calls by its id; none: ids
};

// Its steps point to its scenes' beats, so it is moved and never copied.
struct Story {
  Story() = default;
  Story(Story&&) = default;
  Story& operator=(Story&&) = default;

  std::string id, title, unit, summary, source, language;
  int minutes = 0;
  std::vector<std::string> objectives;
  std::vector<StoryLink> prerequisites, exercises;
  bool beside = false;  // the other lessons have pages beside this one, in a list called index
  LessonColors colors;
  std::vector<StoryScene> scenes;

  std::size_t step_count() const;     // that are told
  std::size_t foreign_count() const;  // of them those in another language
};

// A lesson that was loaded, or an algorithm's run without one. Runs that are too large for fractions are in decimals.
Checked<Story> make_story(const Lesson&, const StoryOptions&);
Checked<Story> make_story(const Algorithm&, const Inputs<Exact>&, const StoryOptions&);

// The step where a step's beat stands in a run of other inputs, as a scene of that step alone, without its question.
// Nothing where these inputs cannot be run, or the beat stands nowhere or its words name something that is not there.
std::optional<StoryScene> with_inputs(const StoryScene&, const StoryStep&, Inputs<Exact>);

}  // namespace blossom
