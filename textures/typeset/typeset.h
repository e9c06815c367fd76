#pragma once

#include <string>
#include <string_view>

#include "textures/base/error.h"
#include "textures/fonts/script.h"
#include "textures/typeset/text_page.h"

namespace moontrace {

/// "a4", "a5" (margin 15 mm), "workspace" (160 x 120 mm, a desk-top device's reach, margin 10 mm),
/// or a custom page in mm as "120x90" (margin 10 mm). Throws InputError for other names and for
/// pages above 5 m. SetText refuses one that is not larger than its margins.
PageSpec FindPage(const std::string& name);

/// The whole text is in a writing that the script has no signs for: another script may set it.
class NoSignError : public InputError {
 public:
  using InputError::InputError;
};

/// Sets UTF-8 text, by the rules of fold.h and signs.h, or of liblouis for Braille; the order of
/// lines is that of layout.h. The first base line is one em below the top margin. Lines break as in
/// the text, at spaces and behind hyphens; a word that no line holds is broken between letters. A
/// letter must fit with its strokes' centre lines, its gap may hang over; below the last base line
/// it may hang into the margin. One or several blank lines become one empty line, none at the top
/// of a page. Linear in the text.
/// Throws InputError: invalid UTF-8 (byte offset), empty text, text over 16 MB or more than 16
/// million signs, a style that fails CheckStyle, an unknown grade or form of h, a page that holds
/// no line or not a letter of the text, nothing left to set (NoSignError where the script is why).
/// LackError: Braille without liblouis.
Typeset SetText(std::string_view text, const Script& script, const TypeStyle& style,
                const PageSpec& page);

/// The same, for long texts: each page goes to `take` as soon as it is finished, in order, and none
/// is kept in what is returned. What fails late fails after pages were taken.
Typeset SetPages(std::string_view text, const Script& script, const TypeStyle& style,
                 const PageSpec& page, const TakePage& take);

}  // namespace moontrace
