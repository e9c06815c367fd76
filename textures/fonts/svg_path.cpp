#include "textures/fonts/svg_path.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <system_error>

#include "textures/base/text_file.h"
#include "textures/base/units.h"
#include "textures/fonts/arc_fit.h"

namespace moontrace {
namespace {

/// Shares of the tolerance: for fitting a curve, for joining its arcs, for joining exact pieces.
constexpr double kFitShare = 0.5, kJoinShare = 0.4, kExactShare = 1e-3;
/// Radii that differ less, relatively, make a circle.
constexpr double kRoundness = 1e-9;

bool IsSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// An elliptical arc as SVG writes it: from end to end with radii, turn and two choices.
struct SvgArc {
  glm::dvec2 from{0, 0};
  glm::dvec2 to{0, 0};
  glm::dvec2 radii{0, 0};  ///< magnitudes, > 0
  double turn = 0;         ///< of the ellipse's x axis [rad]
  bool large = false;      ///< the arc of more than half a turn
  bool positive = false;   ///< towards growing angles
};

/// The same arc by its centre (SVG 1.1, appendix F.6.5; radii that are too small grow, F.6.6).
struct EllipseArc {
  glm::dvec2 center{0, 0};
  glm::dvec2 radii{0, 0};
  double turn = 0;   ///< [rad]
  double start = 0;  ///< parameter angle [rad]
  double sweep = 0;  ///< [rad], never zero
};

glm::dvec2 Turned(glm::dvec2 v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

/// `from` and `to` must differ.
EllipseArc ByCenter(const SvgArc& arc) {
  // In the frame of the ellipse, scaled to a unit circle, the chord's midpoint is the origin.
  glm::dvec2 radii = arc.radii;
  glm::dvec2 half = Turned(0.5 * (arc.from - arc.to), -arc.turn) / radii;
  const double half_length = glm::length(half);
  if (half_length > 1) {
    radii *= half_length;
    half /= half_length;
  }
  const double rise = std::sqrt(std::max(0.0, 1 / glm::dot(half, half) - 1));
  const double side = arc.large == arc.positive ? -1 : 1;
  const glm::dvec2 center = side * rise * glm::dvec2(half.y, -half.x);
  const glm::dvec2 first = half - center, last = -half - center;

  EllipseArc out;
  out.radii = radii;
  out.turn = arc.turn;
  out.center = 0.5 * (arc.from + arc.to) + Turned(center * radii, arc.turn);
  out.start = std::atan2(first.y, first.x);
  out.sweep = std::atan2(last.y, last.x) - out.start;
  if (arc.positive && out.sweep <= 0) out.sweep += kTurn;
  if (!arc.positive && out.sweep >= 0) out.sweep -= kTurn;
  return out;
}

/// The arc over t in [0, 1].
Curve CurveOf(const EllipseArc& arc) {
  return {[arc](double t) {
            const double angle = arc.start + t * arc.sweep;
            const glm::dvec2 unit = DirectionOf(angle);
            return arc.center + Turned(arc.radii * unit, arc.turn);
          },
          [arc](double t) {
            const double angle = arc.start + t * arc.sweep;
            const glm::dvec2 unit(-std::sin(angle), std::cos(angle));
            return Turned(arc.sweep * arc.radii * unit, arc.turn);
          }};
}

class PathReader {
 public:
  PathReader(std::string_view text, PathLimits& limits) : text_(text), limits_(limits) {}

  std::vector<Subpath> Read() {
    SkipSpace();
    char command = '\0';
    while (offset_ < text_.size()) {
      command = NextCommand(command);
      if (limits_.commands == 0) Fail(offset_, "too many path commands; simplify the drawing");
      --limits_.commands;
      Obey(command);
      SkipSpaceAndComma();
    }
    EndSubpath(false);
    return std::move(subpaths_);
  }

 private:
  [[noreturn]] static void Fail(std::size_t offset, const std::string& problem) {
    throw SvgPathError(offset, problem);
  }

  void SkipSpace() {
    while (offset_ < text_.size() && IsSpace(text_[offset_])) ++offset_;
  }
  void SkipSpaceAndComma() {
    SkipSpace();
    if (offset_ < text_.size() && text_[offset_] == ',') ++offset_;
    SkipSpace();
  }

  /// The letter at hand, or the command before once more: numbers may follow without a letter.
  char NextCommand(char before) {
    const char c = text_[offset_];
    if (IsLetter(c) && std::string_view("MmLlHhVvCcSsQqTtAaZz").find(c) != std::string_view::npos) {
      if (before == '\0' && c != 'M' && c != 'm') {
        Fail(offset_, std::string("the path starts with '") + c + "'; start with M");
      }
      ++offset_;
      return c;
    }
    const bool number = IsDigit(c) || c == '+' || c == '-' || c == '.';
    if (!number || before == '\0') {
      Fail(offset_, "unknown path command '" + OneLine(text_.substr(offset_, 8)) +
                        "'; use M L H V C S Q T A Z");
    }
    if (before == 'Z' || before == 'z') {
      Fail(offset_, "a number after Z; write a command before it");
    }
    if (before == 'M') return 'L';
    if (before == 'm') return 'l';
    return before;
  }

  double Number() {
    SkipSpaceAndComma();
    const std::size_t start = offset_;
    const std::optional<double> number = ReadSvgNumber(text_, offset_);
    if (!number) {
      std::size_t end = start;
      while (end < text_.size() && !IsSpace(text_[end]) && text_[end] != ',') ++end;
      Fail(start, start == text_.size()
                      ? std::string("the path ends where a number is due; complete it")
                      : "'" + OneLine(text_.substr(start, end - start), 24) +
                            "' is no finite number; write one");
    }
    if (std::abs(*number) > limits_.greatest) {
      Fail(start, "number beyond 100 em; move the drawing to the letter box");
    }
    return *number;
  }

  bool Flag() {
    SkipSpaceAndComma();
    if (offset_ == text_.size() || (text_[offset_] != '0' && text_[offset_] != '1')) {
      Fail(offset_, "an arc flag is neither 0 nor 1; write one of these");
    }
    return text_[offset_++] == '1';
  }

  glm::dvec2 Point(bool relative) {
    const double x = Number();
    const std::size_t start = offset_;
    const double y = Number();
    const glm::dvec2 p = glm::dvec2(x, y) + (relative ? at_ : glm::dvec2(0.0, 0.0));
    CheckReach(p, start);
    return p;
  }

  void CheckReach(glm::dvec2 p, std::size_t offset) const {
    if (std::max(std::abs(p.x), std::abs(p.y)) > limits_.greatest) {
      Fail(offset, "point beyond 100 em; move the drawing to the letter box");
    }
  }

  void Obey(char command) {
    const bool relative = command >= 'a';
    char previous = control_of_;
    control_of_ = '\0';
    switch (command) {
      case 'M':
      case 'm': {
        EndSubpath(false);
        at_ = Point(relative);
        start_ = at_;
        break;
      }
      case 'Z':
      case 'z':
        AddLine(start_);
        EndSubpath(true);
        break;
      case 'L':
      case 'l':
        AddLine(Point(relative));
        break;
      case 'H':
      case 'h':
        AddLine(Along(0, relative));
        break;
      case 'V':
      case 'v':
        AddLine(Along(1, relative));
        break;
      case 'A':
      case 'a':
        AddArc(relative);
        break;
      default:
        AddCurve(command, relative, previous);
    }
  }

  glm::dvec2 Along(int axis, bool relative) {
    const double value = Number();
    glm::dvec2 p = at_;
    p[axis] = relative ? p[axis] + value : value;
    CheckReach(p, offset_);
    return p;
  }

  void AddCurve(char command, bool relative, char previous) {
    const glm::dvec2 mirrored = 2.0 * at_ - control_;
    glm::dvec2 p1 = at_, p2 = at_;
    const char kind = relative ? static_cast<char>(command - 'a' + 'A') : command;
    if (kind == 'C' || kind == 'Q') p1 = Point(relative);
    if (kind == 'S' && previous == 'C') p1 = mirrored;
    if (kind == 'T' && previous == 'Q') p1 = mirrored;
    const bool cubic = kind == 'C' || kind == 'S';
    if (cubic) p2 = Point(relative);
    const glm::dvec2 to = Point(relative);
    control_ = cubic ? p2 : p1;
    control_of_ = cubic ? 'C' : 'Q';
    CheckReach(control_, offset_);
    if (cubic) {
      AddFitted(CubicCurve(at_, p1, p2, to), to);
    } else {  // a quadratic curve is the cubic with its control points two thirds out
      AddFitted(CubicCurve(at_, at_ + (p1 - at_) * (2.0 / 3), to + (p1 - to) * (2.0 / 3), to), to);
    }
  }

  void AddArc(bool relative) {
    SkipSpaceAndComma();
    const std::size_t start = offset_;
    SvgArc arc;
    arc.from = at_;
    arc.radii.x = std::abs(Number());
    arc.radii.y = std::abs(Number());
    arc.turn = Number() * kTurn / 360;
    arc.large = Flag();
    arc.positive = Flag();
    arc.to = Point(relative);
    if (arc.to == arc.from) return;  // SVG 1.1, F.6.2: nothing is drawn
    if (arc.radii.x == 0 || arc.radii.y == 0) {
      AddLine(arc.to);
      return;
    }
    const bool round = std::abs(arc.radii.x - arc.radii.y) <= kRoundness * arc.radii.x;
    if (round) arc.turn = 0;
    const EllipseArc ellipse = ByCenter(arc);
    if (std::max(ellipse.radii.x, ellipse.radii.y) > limits_.greatest) {
      Fail(start, "arc grows beyond 100 em to reach its end; write radii that reach it");
    }
    if (!round) {
      AddFitted(CurveOf(ellipse), arc.to);
      return;
    }
    EndCurves();
    AddPiece(Arc{ellipse.center, ellipse.radii.x, ellipse.start, ellipse.sweep});
    at_ = arc.to;
  }

  void AddLine(glm::dvec2 to) {
    EndCurves();
    // What closes a curve's rounding error is no line.
    if (glm::length(to - at_) > 1e-9 * limits_.tolerance) AddPiece(Line{at_, to});
    at_ = to;
  }

  void AddFitted(const Curve& curve, glm::dvec2 to) {
    for (const Piece& piece : FitArcs(curve, kFitShare * limits_.tolerance)) {
      Count();
      curves_.push_back(piece);
    }
    at_ = to;
  }

  /// Curves that follow each other (a circle drawn as four) are joined with the curves' tolerance.
  void EndCurves() {
    const std::vector<Piece> joined = MergePieces(curves_, kJoinShare * limits_.tolerance);
    pieces_.insert(pieces_.end(), joined.begin(), joined.end());
    curves_.clear();
  }

  void AddPiece(const Piece& piece) {
    Count();
    pieces_.push_back(piece);
  }

  void Count() {
    if (limits_.pieces == 0) Fail(offset_, "curves too long or too wild; simplify the drawing");
    --limits_.pieces;
  }

  void EndSubpath(bool closed) {
    EndCurves();
    if (!pieces_.empty()) {
      subpaths_.push_back({MergePieces(pieces_, kExactShare * limits_.tolerance), closed});
    }
    pieces_.clear();
  }

  std::string_view text_;
  PathLimits& limits_;
  std::size_t offset_ = 0;
  std::vector<Subpath> subpaths_;
  std::vector<Piece> pieces_;  ///< of the subpath at hand
  std::vector<Piece> curves_;  ///< fitted, not yet joined
  glm::dvec2 at_{0, 0};
  glm::dvec2 start_{0, 0};  ///< of the subpath at hand
  glm::dvec2 control_{0, 0};
  char control_of_ = '\0';  ///< 'C' or 'Q' while `control_` serves a following S or T
};

}  // namespace

std::optional<double> ReadSvgNumber(std::string_view text, std::size_t& offset) {
  std::size_t i = offset;
  const auto digits = [&] {
    const std::size_t first = i;
    while (i < text.size() && IsDigit(text[i])) ++i;
    return i - first;
  };
  if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
  const std::size_t unsigned_start = i;
  std::size_t count = digits();
  if (i < text.size() && text[i] == '.') {
    ++i;
    count += digits();
  }
  if (count == 0) return std::nullopt;
  const std::size_t mantissa_end = i;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    ++i;
    if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
    if (digits() == 0) i = mantissa_end;
  }
  double value = 0;
  const auto result = std::from_chars(text.data() + unsigned_start, text.data() + i, value);
  if (result.ec != std::errc() || !std::isfinite(value)) return std::nullopt;
  const bool negative = text[offset] == '-';
  offset = i;
  return negative ? -value : value;
}

std::vector<Subpath> ParseSvgPath(std::string_view path, PathLimits& limits) {
  return PathReader(path, limits).Read();
}

Subpath CircleSubpath(glm::dvec2 center, double radius) {
  return {{Arc{center, radius, 0, kTurn}}, true};
}

}  // namespace moontrace
