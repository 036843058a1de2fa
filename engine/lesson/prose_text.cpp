#include "lesson/prose_text.hpp"

#include "algorithms/typeset.hpp"

namespace blossom {

RichText typeset_span(const Span& span, const Algorithm& algorithm) {
  RichText runs;
  if (span.kind == Span::Kind::code)
    runs.push_back({span.text, TextRun::Level::base, false, false, true});
  else
    runs = typeset_text(span.text, algorithm);
  for (TextRun& run : runs) {
    run.bold = run.bold || span.bold;
    run.italic = run.italic || (span.italic && run.level == TextRun::Level::base);
  }
  return runs;
}

RichText rich_text(const Prose& prose, const Algorithm& algorithm) {
  RichText text;
  for (const Block& block : prose) {
    // A tab: the rest of a long line begins below what follows it.
    std::string start = text.empty() ? "" : "\n";
    start.append(4 * static_cast<std::size_t>(block.level), ' ');
    if (block.kind == Block::Kind::item)
      start += (block.number > 0 ? std::to_string(block.number) + "." : std::string("•")) + " \t";
    else if (block.kind == Block::Kind::formula)
      start += "    \t";
    else if (block.level > 0)
      start += '\t';
    if (!start.empty()) text.push_back({std::move(start)});
    for (const Span& span : block.spans) {
      if (span.math == nullptr) {
        const RichText runs = typeset_span(span, algorithm);
        text.insert(text.end(), runs.begin(), runs.end());
        continue;
      }
      TextRun run{plain_math(*span.math)};
      run.math = span.math;
      run.display = block.kind == Block::Kind::formula;
      text.push_back(std::move(run));
    }
  }
  return text;
}

std::string plain_text(const Prose& prose) {
  std::string text;
  for (const Block& block : prose) {
    if (!text.empty()) text += '\n';
    text.append(2 * static_cast<std::size_t>(block.level), ' ');
    if (block.kind == Block::Kind::item) text += block.number > 0 ? std::to_string(block.number) + ". " : "- ";
    if (block.kind == Block::Kind::formula) text += "    ";
    for (const Span& span : block.spans) text += span.math != nullptr ? plain_math(*span.math) : span.text;
  }
  return text;
}

}  // namespace blossom
