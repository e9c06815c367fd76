#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim/setup/page_form.h"

namespace moontrace {

/// Words that change the page while it is felt: the same in a tutor's terminal, in the real-time
/// loop and in the panel of a window.
enum class PageWord : std::uint8_t {
  kSize,      ///< value: letters [m], 1 to 1000 mm
  kDepth,     ///< value: PageForm::depth
  kWidth,     ///< value: PageForm::width
  kSpacing,   ///< value: PageForm::spacing
  kPitch,     ///< value: PageForm::pitch
  kTilt,      ///< value: far edge raised [rad], -60 to 60 degrees
  kEngraved,  ///< grooves
  kEmbossed,  ///< ridges
  kForm,      ///< h_form
  kPaper,     ///< paper; none: smooth
};

/// What may stand behind "form" and "paper", in the order in which people see it.
const std::vector<std::string>& FormChoices();
const std::vector<std::string>& PaperChoices();

/// One change, read.
struct PageCommand {
  PageWord word = PageWord::kSize;
  double value = 0;
  std::string h_form = {};
  std::optional<PaperKind> paper = {};
};

/// The words, in the order of PageWord.
const std::vector<std::string>& PageWords();
/// None: another word.
std::optional<PageWord> PageWordOf(std::string_view word);

/// What stands behind a word: "20 mm", "50 %", "arc", "noise"; a number without unit is in mm,
/// times the usual, or degrees. Else one line: what is wrong, and the cure. Which forms of H there
/// are the script says, when the page is set.
std::variant<PageCommand, std::string> ReadPageCommand(PageWord word, std::string_view behind);

/// The form with the change; size and tilt are no part of it.
PageForm Changed(PageForm form, const PageCommand& command);

}  // namespace moontrace
