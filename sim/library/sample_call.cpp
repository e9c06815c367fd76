// The C interface: the surface at one point and at many.
#include <algorithm>
#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <string>

#include "sim/library/call.h"
#include "sim/library/moontrace.h"
#include "sim/library/values.h"
#include "textures/field/surface.h"

using namespace moontrace;

namespace {

constexpr std::size_t kBlock = 512;     ///< points that are copied at a time: they stay near
constexpr std::size_t kStretch = 1024;  ///< points that are done at a time where none is copied

/// Doubles of a caller, some bytes apart. Their addresses may be any, so they are copied one by
/// one.
template <class Byte>
class Strided {
 public:
  /// Throws UsageError: NULL, or longer than any memory.
  Strided(Byte* first, std::ptrdiff_t step, std::size_t count, const char* name)
      : first_(first), step_(step) {
    if (first == nullptr && count > 0) throw UsageError(std::string(name) + " is NULL");
    const std::size_t length =
        step < 0 ? 0 - static_cast<std::size_t>(step) : static_cast<std::size_t>(step);
    constexpr auto kMost = static_cast<std::size_t>(std::numeric_limits<std::ptrdiff_t>::max());
    if (length > 0 && count > kMost / length) {
      throw UsageError(std::string(name) + " is longer than any memory");
    }
  }
  double Get(std::size_t i) const noexcept { return Read(At(i)); }
  void Set(std::size_t i, double value) const noexcept { Write(At(i), value); }
  /// Gives `count` numbers from the i-th on to `take` as 0, 1, ... and their value.
  template <class Take>
  void GetMany(std::size_t first, std::size_t count, Take take) const noexcept {
    const Byte* at = At(first);
    if (step_ == sizeof(double)) {
      for (std::size_t i = 0; i < count; ++i) take(i, Read(at + i * sizeof(double)));
    } else {
      for (std::size_t i = 0; i < count; ++i, at += step_) take(i, Read(at));
    }
  }
  /// Sets `count` numbers from the i-th on to what `value` gives for 0, 1, ...; numbers that follow
  /// each other closely in a loop of their own, which compilers turn into vector instructions.
  template <class Value>
  void SetMany(std::size_t first, std::size_t count, Value value) const noexcept {
    Byte* at = At(first);
    if (step_ == sizeof(double)) {
      for (std::size_t i = 0; i < count; ++i) Write(at + i * sizeof(double), value(i));
    } else {
      for (std::size_t i = 0; i < count; ++i, at += step_) Write(at, value(i));
    }
  }
  Byte* At(std::size_t i) const noexcept { return first_ + static_cast<std::ptrdiff_t>(i) * step_; }
  std::ptrdiff_t step() const noexcept { return step_; }

 private:
  static double Read(const Byte* at) noexcept {
    double value = 0;
    std::memcpy(&value, at, sizeof value);
    return value;
  }
  static void Write(Byte* at, double value) noexcept { std::memcpy(at, &value, sizeof value); }

  Byte* first_;
  std::ptrdiff_t step_;
};

using Input = Strided<const char>;
using Output = Strided<char>;

Input InputOf(const double* first, std::ptrdiff_t step, std::size_t count, const char* name) {
  return {reinterpret_cast<const char*>(first), step, count, name};
}

/// None where it is not wanted. Throws UsageError where numbers would lie over each other.
std::optional<Output> OutputOf(double* first, std::ptrdiff_t step, std::size_t count,
                               const char* name) {
  if (first == nullptr || count == 0) return std::nullopt;
  constexpr std::ptrdiff_t kWidth = sizeof(double);
  if (count > 1 && step > -kWidth && step < kWidth) {
    throw UsageError(std::string(name) + "_step is less than a number's width");
  }
  return Output(reinterpret_cast<char*>(first), step, count, name);
}

/// Whether addresses from `first` on, `step` bytes apart, are those of an array of such values.
template <class Value>
bool IsArrayOf(const char* first, std::ptrdiff_t step) noexcept {
  return step == sizeof(Value) && reinterpret_cast<std::uintptr_t>(first) % alignof(Value) == 0;
}

static_assert(sizeof(glm::dvec2) == 2 * sizeof(double));
static_assert(sizeof(Sample) == 3 * sizeof(double));

/// Places on the page, block by block.
class Places {
 public:
  Places(const Input& x, const Input& y) noexcept
      : x_(x),
        y_(y),
        side_by_side_(IsArrayOf<glm::dvec2>(x.At(0), x.step()) && y.step() == x.step() &&
                      y.At(0) == x.At(0) + sizeof(double)) {}

  /// Those from `first` on: where the caller has them, if they stand there side by side.
  std::span<const glm::dvec2> From(std::size_t first, std::size_t count) noexcept {
    if (side_by_side_) return {reinterpret_cast<const glm::dvec2*>(x_.At(first)), count};
    x_.GetMany(first, count, [this](std::size_t i, double x) { own_[i].x = x; });
    y_.GetMany(first, count, [this](std::size_t i, double y) { own_[i].y = y; });
    return {own_.data(), count};
  }

  bool side_by_side() const noexcept { return side_by_side_; }

 private:
  Input x_, y_;
  bool side_by_side_;
  std::array<glm::dvec2, kBlock> own_;
};

/// False if one of them is not finite, since then no sum is; or, rarely, if a sum is too large. In
/// sums that do not wait for each other, as vectors have them.
bool AllSurelyFinite(std::span<const glm::dvec2> points) noexcept {
  constexpr std::size_t kSums = 8;
  std::array<double, kSums> x{}, y{};
  std::size_t i = 0;
  for (; i + kSums <= points.size(); i += kSums) {
    for (std::size_t k = 0; k < kSums; ++k) {
      x[k] += points[i + k].x;
      y[k] += points[i + k].y;
    }
  }
  for (; i < points.size(); ++i) x[0] += points[i].x + points[i].y;
  return std::isfinite(std::accumulate(x.begin(), x.end(), 0.0) +
                       std::accumulate(y.begin(), y.end(), 0.0));
}

bool IsFinite(glm::dvec2 p) noexcept { return std::isfinite(p.x) && std::isfinite(p.y); }

/// The number of the first point that is not finite, over all blocks.
struct FirstBad {
  std::optional<std::size_t> number;
  void Look(std::span<const glm::dvec2> points, std::size_t first) noexcept {
    if (number || AllSurelyFinite(points)) return;
    const auto bad = std::find_if_not(points.begin(), points.end(), IsFinite);
    if (bad == points.end()) return;
    number = first + static_cast<std::size_t>(bad - points.begin());
  }
  void Tell() const {
    if (number) throw UsageError("point " + std::to_string(*number) + " is not finite");
  }
};

/// Where samples go: straight into the caller's array where all three numbers stand there side by
/// side, else number by number.
class SampleOutputs {
 public:
  explicit SampleOutputs(const moontrace_samples& given)
      : displacement_(OutputOf(given.displacement, given.displacement_step, given.count,
                               "samples.displacement")),
        gradient_x_(
            OutputOf(given.gradient_x, given.gradient_x_step, given.count, "samples.gradient_x")),
        gradient_y_(
            OutputOf(given.gradient_y, given.gradient_y_step, given.count, "samples.gradient_y")) {
    side_by_side_ = displacement_ && gradient_x_ && gradient_y_ &&
                    IsArrayOf<Sample>(displacement_->At(0), displacement_->step()) &&
                    IsBeside(*gradient_x_, 1) && IsBeside(*gradient_y_, 2);
  }

  /// Room for a block of samples from the number `first` on.
  std::span<Sample> From(std::size_t first, std::size_t count) noexcept {
    if (side_by_side_) return {reinterpret_cast<Sample*>(displacement_->At(first)), count};
    return {own_.data(), count};
  }
  void Put(std::span<const Sample> samples, std::size_t first) const noexcept {
    if (side_by_side_) return;
    const std::size_t count = samples.size();
    if (displacement_) {
      displacement_->SetMany(first, count, [&](std::size_t i) { return samples[i].displacement; });
    }
    if (gradient_x_) {
      gradient_x_->SetMany(first, count, [&](std::size_t i) { return samples[i].gradient.x; });
    }
    if (gradient_y_) {
      gradient_y_->SetMany(first, count, [&](std::size_t i) { return samples[i].gradient.y; });
    }
  }

  bool side_by_side() const noexcept { return side_by_side_; }

 private:
  bool IsBeside(const Output& other, std::size_t numbers) const noexcept {
    return other.step() == displacement_->step() &&
           other.At(0) == displacement_->At(0) + numbers * sizeof(double);
  }

  std::optional<Output> displacement_, gradient_x_, gradient_y_;
  bool side_by_side_ = false;
  std::array<Sample, kBlock> own_;
};

void SampleMany(const TextureField& field, const moontrace_samples& given) {
  Places places(InputOf(given.x, given.x_step, given.count, "samples.x"),
                InputOf(given.y, given.y_step, given.count, "samples.y"));
  SampleOutputs outputs(given);
  FirstBad bad;
  const std::size_t most = places.side_by_side() && outputs.side_by_side() ? kStretch : kBlock;
  for (std::size_t first = 0; first < given.count; first += most) {
    const std::size_t count = std::min(most, given.count - first);
    const std::span<const glm::dvec2> points = places.From(first, count);
    const std::span<Sample> samples = outputs.From(first, count);
    field.SamplesAt(points, samples);
    bad.Look(points, first);  // now they are near
    outputs.Put(samples, first);
  }
  bad.Tell();
}

Surface SurfaceOf(const moontrace_surface* given) {
  Surface surface;
  if (given == nullptr) return surface;
  const moontrace_surface known = Given(given, sizeof(moontrace_surface), "surface");
  RequireNumber(known.stiffness, "surface.stiffness", 0);
  RequireNumber(known.force_cap, "surface.force_cap", 0);
  surface.law = RequireFlag(known.law, "surface.law") ? ForceLaw::kPaper : ForceLaw::kPotential;
  if (known.stiffness > 0) surface.stiffness = known.stiffness;
  if (known.force_cap > 0) surface.force_cap = known.force_cap;
  return surface;
}

void ForceMany(const SurfaceLaw& law, const TextureField& field, const moontrace_forces& given) {
  Places places(InputOf(given.x, given.x_step, given.count, "forces.x"),
                InputOf(given.y, given.y_step, given.count, "forces.y"));
  const Input z = InputOf(given.z, given.z_step, given.count, "forces.z");
  const std::optional<Output> x_force =
      OutputOf(given.force_x, given.force_x_step, given.count, "forces.force_x");
  const std::optional<Output> y_force =
      OutputOf(given.force_y, given.force_y_step, given.count, "forces.force_y");
  const std::optional<Output> z_force =
      OutputOf(given.force_z, given.force_z_step, given.count, "forces.force_z");
  std::array<Sample, kBlock> samples;
  FirstBad bad;
  for (std::size_t first = 0; first < given.count; first += kBlock) {
    const std::size_t count = std::min(kBlock, given.count - first);
    const std::span<const glm::dvec2> points = places.From(first, count);
    field.SamplesAt(points, samples);
    bad.Look(points, first);
    for (std::size_t i = 0; i < count; ++i) {
      const double height = z.Get(first + i);
      if (!std::isfinite(height) && bad.number.value_or(first + i) >= first + i)
        bad.number = first + i;
      const glm::dvec3 force_P = Touch(law, samples[i], {points[i], height}).force_P;
      if (x_force) x_force->Set(first + i, force_P.x);
      if (y_force) y_force->Set(first + i, force_P.y);
      if (z_force) z_force->Set(first + i, force_P.z);
    }
  }
  bad.Tell();
}

}  // namespace

int moontrace_sample(const moontrace_page* page, double x, double y, double sample[3]) {
  return Answer([&] {
    RequireNotNull(sample, "sample");
    std::fill_n(sample, 3, 0.0);
    const InUse<PageTable> value(page, kPage);
    RequireNumber(x, "x");
    RequireNumber(y, "y");
    const Sample found = value->field.SampleAt({x, y});
    sample[0] = found.displacement;
    sample[1] = found.gradient.x;
    sample[2] = found.gradient.y;
  });
}

int moontrace_sample_many(const moontrace_page* page, const moontrace_samples* samples) {
  return Answer([&] {
    const InUse<PageTable> value(page, kPage);
    const moontrace_samples given = Given(samples, sizeof(moontrace_samples), "samples");
    SampleMany(value->field, given);
  });
}

int moontrace_force(const moontrace_page* page, const moontrace_surface* surface, double x,
                    double y, double z, double force[3]) {
  return Answer([&] {
    RequireNotNull(force, "force");
    std::fill_n(force, 3, 0.0);
    const InUse<PageTable> value(page, kPage);
    RequireNumber(x, "x");
    RequireNumber(y, "y");
    RequireNumber(z, "z");
    const glm::dvec3 force_P = Touch(SurfaceOf(surface), value->field, {x, y, z}).force_P;
    force[0] = force_P.x;
    force[1] = force_P.y;
    force[2] = force_P.z;
  });
}

int moontrace_force_many(const moontrace_page* page, const moontrace_surface* surface,
                         const moontrace_forces* forces) {
  return Answer([&] {
    const InUse<PageTable> value(page, kPage);
    const moontrace_forces given = Given(forces, sizeof(moontrace_forces), "forces");
    ForceMany(LawOf(SurfaceOf(surface), value->field), value->field, given);
  });
}
