#include "sim/setup/setup_messages.h"

#include <fmt/core.h>

#include "sim/console/wording.h"
#include "sim/setup/writing_messages.h"
#include "textures/base/text_file.h"
#include "textures/typeset/character_name.h"

namespace moontrace::say {

namespace {

std::string Where(const Replacement& replacement, std::size_t times) {
  const std::string line =
      replacement.line == 0 ? "running head" : fmt::format("line {}", replacement.line);
  if (times == 1) return fmt::format("{}, character {}", line, replacement.column);
  return fmt::format("{} times, first in {}, character {}", times, line, replacement.column);
}

/// A character that cannot be seen or heard by its name, any other as it is.
std::string Was(const Replacement& replacement) {
  return replacement.name.empty() ? Quoted(replacement.was) : replacement.name;
}

}  // namespace

std::string ValueEmpty(std::string_view option) {
  return fmt::format("{} is empty: write its value", option);
}

std::string NotANumber(std::string_view option, std::string_view given) {
  return fmt::format("{} is {}, which is no number: write one like 12 or 0.5", option,
                     Quoted(given));
}

std::string NotAWholeNumber(std::string_view option, std::string_view given) {
  return fmt::format("{} is {}: write a whole number from 0 up", option, Quoted(given));
}

std::string OutOfRange(std::string_view option, std::string_view given, double low, double high) {
  return fmt::format("{} is {}: write a number from {} to {}", option, OneLine(given), Plain(low),
                     Plain(high));
}

std::string AlternateLinesBreakWords() {
  return "--hyphenate: alternating lines break words wherever a line ends; leave one of both out";
}

std::string NotAChoice(std::string_view option, std::string_view given, std::string_view choices) {
  return fmt::format("{} is {}: {}choose {}", option, Quoted(given),
                     DidYouMean(NearestListed(given, choices)), choices);
}

std::string NotAnAction(std::string_view command, std::string_view given, std::string_view nearest,
                        std::string_view actions) {
  if (given.empty()) return fmt::format("{}: say what to do: {}", command, actions);
  return fmt::format("{}: unknown action {}: {}write {}", command, Quoted(given),
                     DidYouMean(nearest), actions);
}

std::string NotAPage(std::string_view given) {
  constexpr const char* kChoices = "a4, a5, workspace or width x height like 120x80";
  return fmt::format("--page is {}: {}write {}", Quoted(given),
                     DidYouMean(NearestListed(given, "a4, a5, workspace")), kChoices);
}

std::string NotAPicture(std::string_view option, std::string_view given) {
  return fmt::format("{} needs an ending .svg, .png or .pdf: {}", option, OneLine(given, 200));
}

std::string NeedsOther(std::string_view option, std::string_view other) {
  return fmt::format("{} needs {} beside it", option, other);
}

std::string NoText(std::string_view command) {
  return fmt::format("no text: write moontrace {} \"some text\", or --file FILE, or - for input",
                     command);
}

std::string TwoTexts() { return "two texts: give either a text or --file, not both"; }

std::string CannotReadInput() {
  return "standard input: cannot be read or holds more than 16 MB; name a smaller file";
}

std::string TooLong(std::size_t letters, std::size_t limit) {
  return fmt::format("the text has {} signs, a trace takes at most {}: give a shorter text",
                     letters, limit);
}

std::string Folded(const Replacement& replacement, std::size_t times) {
  if (replacement.became.empty()) {
    return fmt::format("Left out: {}, {}.", Was(replacement), Where(replacement, times));
  }
  const std::string name = CharacterName(replacement.became);
  return WrittenBy(replacement, Was(replacement), name.empty() ? Quoted(replacement.became) : name,
                   Where(replacement, times));
}

std::string Missing(const Replacement& replacement, std::size_t times) {
  return fmt::format("Left out: {}, no sign for it, {}.", Was(replacement),
                     Where(replacement, times));
}

std::string Untaught(const Replacement& replacement, std::size_t times) {
  return NotTaught(Was(replacement), Where(replacement, times));
}

std::string Doubtful(const Replacement& replacement, std::size_t times) {
  return fmt::format("Doubtful: {} directly after a number reads as {}, {}.", Was(replacement),
                     replacement.became, Where(replacement, times));
}

std::string MoreReplacements(std::size_t count) {
  return fmt::format("And {} more like these; --json lists the first 1000.", count);
}

std::string BadParameters(std::string_view folder, std::string_view cause) {
  return fmt::format("{}/trial.json: parameters cannot be used ({}); record the trial again",
                     folder, OneLine(cause));
}

}  // namespace moontrace::say
