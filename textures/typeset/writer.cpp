#include "textures/typeset/writer.h"

#include <fmt/core.h>

#include "textures/base/error.h"
#include "textures/typeset/braille_writer.h"
#include "textures/typeset/character_name.h"
#include "textures/typeset/signs.h"

namespace moontrace {
namespace {

// Entries kept of each list in Typeset; the counts go on.
constexpr std::size_t kMostReplacements = 1000;

}  // namespace

std::unique_ptr<Writer> MakeWriter(const Script& script, const TypeStyle& style) {
  if (!script.braille_tables.empty()) {
    if (!style.h_form.empty()) {
      throw InputError(fmt::format("script {} has one form of h only, no '{}': leave the form out",
                                   script.name, Shown(style.h_form)));
    }
    if (!style.only.empty()) {
      throw InputError(fmt::format(
          "script {} has no letters of its own to choose from: leave the taught signs out",
          script.name));
    }
    return std::make_unique<BrailleWriter>(script, style.grade, style.table);
  }
  if (!style.table.empty()) {
    throw InputError(fmt::format("script {} uses no Braille table: leave out table '{}'",
                                 script.name, Shown(style.table)));
  }
  return std::make_unique<SignWriter>(script, style.grade, style.h_form, style.only);
}

void CheckGrade(const Script& script, double grade) {
  std::string known;
  for (const double other : script.grades) {
    if (other == grade) return;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", other);
  }
  throw InputError(
      fmt::format("script {} has no grade {}: choose from {}", script.name, grade, known));
}

void Note(std::vector<Replacement>& list, std::size_t& count, std::string_view text,
          std::size_t line_number, const FoldedChar& c, std::string became) {
  ++count;
  if (list.size() >= kMostReplacements) return;
  // A part of what a character became ("ae") has no range of its own.
  const std::string was =
      c.begin < c.end ? std::string(text.substr(c.begin, c.end - c.begin)) : ToUtf8(c.code);
  list.push_back(
      {Shown(was), std::move(became), line_number, c.column, CharacterName(was), c.replaced});
}

std::string Became(const std::vector<FoldedChar>& line, std::size_t at) {
  if (line[at].kind == FoldedChar::Kind::kNothing) return {};
  std::string became = ToUtf8(line[at].code);
  for (std::size_t i = at + 1; i < line.size() && line[i].begin == line[i].end; ++i) {
    became += ToUtf8(line[i].code);
  }
  return became;
}

}  // namespace moontrace
