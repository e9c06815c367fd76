#include "sim/session/view_panels.h"

#include <fmt/core.h>

#include <algorithm>
#include <numbers>

#include "sim/session/view_controls.h"
#include "sim/session/view_messages.h"
#include "sim/tutor/page_words.h"

namespace moontrace {

namespace {

/// The place of a word among the choices; -1: none of them.
int PlaceOf(const std::vector<std::string>& choices, std::string_view word) {
  const auto found = std::find(choices.begin(), choices.end(), word);
  return found == choices.end() ? -1 : static_cast<int>(found - choices.begin());
}

const std::vector<std::string> kReliefs = {"engraved", "embossed"};

/// As it is set; where nobody has chosen, the one that has no name of its own.
std::string FormOfH(const TextSetup& text) {
  if (!text.set.style.h_form.empty()) return text.set.style.h_form;
  const auto forms = text.script.forms.find("h");
  if (forms == text.script.forms.end()) return FormChoices().front();  // there is no H to be seen
  for (const auto& [form, glyph] : forms->second) {
    if (glyph == "h") return form;
  }
  return {};
}

}  // namespace

std::vector<PanelControl> PageControls() {
  return {SliderControl("Size", "size", "mm", 4, 60, 1),
          SliderControl("Depth", "depth", "%", 20, 200, 10),
          SliderControl("Width", "width", "%", 50, 200, 10),
          ChoiceControl("Letters", "", kReliefs),
          ChoiceControl("Form of H", "form", FormChoices()),
          SliderControl("Line pitch", "pitch", "%", 100, 300, 10),
          SliderControl("Tilt", "tilt", "degrees", -60, 60, 5),
          ChoiceControl("Paper", "paper", PaperChoices())};
}

std::vector<PanelValue> PageValues(const TextSetup& text, const PageForm& form, double tilt) {
  const TypeStyle& style = text.set.style;
  const std::optional<PaperTexture>& paper = style.texture.paper;
  return {NumberValue(1e3 * style.size),
          NumberValue(100 * form.depth),
          NumberValue(100 * form.width),
          ChosenValue(style.relief == Relief::kEmbossed ? 1 : 0),
          ChosenValue(PlaceOf(FormChoices(), FormOfH(text))),
          NumberValue(100 * form.pitch),
          NumberValue(180 / std::numbers::pi * tilt),
          ChosenValue(PlaceOf(PaperChoices(), paper ? NameOf(paper->kind) : "smooth"))};
}

std::vector<PanelControl> LoopPanel() {
  std::vector<PanelControl> panel = {HeadingControl("Page"), TextControl("Page"),
                                     TextControl("The tip")};
  Append(panel, PageControls());
  Append(panel, {HeadingControl("Do"), ButtonControl("Stop", "stop"), ButtonControl("Go on", "go"),
                 ButtonControl("Next page", "next"), ButtonControl("Page back", "back")});
  return panel;
}

std::vector<PanelValue> LoopPanelValues(const TextSetup& text, const PageForm& form, double tilt,
                                        std::size_t page, const std::string& state) {
  std::vector<PanelValue> values = {
      {}, TextValue(say::PanelPage(page, text.set.pages.size())), TextValue(state)};
  Append(values, PageValues(text, form, tilt));
  values.resize(values.size() + 5);
  return values;
}

std::vector<PanelControl> TrialPanel() {
  return {HeadingControl("Trace"), TextControl("Text"), TextControl("Size"), TextControl("Page"),
          TextControl("Time")};
}

std::vector<PanelControl> ReadingPanel() {
  std::vector<PanelControl> panel = TrialPanel();
  panel.front() = HeadingControl("Page");
  Append(panel, {HeadingControl("Reader"), TextControl("Read"), TextControl("Takes it for"),
                 TextControl("The hand")});
  return panel;
}

std::vector<PanelValue> TrialPanelValues(const TrialTexts& texts) {
  std::vector<PanelValue> values = {{},
                                    TextValue(texts.text),
                                    TextValue(fmt::format("{:.3g} mm", 1e3 * texts.size)),
                                    TextValue(texts.page),
                                    TextValue(texts.time)};
  if (!texts.reading) return values;
  Append(values, {{},
                  TextValue(texts.reading->read),
                  TextValue(texts.reading->belief),
                  TextValue(texts.reading->doing)});
  return values;
}

}  // namespace moontrace
