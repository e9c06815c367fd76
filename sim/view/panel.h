#pragma once

#include <string>
#include <vector>

namespace moontrace {

/// One control of the tutor's panel. What it does it says, as a line of the text face.
struct PanelControl {
  enum class Kind {
    kHeading,  ///< begins a part of the panel; `label` only
    kText,     ///< shows PanelValue::text
    kSlider,   ///< says "WORD VALUE UNIT"
    kChoice,   ///< one of `choices`: says "WORD CHOICE", or the choice alone where `word` is empty
    kButton,   ///< says `word`
  };
  Kind kind = Kind::kHeading;
  std::string label;  ///< at most 20 characters
  std::string word;
  double low = 0, high = 1, step = 0.1;  ///< of a slider, in `unit`
  std::string unit;                      ///< "mm", "%", "degrees" or empty
  std::vector<std::string> choices;      ///< at most 8
};

/// A line that was said in the window.
struct ViewLine {
  std::string text;
  bool of_panel = false;  ///< by a control; else by the keyboard: typed, or a key that has a word
};

/// What a control shows now.
struct PanelValue {
  double number = 0;  ///< of a slider, in its unit
  int choice = 0;     ///< of a choice, from 0; -1: none
  std::string text;   ///< of a text
  bool operator==(const PanelValue&) const = default;
};

/// The line that a control says when it is given this value: "size 20 mm", "mode rail", "again".
/// Empty for headings, texts and a choice of none. A number is held to the slider and its steps.
std::string LineOf(const PanelControl& control, const PanelValue& value);

}  // namespace moontrace
