#include "textures/typeset/taught.h"

#include <algorithm>

#include "textures/base/error.h"
#include "textures/base/nearest_word.h"
#include "textures/base/text_file.h"
#include "textures/base/utf8.h"
#include "textures/typeset/fold.h"

namespace moontrace {
namespace {

void AddCharacters(std::string_view characters, const Script& script,
                   std::vector<std::string>& taught) {
  const std::string lower = LowerCase(characters);
  for (const char32_t c : ToCodePoints(lower)) {
    if (c == U' ') continue;
    const auto digit = script.digits.find(c);
    const auto sign = script.signs.find(c);
    if (digit == script.digits.end() && sign == script.signs.end()) {
      throw InputError("taught signs: script " + script.name + " has no sign for '" +
                       Shown(ToUtf8(c)) + "': leave it out");
    }
    taught.push_back(digit != script.digits.end() ? digit->second : sign->second);
  }
}

void AddName(std::string_view given, const Script& script, std::vector<std::string>& taught) {
  const std::string name(given);
  if (script.Find(name) == Script::npos) {
    std::vector<std::string> known;
    for (const Glyph& glyph : script.glyphs) known.push_back(glyph.name);
    const std::string nearest = NearestWord(name, known);
    throw InputError(
        "taught signs: script " + script.name + " has no sign named '" + OneLine(name, 40) +
        "': " + (nearest.empty() ? "page lists names" : "did you mean " + nearest + "?"));
  }
  taught.push_back(name);
}

}  // namespace

std::vector<std::string> TaughtSigns(std::string_view given, const Script& script) {
  std::vector<std::string> taught;
  const std::size_t plus = std::min(given.find('+'), given.size());
  AddCharacters(given.substr(0, plus), script, taught);
  for (std::string_view rest = given.substr(plus); !rest.empty();) {
    rest.remove_prefix(1);
    const std::size_t next = std::min(rest.find('+'), rest.size());
    AddName(rest.substr(0, next), script, taught);
    rest.remove_prefix(next);
  }
  if (taught.empty()) throw InputError("taught signs: none given: write letters like abc");
  return taught;
}

}  // namespace moontrace
