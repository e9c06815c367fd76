#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/setup/page_form.h"
#include "sim/setup/text_setup.h"
#include "sim/view/panel.h"

namespace moontrace {

/// What stands in the panel beside a view, and what it says: controls and their values, one a
/// control.

/// What changes the page: a part of several panels. `tilt` [rad].
std::vector<PanelControl> PageControls();
std::vector<PanelValue> PageValues(const TextSetup& text, const PageForm& form, double tilt);

/// A page that is felt.
std::vector<PanelControl> LoopPanel();
/// `tilt` [rad], `page` from 0; `state` of the tip, in words.
std::vector<PanelValue> LoopPanelValues(const TextSetup& text, const PageForm& form, double tilt,
                                        std::size_t page, const std::string& state);

/// A trace by itself, or its replay, or a reader.
struct TrialTexts {
  std::string text;  ///< on the page
  double size = 0;   ///< of its letters [m]
  std::string page;  ///< "1 of 3"
  std::string time;
  struct Reading {
    std::string read;    ///< so far
    std::string belief;  ///< about the sign felt last
    std::string doing;
  };
  std::optional<Reading> reading{};  ///< of a reader
};
std::vector<PanelControl> TrialPanel();
std::vector<PanelControl> ReadingPanel();
/// Of the panel that is meant by `texts`.
std::vector<PanelValue> TrialPanelValues(const TrialTexts& texts);

}  // namespace moontrace
