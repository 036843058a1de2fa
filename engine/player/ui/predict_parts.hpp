#pragma once
// What the panel of predicting is made of.

#include "player/action.hpp"
#include "player/ui/ui.hpp"

namespace blossom {

enum class Mark { open, answered, shown, right, partly, wrong, missing };

Mark mark_of(const Prediction&, std::size_t question);
void draw_mark(Ui&, Mark, ImVec2 centre, float radius);
// The questions as a row of marks.
void draw_marks(Ui&, const Prediction&, std::optional<std::size_t> asked);
void draw_feedback(Ui&, const Prediction&, std::size_t question);

void predict_text(Ui&, const std::string& text, double size, Role);
bool predict_button(Ui&, const char* label, const std::string& name, const std::string& tip = {});
bool predict_action(Ui&, std::string_view action, const char* label);
// The spans one can pick, the nonempty ones of the domain, as buttons called `name` and the index; `picked` gets it.
void draw_spans(Ui&, const Session&, const std::string& name, void (*picked)(Player&, const std::string& index));
void predict_tip(Ui&, const std::string& text);  // of ImGui's last item

}  // namespace blossom
