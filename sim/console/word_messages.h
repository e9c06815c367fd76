#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/console/vocabulary.h"

/// Sentences about words that were typed, and their numbers.
namespace moontrace::say {

/// "Words, or their beginning or number: 1 stop, 2 next."
std::string NumberedWords(WordPlace place);
/// What stands behind "help": "next, 2: on to the next page.", or that there is no such word.
std::string HelpWith(std::string_view given, WordPlace place);
std::string WordUnknown(std::string_view given, std::string_view nearest);
/// It holds in other places.
std::string WordNotHere(std::string_view word);
/// Likewise; `instead`: what does that here.
std::string WordInstead(std::string_view word, std::string_view instead);
/// A beginning that is short for `elsewhere` in another place, and would be for `here`.
std::string WordShortElsewhere(std::string_view given, std::string_view elsewhere,
                               std::string_view here);
std::string WordAmbiguous(std::string_view given, const std::vector<std::string>& words);
/// `wants`: what stands behind the word, "a number from 0 to 10".
std::string WordWants(std::string_view word, std::string_view wants);
std::string WordCannotBe(std::string_view word, std::string_view given, std::string_view wants);
std::string WordOutOfRange(std::string_view word, std::string_view given, std::string_view wants);
/// What was typed, behind which a sentence ends: without closing marks of its own, unless it is
/// one.
std::string Unstopped(std::string text);
/// Single keys were asked for.
std::string NoTerminal();
std::string WordStandsAlone(std::string_view word, std::string_view given);

}  // namespace moontrace::say
