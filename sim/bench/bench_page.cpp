#include "sim/bench/bench_page.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "textures/fonts/script_library.h"
#include "textures/relief/glyph_group.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

namespace {

/// Letters by their share of English text, in tenths of a percent (Lewand, Cryptological
/// Mathematics, 2000).
constexpr std::pair<char, int> kFrequencies[] = {
    {'e', 127}, {'t', 91}, {'a', 82}, {'o', 75}, {'i', 70}, {'n', 67}, {'s', 63},
    {'h', 61},  {'r', 60}, {'d', 43}, {'l', 40}, {'c', 28}, {'u', 28}, {'m', 24},
    {'w', 24},  {'f', 22}, {'g', 20}, {'y', 20}, {'p', 19}, {'b', 15}, {'v', 10},
    {'k', 8},   {'j', 2},  {'x', 2},  {'q', 1},  {'z', 1}};

std::string RepresentativeText(std::size_t lines, std::uint64_t seed) {
  std::string pool;
  for (const auto& [letter, share] : kFrequencies) {
    pool.append(static_cast<std::size_t>(share), letter);
  }
  std::mt19937_64 random(seed);
  std::string text;
  for (std::size_t line = 0; line < lines; ++line) {
    std::size_t in_word = 0;
    for (int column = 0; column < 64; ++column) {
      // English words have 4.7 letters on average; a line neither begins nor ends with a space
      const bool space = in_word > 0 && column < 63 && random() % 47 < 10;
      text += space ? ' ' : pool[random() % pool.size()];
      in_word = space ? 0 : in_word + 1;
    }
    text += '\n';
  }
  return text;
}

}  // namespace

BenchPage MakeBenchPage(std::size_t pages, std::uint64_t seed) {
  constexpr std::size_t kLines = 30;
  BenchPage page;
  page.script = FindScript("moon");
  page.style = DefaultStyle(0.005, Relief::kEngraved, page.script);
  page.style.grade = 0.5;  // every letter by itself: 64 signs a line
  const double margin = 0.001, text_height = kLines * page.style.line_pitch;
  const PageSpec paper{"custom", 0.56, text_height + 2 * margin, margin};
  const Typeset set =
      SetText(RepresentativeText(pages * kLines, seed), page.script, page.style, paper);
  page.size = {paper.width, static_cast<double>(set.pages.size()) * text_height + 2 * margin};
  // lines stay evenly spaced across the pages
  double up = static_cast<double>(set.pages.size()) * text_height;
  for (const TextPage& one : set.pages) {
    up -= text_height;
    for (PlacedGlyph glyph : one.glyphs) {
      glyph.origin_P.y += up;
      glyph.line += page.sheet.lines;
      page.sheet.glyphs.push_back(glyph);
    }
    page.sheet.lines += one.lines;
  }
  page.texture = BuildTexture(page.sheet, page.script, page.style);
  return page;
}

BenchPage MakeRichBenchPage(std::uint64_t seed) {
  constexpr std::size_t kLines = 30;
  BenchPage page;
  page.script = FindScript("moon");
  page.style = DefaultStyle(0.005, Relief::kEngraved, page.script);
  page.style.grade = 0.5;
  page.style.structure.read = true;
  page.style.links.reach = LinkReach::kLetters;
  page.style.rules.lines = page.style.rules.margin = true;
  page.style.texture.paper = PaperTexture{};
  std::string text = RepresentativeText(kLines, seed);
  std::size_t line = 0;
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1, ++line) {
    if (line % 10 == 0) text.insert(at, "# ");
  }
  // wide enough for a heading of 64 letters, high enough for all lines
  const PageSpec paper{"custom", 0.80, (kLines + 3) * page.style.line_pitch + 0.02, 0.01};
  const Typeset set = SetText(text, page.script, page.style, paper);
  page.size = {paper.width, paper.height};
  page.sheet = set.pages.front();
  page.texture = BuildTexture(page.sheet, page.script, page.style);
  return page;
}

BenchPage MakeLinkBenchPage(std::uint64_t seed) {
  constexpr std::size_t kLines = 10, kSigns = 480;
  BenchPage page;
  page.script = FindScript("moon");
  page.style = DefaultStyle(0.012, Relief::kEngraved, page.script);
  page.style.grade = 0.5;
  page.style.links.reach = LinkReach::kWords;
  const PageSpec paper{"custom", 1.6, (kLines + 2) * page.style.line_pitch, 0.01};
  page.size = {paper.width, paper.height};
  page.sheet =
      SetText(RepresentativeText(kLines, seed), page.script, page.style, paper).pages.front();
  page.sheet.glyphs.resize(kSigns);
  return page;
}

std::vector<glm::dvec2> PointsInLetters(const BenchPage& page, std::size_t count,
                                        std::uint64_t seed) {
  std::vector<Box> boxes;
  for (const Glyph& glyph : page.script.glyphs) {
    boxes.push_back(Finish(BuildGlyph(glyph, page.style))->bounds);
  }
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  const auto& glyphs = page.sheet.glyphs;
  std::vector<glm::dvec2> points(count);
  for (glm::dvec2& p : points) {
    const PlacedGlyph& glyph = glyphs[random() % glyphs.size()];
    const Box& box = boxes[glyph.glyph];
    const double scale = ScaleOf(glyph.kind, page.style);
    const glm::dvec2 in_box(share(random), share(random));
    p = glyph.origin_P + scale * (box.min + in_box * (box.max - box.min));
  }
  return points;
}

std::vector<glm::dvec2> SlidingPoints(const BenchPage& page, std::size_t most) {
  std::vector<glm::dvec2> points;
  const auto& glyphs = page.sheet.glyphs;
  for (std::size_t i = 0; i < glyphs.size() && points.size() < most; ++i) {
    if (i > 0 && glyphs[i].line == glyphs[i - 1].line) continue;
    const double middle = glyphs[i].origin_P.y + 0.5 * page.style.size;
    for (double x = 0; x < page.size.x && points.size() < most; x += 50e-6) {
      points.emplace_back(x, middle + 2e-3 * std::sin(40 * x));
    }
  }
  return points;
}

}  // namespace moontrace
