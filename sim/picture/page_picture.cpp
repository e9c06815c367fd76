#include "sim/picture/page_picture.h"

#include <algorithm>
#include <string>
#include <utility>

#include "sim/picture/link_marks.h"
#include "sim/picture/link_messages.h"
#include "sim/picture/moon_marks.h"
#include "sim/picture/picture_messages.h"
#include "sim/picture/print_marks.h"
#include "sim/picture/sheet_marks.h"
#include "sim/picture/sheet_messages.h"
#include "sim/picture/structure_messages.h"
#include "textures/base/units.h"
#include "textures/relief/structure_patches.h"
#include "textures/typeset/sheet_texture.h"

namespace moontrace {

namespace {

PathMark Edge(double width, double height) {
  PathMark edge;
  edge.subpaths = {{Line{{0, 0}, {width, 0}}, Line{{width, 0}, {width, height}},
                    Line{{width, height}, {0, height}}, Line{{0, height}, {0, 0}}}};
  edge.stroke = palette::kPaperEdge;
  edge.width = 0.5;
  return edge;
}

}  // namespace

Drawing PagePicture(const TextPage& text_page, PageNumber number, const Typeset& set,
                    const Script& script, std::string_view source, bool print_letters) {
  Drawing drawing;
  drawing.width = kMillimetres * set.page.width;
  drawing.height = kMillimetres * set.page.height;
  drawing.title = say::PagePictureTitle(script.title, number.page, number.pages);
  drawing.description = say::PagePictureWords(text_page.glyphs.size(), text_page.lines, set.style);
  Texture rough;
  AddSheetTexture(text_page, set.style, rough);
  AddStructurePatches(text_page, script, set.style, rough);
  const bool drawn = std::all_of(rough.paper.begin(), rough.paper.end(), CanDraw);
  const say::PaperDrawn paper = drawn ? say::PaperDrawn::kShaded : say::PaperDrawn::kTooFine;
  drawing.description += say::SheetWords(set.style, paper) + say::HeadingWords(set.style);
  for (Mark& mark : TextureMarks(rough.paper)) drawing.marks.push_back(std::move(mark));
  drawing.marks.emplace_back(Edge(drawing.width, drawing.height));
  for (Mark& mark : RuleMarks(text_page, script, set.style, {0, 0})) {
    drawing.marks.push_back(std::move(mark));
  }
  const std::shared_ptr<const GrooveLinks> links = LinksOf(text_page, script, set.style);
  if (set.style.links.reach != LinkReach::kNone) {
    drawing.description += ' ';
    drawing.description += say::LinksDrawn({links->links.size(), links->missing, links->crossings});
  }
  for (Mark& mark : LinkMarks(*links, script, set.style, {0, 0}, palette::kLink)) {
    drawing.marks.push_back(std::move(mark));
  }
  for (Mark& mark : MoonMarks(text_page, script, set.style, {0, 0}, palette::kInk)) {
    drawing.marks.push_back(std::move(mark));
  }
  if (!print_letters) return drawing;
  for (Mark& mark : PrintMarks(text_page, script, set.style, source)) {
    drawing.marks.push_back(std::move(mark));
  }
  return drawing;
}

Drawing SwellPage(const TextPage& page, const Typeset& set, const Script& script,
                  const std::string& title) {
  Drawing drawing;
  drawing.width = kMillimetres * set.page.width;
  drawing.height = kMillimetres * set.page.height;
  drawing.title = title;
  drawing.description = say::PagePictureWords(page.glyphs.size(), page.lines, set.style);
  drawing.marks = MoonMarks(page, script, set.style, {0, 0}, Color{0, 0, 0});
  return drawing;
}

}  // namespace moontrace
