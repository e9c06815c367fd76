#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/page_view/view_page.h"
#include "sim/physics/page_field.h"
#include "sim/view/panel.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

inline std::shared_ptr<const ViewPage> PageOf(const std::string& text, std::uint32_t number = 1) {
  const Script script = FindScript("moon");
  const PageSpec sheet{"custom", 0.12, 0.06, 0.005};
  const Typeset set = SetText(text, script, DefaultStyle(0.012, Relief::kEngraved, script), sheet);
  auto field =
      std::make_shared<const TextureField>(PageField(set.pages.at(0), script, set.style, false));
  return MakeViewPage(set, 0, script, text, std::move(field), false, number);
}

/// A heading, then one control of each kind that says something.
inline std::vector<PanelControl> SmallPanel() {
  PanelControl heading, slider, choice, button;
  heading.label = "Letters";
  slider.kind = PanelControl::Kind::kSlider;
  slider.label = "Size";
  slider.word = "size";
  slider.low = 5;
  slider.high = 40;
  slider.step = 1;
  slider.unit = "mm";
  choice.kind = PanelControl::Kind::kChoice;
  choice.label = "Mode";
  choice.word = "mode";
  choice.choices = {"attract", "bead", "rail"};
  button.kind = PanelControl::Kind::kButton;
  button.label = "Again";
  button.word = "again";
  return {heading, slider, choice, button};
}

/// Size 12, mode attract.
inline std::vector<PanelValue> SmallValues() {
  std::vector<PanelValue> values(4);
  values[1].number = 12;
  values[2].choice = 0;
  return values;
}

}  // namespace moontrace
