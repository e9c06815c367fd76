#pragma once

#include <cstddef>
#include <vector>

#include "lessons/measure/intended_strokes.h"
#include "textures/relief/groove_links.h"

namespace moontrace {

/// One stroke of a walk, and the path to it over the page.
struct WalkStep {
  std::vector<Piece> path_P;   ///< over links and grooves already traced; empty where it begins
  std::vector<Piece> trace_P;  ///< the stroke itself; empty for a dot
  std::size_t stroke = 0;
};

/// What is traced without lifting.
using Walk = std::vector<WalkStep>;

/// Each stroke by itself, from its start: lifted from stroke to stroke.
std::vector<Walk> SeparateWalks(const std::vector<IntendedStroke>& strokes);

/// Goes through the strokes of `page` in writing order along the shortest paths in its grooves:
/// along links and the strokes of a letter, also back over those already traced; links and rings
/// only in their direction of travel. A ring is traced once round from where it is reached. From
/// groove to groove it goes where they run into each other. A walk ends where no groove leads to
/// the next stroke.
std::vector<Walk> LinkedWalks(const std::vector<IntendedStroke>& strokes, const TextPage& page,
                              const GrooveLinks& links);

/// LinkedWalks where there are links, else SeparateWalks.
std::vector<Walk> WalksOf(const std::vector<IntendedStroke>& strokes, const TextPage& page,
                          const GrooveLinks& links);

}  // namespace moontrace
