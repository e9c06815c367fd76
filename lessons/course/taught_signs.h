#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "textures/fonts/script.h"

namespace moontrace {

/// The signs that a text is written with.
struct SignUse {
  std::vector<std::string> signs;     ///< names, in the order of the text, with repetitions
  std::vector<std::string> pieces;    ///< what each stands for in the text; a numeral sign: nothing
  std::vector<std::string> missing;   ///< characters without a form in the script, each once
  std::vector<std::string> untaught;  ///< characters and groups whose sign is not taught, each once
};

/// Signs of a text in a script at a grade, as a lesson's page is set: with all contractions of the
/// grade, whether taught or not. `taught`: signs by name; null: all. Throws InputError: a grade
/// that the script does not know.
SignUse SignsOf(std::string_view text, const Script& script, double grade,
                const std::set<std::string>* taught);

/// Whether an item teaches the signs that it is written with: a letter, a digit with its numeral
/// sign, a word with a sign of its own. Any other word is made of signs taught before.
bool TeachesSigns(std::string_view item, const SignUse& use);

}  // namespace moontrace
