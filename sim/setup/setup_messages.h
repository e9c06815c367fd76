#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "textures/typeset/text_page.h"

namespace moontrace::say {

/// What is wrong with an option, a text or what a page was made of. Plain lines: the outcome first,
/// numbers and paths last.

std::string ValueEmpty(std::string_view option);
std::string NotANumber(std::string_view option, std::string_view given);
std::string NotAWholeNumber(std::string_view option, std::string_view given);
std::string OutOfRange(std::string_view option, std::string_view given, double low, double high);
std::string AlternateLinesBreakWords();
std::string NotAChoice(std::string_view option, std::string_view given, std::string_view choices);
/// A command's first word, which says what to do. `actions`: "check or show"; empty `given`: none.
std::string NotAnAction(std::string_view command, std::string_view given, std::string_view nearest,
                        std::string_view actions);
std::string NotAPage(std::string_view given);
std::string NotAPicture(std::string_view option, std::string_view given);
std::string NeedsOther(std::string_view option, std::string_view other);
std::string NoText(std::string_view command);
std::string TwoTexts();
std::string CannotReadInput();

std::string TooLong(std::size_t letters, std::size_t limit);
/// Of the first of `times` characters to which the same happened.
std::string Folded(const Replacement& replacement, std::size_t times);
std::string Missing(const Replacement& replacement, std::size_t times);
std::string Untaught(const Replacement& replacement, std::size_t times);
std::string Doubtful(const Replacement& replacement, std::size_t times);
std::string MoreReplacements(std::size_t count);
std::string BadParameters(std::string_view folder, std::string_view cause);

}  // namespace moontrace::say
