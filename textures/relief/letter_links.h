#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "textures/fonts/script.h"
#include "textures/relief/clearance.h"
#include "textures/relief/link.h"
#include "textures/typeset/style.h"

namespace moontrace {

/// A glyph made ready for linking, in its own frame [m].
struct LinkedLetter {
  std::vector<Stroke> parts;    ///< strokes and dots in writing order
  std::vector<LinkWall> walls;  ///< with its inner links
  Box box;                      ///< of the centre lines
  std::vector<std::vector<Piece>> inner;
  /// Directions of inner links where they leave the first part and reach the last; of dots only.
  std::optional<glm::dvec2> leaves_first, reaches_last;
  std::size_t missing = 0;
};

/// Own length of a link at a ring, which it leaves along a tangent [w].
inline constexpr double kRingLinkOwn = 3.5;

/// One end of a link and what it asks of it.
struct LinkEnds {
  LinkEnd end;
  double level = 0;  ///< as deep as the letters from this end [m]
};

/// What stands about a link beside its two letters.
struct LinkSurroundings {
  std::vector<LinkWall> others;  ///< of further letters [m]
  std::vector<Piece> links;      ///< centre lines of links found before [m]
  bool may_cross = false;        ///< those, if steeply
  /// The direction by which the last link reached a letter that is one dot.
  std::optional<glm::dvec2> arrived;
};

/// A link between two letters, from the first one's origin.
struct LetterLink {
  std::vector<Piece> spine;             ///< [m], in the direction of travel, without a corner
  double from_level = 0, to_level = 0;  ///< first and last length that are as deep as letters [m]
};

/// Finds links for the letters of lines of one kind: within a letter, and from one to the next.
class LetterLinks {
 public:
  LetterLinks(const Script& script, const TypeStyle& style, LineKind kind);

  LineKind kind() const { return kind_; }

  /// Made once for each glyph. Throws std::out_of_range for one that the script has not.
  const LinkedLetter& LetterOf(std::size_t glyph);

  /// From a glyph's last stroke to the first of the next, which stands at `offset`; without a spine
  /// if none keeps the gap to both and to what stands about.
  LetterLink Between(std::size_t a, std::size_t b, glm::dvec2 offset,
                     const LinkSurroundings& about);

  /// Whether a glyph that stands at `at` is nearer to a link than the gap.
  bool IsNear(const std::vector<Curve>& link, std::size_t glyph, glm::dvec2 at);
  /// Whether two links, the second moved by `at`, are nearer to each other than the gap.
  bool AreNear(const std::vector<Curve>& a, const std::vector<Curve>& b, glm::dvec2 at) const;

  /// Whether the grooves of two links, the second moved by `at`, run into each other; `share_dot`:
  /// but for the first one's last part and the second's first, which meet at a dot.
  bool RunInto(const std::vector<Piece>& a, const std::vector<Piece>& b, glm::dvec2 at,
               bool share_dot) const;

  /// The way straight on from the end of a glyph at `at`, a turn's room away from it, as far as
  /// links go.
  Piece WayOn(std::size_t glyph, glm::dvec2 at);

  /// What links keep away from, of a glyph at `at`.
  std::vector<LinkWall> WallsAt(std::size_t glyph, glm::dvec2 at);

  /// Length as deep as the letters at the end of a link from an open stroke [m].
  double OpenLevel() const;
  const TypeStyle& style() const { return style_; }  ///< of lines of this kind

 private:
  /// `straight`: the direction in which another link passes this end. A dot is left within 60
  /// degrees of it, since a tip that turned back would find the groove that it came by.
  LinkEnds EndsOf(const Stroke& stroke, bool leaving, std::optional<glm::dvec2> straight) const;

  static Ray RayAt(const Stroke& stroke, double s);

  static glm::dvec2 CenterOf(const Stroke& dot);
  double DotRadius(const Stroke& dot) const;

  std::vector<LinkWall> WallsOf(const Stroke& stroke) const;

  /// Whether a tip gets from one to the other without a link: their grooves run into each other.
  bool Touch(const Stroke& a, const std::vector<LinkWall>& walls) const;

  LinkedLetter MakeLetter(const Glyph& glyph);

  void AddInner(const Stroke& a, const Stroke& b, LinkedLetter& letter) const;

  std::vector<Piece> Find(LinkTask task, const Box& a, const Box& b) const;

  const Script& script_;
  TypeStyle style_;
  LineKind kind_;
  double half_ = 0, gap_ = 0;  // [m]
  double radius_ = 0;          // of the sharpest turn [m]
  double reach_ = 0;           // above the top line and below the base line [m]
  std::map<std::size_t, LinkedLetter> letters_;
};

}  // namespace moontrace
