#pragma once

#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/view/panel.h"
#include "textures/base/text_file.h"

namespace moontrace {

// Controls of a panel and their values, made short.

inline PanelControl HeadingControl(std::string label) {
  PanelControl control;
  control.label = std::move(label);
  return control;
}

inline PanelControl TextControl(std::string label) {
  PanelControl control;
  control.kind = PanelControl::Kind::kText;
  control.label = std::move(label);
  return control;
}

inline PanelControl SliderControl(std::string label, std::string word, std::string unit, double low,
                                  double high, double step) {
  PanelControl control;
  control.kind = PanelControl::Kind::kSlider;
  control.label = std::move(label);
  control.word = std::move(word);
  control.unit = std::move(unit);
  control.low = low;
  control.high = high;
  control.step = step;
  return control;
}

inline PanelControl ChoiceControl(std::string label, std::string word,
                                  std::vector<std::string> choices) {
  PanelControl control;
  control.kind = PanelControl::Kind::kChoice;
  control.label = std::move(label);
  control.word = std::move(word);
  control.choices = std::move(choices);
  return control;
}

inline PanelControl ButtonControl(std::string label, std::string word) {
  PanelControl control;
  control.kind = PanelControl::Kind::kButton;
  control.label = std::move(label);
  control.word = std::move(word);
  return control;
}

inline PanelValue NumberValue(double number) { return {number, 0, {}}; }
inline PanelValue ChosenValue(int choice) { return {0, choice, {}}; }
inline PanelValue TextValue(std::string_view text) { return {0, 0, OneLine(text, 40)}; }

template <class Part>
void Append(std::vector<Part>& whole, std::vector<Part> more) {
  whole.insert(whole.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
}

}  // namespace moontrace
