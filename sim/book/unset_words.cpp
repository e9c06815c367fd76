#include "sim/book/unset_words.h"

#include <string_view>

#include "lessons/documents/document_places.h"

namespace moontrace {

std::string UnsetWords(const FeltPage& page, std::size_t glyph) {
  const PlacedGlyph& mark = page.set().glyphs[glyph];
  if (mark.glyph != page.text->script.Find(kLeftOutMark)) return {};
  return WordsOf(std::string_view(page.text->text)
                     .substr(mark.source_begin, mark.source_end - mark.source_begin));
}

LeftOutWords CountLeftOut(const TextSetup& text) {
  LeftOutWords counts;
  for (const TextPage& page : text.set.pages) CountLeftOut(page, text.script, counts);
  return counts;
}

}  // namespace moontrace
