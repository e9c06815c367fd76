#include "sim/reading/read_text.h"

#include <map>

#include "textures/base/utf8.h"

namespace moontrace {
namespace {

/// The plain form of a sign's name.
std::string PlainName(const std::string& name, const Script& script) {
  for (const auto& [plain, forms] : script.forms) {
    for (const auto& [form, glyph] : forms) {
      if (glyph == name) return plain;
    }
  }
  return name;
}

}  // namespace

std::string TextOfSign(std::size_t glyph, const Script& script, bool alone) {
  const std::string name = PlainName(script.glyphs[glyph].name, script);
  for (const auto& [character, sign] : script.signs) {
    if (sign == name) return ToUtf8(character);
  }
  std::string text = "<" + name + ">";
  for (const Contraction& contraction : script.contractions) {
    if (contraction.signs != std::vector<std::string>{name}) continue;
    text = contraction.print;
    if ((contraction.where == Contraction::Where::kWholeWord) == alone) break;
  }
  return text;
}

std::string TextRead(const std::vector<ReadToken>& tokens, const Script& script) {
  std::map<std::string, char32_t> digits;
  for (const auto& [digit, name] : script.digits) digits[name] = digit;
  std::string text;
  bool number = false;
  const auto is_sign = [&tokens](std::size_t i) {
    return i < tokens.size() && tokens[i].kind == ReadToken::Kind::kSign;
  };
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const ReadToken& token = tokens[i];
    switch (token.kind) {
      case ReadToken::Kind::kSign: {
        const std::string& name = script.glyphs[token.glyph].name;
        if (name == script.numeral_sign) {
          number = true;
          break;
        }
        const auto digit = digits.find(PlainName(name, script));
        text +=
            number && digit != digits.end()
                ? ToUtf8(digit->second)
                : TextOfSign(token.glyph, script, !is_sign(i + 1) && (i == 0 || !is_sign(i - 1)));
        break;
      }
      case ReadToken::Kind::kUnknown:
        text += "\xEF\xBF\xBD";
        break;
      case ReadToken::Kind::kSpace:
        text += ' ';
        number = false;
        break;
      case ReadToken::Kind::kLineEnd:
        text += '\n';
        number = false;
        break;
    }
  }
  return text;
}

}  // namespace moontrace
