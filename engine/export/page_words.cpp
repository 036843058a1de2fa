#include "export/page_words.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <span>

#include "base/json.hpp"

namespace blossom {
namespace {

constexpr std::array<std::string_view, 2> languages{"en", "de"};

struct Entry {
  std::string_view key;
  std::array<std::string_view, languages.size()> words;
};
// In braces stands what the page fills in.
constexpr Entry page_table[] = {
    {"about", {"About this lesson", "Über diese Lektion"}},
    {"minutes", {"{n} minutes", "{n} Minuten"}},
    {"objectives", {"What you will learn", "Was du lernst"}},
    {"before", {"Before it", "Vorher"}},
    {"practise", {"To practise", "Zum Üben"}},
    {"source", {"To read on", "Zum Weiterlesen"}},
    {"player", {"Step by step", "Schritt für Schritt"}},
    {"scenes", {"Scenes", "Szenen"}},
    {"first", {"First step", "Erster Schritt"}},
    {"back", {"One step back", "Ein Schritt zurück"}},
    {"next", {"One step forward", "Ein Schritt vor"}},
    {"last", {"Last step", "Letzter Schritt"}},
    {"beatback", {"Previous explanation", "Vorige Erklärung"}},
    {"beatnext", {"Next explanation", "Nächste Erklärung"}},
    {"play", {"Play", "Abspielen"}},
    {"pause", {"Pause", "Anhalten"}},
    {"speed", {"Speed", "Tempo"}},
    {"scrub", {"Step", "Schritt"}},
    {"of", {"step {n} of {last}", "Schritt {n} von {last}"}},
    {"picture", {"Picture of step {n}", "Bild von Schritt {n}"}},
    {"knots", {"Knots and basis functions", "Knoten und Basisfunktionen"}},
    {"formula", {"This step", "Dieser Schritt"}},
    {"code", {"Pseudo-code", "Pseudocode"}},
    {"scheme", {"Triangular scheme", "Dreiecksschema"}},
    {"level", {"Level {n}", "Stufe {n}"}},
    {"given", {"What is given", "Was gegeben ist"}},
    {"values", {"Values so far", "Bisherige Werte"}},
    {"blossom", {"blossom value", "Polarform"}},
    {"steps", {"All steps in words", "Alle Schritte in Worten"}},
    {"theme", {"Colours", "Farben"}},
    {"auto", {"As the system", "Wie das System"}},
    {"light", {"Light", "Hell"}},
    {"dark", {"Dark", "Dunkel"}},
    {"contrast", {"High contrast", "Hoher Kontrast"}},
    {"help", {"Keys and gestures", "Tasten und Gesten"}},
    {"close", {"Close", "Schließen"}},
    {"keyarrows", {"one step back or forward", "ein Schritt zurück oder vor"}},
    {"keyends", {"first or last step", "erster oder letzter Schritt"}},
    {"keybeats", {"previous or next explanation", "vorige oder nächste Erklärung"}},
    {"keyslider", {"on a slider: another number", "auf einem Schieberegler: eine andere Zahl"}},
    {"keyspace", {"play or pause", "abspielen oder anhalten"}},
    {"keyhelp", {"this list", "diese Liste"}},
    {"space", {"Space", "Leertaste"}},
    {"pages", {"Page Up, Page Down", "Bild auf, Bild ab"}},
    {"ends", {"Home, End", "Pos 1, Ende"}},
    {"swipe", {"Swipe over the picture", "Über das Bild wischen"}},
    {"sliders", {"Other numbers", "Andere Zahlen"}},
    {"reset", {"Back to the lesson's numbers", "Zurück zu den Zahlen der Lektion"}},
    {"asksown",
     {"The question is asked of the lesson's own numbers.", "Die Frage gilt den Zahlen der Lektion selbst."}},
    {"question", {"Question", "Frage"}},
    {"check", {"Check", "Prüfen"}},
    {"show", {"Show the answer", "Antwort zeigen"}},
    {"right", {"Right.", "Richtig."}},
    {"wrong", {"Not yet.", "Noch nicht."}},
    {"unread", {"Please enter a number such as 2/5 or 0.4.", "Bitte eine Zahl wie 2/5 oder 0,4 eingeben."}},
    {"unreadfield",
     {"Please enter a number such as 2/5 or 0.4 in each field.",
      "Bitte in jedes Feld eine Zahl wie 2/5 oder 0,4 eingeben."}},
    {"count",
     {"Please enter {n} numbers, with commas between them.",
      "Bitte {n} Zahlen eingeben, durch Strichpunkte getrennt."}},
    {"answer", {"The answer is {a}.", "Die Antwort ist {a}."}},
    {"value", {"Value", "Wert"}},
    {"coordinate", {"Coordinate {a}", "Koordinate {a}"}},
    {"index", {"Index of the knot span", "Index des Knotenintervalls"}},
    {"pick", {"or pick the span:", "oder das Intervall wählen:"}},
    {"up", {"Up: {a}", "Nach oben: {a}"}},
    {"down", {"Down: {a}", "Nach unten: {a}"}},
    {"orderhint",
     {"Drag the lines into order, or move them with the buttons.",
      "Die Zeilen an ihren Platz ziehen oder mit den Knöpfen bewegen."}},
    {"decimals",
     {"{n} decimals are enough; fractions are welcome.", "{n} Nachkommastellen genügen; Brüche sind willkommen."}},
    {"wholes", {"A whole number is enough; fractions are welcome.", "Eine ganze Zahl genügt; Brüche sind willkommen."}},
    {"score", {"{n} of {all} questions right", "{n} von {all} Fragen richtig"}},
    {"save", {"Save my answers", "Meine Antworten speichern"}},
    {"saved", {"Saved as {a}.", "Gespeichert als {a}."}},
    {"forget", {"Start over", "Von vorn beginnen"}},
    {"goto", {"Go to the question of step {n}", "Zur Frage in Schritt {n}"}},
};
// Of paper, pictures, films and the list of lessons.
constexpr Entry other_table[] = {
    {"name", {"Name", "Name"}},
    {"lesson", {"Lesson", "Lektion"}},
    {"lessons", {"Lessons", "Lektionen"}},
    {"time", {"Time", "Dauer"}},
    {"duration", {"about {n} minutes", "etwa {n} Minuten"}},
    {"onestep", {"1 step", "1 Schritt"}},
    {"allsteps", {"{n} steps", "{n} Schritte"}},
    {"stepname", {"Step {n}", "Schritt {n}"}},
    {"continued", {"{n}, continued", "{n}, Fortsetzung"}},
    {"lines", {"The algorithm, line by line", "Der Algorithmus, Zeile für Zeile"}},
    {"line", {"line {n}", "Zeile {n}"}},
    {"lineasked", {"Line", "Zeile"}},
    {"orderasked", {"In the right order", "In der richtigen Reihenfolge"}},
    {"asked", {"Answer", "Antwort"}},
    {"answers", {"Answers", "Antworten"}},
    {"work", {"Room for your work", "Platz zum Rechnen"}},
};
// Words of scenes (engine/scene), as these have them.
constexpr Entry scene_table[] = {
    {"step ", {"step ", "Schritt "}},
    {"This step", {"This step", "Dieser Schritt"}},
    {"Triangular scheme", {"Triangular scheme", "Dreiecksschema"}},
    {"What is given", {"What is given", "Was gegeben ist"}},
    {"Values so far", {"Values so far", "Bisherige Werte"}},
    {"blossom value", {"blossom value", "Polarform"}},
};

}  // namespace

PageWords::PageWords(std::string_view language) {
  const auto found = std::ranges::find(languages, language);
  column_ = found != languages.end() ? static_cast<std::size_t>(found - languages.begin()) : 0;
  language_ = languages[column_];
}

std::string_view PageWords::operator()(std::string_view key) const {
  for (const std::span<const Entry> table : {std::span<const Entry>(page_table), std::span<const Entry>(other_table)})
    if (const auto found = std::ranges::find(table, key, &Entry::key); found != table.end())
      return found->words[column_];
  assert(false);
  return key;
}

std::string PageWords::operator()(std::string_view key, std::string_view n) const {
  std::string out((*this)(key));
  const std::size_t open = out.find('{'), close = out.find('}', open);
  assert(close != std::string::npos);
  return out.replace(open, close + 1 - open, n);
}

void PageWords::put_into(Label& label) const {
  for (TextRun& run : label.text) {
    for (const Entry& entry : scene_table) {
      const std::size_t at = run.text.find(entry.key);
      if (at == 0 || (at != std::string::npos && run.text[at - 1] == '\n'))
        run.text.replace(at, entry.key.size(), entry.words[column_]);
    }
  }
}

void PageWords::put_into(View& view) const {
  if (column_ == 0) return;
  for (Label& label : view.labels) put_into(label);
}

std::string PageWords::json() const {
  std::string out = "{";
  for (const Entry& entry : page_table)
    out += (out.size() > 1 ? "," : "") + json_quote(entry.key) + ":" + json_quote(entry.words[column_]);
  return out + "}";
}

}  // namespace blossom
