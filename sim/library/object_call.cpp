// The C interface: solids that carry a page.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "sim/library/call.h"
#include "sim/library/given_surface.h"
#include "sim/library/moontrace.h"
#include "sim/library/strided.h"
#include "sim/library/values.h"
#include "textures/base/error.h"

using namespace moontrace;

namespace {

struct Kind {
  const char* name;
  SolidKind kind;
  int sizes;  ///< of Solid::half that count
};
constexpr Kind kKinds[] = {
    {"plane", SolidKind::kPlane, 2},       {"box", SolidKind::kBox, 3},
    {"cylinder", SolidKind::kCylinder, 2}, {"sphere", SolidKind::kSphere, 1},
    {"capsule", SolidKind::kCapsule, 2},   {"ellipsoid", SolidKind::kEllipsoid, 3}};

const Kind& KindOf(const char* name) {
  RequireNotNull(name, "shape.kind");
  for (const Kind& kind : kKinds) {
    if (std::string_view(kind.name) == name) return kind;
  }
  throw InputError("shape.kind is one of plane, box, cylinder, sphere, capsule, ellipsoid");
}

constexpr double kGreatest = 1000;  ///< [m]; a larger value is a mistake

/// Throws UsageError for what is no size or place of an object.
double LengthOf(double value, const char* name, double least = -kGreatest) {
  RequireNumber(value, name, least);
  if (value > kGreatest) {
    throw UsageError(fmt::format("{} is above {} m: {}", name, kGreatest, value));
  }
  return value;
}

Solid SolidOf(const moontrace_shape& given) {
  const Kind& kind = KindOf(given.kind);
  Solid solid{kind.kind, {0, 0, 0}};
  for (int i = 0; i < kind.sizes; ++i) {
    solid.half[i] = LengthOf(given.half[i], "shape.half", 0);
    if (kind.kind != SolidKind::kPlane && given.half[i] == 0) {
      throw UsageError(fmt::format("shape.half: give {} {} above 0 for a shape of kind {}",
                                   kind.sizes, kind.sizes == 1 ? "size" : "sizes", kind.name));
    }
  }
  return solid;
}

Face FaceFor(const moontrace_shape& given, const Solid& solid) {
  if (given.face == nullptr) return UsualFace(solid);
  const std::optional<Face> face = FaceOf(given.face);
  if (!face) throw InputError(std::string("shape.face is one of ") + kFaceNames);
  if (!HasFace(solid, *face)) {
    throw InputError(fmt::format("shape.face: a {} has no face {}", given.kind, given.face));
  }
  return *face;
}

bool IsEmpty(const Box& box) noexcept { return !(box.min.x <= box.max.x); }

std::unique_ptr<ObjectValue> ObjectOf(const PageValue& page, const moontrace_shape& given) {
  LengthOf(given.u, "shape.u");
  LengthOf(given.v, "shape.v");
  RequireNumber(given.turn, "shape.turn");
  const bool corner = RequireFlag(given.corner, "shape.corner");
  auto object = std::make_unique<ObjectValue>();
  object->field = page.field;
  object->text_P = page.text_P;
  object->solid = SolidOf(given);
  LabelPlace place{FaceFor(given, object->solid), {given.u, given.v}, {0, 0}, given.turn};
  if (!corner && !IsEmpty(page.text_P)) place.on_page = 0.5 * (page.text_P.min + page.text_P.max);
  if (!IsEmpty(page.text_P) && !Fits(object->solid, place, page.text_P)) {
    const glm::dvec2 text = 1e3 * (page.text_P.max - page.text_P.min);
    throw InputError(
        fmt::format("what stands on the page, {:.1f} by {:.1f} mm, has no room there on the {}; "
                    "make the letters "
                    "smaller or place it otherwise",
                    text.x, text.y, given.kind));
  }
  object->label = {LabelChart(object->solid, place), object->field.get(), 1};
  if (place.face == Face::kRound && !IsEmpty(page.text_P)) {
    object->label.stretch = std::max(1.0, ScalesOf(object->label.chart, page.text_P).greatest);
  }
  return object;
}

/// What a tip meets, whatever the force.
SolidContact SurfaceAt(const ObjectValue& object, glm::dvec3 p_O) noexcept {
  return TouchSolid(SurfaceLaw(), object.solid, {&object.label, 1}, p_O);
}

SurfaceLaw LawOf(const ObjectValue& object, const moontrace_surface* surface) {
  return LawOn(object.solid, SurfaceOf(surface), {&object.label, 1});
}

glm::dvec3 PointOf(double x, double y, double z) {
  RequireNumber(x, "x");
  RequireNumber(y, "y");
  RequireNumber(z, "z");
  return {x, y, z};
}

void Put(glm::dvec3 value, double* to) noexcept {
  for (int i = 0; i < 3; ++i) to[i] = value[i];
}

/// Hands all points to `work(i, p_O)`, block by block, i within the block; `begin(first)` comes
/// before each, `end(first, count)` after it. Throws UsageError at the end where one was not
/// finite.
template <class Given, class Begin, class Work, class End>
void ForPoints(const Given& given, const std::array<const char*, 3>& names, Begin begin, Work work,
               End end) {
  InColumn x_column(InputOf(given.x, given.x_step, given.count, names[0]));
  InColumn y_column(InputOf(given.y, given.y_step, given.count, names[1]));
  InColumn z_column(InputOf(given.z, given.z_step, given.count, names[2]));
  FirstBad bad;
  for (std::size_t first = 0; first < given.count; first += kBlock) {
    const std::size_t count = std::min(kBlock, given.count - first);
    const double *x = x_column.From(first, count), *y = y_column.From(first, count);
    const double* z = z_column.From(first, count);
    bad.Look(first, count, x, y, z);
    begin(first);
    for (std::size_t i = 0; i < count; ++i) work(i, glm::dvec3(x[i], y[i], z[i]));
    end(first, count);
  }
  bad.Tell();
}

/// Columns that are written, by number.
template <std::size_t kColumns>
class OutColumns {
 public:
  explicit OutColumns(std::array<OutColumn, kColumns> columns) : columns_(std::move(columns)) {}
  void Begin(std::size_t first) noexcept {
    for (std::size_t k = 0; k < kColumns; ++k) to_[k] = columns_[k].From(first);
  }
  void Set(std::size_t column, std::size_t i, double value) noexcept { to_[column][i] = value; }
  void End(std::size_t first, std::size_t count) const noexcept {
    for (const OutColumn& column : columns_) column.Put(first, count);
  }

 private:
  std::array<OutColumn, kColumns> columns_;
  std::array<double*, kColumns> to_{};
};

void SampleMany(const ObjectValue& object, const moontrace_object_samples& given) {
  const auto out = [&given](double* first, std::ptrdiff_t step, const char* name) {
    return OutColumn(OutputOf(first, step, given.count, name));
  };
  OutColumns<5> columns({out(given.displacement, given.displacement_step, "samples.displacement"),
                         out(given.gradient_x, given.gradient_x_step, "samples.gradient_x"),
                         out(given.gradient_y, given.gradient_y_step, "samples.gradient_y"),
                         out(given.gradient_z, given.gradient_z_step, "samples.gradient_z"),
                         out(given.height, given.height_step, "samples.height")});
  ForPoints(
      given, {"samples.x", "samples.y", "samples.z"},
      [&](std::size_t first) { columns.Begin(first); },
      [&](std::size_t i, glm::dvec3 p_O) {
        const SolidContact contact = SurfaceAt(object, p_O);
        columns.Set(0, i, contact.displacement);
        columns.Set(1, i, contact.gradient_O.x);
        columns.Set(2, i, contact.gradient_O.y);
        columns.Set(3, i, contact.gradient_O.z);
        columns.Set(4, i, contact.nearest.height);
      },
      [&](std::size_t first, std::size_t count) { columns.End(first, count); });
}

void ForceMany(const ObjectValue& object, const SurfaceLaw& law, const moontrace_forces& given) {
  const auto out = [&given](double* first, std::ptrdiff_t step, const char* name) {
    return OutColumn(OutputOf(first, step, given.count, name));
  };
  OutColumns<3> columns({out(given.force_x, given.force_x_step, "forces.force_x"),
                         out(given.force_y, given.force_y_step, "forces.force_y"),
                         out(given.force_z, given.force_z_step, "forces.force_z")});
  ForPoints(
      given, {"forces.x", "forces.y", "forces.z"}, [&](std::size_t first) { columns.Begin(first); },
      [&](std::size_t i, glm::dvec3 p_O) {
        const glm::dvec3 force_O = TouchSolid(law, object.solid, {&object.label, 1}, p_O).force_O;
        columns.Set(0, i, force_O.x);
        columns.Set(1, i, force_O.y);
        columns.Set(2, i, force_O.z);
      },
      [&](std::size_t first, std::size_t count) { columns.End(first, count); });
}

}  // namespace

int moontrace_object_open(const moontrace_page* page, const moontrace_shape* shape,
                          moontrace_object** object) {
  return Answer([&] {
    RequireNotNull(object, "object");
    const InUse<PageTable> value(page, kPage);
    OpenHandle<ObjectTable>(ObjectOf(*value, Given(shape, sizeof *shape, "shape")), object);
  });
}

int moontrace_object_describe(const moontrace_object* object, moontrace_object_facts* facts) {
  return Answer([&] {
    const InUse<ObjectTable> value(object, kObject);
    const Box& text_P = value->text_P;
    moontrace_object_facts given{};
    given.face = NameOf(value->label.chart.place().face).data();
    given.least_scale = given.greatest_scale = 1;
    if (!IsEmpty(text_P)) {
      given.text_width = text_P.max.x - text_P.min.x;
      given.text_height = text_P.max.y - text_P.min.y;
      const ScaleRange scales = ScalesOf(value->label.chart, text_P);
      given.least_scale = scales.least;
      given.greatest_scale = scales.greatest;
    }
    given.greatest_depth = GreatestDepth(value->solid);
    Give(given, sizeof given, "facts", facts);
  });
}

int moontrace_object_place(const moontrace_object* object, double x, double y, double z,
                           double place[3]) {
  return Answer([&] {
    RequireNotNull(place, "place");
    std::fill_n(place, 3, 0.0);
    const InUse<ObjectTable> value(object, kObject);
    Put(value->label.chart.ToObject(PointOf(x, y, z)), place);
  });
}

int moontrace_object_sample(const moontrace_object* object, double x, double y, double z,
                            double sample[5]) {
  return Answer([&] {
    RequireNotNull(sample, "sample");
    std::fill_n(sample, 5, 0.0);
    const InUse<ObjectTable> value(object, kObject);
    const SolidContact contact = SurfaceAt(*value, PointOf(x, y, z));
    sample[0] = contact.displacement;
    Put(contact.gradient_O, sample + 1);
    sample[4] = contact.nearest.height;
  });
}

int moontrace_object_sample_many(const moontrace_object* object,
                                 const moontrace_object_samples* samples) {
  return Answer([&] {
    const InUse<ObjectTable> value(object, kObject);
    SampleMany(*value, Given(samples, sizeof *samples, "samples"));
  });
}

int moontrace_object_force(const moontrace_object* object, const moontrace_surface* surface,
                           double x, double y, double z, double force[3]) {
  return Answer([&] {
    RequireNotNull(force, "force");
    std::fill_n(force, 3, 0.0);
    const InUse<ObjectTable> value(object, kObject);
    const glm::dvec3 p_O = PointOf(x, y, z);
    const SurfaceLaw law = LawOf(*value, surface);
    Put(TouchSolid(law, value->solid, {&value->label, 1}, p_O).force_O, force);
  });
}

int moontrace_object_force_many(const moontrace_object* object, const moontrace_surface* surface,
                                const moontrace_forces* forces) {
  return Answer([&] {
    const InUse<ObjectTable> value(object, kObject);
    ForceMany(*value, LawOf(*value, surface), Given(forces, sizeof *forces, "forces"));
  });
}

int moontrace_object_close(moontrace_object* object) {
  return Answer([&] { CloseHandle<ObjectTable>(object, kObject); });
}
