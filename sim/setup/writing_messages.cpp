#include "sim/setup/writing_messages.h"

#include <fmt/core.h>

#include "sim/console/wording.h"

namespace moontrace::say {

std::string WrittenBy(const Replacement& replacement, std::string_view was, std::string_view became,
                      std::string_view where) {
  switch (replacement.how) {
    case Replaced::kOtherScript:
      return fmt::format("Other script: {}, {}.", was, where);
    case Replaced::kTransliterated:
      return fmt::format("By sound: {} by {}, {}.", was, became, where);
    case Replaced::kNamed:
      return fmt::format("By name: {} as {}, {}.", was, became, where);
    case Replaced::kFolded:
      break;
  }
  return fmt::format("Replaced: {} by {}, {}.", was, became, where);
}

std::string NotTaught(std::string_view was, std::string_view where) {
  return fmt::format("Not taught, left out: {}, {}.", was, where);
}

std::string ReadBackOutcome(const BackTranslation& back) {
  const std::string words = Counted(back.words, "word", "words");
  std::string missing;
  if (back.left_out > 0) {
    missing += fmt::format(", {} left out", Counted(back.left_out, "character", "characters"));
  }
  if (back.replaced > 0) missing += fmt::format(", {} replaced", back.replaced);
  if (back.differ_count > 0) {
    return fmt::format("Reads back otherwise: {} of {}{}.",
                       Counted(back.differ_count, "word", "words"), back.words, missing);
  }
  if (missing.empty()) return fmt::format("Reads back as the text: {}.", words);
  return fmt::format("Reads back as written, not as given: {}{}.", words, missing);
}

std::string ReadBackLine(std::string_view line) { return fmt::format("Reads: {}", line); }

std::string ReadOtherwise(std::string_view was, std::string_view became) {
  if (became.empty()) return fmt::format("Not read: \"{}\".", was);
  if (was.empty()) return fmt::format("Read in addition: \"{}\".", became);
  return fmt::format("Reads otherwise: \"{}\" as \"{}\".", was, became);
}

std::string MoreWords(std::size_t count) {
  return fmt::format("And {} more; --json lists the first 1000.", Counted(count, "word", "words"));
}

std::string WrittenAlike(std::size_t count) {
  return fmt::format("Written alike in both readings: {} of these.",
                     Counted(count, "word", "words"));
}

}  // namespace moontrace::say
