#include "textures/fonts/hershey.h"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "textures/base/error.h"
#include "textures/base/text_file.h"
#include "textures/base/units.h"
#include "textures/fonts/polyline.h"

namespace moontrace {
namespace {

constexpr double kUnitsInEm = 21;
constexpr double kBaseLine = 9;     ///< units below the middle
constexpr double kDotRadius = 0.5;  ///< [units]
constexpr double kInkGap = 5;       ///< [units]
constexpr std::size_t kMostRecords = 4000;
constexpr char32_t kFirst = U' ', kLast = U'~';

class JhfReader {
 public:
  JhfReader(std::string_view jhf, const std::string& file_name) : text_(jhf), file_(file_name) {}

  void Read(Script& script) {
    for (SkipBreaks(); at_ < text_.size(); SkipBreaks()) {
      if (record_ == kMostRecords) Fail("more than 4000 records; use a font of fewer");
      ReadRecord(script);
      ++record_;
    }
  }

 private:
  [[noreturn]] void Fail(const std::string& problem) const {
    const TextPlace place = PlaceOf(text_, at_);
    throw InputError(file_ + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) +
                     ": " + problem);
  }

  void SkipBreaks() {
    while (at_ < text_.size() && (text_[at_] == '\n' || text_[at_] == '\r')) ++at_;
  }

  char Next() {
    SkipBreaks();
    if (at_ == text_.size()) Fail("the record ends in its middle; get the whole .jhf file");
    const char c = text_[at_];
    if (c < ' ' || c > '~') Fail("a byte that is no printed ASCII; give a Hershey .jhf file");
    ++at_;
    return c;
  }

  /// A whole number in a column of `width`, blanks before it.
  std::size_t Column(int width) {
    std::size_t value = 0;
    bool begun = false;
    for (int i = 0; i < width; ++i) {
      const char c = Next();
      if (c == ' ' && !begun) continue;
      if (c < '0' || c > '9') {
        --at_;
        Fail("'" + OneLine(text_.substr(at_, 1)) +
             "' where a number must stand; give a Hershey .jhf file");
      }
      begun = true;
      value = 10 * value + static_cast<std::size_t>(c - '0');
    }
    return value;
  }

  static double Coordinate(char c) { return c - 'R'; }

  void ReadRecord(Script& script) {
    Column(5);
    const std::size_t pairs = Column(3);
    if (pairs == 0) Fail("a record of no pairs; give a Hershey .jhf file");
    const double left = Coordinate(Next());
    const double right = Coordinate(Next());
    Glyph glyph;
    std::vector<glm::dvec2> points;
    for (std::size_t i = 1; i < pairs; ++i) {
      const char x = Next(), y = Next();
      if (x == ' ' && y == 'R') {
        EndStroke(points, glyph);
      } else {
        points.emplace_back((Coordinate(x) - left) / kUnitsInEm,
                            (kBaseLine - Coordinate(y)) / kUnitsInEm);
      }
    }
    EndStroke(points, glyph);
    glyph.advance = right > left ? (right - left) / kUnitsInEm : InkEdge(glyph);
    Add(std::move(glyph), script);
  }

  /// A step behind what is drawn, for the few records whose edges leave no room for it.
  static double InkEdge(const Glyph& glyph) {
    double edge = 0;
    for (const Stroke& stroke : glyph.strokes) {
      for (const Piece& piece : stroke.pieces) edge = std::max(edge, BoundsOf(piece).max.x);
    }
    return edge + kInkGap / kUnitsInEm;
  }

  static void EndStroke(std::vector<glm::dvec2>& points, Glyph& glyph) {
    Stroke stroke;
    stroke.pieces = RoundedPolyline(points, kPolylineTolerance);
    if (stroke.pieces.empty() && !points.empty()) {
      stroke.kind = StrokeKind::kDot;
      stroke.pieces.emplace_back(Arc{points.front(), kDotRadius / kUnitsInEm, 0, kTurn});
    }
    if (!stroke.pieces.empty()) glyph.strokes.push_back(std::move(stroke));
    points.clear();
  }

  void Add(Glyph glyph, Script& script) const {
    const char32_t c = kFirst + static_cast<char32_t>(record_);
    if (c == kFirst) script.space_advance = glyph.advance;
    if (glyph.strokes.empty()) return;
    if (c <= kLast) {
      glyph.name = std::string(1, static_cast<char>(c));
      script.signs[c] = glyph.name;
    } else {
      glyph.name = fmt::format("#{}", record_);
    }
    script.glyphs.push_back(std::move(glyph));
  }

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
  std::size_t record_ = 0;
};

}  // namespace

Script ParseHershey(std::string_view jhf, const std::string& name, const std::string& file_name) {
  if (jhf.size() > kMaxHersheyBytes) {
    throw InputError(file_name + ": holds more than 1 MB; give a Hershey .jhf file");
  }
  Script script;
  script.name = name;
  script.title = "Hershey " + name;
  script.author = "Dr A. V. Hershey (shapes, 1967); James Hurt (format)";
  script.licence = "Hershey font licence: free, with these names";
  script.stroke_width = 0.1;
  script.space_advance = 16 / kUnitsInEm;
  script.grades = {1};
  JhfReader(jhf, file_name).Read(script);
  if (script.glyphs.empty()) {
    throw InputError(file_name + ": nothing is drawn in it; give a Hershey .jhf file");
  }
  return script;
}

}  // namespace moontrace
