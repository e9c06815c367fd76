#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/course/course.h"

namespace moontrace {

/// What may have been meant, the fullest first: all of it, without a closing mark, without words
/// before a name, at last the letter that is called so ("tee"). In small letters (of English), one
/// blank between words; empty: too long.
std::vector<std::string> ReadingsOf(std::string_view said);

/// "I don't know", "no idea": no answer is to be expected.
bool DoesNotKnow(std::string_view said);

/// "I know", "yes, I know it": the name itself was not said.
bool KnowsWithoutName(std::string_view said);

/// Whether what was said names the item: by its text or its name in the course. Capitals (of
/// English letters), blanks, a closing mark and words before the name do not count: "B", " b ",
/// "capital b", "the letter B.", "bee" are all b, the last where no item is called so itself.
bool Names(const Course& course, std::string_view item, std::string_view said);

/// The item of the course that was named: `expected` where that fits too; none: no item.
std::optional<std::string> ItemSaid(const Course& course, std::string_view said,
                                    std::string_view expected);

/// Two signs held to be the same ("same", "s", "yes") or not ("different", "d", "no"); none:
/// neither.
std::optional<bool> SameSaid(std::string_view said);

}  // namespace moontrace
