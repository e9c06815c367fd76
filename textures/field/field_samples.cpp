// Many points at once. Points that follow each other in one letter are cut into runs in cells that
// hold the same; the elements of those cells are then looked at one after the other, for all points
// of the run side by side, in loops that compilers turn into vector instructions.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "textures/base/wide_vectors.h"
#include "textures/field/field_find.h"

namespace moontrace {

namespace {

using CompiledLayer = TextureField::CompiledLayer;

constexpr std::size_t kMost = 64;  ///< points of a run
constexpr std::size_t kSide = 8;   ///< that the widest vectors work out side by side
constexpr double kFar = 1e300;
constexpr double kHair = 1e-9;  ///< more than all rounding of places on a page [m]

/// Points of a run from their block's origin [m], and what is found there.
struct Run {
  std::size_t count = 0;
  alignas(64) std::array<double, kMost> x, y;
  alignas(64) std::array<double, kMost> distance, away_x, away_y;
  alignas(64) std::array<double, kMost> height, slope_x, slope_y;
};

/// As NearestOf and DisplacementAt of the single query, in the same order of operations.
MOONTRACE_WIDE void RunPlain(const CellElements& elements, const FlatProfile& profile, double sign,
                             Run& run) noexcept {
  // whole vectors only, so that no rest is left to be worked out one by one
  const std::size_t count = (run.count + kSide - 1) / kSide * kSide;
  const double *x = run.x.data(), *y = run.y.data();
  double *best = run.distance.data(), *away_x = run.away_x.data(), *away_y = run.away_y.data();
  for (std::size_t i = 0; i < count; ++i) best[i] = kFar;
  for (std::size_t i = 0; i < count; ++i) away_x[i] = away_y[i] = 0;
  for (std::size_t k = 0; k < elements.count; ++k) {
    const FlatElement& element = elements[k];
    const double ax = element.anchor.x, ay = element.anchor.y;
    const double ux = element.direction.x, uy = element.direction.y;
    if (element.kind == FlatKind::kLine) {
      const double length = element.length;
      for (std::size_t i = 0; i < count; ++i) {
        const double vx = x[i] - ax, vy = y[i] - ay;
        const double along = vx * ux + vy * uy;
        const double across = vy * ux - vx * uy;
        const double side = std::copysign(1.0, across);
        const bool at_spine = (along >= 0) & (along <= length);
        const double d = at_spine ? std::abs(across) : kFar;
        const bool nearer = d < best[i];
        best[i] = nearer ? d : best[i];
        away_x[i] = nearer ? -side * uy : away_x[i];
        away_y[i] = nearer ? side * ux : away_y[i];
      }
    } else if (element.kind == FlatKind::kCapped) {
      const double length = element.length;
      for (std::size_t i = 0; i < count; ++i) {
        const double vx = x[i] - ax, vy = y[i] - ay;
        const double on_line = vx * ux + vy * uy;
        const double past_start = on_line > 0 ? on_line : 0;
        const double along = past_start < length ? past_start : length;
        const double wx = vx - along * ux, wy = vy - along * uy;
        const double square = wx * wx + wy * wy, distance = std::sqrt(square);
        const double scale = OneOver(distance, square);
        best[i] = distance;
        away_x[i] = scale * wx;
        away_y[i] = scale * wy;
      }
    } else {
      const double radius = element.radius, cos_half = element.cos_half;
      for (std::size_t i = 0; i < count; ++i) {
        const double vx = x[i] - ax, vy = y[i] - ay;
        const double along = vx * ux + vy * uy;
        const double square = vx * vx + vy * vy, distance = std::sqrt(square);
        const double off = distance - radius;
        const double scale = std::copysign(OneOver(distance, square), off);
        const double d = along - distance * cos_half >= 0 ? std::abs(off) : kFar;
        const bool nearer = d < best[i];
        best[i] = nearer ? d : best[i];
        away_x[i] = nearer ? scale * vx : away_x[i];
        away_y[i] = nearer ? scale * vy : away_y[i];
      }
    }
  }
  const double half = profile.half, rounding = profile.rounding, straight = profile.straight;
  const double k = profile.curvature, signed_k = sign * k;
  double *height = run.height.data(), *slope_x = run.slope_x.data(), *slope_y = run.slope_y.data();
  for (std::size_t i = 0; i < count; ++i) {
    const double to_rim = half - best[i];
    const double inside = to_rim > 0 ? to_rim : 0;
    const double at_rim = inside < rounding ? inside : rounding;
    const double past_flank = inside > straight ? inside - straight : 0;
    const double steepness = k * at_rim - k * past_flank;
    const double to_x = inside > 0 ? 0.0 - sign * away_x[i] : 0;
    const double to_y = inside > 0 ? 0.0 - sign * away_y[i] : 0;
    height[i] =
        signed_k * at_rim * (inside - 0.5 * at_rim) - 0.5 * signed_k * past_flank * past_flank;
    slope_x[i] = steepness * to_x;
    slope_y[i] = steepness * to_y;
  }
}

/// Points and samples whose numbers stand side by side.
class SideBySide {
 public:
  SideBySide(std::span<const glm::dvec2> points, std::span<Sample> samples) noexcept
      : points_(points), samples_(samples) {}
  std::size_t count() const noexcept { return points_.size(); }
  glm::dvec2 PointAt(std::size_t i) const noexcept { return points_[i]; }
  void Clear(std::size_t i) const noexcept { samples_[i] = {}; }
  void Clear(std::size_t first, std::size_t count) const noexcept {
    std::fill_n(samples_.data() + first, count, Sample{});
  }
  void Set(std::size_t i, const Sample& sample) const noexcept { samples_[i] = sample; }
  Sample At(std::size_t i) const noexcept { return samples_[i]; }
  void Add(std::size_t i, const Sample& sample) const noexcept {
    samples_[i].displacement += sample.displacement;
    samples_[i].gradient += sample.gradient;
  }
  /// Those of a run, the first of which has the number `first`.
  void Set(std::size_t first, std::size_t count, const Run& run) const noexcept {
    for (std::size_t k = 0; k < count; ++k) {
      Set(first + k, {run.height[k], {run.slope_x[k], run.slope_y[k]}});
    }
  }

 private:
  std::span<const glm::dvec2> points_;
  std::span<Sample> samples_;
};

/// Those that have an array for each number.
class InColumns {
 public:
  InColumns(const PointColumns& points, const SampleColumns& samples, std::size_t count) noexcept
      : points_(points), samples_(samples), count_(count) {}
  std::size_t count() const noexcept { return count_; }
  glm::dvec2 PointAt(std::size_t i) const noexcept { return {points_.x[i], points_.y[i]}; }
  void Clear(std::size_t i) const noexcept { Set(i, Sample()); }
  void Clear(std::size_t first, std::size_t count) const noexcept {
    std::fill_n(samples_.displacement + first, count, 0.0);
    std::fill_n(samples_.gradient_x + first, count, 0.0);
    std::fill_n(samples_.gradient_y + first, count, 0.0);
  }
  void Set(std::size_t i, const Sample& sample) const noexcept {
    samples_.displacement[i] = sample.displacement;
    samples_.gradient_x[i] = sample.gradient.x;
    samples_.gradient_y[i] = sample.gradient.y;
  }
  Sample At(std::size_t i) const noexcept {
    return {samples_.displacement[i], {samples_.gradient_x[i], samples_.gradient_y[i]}};
  }
  void Add(std::size_t i, const Sample& sample) const noexcept {
    samples_.displacement[i] += sample.displacement;
    samples_.gradient_x[i] += sample.gradient.x;
    samples_.gradient_y[i] += sample.gradient.y;
  }
  void Set(std::size_t first, std::size_t count, const Run& run) const noexcept {
    std::copy_n(run.height.data(), count, samples_.displacement + first);
    std::copy_n(run.slope_x.data(), count, samples_.gradient_x + first);
    std::copy_n(run.slope_y.data(), count, samples_.gradient_y + first);
  }

 private:
  PointColumns points_;
  SampleColumns samples_;
  std::size_t count_;
};

/// Sets the samples to what a layer that stands in rows gives.
template <class Arrays>
class RowLayer {
 public:
  RowLayer(const CompiledLayer& layer, const Arrays& arrays) noexcept
      : layer_(layer), arrays_(arrays) {}

  void Set() noexcept {
    std::size_t i = 0;
    while (i < arrays_.count()) i = SetRun(i);
  }

 private:
  /// Sets what the layer gives at the i-th point and at those after it that meet the same cell, or
  /// the same gap; returns the next point's number.
  std::size_t SetRun(std::size_t i) noexcept {
    const glm::dvec2 p = arrays_.PointAt(i);
    const std::uint32_t band = BandOf(layer_, p.y);
    if (band >= layer_.band_count) return Skip(i, {{-kFar, p.y}, {kFar, p.y}});
    const std::vector<std::uint32_t>& of_band = layer_.rows.of_band;
    const FoundLetter letter = FindLetter(layer_, of_band.empty() ? band : of_band[band], p);
    if (letter.block == FoundLetter::kNone) return Skip(i, GapBesideRows(p));
    const double below = layer_.origin.y + band * band_height_;
    const Box in_band{{-kFar, below + kHair}, {kFar, below + band_height_ - kHair}};
    if (IsIn(layer_.blocks[letter.block].box, p - letter.origin))
      return SetLetter(letter, in_band, i);
    return Skip(i, GapBeside(letter, in_band, p));
  }

  /// Where there is nothing around a point to the left or to the right of all rows.
  Box GapBesideRows(glm::dvec2 p) const noexcept {
    const Rows& rows = layer_.rows;
    const double end = rows.begin + rows.slot_count / rows.slots_per_m;
    if (p.x < rows.begin) return {{-kFar, -kFar}, {rows.begin - kHair, kFar}};
    if (p.x > end) return {{end + kHair, -kFar}, {kFar, kFar}};
    return {p, p};
  }

  /// Where there is nothing around a point of the letter's stretch that is not in its box: beyond
  /// one of its sides. A hair less, so that rounding decides nothing.
  Box GapBeside(const FoundLetter& letter, const Box& in_band, glm::dvec2 p) const noexcept {
    const Box box = Moved(layer_.blocks[letter.block].box, letter.origin);
    const Rows& rows = layer_.rows;
    double next = rows.begin + letter.next * rows.step;
    if (!rows.pairs.empty()) {
      const double slot = std::floor((p.x - rows.begin) * rows.slots_per_m);
      next = std::min(next, rows.begin + (slot + 1) / rows.slots_per_m);
    }
    Box gap = in_band;
    if (p.x < box.min.x) {
      gap.min.x = p.x;
      gap.max.x = std::min(next, box.min.x) - kHair;
      return gap;
    }
    gap.min.x = p.x > box.max.x ? box.max.x + kHair : p.x;
    gap.max.x = next - kHair;
    if (p.x > box.max.x) return gap;
    if (p.y > box.max.y) gap.min.y = std::max(gap.min.y, box.max.y + kHair);
    if (p.y < box.min.y) gap.max.y = std::min(gap.max.y, box.min.y - kHair);
    return gap;
  }

  /// Nothing at the points up to the next outside the gap, whose number it returns.
  std::size_t Skip(std::size_t i, const Box& gap) const noexcept {
    do arrays_.Clear(i++);
    while (i < arrays_.count() && IsIn(gap, arrays_.PointAt(i)));
    return i;
  }

  /// The same for all cells of one letter that the points go through.
  std::size_t SetLetter(const FoundLetter& letter, const Box& in_band, std::size_t i) noexcept {
    const Block& block = layer_.blocks[letter.block];
    // a hair within the letter's box and its band a point surely meets this letter
    Box sure{block.box.min + kHair, block.box.max - kHair};
    sure.min.y = std::max(sure.min.y, in_band.min.y - letter.origin.y);
    sure.max.y = std::min(sure.max.y, in_band.max.y - letter.origin.y);
    do i = SetCells(letter, sure, i);
    while (i < arrays_.count() && IsIn(sure, arrays_.PointAt(i) - letter.origin));
    return i;
  }

  /// What a cell and its neighbours on one side in a row hold, and the part of the letter's box
  /// where a point surely lies in one of them.
  struct SureCells {
    Cell cell;
    Box sure;
  };
  /// Of those around the i-th point, to the side where the next one lies.
  SureCells CellsAt(const FoundLetter& letter, const Box& of_letter, std::size_t i) const noexcept {
    const glm::dvec2 p = arrays_.PointAt(i);
    const CellGrid& grid = layer_.rows.grid;
    const CellPlace place = PlaceOf(layer_, letter, p);
    const Cell* row =
        &layer_.cells[letter.block * layer_.rows.cells_per_block + place.row * grid.columns];
    const Cell cell = row[place.column];
    std::uint32_t first = place.column, end = first + 1;
    if (i + 1 < arrays_.count() && arrays_.PointAt(i + 1).x < p.x) {
      while (first > 0 && row[first - 1].code == cell.code) --first;
    } else {
      while (end < grid.columns && row[end].code == cell.code) ++end;
    }
    // where counting in steps decides nothing
    const glm::dvec2 from = grid_begin_ + cell_size_ * glm::dvec2(first, place.row) + wrong_;
    const glm::dvec2 to = grid_begin_ + cell_size_ * glm::dvec2(end, place.row + 1) - wrong_;
    return {cell, {glm::max(from, of_letter.min), glm::min(to, of_letter.max)}};
  }

  /// The same for the cells that hold the same as the i-th point's, as long as the points stay
  /// there.
  std::size_t SetCells(const FoundLetter& letter, const Box& of_letter, std::size_t i) noexcept {
    const Block& block = layer_.blocks[letter.block];
    const std::size_t first = i, end = std::min(arrays_.count(), first + kMost);
    SureCells at = CellsAt(letter, of_letter, i);
    const Cell cell = at.cell;
    do {
      i = Take(letter.origin, at.sure, first, i, end);
      if (i == end || !IsIn(of_letter, arrays_.PointAt(i) - letter.origin)) break;
      at = CellsAt(letter, of_letter, i);
    } while (at.cell.code == cell.code);
    if (cell.empty()) {
      arrays_.Clear(first, i - first);
    } else {
      SetPoints(block, cell, first, i - first);
    }
    return i;
  }

  /// Writes the i-th point, wherever it lies, and those after it that lie in the box to the run,
  /// which begins with the point `first`; returns the number of the first that does not, or `end`.
  std::size_t Take(glm::dvec2 origin, const Box box, std::size_t first, std::size_t i,
                   std::size_t end) noexcept {
    const Arrays points = arrays_;  // nothing that is written is among them
    double *x = &run_.x[i - first], *y = &run_.y[i - first];
    glm::dvec2 local = points.PointAt(i) - origin;
    do {
      *x++ = local.x;
      *y++ = local.y;
      if (++i == end) break;
      local = points.PointAt(i) - origin;
    } while (IsIn(box, local));
    return i;
  }

  /// Sets the run's points, the first of which has the number `first`.
  void SetPoints(const Block& block, Cell cell, std::size_t first, std::size_t count) noexcept {
    run_.count = count;
    for (std::size_t k = count; k % kSide != 0; ++k) {
      run_.x[k] = run_.x[count - 1];
      run_.y[k] = run_.y[count - 1];
    }
    const CellElements elements(layer_, block, cell);
    if (!elements.plain || elements.rims > 0 || count == 1) {
      for (std::size_t k = 0; k < count; ++k) {
        arrays_.Set(first + k, SampleCellAt(layer_, block, cell, {run_.x[k], run_.y[k]}));
      }
      return;
    }
    RunPlain(elements, layer_.profiles[elements[0].profile], layer_.sign, run_);
    arrays_.Set(first, count, run_);
  }

  const CompiledLayer& layer_;
  const Arrays arrays_;
  double band_height_ = 1 / layer_.bands_per_m;  ///< [m]
  double step_ = 1 / layer_.steps_per_m;         ///< [m]
  double wrong_ = kStepsWrong * step_;           ///< [m]
  /// Of a letter's cells, from its origin [m].
  glm::dvec2 grid_begin_ = glm::dvec2(layer_.lead, 0.0) -
                           step_ * glm::dvec2(layer_.rows.grid.left, layer_.rows.grid.below);
  glm::dvec2 cell_size_ = step_ * glm::dvec2(1u << layer_.rows.grid.column_shift,
                                             1u << layer_.rows.grid.row_shift);  ///< [m]
  Run run_;
};

template <class Arrays>
void SampleAll(const std::vector<CompiledLayer>& layers, const PaperField& paper,
               const Arrays& arrays) noexcept {
  if (layers.empty()) {
    arrays.Clear(0, arrays.count());
  } else if (layers.front().rows.length > 0) {
    RowLayer<Arrays>(layers.front(), arrays).Set();
  } else {
    for (std::size_t k = 0; k < arrays.count(); ++k) {
      arrays.Set(k, SampleLayerAt(layers.front(), arrays.PointAt(k)));
    }
  }
  for (std::size_t k = 0; layers.size() > 1 && k < arrays.count(); ++k) {
    const glm::dvec2 p_P = arrays.PointAt(k);
    const unsigned others = layers.front().others.At(p_P);
    if (others != 0) arrays.Set(k, SampleWithOthers(layers, arrays.At(k), others, p_P));
  }
  if (paper.empty()) return;
  for (std::size_t k = 0; k < arrays.count(); ++k) {
    arrays.Add(k, paper.SampleAt(arrays.PointAt(k)));
  }
}

}  // namespace

void TextureField::SamplesAt(std::span<const glm::dvec2> points_P,
                             std::span<Sample> samples) const noexcept {
  SampleAll(layers_, paper_, SideBySide(points_P, samples));
}

void TextureField::SamplesAt(const PointColumns& points_P, const SampleColumns& samples,
                             std::size_t count) const noexcept {
  SampleAll(layers_, paper_, InColumns(points_P, samples, count));
}

}  // namespace moontrace
