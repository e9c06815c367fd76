#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "textures/typeset/writer.h"

namespace moontrace {

/// Where words of one language may be broken at a line's end: by libhyphen and the pattern files
/// that are installed for it.
class Hyphenation {
 public:
  /// By the name of a pattern file, "en_US". Throws InputError for one that is not installed, with
  /// the nearest, or in an encoding other than UTF-8 and ISO 8859-1; LackError where the build has
  /// no libhyphen.
  explicit Hyphenation(const std::string& language);
  ~Hyphenation();

  /// Sets `hyphen_after` of the signs of one line of `text`. A sign that stands for letters on both
  /// sides of a break is not broken; patterns that would change letters are passed over.
  void Mark(std::string_view text, std::vector<Sign>& signs) const;

 private:
  struct Patterns;
  std::unique_ptr<Patterns> patterns_;
};

}  // namespace moontrace
