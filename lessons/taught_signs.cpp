#include "lessons/taught_signs.h"

#include <algorithm>
#include <memory>

#include "lessons/lesson_order.h"
#include "textures/fold.h"
#include "textures/text_file.h"
#include "textures/typeset.h"
#include "textures/writer.h"

namespace moontrace {
namespace {

void AddOnce(std::vector<std::string>& list, std::string text) {
  if (std::find(list.begin(), list.end(), text) == list.end()) list.push_back(std::move(text));
}

}  // namespace

SignUse SignsOf(std::string_view text, const Script& script, double grade,
                const std::set<std::string>* taught) {
  TypeStyle style = DefaultStyle(script.size, Relief::kEngraved, script);
  style.grade = grade;
  // Tables of liblouis know no signs left out, and no signs at all would mean all of them: what is
  // not taught is then seen below.
  if (taught != nullptr && script.braille_tables.empty()) {
    style.only.assign(taught->begin(), taught->end());
  }
  SignUse use;
  if (text.empty()) return use;
  const std::unique_ptr<Writer> writer = MakeWriter(script, style);
  Folder folder(text, script, [&writer](char32_t c) { return writer->Has(c); });
  Typeset notes;
  std::vector<FoldedChar> line;
  for (std::size_t number = 1; folder.NextLine(line); ++number) {
    std::vector<Sign> signs;
    writer->Write(text, number, line, signs, notes);
    for (const Sign& sign : signs) {
      if (sign.space) continue;
      const std::string& name = script.glyphs[sign.glyph].name;
      use.signs.push_back(name);
      // A numeral sign stands for no text of its own: its digits are noted.
      if (taught != nullptr && taught->count(name) == 0 && sign.end > sign.begin) {
        AddOnce(use.untaught, std::string(text.substr(sign.begin, sign.end - sign.begin)));
      }
    }
  }
  for (const Replacement& missing : notes.missing) AddOnce(use.missing, missing.was);
  for (const Replacement& untaught : notes.untaught) AddOnce(use.untaught, untaught.was);
  return use;
}

bool TeachesSigns(std::string_view item, const SignUse& use) {
  return use.signs.size() == 1 || (!use.signs.empty() && CountCharacters(item) == 1);
}

std::vector<std::string> SignsKnown(const Course& course, std::string_view lesson,
                                    const Script& script) {
  std::set<std::string> known;
  for (const std::size_t index : OrderOf(course).walk) {
    const Lesson& at = course.lessons[index];
    const bool own = at.script == course.script;
    if (at.id == lesson && !own) return {};
    for (const std::string& item : own ? at.items : std::vector<std::string>{}) {
      const SignUse use = SignsOf(item, script, at.grade, nullptr);
      if (TeachesSigns(item, use)) known.insert(use.signs.begin(), use.signs.end());
    }
    if (at.id == lesson) break;
  }
  return {known.begin(), known.end()};
}

}  // namespace moontrace
