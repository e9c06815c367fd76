#pragma once

#include <map>
#include <string>
#include <string_view>

#include "lessons/course/course.h"
#include "textures/fonts/script.h"

namespace moontrace {

/// How two items resemble each other, so that one may be taken for the other. Moon turns and
/// mirrors few shapes: these are its known weakness.
enum class Likeness {
  kTurned,       ///< one sign is the other, turned by a quarter or a half
  kMirrored,     ///< one sign is the other's image in an upright or a level mirror
  kBeginsAlike,  ///< two signs whose lines begin with the same movement; two words with one letter
  kOther
};

/// "turned", "mirrored", "begins alike", "otherwise".
std::string_view NameOf(Likeness likeness);

/// Of two glyphs: told by their lines alone, whatever their widths' last hundredths. What a mirror
/// makes as well as a turn (the cups C and D) is mirrored.
Likeness LikenessOf(const Glyph& a, const Glyph& b);

/// Knows the signs of a course's items; where its script cannot be had, the texts alone.
class ItemLikeness {
 public:
  explicit ItemLikeness(const Course& course);

  Likeness Of(const std::string& a, const std::string& b) const;

 private:
  std::map<std::string, Glyph> glyphs_;  ///< item -> its sign; of a number, the sign of its digit
};

}  // namespace moontrace
