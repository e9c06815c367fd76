#include "lessons/course/taught_signs.h"

#include <algorithm>
#include <memory>

#include "textures/base/text_file.h"
#include "textures/typeset/fold.h"
#include "textures/typeset/make_writer.h"
#include "textures/typeset/typeset.h"
#include "textures/typeset/writer.h"

namespace moontrace {
namespace {

void AddOnce(std::vector<std::string>& list, std::string text) {
  if (std::find(list.begin(), list.end(), text) == list.end()) list.push_back(std::move(text));
}

}  // namespace

SignUse SignsOf(std::string_view text, const Script& script, double grade,
                const std::set<std::string>* taught) {
  SignUse use;
  if (text.empty()) return use;
  TypeStyle style = DefaultStyle(script.size, Relief::kEngraved, script);
  style.grade = grade;
  const std::unique_ptr<Writer> writer = MakeWriter(script, style);
  Folder folder(text, script, [&writer](char32_t c) { return writer->Has(c); });
  Typeset notes;
  std::vector<FoldedChar> line;
  while (folder.NextLine(line)) {
    std::vector<Sign> signs;
    writer->Write(text, folder.line_number(), line, signs, notes);
    bool numeral_untaught = false;
    for (const Sign& sign : signs) {
      if (sign.space) continue;
      const std::string& name = script.glyphs[sign.glyph].name;
      use.signs.push_back(name);
      use.pieces.emplace_back(text.substr(sign.begin, sign.end - sign.begin));
      const bool known = taught == nullptr || taught->count(name) > 0;
      // A numeral sign stands for no text of its own: its first digit is noted.
      if (sign.end == sign.begin) {
        numeral_untaught = numeral_untaught || !known;
        continue;
      }
      if (!known || numeral_untaught) {
        AddOnce(use.untaught, std::string(text.substr(sign.begin, sign.end - sign.begin)));
      }
      numeral_untaught = false;
    }
  }
  for (const Replacement& missing : notes.missing) AddOnce(use.missing, missing.was);
  return use;
}

bool TeachesSigns(std::string_view item, const SignUse& use) {
  return use.signs.size() == 1 || (!use.signs.empty() && CountCharacters(item) == 1);
}

}  // namespace moontrace
