#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Sentences about words that were typed, and their numbers.
namespace moontrace::say {

/// "Words, or their beginning or number: 1 size, 2 help."
std::string NumberedWords(const std::vector<std::string>& words);
std::string WordUnknown(std::string_view given, std::string_view nearest);
std::string WordAmbiguous(std::string_view given, const std::vector<std::string>& words);
/// `wants`: what stands behind the word, "a number from 0 to 10".
std::string WordWants(std::string_view word, std::string_view wants);
std::string WordCannotBe(std::string_view word, std::string_view given, std::string_view wants);
std::string WordOutOfRange(std::string_view word, std::string_view given, std::string_view wants);
std::string WordStandsAlone(std::string_view word, std::string_view given);

}  // namespace moontrace::say
