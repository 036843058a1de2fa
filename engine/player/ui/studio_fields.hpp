#pragma once
// Forms about a scene of the studio.

#include "player/studio.hpp"
#include "player/ui/number_field.hpp"

namespace blossom {

// What is changed is the scene, with all that follows; made when it is sent, of the scene as it is then.
using StudioEdit = std::function<Worked(const Workspace&)>;
using StudioNumberEdit = std::function<Worked(const Workspace&, const Exact&)>;

class StudioFields : public Fields {
 public:
  StudioFields(Ui& ui, const FieldModel& model) : Fields(ui, model) {}
  bool number(const NumberField&, StudioNumberEdit);
  void send(const std::string& path, const std::string& what, StudioEdit, const std::string& gesture = {});
};

// The model of the forms in the panel of this id; it must stay.
class StudioModel : public FieldModel {
 public:
  explicit StudioModel(std::string_view panel) : panel_(panel) {}
  std::string_view panel() const override { return panel_; }
  FieldTexts* texts(Player&) const override;
  const FieldTexts& texts(const Player&) const override;
  const Diagnostics& rejected(const Player&) const override;
  void forget_rejected(Player&) const override;

 private:
  std::string_view panel_;
};

// Does something with the studio after the frame, if it is still open.
void send_studio(Ui&, std::function<void(Studio&)>);

// A square of the colour a thing has.
void color_chip(const Ui&, int color, float side);
// A slider over [low, high] as an item of this width; the new value while it is held.
std::optional<double> share_slider(Ui&, const std::string& name, double value, double low, double high, float width);
// A choice of names; the index of another one.
std::optional<std::size_t> combo(Ui&, const std::string& name, const std::vector<std::string>& names,
                                 std::size_t current, float width);

}  // namespace blossom
