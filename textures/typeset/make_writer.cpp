#include "textures/typeset/make_writer.h"

#include <fmt/core.h>

#include "textures/base/error.h"
#include "textures/base/utf8.h"
#include "textures/typeset/braille_writer.h"
#include "textures/typeset/signs.h"

namespace moontrace {

std::unique_ptr<Writer> MakeWriter(const Script& script, const TypeStyle& style) {
  if (style.older_punctuation && script.older_punctuation.short_stop == 0) {
    throw InputError(fmt::format("script {} has no older punctuation: leave it out", script.name));
  }
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
    throw InputError(fmt::format(
        "script {} is not Braille: choose script braille, or leave out Braille's table '{}'",
        script.name, Shown(style.table)));
  }
  return std::make_unique<SignWriter>(script, style.grade, style.h_form, style.only);
}

}  // namespace moontrace
