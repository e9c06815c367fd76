#include "sim/page_view/view_page.h"

#include <algorithm>
#include <utility>

#include "sim/picture/print_marks.h"

namespace moontrace {

namespace {

ViewPage::Letter LetterOf(const PlacedGlyph& placed, const Script& script, const TypeStyle& style,
                          std::string_view source) {
  const double em = ScaleOf(placed.kind, style) * style.size;
  ViewPage::Letter letter;
  letter.box_P = {placed.origin_P,
                  placed.origin_P + em * glm::dvec2(script.glyphs.at(placed.glyph).advance, 1)};
  const std::size_t begin = std::min(placed.source_begin, source.size());
  const std::size_t end = std::clamp(placed.source_end, begin, source.size());
  letter.print = source.substr(begin, end - begin);
  return letter;
}

}  // namespace

std::shared_ptr<const ViewPage> MakeViewPage(const Typeset& set, std::size_t index,
                                             const Script& script, std::string_view source,
                                             std::shared_ptr<const TextureField> field, bool blank,
                                             std::uint32_t number) {
  const TextPage& page = set.pages.at(index);
  const TypeStyle& style = set.style;
  auto view = std::make_shared<ViewPage>();
  view->number = number;
  view->field = std::move(field);
  view->sheet_P = {{0, 0}, {set.page.width, set.page.height}};
  view->width = style.width;
  view->letters.reserve(page.glyphs.size());
  const std::vector<PrintRoom> rooms = PrintRooms(page, script, style);
  const bool ruled = style.rules.lines && style.lines != LineDirection::kVertical;
  for (std::size_t i = 0; i < page.glyphs.size(); ++i) {
    ViewPage::Letter letter = LetterOf(page.glyphs[i], script, style, source);
    letter.print_top = rooms[i].top;
    if (!blank && (ruled || style.rules.margin)) letter.print_bottom = rooms[i].bottom;
    view->letters.push_back(std::move(letter));
  }
  if (!blank) view->strokes = IntendedStrokes(page, script, style);
  return view;
}

std::shared_ptr<const ViewPage> WithoutPrint(const ViewPage& page) {
  auto view = std::make_shared<ViewPage>(page);
  for (ViewPage::Letter& letter : view->letters) letter.print.clear();
  return view;
}

std::shared_ptr<const ViewPage> WithPaperAround(const ViewPage& page) {
  auto view = std::make_shared<ViewPage>(page);
  Box text;
  for (const ViewPage::Letter& letter : page.letters) Include(text, letter.box_P);
  if (page.letters.empty()) return view;
  const glm::dvec2 size = text.max - text.min, middle = 0.5 * (text.min + text.max);
  const double half = std::max(size.x, size.y);
  Include(view->sheet_P, Box{middle - half, middle + half});
  return view;
}

}  // namespace moontrace
