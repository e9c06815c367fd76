#include "sim/view/panel.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace moontrace {

namespace {

/// A number of the slider's steps, without zeros behind the last digit that counts.
std::string Number(const PanelControl& slider, double value) {
  double at = std::clamp(value, slider.low, slider.high);
  if (slider.step > 0) {
    const double steps = std::round((at - slider.low) / slider.step);
    at = std::min(slider.low + steps * slider.step, slider.high);
  }
  std::string text = fmt::format("{:.6f}", at);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string Joined(const std::string& a, const std::string& b) {
  if (a.empty()) return b;
  return b.empty() ? a : fmt::format("{} {}", a, b);
}

}  // namespace

std::string LineOf(const PanelControl& control, const PanelValue& value) {
  switch (control.kind) {
    case PanelControl::Kind::kSlider:
      return Joined(Joined(control.word, Number(control, value.number)), control.unit);
    case PanelControl::Kind::kChoice: {
      const auto index = static_cast<std::size_t>(value.choice);
      if (value.choice < 0 || index >= control.choices.size()) return {};
      return Joined(control.word, control.choices[index]);
    }
    case PanelControl::Kind::kButton:
      return control.word;
    case PanelControl::Kind::kHeading:
    case PanelControl::Kind::kText:
      break;
  }
  return {};
}

}  // namespace moontrace
