#include "textures/typeset/writer.h"

#include <fmt/core.h>

#include "textures/base/error.h"
#include "textures/base/utf8.h"
#include "textures/typeset/character_name.h"

namespace moontrace {
namespace {

// Entries kept of each list in Typeset; the counts go on.
constexpr std::size_t kMostReplacements = 1000;

}  // namespace

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
  while (!became.empty() && became.back() == ' ') became.pop_back();  // parts it from what follows
  return became;
}

}  // namespace moontrace
