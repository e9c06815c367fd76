#include "sim/session/felt_page.h"

#include <algorithm>
#include <glm/glm.hpp>
#include <limits>
#include <utility>

#include "sim/physics/page_field.h"
#include "sim/session/turn_mark.h"

namespace moontrace {

namespace {

/// Height of a letter [m].
double SizeOf(const PlacedGlyph& glyph, const TextSetup& text) {
  return ScaleOf(glyph.kind, text.set.style) * text.set.style.size;
}

/// Distance of a point to a letter's em box; 0 inside.
double DistanceTo(const PlacedGlyph& glyph, const TextSetup& text, glm::dvec2 p_P) {
  const double size = SizeOf(glyph, text);
  const glm::dvec2 extent(size * text.script.glyphs[glyph.glyph].advance, size);
  const glm::dvec2 low = glyph.origin_P, high = glyph.origin_P + extent;
  return glm::length(p_P - glm::clamp(p_P, low, high));
}

const PlacedGlyph* NearestGlyph(const FeltPage& page, glm::dvec2 p_P) {
  const PlacedGlyph* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const PlacedGlyph& glyph : page.set().glyphs) {
    const double distance = DistanceTo(glyph, *page.text, p_P);
    if (distance < least) {
      least = distance;
      nearest = &glyph;
    }
  }
  return nearest;
}

/// Where a character of the text stands: its page, and the letter.
struct FoundGlyph {
  std::size_t page = 0;
  const PlacedGlyph* glyph = nullptr;
};
/// The last page that begins at `source` or before it, else the first. Pages come in the order of
/// the text; by halves, since a book has thousands.
std::size_t PageAt(const TextSetup& text, std::size_t source) {
  const std::vector<TextPage>& pages = text.set.pages;
  const auto behind =
      std::partition_point(pages.begin(), pages.end(), [source](const TextPage& page) {
        return page.glyphs.empty() || page.glyphs.front().source_begin <= source;
      });
  return behind == pages.begin() ? 0 : static_cast<std::size_t>(behind - pages.begin()) - 1;
}

FoundGlyph GlyphAt(const TextSetup& text, std::size_t source) {
  FoundGlyph found;
  for (std::size_t page = PageAt(text, source); page < text.set.pages.size(); ++page) {
    for (const PlacedGlyph& glyph : text.set.pages[page].glyphs) {
      if (glyph.source_begin > source && found.glyph != nullptr) return found;
      found = {page, &glyph};
    }
  }
  return found;
}

}  // namespace

FeltPage FeltPageOf(std::shared_ptr<const TextSetup> text, std::size_t index, bool blank,
                    std::uint32_t number) {
  FeltPage page;
  page.text = std::move(text);
  page.index = index;
  page.blank = blank;
  page.number = number;
  std::vector<PaperPatch> marks;
  if (page.text->turn_mark) marks.push_back(TurnMark(page.text->set.page));
  page.field = std::make_shared<const TextureField>(
      PageField(page.set(), page.text->script, page.text->set.style, blank, marks));
  return page;
}

FeltPage OtherPage(const FeltPage& page, std::size_t index) {
  const std::size_t first = page.number - page.index;
  return FeltPageOf(page.text, index, page.blank, static_cast<std::uint32_t>(first + index));
}

std::optional<NearLetter> LetterNear(const FeltPage& page, glm::dvec2 p_P) {
  const PlacedGlyph* glyph = NearestGlyph(page, p_P);
  if (glyph == nullptr) return std::nullopt;
  const TextSetup& text = *page.text;
  NearLetter found;
  found.name = SourceOf(text, *glyph);
  if (found.name.empty()) found.name = text.script.glyphs[glyph->glyph].name;
  std::size_t begin = glyph->source_begin, end = glyph->source_end;
  for (const PlacedGlyph& other : page.set().glyphs) {
    if (other.word != glyph->word) continue;
    begin = std::min(begin, other.source_begin);
    end = std::max(end, other.source_end);
  }
  found.word = text.text.substr(begin, end - begin);
  found.line = glyph->line;
  const double size = SizeOf(*glyph, text);
  found.near = DistanceTo(*glyph, text, p_P) <= 0.25 * size;
  found.in_P = glm::clamp((p_P - glyph->origin_P) / size, glm::dvec2(0), glm::dvec2(1));
  return found;
}

std::optional<LetterPlace> LetterPlaceOf(const FeltPage& page, glm::dvec2 p_P) {
  const PlacedGlyph* letter = NearestGlyph(page, p_P);
  if (letter == nullptr) return std::nullopt;
  return LetterPlace{letter->source_begin, (p_P - letter->origin_P) / SizeOf(*letter, *page.text)};
}

std::optional<FoundPlace> Find(const TextSetup& text, const LetterPlace& place) {
  const FoundGlyph found = GlyphAt(text, place.source);
  if (found.glyph == nullptr) return std::nullopt;
  const glm::dvec2 p_P = found.glyph->origin_P + SizeOf(*found.glyph, text) * place.from_letter;
  return FoundPlace{found.page, found.glyph->line, p_P, std::string(SourceOf(text, *found.glyph))};
}

std::optional<std::size_t> LetterFrom(const TextSetup& text, std::size_t source) {
  for (std::size_t page = PageAt(text, source); page < text.set.pages.size(); ++page) {
    for (const PlacedGlyph& glyph : text.set.pages[page].glyphs) {
      const bool letter = glyph.kind != LineKind::kHead && glyph.source_begin < glyph.source_end;
      if (letter && glyph.source_begin >= source) return glyph.source_begin;
    }
  }
  return std::nullopt;
}

Followed Follow(const FeltPage& page, const TextSetup& next, glm::dvec2 tip_P) {
  const PlacedGlyph* letter = NearestGlyph(page, tip_P);
  const FoundGlyph found = GlyphAt(next, letter != nullptr ? letter->source_begin : 0);
  Followed followed{found.page, std::nullopt};
  if (letter != nullptr && found.glyph != nullptr) {
    const double ratio = next.set.style.size / page.text->set.style.size;
    followed.anchor = PageAnchor{letter->origin_P, found.glyph->origin_P, ratio};
  }
  return followed;
}

}  // namespace moontrace
