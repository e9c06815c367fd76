// The C interface: the surface at one point and at many.
#include <algorithm>
#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>

#include "sim/library/call.h"
#include "sim/library/given_surface.h"
#include "sim/library/moontrace.h"
#include "sim/library/strided.h"
#include "sim/library/values.h"
#include "textures/field/surface.h"

using namespace moontrace;

namespace {

static_assert(sizeof(glm::dvec2) == 2 * sizeof(double));
static_assert(sizeof(Sample) == 3 * sizeof(double));

constexpr std::size_t kStretch = 4096;  ///< points that are done at a time where none is copied

/// Whether addresses from `first` on, `step` bytes apart, are those of an array of such values.
template <class Value>
bool IsArrayOf(const void* first, std::ptrdiff_t step) noexcept {
  return step == sizeof(Value) && reinterpret_cast<std::uintptr_t>(first) % alignof(Value) == 0;
}

/// Whether points are an array of pairs and samples one of threes.
bool AreSideBySide(const moontrace_samples& given) noexcept {
  return IsArrayOf<glm::dvec2>(given.x, given.x_step) && given.y == given.x + 1 &&
         given.y_step == given.x_step && given.displacement != nullptr &&
         IsArrayOf<Sample>(given.displacement, given.displacement_step) &&
         given.gradient_x == given.displacement + 1 && given.gradient_y == given.displacement + 2 &&
         given.gradient_x_step == given.displacement_step &&
         given.gradient_y_step == given.displacement_step;
}

void SampleSideBySide(const TextureField& field, const moontrace_samples& given) {
  const auto* points = reinterpret_cast<const glm::dvec2*>(given.x);
  auto* samples = reinterpret_cast<Sample*>(given.displacement);
  FirstBad bad;
  for (std::size_t first = 0; first < given.count; first += kStretch) {
    const std::size_t count = std::min(kStretch, given.count - first);
    field.SamplesAt({points + first, count}, {samples + first, count});
    bad.LookAtPairs(first, count, given.x + 2 * first);  // now they are near
  }
  bad.Tell();
}

void SampleMany(const TextureField& field, const moontrace_samples& given) {
  const Input x_given = InputOf(given.x, given.x_step, given.count, "samples.x");
  const Input y_given = InputOf(given.y, given.y_step, given.count, "samples.y");
  OutColumn displacement(
      OutputOf(given.displacement, given.displacement_step, given.count, "samples.displacement"));
  OutColumn gradient_x(
      OutputOf(given.gradient_x, given.gradient_x_step, given.count, "samples.gradient_x"));
  OutColumn gradient_y(
      OutputOf(given.gradient_y, given.gradient_y_step, given.count, "samples.gradient_y"));
  if (given.count > 0 && AreSideBySide(given)) {
    SampleSideBySide(field, given);
    return;
  }
  InColumn x_column(x_given), y_column(y_given);
  const bool in_place = x_column.in_place() && y_column.in_place() && displacement.in_place() &&
                        gradient_x.in_place() && gradient_y.in_place();
  const std::size_t most = in_place ? kStretch : kBlock;
  FirstBad bad;
  for (std::size_t first = 0; first < given.count; first += most) {
    const std::size_t count = std::min(most, given.count - first);
    const double *x = x_column.From(first, count), *y = y_column.From(first, count);
    field.SamplesAt(
        {x, y}, {displacement.From(first), gradient_x.From(first), gradient_y.From(first)}, count);
    bad.Look(first, count, x, y);
    displacement.Put(first, count);
    gradient_x.Put(first, count);
    gradient_y.Put(first, count);
  }
  bad.Tell();
}

/// What is done at once, with the force.
struct SampleBlock {
  std::array<double, kBlock> displacement, gradient_x, gradient_y;
};

void ForceMany(const SurfaceLaw& law, const TextureField& field, const moontrace_forces& given) {
  InColumn x_column(InputOf(given.x, given.x_step, given.count, "forces.x"));
  InColumn y_column(InputOf(given.y, given.y_step, given.count, "forces.y"));
  InColumn z_column(InputOf(given.z, given.z_step, given.count, "forces.z"));
  OutColumn x_force(OutputOf(given.force_x, given.force_x_step, given.count, "forces.force_x"));
  OutColumn y_force(OutputOf(given.force_y, given.force_y_step, given.count, "forces.force_y"));
  OutColumn z_force(OutputOf(given.force_z, given.force_z_step, given.count, "forces.force_z"));
  SampleBlock block;
  FirstBad bad;
  for (std::size_t first = 0; first < given.count; first += kBlock) {
    const std::size_t count = std::min(kBlock, given.count - first);
    const double *x = x_column.From(first, count), *y = y_column.From(first, count);
    const double* z = z_column.From(first, count);
    field.SamplesAt({x, y},
                    {block.displacement.data(), block.gradient_x.data(), block.gradient_y.data()},
                    count);
    bad.Look(first, count, x, y, z);
    double *to_x = x_force.From(first), *to_y = y_force.From(first), *to_z = z_force.From(first);
    for (std::size_t i = 0; i < count; ++i) {
      const Sample sample{block.displacement[i], {block.gradient_x[i], block.gradient_y[i]}};
      const glm::dvec3 force_P = Touch(law, sample, {x[i], y[i], z[i]}).force_P;
      to_x[i] = force_P.x;
      to_y[i] = force_P.y;
      to_z[i] = force_P.z;
    }
    x_force.Put(first, count);
    y_force.Put(first, count);
    z_force.Put(first, count);
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
    const Sample found = value->field->SampleAt({x, y});
    sample[0] = found.displacement;
    sample[1] = found.gradient.x;
    sample[2] = found.gradient.y;
  });
}

int moontrace_sample_many(const moontrace_page* page, const moontrace_samples* samples) {
  return Answer([&] {
    const InUse<PageTable> value(page, kPage);
    const moontrace_samples given = Given(samples, sizeof(moontrace_samples), "samples");
    SampleMany(*value->field, given);
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
    const glm::dvec3 force_P = Touch(SurfaceOf(surface), *value->field, {x, y, z}).force_P;
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
    ForceMany(LawOf(SurfaceOf(surface), *value->field), *value->field, given);
  });
}
