#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "textures/fonts/script.h"
#include "textures/typeset/fold.h"
#include "textures/typeset/text_page.h"
#include "textures/typeset/writer.h"

/// Words that are left out whole because not all their letters are taught: what is left of such a
/// word would read as another one.
namespace moontrace {

/// The sign that stands in place of a word that is left out, where it is among the signs taught. In
/// Moon it is two level lines, one above the other, which no character is bound to.
inline constexpr const char* kLeftOutMark = "double-bar";

/// Whether TypeStyle::only has it: then words are left out whole, otherwise letter by letter.
bool LeavesOutWords(const std::vector<std::string>& only);

/// How a line was written, character by character.
struct WrittenLine {
  std::vector<std::size_t> first;  ///< its first sign, also where it has none: the next one's
  std::vector<bool> untaught;      ///< left out, since its sign is not taught
};

/// Puts `mark` in place of each word of the line that lacks a letter, a digit or a mark between
/// these; marks before its first and behind its last letter stay. `begin`: the line's first sign.
void LeaveOutWords(const std::vector<FoldedChar>& line, const WrittenLine& written,
                   std::uint32_t mark, std::size_t begin, std::vector<Sign>& signs);

/// Words of a page.
struct LeftOutWords {
  std::size_t words = 0, left_out = 0;
};
/// Adds those of a page. A word that goes on over a page's end counts twice.
void CountLeftOut(const TextPage& page, const Script& script, LeftOutWords& counts);

}  // namespace moontrace
