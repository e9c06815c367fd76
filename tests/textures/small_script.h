#pragma once

#include <string>

#include "textures/fonts/script.h"

namespace moontrace {

/// A script made for these tests, so that sums can be done in the head: every sign is one upright
/// 0.5 em from the left (its strokes reach 0.5 em), every advance 1 em, the space 1 em. It has a to
/// z, comma, full stop, hyphen, digits, AND, TH, a two-sign ING and a protect mark '|'.
inline Script SmallScript() {
  Script script;
  script.name = "small";
  script.stroke_width = 0.1;
  script.space_advance = 1;
  script.grades = {0.5, 1};
  const auto add = [&script](const std::string& name) {
    script.glyphs.push_back({name, 1, {{StrokeKind::kStroke, {Line{{0.5, 0}, {0.5, 1}}}}}});
  };
  for (char c = 'a'; c <= 'z'; ++c) {
    add(std::string(1, c));
    script.signs[static_cast<char32_t>(c)] = std::string(1, c);
  }
  for (const char* name : {"h.arc", "comma", "stop", "hyphen", "numeral", "and", "th", "mark"}) {
    add(name);
  }
  script.signs[U','] = "comma";
  script.signs[U'.'] = "stop";
  script.signs[U'-'] = "hyphen";
  const std::string digits = "jabcdefghi";  // 0 is j, 1 to 9 are a to i
  for (std::size_t i = 0; i < 10; ++i) {
    script.digits[U'0' + static_cast<char32_t>(i)] = std::string(1, digits[i]);
  }
  script.numeral_sign = "numeral";
  script.folds = {{U';', ","}, {U'\u00E6', "ae"}, {U'\u00F6', "oe"}, {U'\u2014', " - "}};
  using Where = Contraction::Where;
  script.contractions = {{"th", {"th"}, 1, Where::kPartOfWord},
                         {"and", {"and"}, 1, Where::kWholeWord},
                         {"the", {"th"}, 1, Where::kWholeWord},
                         {"ing", {"mark", "g"}, 1, Where::kWordEnd}};
  script.forms["h"] = {{"plain", "h"}, {"arc", "h.arc"}};
  script.protect_mark = U'|';
  return script;
}

}  // namespace moontrace
