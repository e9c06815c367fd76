#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "textures/field/element.h"
#include "textures/field/sampled.h"

namespace moontrace {

/// The rough textures that a sheet may have (the paper, section 6: superimposed on the text, they
/// give an extra clue as to distances traversed).
enum class PaperKind {
  kSine,    ///< parallel waves
  kGrid,    ///< the mean of two waves at right angles
  kNoise,   ///< aperiodic hills, band-limited
  kSampled  ///< an array of heights
};

/// "sine", "grid", "noise", "sampled"; none for other words.
std::optional<PaperKind> PaperKindOf(std::string_view name);
std::string NameOf(PaperKind kind);

/// A rough texture of the whole plane, C1, with a phase that begins at its patch's lower left
/// corner.
struct PaperTexture {
  PaperKind kind = PaperKind::kNoise;
  double amplitude = 30e-6;  ///< greatest displacement, up and down [m]; of an array: of height 1
  /// Crest to crest; noise rises and falls as often as a wave of this length does along any line;
  /// of an array: the length of a tile along x, each sample as high as it is wide [m].
  double wavelength = 2e-3;
  double angle = 0;        ///< of the waves' normal from x, of sine and grid [rad]
  std::uint32_t seed = 1;  ///< of noise
  std::shared_ptr<const SampledHeights> heights = nullptr;  ///< of an array
  bool tiled = false;  ///< an array is repeated; else it is stretched over its patch
};

/// A rectangle with a paper texture, faded at its border so that displacement and slope end there
/// at zero. Patches that overlap add.
struct PaperPatch {
  Box box_P;  ///< [m]
  PaperTexture texture;
  double fade = 2e-3;  ///< length over which it comes and goes, at most half a side [m]
};

/// Displacement and gradient, zero outside the box: the plain definition that the compiled field is
/// tested against.
Sample Evaluate(const PaperPatch& patch, glm::dvec2 p_P) noexcept;

/// What displacement, slope and second derivative in any direction do not exceed; proofs beside the
/// source.
struct PaperBounds {
  double displacement = 0;  ///< [m]
  double slope = 0;         ///< [m/m]
  double curvature = 0;     ///< [1/m]
};
/// Of the texture by itself, an array's over the box that it is stretched to.
PaperBounds BoundsOf(const PaperTexture& texture, const Box& box_P);
/// With the fade.
PaperBounds BoundsOf(const PaperPatch& patch);

/// Throws InputError unless lengths are finite and above zero, the box has an area, an array is
/// there where one is wanted, and the texture by itself is no steeper than 1: a tip pressed on
/// steeper paper would not find the grooves.
void Check(const PaperPatch& patch);

}  // namespace moontrace
