#include "textures/objects/label_chart.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>

namespace moontrace {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kOnAxis = 1e-6;               ///< no gradient is taken nearer to an axis [m]
constexpr double kGreatestLatitude = kPi / 3;  ///< of text on a sphere or ellipsoid [rad]
constexpr double kGreatestShareAround = 15.0 / 16;

/// Columns: u, v and the normal of a flat face, in O.
glm::dmat3 AxesOf(Face face) noexcept {
  const glm::dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  switch (face) {
    case Face::kTop:
    case Face::kRound:
      break;
    case Face::kBottom:
      return {x, -y, -z};
    case Face::kFront:
      return {x, z, -y};
    case Face::kBack:
      return {-x, z, y};
    case Face::kRight:
      return {y, z, x};
    case Face::kLeft:
      return {-y, z, -x};
  }
  return {x, y, z};
}

/// From the middle of the solid to a flat face [m].
double HeightOf(const Solid& solid, Face face) noexcept {
  if (solid.kind == SolidKind::kPlane) return 0;
  if (solid.kind == SolidKind::kCylinder) return solid.half.y;
  switch (face) {
    case Face::kFront:
    case Face::kBack:
      return solid.half.y;
    case Face::kLeft:
    case Face::kRight:
      return solid.half.x;
    case Face::kTop:
    case Face::kBottom:
    case Face::kRound:
      break;
  }
  return solid.half.z;
}

glm::dvec2 Turned(glm::dvec2 p, double c, double s) noexcept {
  return {c * p.x - s * p.y, s * p.x + c * p.y};
}

/// Within half of `around` from zero.
double Wrapped(double u, double around) noexcept { return u - around * std::round(u / around); }

double AroundOf(const Solid& solid, const EllipseArc& equator) noexcept {
  return solid.kind == SolidKind::kEllipsoid ? equator.around() : 2 * kPi * solid.half.x;
}

EllipseArc EquatorOf(const Solid& solid) { return {solid.half.y, solid.half.x}; }
EllipseArc MeridianOf(const Solid& solid) {
  const double mean = std::sqrt(0.5 * (solid.half.x * solid.half.x + solid.half.y * solid.half.y));
  return {mean, solid.half.z};
}

/// Out from the middle at a longitude, counted from the front to the right, and a latitude.
glm::dvec3 Direction(double longitude, double latitude) noexcept {
  const double across = std::cos(latitude);
  return {across * std::sin(longitude), -across * std::cos(longitude), std::sin(latitude)};
}

/// Of a sphere whose page has its middle at the front of a chart of its own.
glm::dmat3 OwnPoles(double radius, glm::dvec2 middle, double turn) noexcept {
  const double longitude = middle.x / radius, latitude = middle.y / radius;
  const glm::dvec3 out = Direction(longitude, latitude);
  const glm::dvec3 north = Direction(longitude, latitude + kPi / 2);
  const glm::dvec3 east(std::cos(longitude), std::sin(longitude), 0);
  const double c = std::cos(turn), s = std::sin(turn);
  return {c * east + s * north, -out, c * north - s * east};
}

}  // namespace

EllipseArc::EllipseArc(double first, double second) {
  // The trapezoid rule is exact for a periodic function but for harmonics beyond the samples.
  constexpr int kSamples = 8 * kTerms;
  for (int k = 0; k < kSamples; ++k) {
    const double angle = 2 * kPi * k / kSamples;
    const double rate = std::hypot(first * std::sin(angle), second * std::cos(angle));
    mean_ += rate / kSamples;
    for (int n = 1; n <= kTerms; ++n) {
      harmonics_[static_cast<std::size_t>(n - 1)] +=
          rate * std::cos(2 * n * angle) / (kSamples * n);
    }
  }
}

double EllipseArc::LengthTo(double angle) const noexcept {
  double length = mean_ * angle;
  // sin 2nt by the recursion of Chebyshev
  const double twice = 2 * std::cos(2 * angle);
  double before = 0, now = std::sin(2 * angle);
  for (const double harmonic : harmonics_) {
    length += harmonic * now;
    const double next = twice * now - before;
    before = now;
    now = next;
  }
  return length;
}

double EllipseArc::RateAt(double angle) const noexcept {
  double rate = mean_;
  const double twice = 2 * std::cos(2 * angle);
  double before = 1, now = std::cos(2 * angle);
  int n = 1;
  for (const double harmonic : harmonics_) {
    rate += 2 * n * harmonic * now;
    const double next = twice * now - before;
    before = now;
    now = next;
    ++n;
  }
  return rate;
}

double EllipseArc::AngleAt(double length) const noexcept {
  // The length grows with the angle and both agree at every quarter: bisect where Newton leaves it.
  const double quarter = std::floor(2 * length / (kPi * mean_));
  double low = quarter * kPi / 2, high = low + kPi / 2, angle = length / mean_;
  for (int i = 0; i < 60; ++i) {
    const double error = LengthTo(angle) - length;
    if (error > 0) {
      high = angle;
    } else {
      low = angle;
    }
    const double next = angle - error / RateAt(angle);
    if (std::abs(next - angle) < 1e-15) break;
    angle = next > low && next < high ? next : 0.5 * (low + high);
  }
  return angle;
}

double EllipseArc::around() const noexcept { return 2 * kPi * mean_; }

LabelChart::LabelChart(const Solid& solid, const LabelPlace& place)
    : solid_(solid), place_(place), c_(std::cos(place.turn)), s_(std::sin(place.turn)) {
  if (place.face != Face::kRound) {
    own_ = AxesOf(place.face);
  } else if (solid.kind == SolidKind::kSphere) {
    own_ = OwnPoles(solid.half.x, place.on_face, place.turn);
    place_.on_face = {0, 0};
    c_ = 1;
    s_ = 0;
  } else if (solid.kind == SolidKind::kEllipsoid) {
    equator_ = EquatorOf(solid);
    meridian_ = MeridianOf(solid);
  }
}

LabelChart::Point LabelChart::OnRound(glm::dvec3 p_O) const noexcept {
  const bool ball = solid_.kind == SolidKind::kSphere;
  const double radius = solid_.half.x;
  const glm::dvec3 p = ball ? p_O * own_ : p_O;
  const double across2 = std::max(p.x * p.x + p.y * p.y, kOnAxis * kOnAxis);
  const double across = std::sqrt(across2);
  Point point;
  point.p_P.x = radius * std::atan2(p.x, -p.y);
  point.dx_O = radius / across2 * glm::dvec3(-p.y, p.x, 0);
  const double straight = ball ? 0 : solid_.half.y;
  const double beyond = p.z - std::clamp(p.z, -straight, straight);
  if (solid_.kind == SolidKind::kCylinder || (beyond == 0 && !ball)) {
    point.p_P.y = p.z;
    point.dy_O = {0, 0, 1};
  } else {
    point.p_P.y = p.z - beyond + radius * std::atan2(beyond, across);
    point.dy_O = radius / (across2 + beyond * beyond) *
                 glm::dvec3(-beyond / across * glm::dvec2(p.x, p.y), across);
  }
  if (ball) {
    point.dx_O = own_ * point.dx_O;
    point.dy_O = own_ * point.dy_O;
  }
  return point;
}

LabelChart::Point LabelChart::OnEllipsoid(glm::dvec3 p_O) const noexcept {
  const glm::dvec3& a = solid_.half;
  if (p_O == glm::dvec3(0)) return {};
  const glm::dvec3 below = a * a + EllipsoidParameter(a, p_O);
  const glm::dvec3 weight = a * a / below;  // nearest point over point
  const glm::dvec3 bend = weight * p_O / below;
  const double steep2 = std::max(glm::dot(bend, p_O / below), 1e-300);
  // how a function of the nearest point changes with the point
  const auto carried = [&](const glm::dvec3& gradient) {
    return weight * gradient - bend * (glm::dot(bend, gradient) / steep2);
  };
  const glm::dvec3 unit = weight * p_O / a;  // the nearest point, on the unit sphere
  const double least = kOnAxis / a.x;
  const double across2 = std::max(unit.x * unit.x + unit.y * unit.y, least * least);
  const double across = std::sqrt(across2);
  const double longitude = std::atan2(unit.x, -unit.y);
  const double latitude = std::atan2(unit.z, across);
  const glm::dvec3 longitude_x = glm::dvec3(-unit.y / a.x, unit.x / a.y, 0) / across2;
  const glm::dvec3 latitude_x = glm::dvec3(-unit.z * unit.x / (across * a.x),
                                           -unit.z * unit.y / (across * a.y), across / a.z) /
                                (across2 + unit.z * unit.z);
  return {{equator_.LengthTo(longitude), meridian_.LengthTo(latitude)},
          equator_.RateAt(longitude) * carried(longitude_x),
          meridian_.RateAt(latitude) * carried(latitude_x)};
}

LabelChart::Point LabelChart::OnFace(glm::dvec3 p_O) const noexcept {
  if (place_.face != Face::kRound) {
    return {{glm::dot(p_O, own_[0]), glm::dot(p_O, own_[1])}, own_[0], own_[1]};
  }
  Point point = solid_.kind == SolidKind::kEllipsoid ? OnEllipsoid(p_O) : OnRound(p_O);
  point.p_P.x =
      place_.on_face.x + Wrapped(point.p_P.x - place_.on_face.x, AroundOf(solid_, equator_));
  return point;
}

LabelChart::Point LabelChart::At(glm::dvec3 p_O) const noexcept {
  const Point on_face = OnFace(p_O);
  return {place_.on_page + Turned(on_face.p_P - place_.on_face, c_, -s_),
          c_ * on_face.dx_O + s_ * on_face.dy_O, c_ * on_face.dy_O - s_ * on_face.dx_O};
}

glm::dvec3 LabelChart::FromFace(glm::dvec2 p_F, double height) const noexcept {
  if (place_.face != Face::kRound) {
    return p_F.x * own_[0] + p_F.y * own_[1] + (HeightOf(solid_, place_.face) + height) * own_[2];
  }
  const double radius = solid_.half.x;
  switch (solid_.kind) {
    case SolidKind::kSphere:
      return own_ * ((radius + height) * Direction(p_F.x / radius, p_F.y / radius));
    case SolidKind::kCapsule: {
      const double on_axis = std::clamp(p_F.y, -solid_.half.y, solid_.half.y);
      return glm::dvec3(0, 0, on_axis) +
             (radius + height) * Direction(p_F.x / radius, (p_F.y - on_axis) / radius);
    }
    case SolidKind::kEllipsoid: {
      const glm::dvec3 unit = Direction(equator_.AngleAt(p_F.x), meridian_.AngleAt(p_F.y));
      return solid_.half * unit + height * glm::normalize(unit / solid_.half);
    }
    case SolidKind::kPlane:
    case SolidKind::kBox:
    case SolidKind::kCylinder:
      break;
  }
  return (radius + height) * Direction(p_F.x / radius, 0) + glm::dvec3(0, 0, p_F.y);
}

glm::dvec3 LabelChart::ToObject(glm::dvec3 p_P) const noexcept {
  const glm::dvec2 from_middle = glm::dvec2(p_P) - place_.on_page;
  return FromFace(place_.on_face + Turned(from_middle, c_, s_), p_P.z);
}

Nearest LabelChart::Above(glm::dvec3 p_O) const noexcept {
  if (place_.face != Face::kRound) {
    return {place_.face, glm::dot(p_O, own_[2]) - HeightOf(solid_, place_.face), own_[2]};
  }
  if (solid_.kind != SolidKind::kCylinder) return NearestOf(solid_, p_O);
  return NearestOf({SolidKind::kSphere, solid_.half}, {p_O.x, p_O.y, 0});  // its side alone
}

Box RoomOn(const Solid& solid, Face face) noexcept {
  constexpr double kNoEdge = std::numeric_limits<double>::infinity();
  glm::dvec2 half(kNoEdge, kNoEdge);
  if (face != Face::kRound) {
    const glm::dmat3 axes = AxesOf(face);
    for (int i = 0; i < 2; ++i) {
      const double length = std::abs(glm::dot(axes[i], solid.half));
      if (length > 0) half[i] = length;
    }
    if (solid.kind == SolidKind::kPlane) {
      for (int i = 0; i < 2; ++i) half[i] = solid.half[i] > 0 ? solid.half[i] : kNoEdge;
    }
    if (solid.kind == SolidKind::kCylinder) half = glm::dvec2(solid.half.x / std::sqrt(2.0));
    return {-half, half};
  }
  const bool ellipsoid = solid.kind == SolidKind::kEllipsoid;
  half.x =
      0.5 * kGreatestShareAround * AroundOf(solid, ellipsoid ? EquatorOf(solid) : EllipseArc());
  half.y = solid.half.y;
  if (solid.kind == SolidKind::kSphere) half.y = kGreatestLatitude * solid.half.x;
  if (ellipsoid) half.y = MeridianOf(solid).LengthTo(kGreatestLatitude);
  return {-half, half};
}

bool Fits(const Solid& solid, const LabelPlace& place, const Box& box_P) noexcept {
  constexpr double kHair = 1e-9;  // [m]
  const bool round = place.face == Face::kRound;
  const bool ball = round && solid.kind == SolidKind::kSphere;
  const double c = ball ? 1 : std::cos(place.turn), s = ball ? 0 : std::sin(place.turn);
  const glm::dvec2 middle = ball ? glm::dvec2(0, 0) : place.on_face;
  Box covered;
  for (const double x : {box_P.min.x, box_P.max.x}) {
    for (const double y : {box_P.min.y, box_P.max.y}) {
      Include(covered, middle + Turned(glm::dvec2(x, y) - place.on_page, c, s));
    }
  }
  const Box room = RoomOn(solid, place.face);
  if (!(covered.min.y >= room.min.y - kHair && covered.max.y <= room.max.y + kHair)) return false;
  if (round) return covered.max.x - covered.min.x <= room.max.x - room.min.x + kHair;
  return covered.min.x >= room.min.x - kHair && covered.max.x <= room.max.x + kHair;
}

ScaleRange ScalesOf(const LabelChart& chart, const Box& box_P) noexcept {
  constexpr int kPoints = 8;
  ScaleRange range{std::numeric_limits<double>::infinity(), 0};
  for (int i = 0; i <= kPoints; ++i) {
    for (int j = 0; j <= kPoints; ++j) {
      const glm::dvec2 share = glm::dvec2(i, j) / static_cast<double>(kPoints);
      const glm::dvec2 p_P = box_P.min + share * (box_P.max - box_P.min);
      const LabelChart::Point point = chart.At(chart.ToObject({p_P, 0}));
      const double xx = glm::dot(point.dx_O, point.dx_O), yy = glm::dot(point.dy_O, point.dy_O);
      const double xy = glm::dot(point.dx_O, point.dy_O);
      const double mean = 0.5 * (xx + yy), apart = std::hypot(0.5 * (xx - yy), xy);
      range.least = std::min(range.least, std::sqrt(mean - apart));
      range.greatest = std::max(range.greatest, std::sqrt(mean + apart));
    }
  }
  return range;
}

double LengthError(const LabelChart& chart, const Box& box_P) noexcept {
  const ScaleRange range = ScalesOf(chart, box_P);
  return std::max(1 / range.least - 1, 1 - 1 / range.greatest);
}

}  // namespace moontrace
