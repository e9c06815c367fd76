// Rows of slots, the form of evenly set text. Runs outside the tick.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "textures/field/field_place.h"

namespace moontrace {

namespace {

using Row = std::vector<const PlacedGroup*>;

constexpr double kMostSteps = 0x1p22;  // finer than this is no raster but rounding

/// Equally spaced places in x.
struct Raster {
  double first = 0;  ///< [m]
  double step = 0;   ///< [m]; 0 if there is none
  double NumberOf(double x) const { return std::floor((x - first) / step + 0.5); }
};

/// The greatest length that both are multiples of (Euclid), rounding errors aside.
double CommonMeasure(double a, double b, double negligible) {
  while (b > negligible) {
    const double rest = std::abs(std::remainder(a, b));
    a = b;
    b = rest;
  }
  return a;
}

/// The coarsest raster that all places stand on to a few units in the last place of the greatest;
/// typeset letters have one, since advances are whole thousandths of an em.
Raster FindRaster(const Bands& bands, const Box& all) {
  double first = std::numeric_limits<double>::infinity(), last = -first;
  for (const Row& row : bands) {
    for (const PlacedGroup* place : row) {
      first = std::min(first, place->origin.x);
      last = std::max(last, place->origin.x);
    }
  }
  const double least = (last - first) / kMostSteps;
  // A length known to be a whole number of steps sharpens the step: else its rounding error, times
  // as many steps as a row has, would pass for a finer raster.
  double step = 0, longest = 0;
  for (const Row& row : bands) {
    for (const PlacedGroup* place : row) {
      const double length = place->origin.x - first;
      if (!(length > least)) continue;
      step = CommonMeasure(length, step, 0.25 * least);
      if (step < least) return {};
      longest = std::max(longest, length);
      step = longest / std::floor(longest / step + 0.5);
    }
  }
  if (step == 0) return {first, all.max.x - all.min.x};
  Raster raster{first, step};
  raster.step = (last - first) / raster.NumberOf(last);  // sharper: the longest length measured
  const double most = 8 * std::numeric_limits<double>::epsilon() * std::max(-first, last);
  for (const Row& row : bands) {
    for (const PlacedGroup* place : row) {
      const double x = first + raster.NumberOf(place->origin.x) * raster.step;
      if (!(std::abs(x - place->origin.x) <= most)) return {};
    }
  }
  return raster;
}

/// The narrowest gap between a block's end and where its neighbour's may begin [m]; a block begins
/// `lead` [m] from its origin. Zero or less where they overlap or do not stand at one height.
double GapBetweenBlocks(const Bands& bands, double lead) {
  double gap = std::numeric_limits<double>::infinity();
  for (const Row& row : bands) {
    for (std::size_t i = 1; i < row.size(); ++i) {
      if (row[i]->origin.y != row[0]->origin.y) return 0;
      gap = std::min(gap, row[i]->origin.x + lead - row[i - 1]->box.max.x);
    }
  }
  return gap;
}

/// Numbers the blocks and steps that occur together.
class CodeBook {
 public:
  /// False if there are too many.
  bool Add(Code code, std::uint8_t& number) {
    const auto [at, is_new] = numbers_.try_emplace(code.bits, numbers_.size());
    if (at->second >= codes_.size()) return false;
    number = static_cast<std::uint8_t>(at->second);
    codes_[number] = code;
    return true;
  }
  const std::array<Code, 256>& codes() const { return codes_; }

 private:
  std::map<std::uint64_t, std::size_t> numbers_;
  std::array<Code, 256> codes_{};
};

/// A letter's place on the raster, and its code.
struct RasterLetter {
  std::int32_t at = 0;  ///< [steps]
  std::uint8_t code = 0;
};
using RasterLine = std::vector<RasterLetter>;

/// False if the code book does not suffice.
bool Encode(const Row& row, const Raster& raster, CodeBook& book, RasterLine& line) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    const auto at = static_cast<std::int32_t>(raster.NumberOf(row[i]->origin.x));
    std::int32_t step = Letters::kFar;
    if (i + 1 < row.size()) {
      step = static_cast<std::int32_t>(raster.NumberOf(row[i + 1]->origin.x)) - at;
    }
    std::uint8_t number = 0;
    if (!book.Add(MakeCode(step, row[i]->block), number)) return false;
    line.push_back({at, number});
  }
  return true;
}

/// The letters of a line from one on, as many as a slot holds.
Letters LettersFrom(const RasterLine& line, std::size_t first) {
  Letters letters{static_cast<std::uint64_t>(line[first].at)};
  for (std::size_t i = 0; i < Letters::kMost && first + i < line.size(); ++i) {
    letters.bits |= std::uint64_t{line[first + i].code} << (24 + 8 * i);
  }
  return letters;
}

/// Spreads a line over slots by fives, from left to right; false if letters come to stand further
/// on than a query looks.
bool Spread(const RasterLine& line, const Rows& rows, std::vector<Letters>& slots) {
  slots.assign(1, line.empty() ? Letters{Letters::kFar} : LettersFrom(line, 0));
  for (std::size_t i = 0; i < line.size(); i += Letters::kMost) {
    // the first slot is for what begins before a query's
    const auto own = 1 + static_cast<std::size_t>(line[i].at * rows.step * rows.slots_per_m);
    if (slots.size() >= own + Rows::kWindow) return false;
    while (slots.size() < own) slots.push_back(slots.back());
    slots.push_back(LettersFrom(line, i));
  }
  return true;
}

/// Spreads all lines over `count` slots each; false as above.
bool SpreadAll(const std::vector<RasterLine>& lines, std::size_t count, double width, Rows& rows) {
  rows.slots_per_m = static_cast<double>(count) / width;
  rows.slot_count = std::floor(width * rows.slots_per_m) + 1;
  std::vector<std::vector<Letters>> spread(lines.size());
  std::size_t length = 1 + Rows::kWindow;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!Spread(lines[i], rows, spread[i])) return false;
    length = std::max(length, spread[i].size());
  }
  rows.length = static_cast<std::uint32_t>(length);
  rows.slots.reserve(length * lines.size());
  for (std::vector<Letters>& row : spread) {
    row.resize(length, row.back());
    rows.slots.insert(rows.slots.end(), row.begin(), row.end());
  }
  return true;
}

/// What a slot tells: the i-th letter of a line, or none before its first, and the next, if it
/// begins within reach.
LetterPair PairOf(const RasterLine& line, const CodeBook& book, std::size_t i) {
  const auto block = [&](std::size_t k) {
    return std::uint64_t{book.codes()[line[k].code].block()};
  };
  const bool last = i + 1 == line.size();
  const auto at = static_cast<std::uint64_t>(line[i].at);
  const std::int32_t step =
      last ? LetterPair::kMostSteps : std::min(line[i + 1].at - line[i].at, LetterPair::kMostSteps);
  return {at | static_cast<std::uint64_t>(step) << 24 | block(i) << 40 |
          block(last ? i : i + 1) << 52};
}

/// A line's slots where each holds the letter in which it begins and the one that may begin in it.
/// A hair of rounding decides nothing, since letters begin half a step from where steps change.
void SpreadInPairs(const RasterLine& line, const CodeBook& book, Rows& rows) {
  constexpr LetterPair kNothing{Letters::kFar | std::uint64_t{LetterPair::kMostSteps} << 24};
  const double slot_steps = 1 / (rows.slots_per_m * rows.step);
  std::size_t i = 0;
  for (std::uint32_t slot = 0; slot < rows.length; ++slot) {
    const double begin = slot * slot_steps - 0.5, end = begin + slot_steps + 1;
    while (i + 1 < line.size() && line[i + 1].at <= begin) ++i;
    // so long after its origin no letter matters any more
    const bool over = i < line.size() && line[i].at + LetterPair::kMostSteps <= end;
    const std::size_t first = i + (over ? 1 : 0);
    const bool nothing = first >= line.size() || (over && line[first].at > end);
    rows.pairs.push_back(nothing ? kNothing : PairOf(line, book, first));
  }
}

/// Slots so narrow that at most one letter begins in each; false if there would be more than a
/// page's, or blocks that these cannot tell.
bool SpreadAllInPairs(const std::vector<RasterLine>& lines, const CodeBook& book, double width,
                      const LargeArray<Block>& blocks, Rows& rows) {
  constexpr double kMostSlots = 20000;  // 160 kB, well within a second cache
  if (blocks.size() > LetterPair::kMostBlocks) return false;
  for (const Block& block : blocks) {
    if (block.box.max.x - block.box.min.x > 0.5 * LetterPair::kMostSteps * rows.step) return false;
  }
  std::int32_t least = LetterPair::kMostSteps / 2;
  for (const RasterLine& line : lines) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      least = std::min(least, line[i].at - line[i - 1].at);
    }
  }
  const double slot = (least - 2) * rows.step;
  if (least < 8 || width / slot * static_cast<double>(lines.size()) > kMostSlots) return false;
  rows.slots_per_m = 1 / slot;
  rows.slot_count = std::floor(width * rows.slots_per_m) + 1;
  rows.length = static_cast<std::uint32_t>(rows.slot_count);
  rows.pairs.reserve(rows.length * lines.size());
  for (const RasterLine& line : lines) SpreadInPairs(line, book, rows);
  return true;
}

/// The groups that stand at one height, and the heights that they reach over.
struct TextLine {
  Row row;
  double low = 0, high = 0;  ///< [m]
};

/// Lines from the lowest to the highest.
std::vector<TextLine> LinesOf(const std::vector<PlacedGroup>& places) {
  std::map<double, TextLine> by_height;
  for (const PlacedGroup& place : places) {
    TextLine& line = by_height[place.origin.y];
    const bool first = line.row.empty();
    line.low = first ? place.box.min.y : std::min(line.low, place.box.min.y);
    line.high = first ? place.box.max.y : std::max(line.high, place.box.max.y);
    line.row.push_back(&place);
  }
  std::vector<TextLine> lines;
  lines.reserve(by_height.size());
  for (auto& [y, line] : by_height) lines.push_back(std::move(line));
  return lines;
}

/// The narrowest gap between neighbouring lines [m]; zero or less where they overlap.
double NarrowestGap(const std::vector<TextLine>& lines) {
  double gap = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < lines.size(); ++i) {
    gap = std::min(gap, lines[i].low - lines[i - 1].high);
  }
  return gap;
}

void SetRows(Rows rows, double lead, TextureField::CompiledLayer& layer) {
  layer.steps_per_m = 1 / rows.step;
  layer.lead = lead;
  layer.rows = std::move(rows);
}

}  // namespace

bool AddRows(const Bands& bands, const Box& all, TextureField::CompiledLayer& layer) {
  Raster raster = FindRaster(bands, all);
  if (raster.step == 0) return false;
  double lead = layer.blocks.front().box.min.x;
  for (const Block& block : layer.blocks) lead = std::min(lead, block.box.min.x);
  // half a step of room on either side, so that a query's rounding never hides a letter: where all
  // stand a cell apart, as in Braille, steps are parts of a cell
  const double gap = GapBetweenBlocks(bands, lead);
  if (!(gap > 0)) return false;
  // as fine as the blocks' grids need it; halved, so that places stay what they are to the bit
  while (!(raster.step < gap) || raster.step * layer.steps_per_m > 1) raster.step /= 2;
  Rows rows;
  rows.first_x = raster.first;
  rows.step = raster.step;
  rows.begin = raster.first + lead - 0.5 * raster.step;
  const double width = all.max.x - rows.begin;
  if (!(2 * width < Letters::kFar * raster.step)) return false;

  CodeBook book;
  std::vector<RasterLine> lines(bands.size());
  std::size_t places = 0, longest = 1;
  for (std::size_t i = 0; i < bands.size(); ++i) {
    if (!Encode(bands[i], raster, book, lines[i])) return false;
    places += bands[i].size();
    longest = std::max(longest, (lines[i].size() + Letters::kMost - 1) / Letters::kMost);
    rows.heights.push_back({bands[i].empty() ? 0 : bands[i].front()->origin.y, 0});
  }
  rows.codes = book.codes();
  if (SpreadAllInPairs(lines, book, width, layer.blocks, rows)) {
    SetRows(std::move(rows), lead, layer);
    return true;
  }
  // the fewest slots that serve; not so many that rows would outgrow buckets
  const std::size_t most = (4 * places + 64) / bands.size();
  for (std::size_t count = std::max<std::size_t>(longest, Rows::kWindow); count < most;
       count += 1 + count / 8) {
    if (!SpreadAll(lines, count, width, rows)) continue;
    SetRows(std::move(rows), lead, layer);
    return true;
  }
  return false;
}

bool AddUnevenRows(const std::vector<PlacedGroup>& places, const Box& all,
                   TextureField::CompiledLayer& layer) {
  std::vector<TextLine> lines = LinesOf(places);
  const double gap = NarrowestGap(lines), height = all.max.y - all.min.y;
  const double most = 4.0 * static_cast<double>(places.size()) + 64;
  // bands narrower than any gap meet one line at most; so many that they would outgrow buckets: no
  if (lines.size() < 2 || !(gap > 0) || height / (0.9 * gap) > most) return false;
  Bands rows;
  for (TextLine& line : lines) {
    std::stable_sort(
        line.row.begin(), line.row.end(),
        [](const PlacedGroup* a, const PlacedGroup* b) { return a->box.min.x < b->box.min.x; });
    rows.push_back(line.row);
  }
  if (!AddRows(rows, all, layer)) return false;
  layer.origin.y = all.min.y;
  layer.bands_per_m = 1 / (0.9 * gap);
  layer.band_count = std::floor((all.max.y - layer.origin.y) * layer.bands_per_m) + 1;
  layer.rows.of_band.assign(static_cast<std::size_t>(layer.band_count), 0);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    // computed as a query computes it, so that rounding cannot part them
    const auto band_of = [&layer](double y) {
      return static_cast<std::size_t>((y - layer.origin.y) * layer.bands_per_m);
    };
    for (std::size_t band = band_of(lines[i].low); band <= band_of(lines[i].high); ++band) {
      layer.rows.of_band[band] = static_cast<std::uint32_t>(i);
    }
  }
  return true;
}

}  // namespace moontrace
