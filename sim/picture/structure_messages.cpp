#include "sim/picture/structure_messages.h"

#include <fmt/core.h>

#include <cmath>

#include "sim/console/wording.h"
#include "textures/base/units.h"

namespace moontrace::say {

std::string Form(const LetterForm& form) {
  if (form == LetterForm{}) return {};
  std::string words;
  if (form.slant != 0) {
    words = fmt::format("lean {} degrees to the {}", Short(InDegrees(std::abs(form.slant)), 2),
                        form.slant > 0 ? "right" : "left");
  }
  if (form.stretch != 1) {
    if (!words.empty()) words += ", ";
    words += fmt::format("are {} times as wide", Short(form.stretch, 3));
  }
  return fmt::format("Letters {}.", words);
}

std::string Structure(const Typeset& set) {
  const StructureCounts& found = set.structure;
  std::string words = fmt::format(
      "Structure: {}, {}, {}.", Counted(found.headings, "heading", "headings"),
      Counted(found.quotations, "quotation", "quotations"), Counted(found.links, "link", "links"));
  if (found.headings == 0) return words;
  words.pop_back();
  const double size = ScaleOf(LineKind::kHeading, set.style) * set.style.size;
  return fmt::format("{}; headings {} mm high.", words, Short(kMillimetres * size, 2));
}

std::string HeadingWords(const TypeStyle& style) {
  const Relief relief = style.structure.heading_relief.value_or(style.relief);
  if (!style.structure.read || relief == style.relief) return {};
  return fmt::format(" Headings are {}, green.",
                     relief == Relief::kEmbossed ? "ridges" : "grooves");
}

}  // namespace moontrace::say
