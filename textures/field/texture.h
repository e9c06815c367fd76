#pragma once

#include <memory>
#include <vector>

#include "textures/field/element.h"
#include "textures/field/paper.h"

namespace moontrace {

struct Group;

/// A group standing in another: shared, moved, never turned. A glyph at one size is stored once.
struct Placement {
  std::shared_ptr<const Group> group;
  glm::dvec2 origin{0, 0};  ///< of the member's frame, in the group's frame [m]
};

/// Elements and smaller groups; at each point the member with the greatest magnitude decides (the
/// paper, section 4: mitres joints of grooves and of ridges), at equal members the lowest-numbered,
/// elements before placements. Groups nest: glyph, word, line, page.
struct Group {
  std::vector<Element> elements;
  std::vector<Placement> placements;
  /// Creases between the group's own lines and arcs of one profile are rounded over this length
  /// [m]; 0 keeps them sharp. See `blend.h` for the formula.
  double blend_radius = 0;
  Box bounds;  ///< set by Finish
};

/// Computes the bounding rectangle from the members and returns the group for sharing.
std::shared_ptr<const Group> Finish(Group group);

enum class Relief { kEngraved, kEmbossed };

/// One group with its sign. Layers are joined by Sum, so that grooves, ridges and paper texture may
/// overlap and displacement stays continuous.
struct Layer {
  std::shared_ptr<const Group> group;
  Relief relief = Relief::kEngraved;
};

/// The tactile surface as a tree: the sum of its layers and its patches of rough paper.
struct Texture {
  std::vector<Layer> layers;
  std::vector<PaperPatch> paper{};
};

/// Samples the tree itself by walking it: exact, slow, and it allocates, so never in a tick. The
/// compiled field agrees with it at every point to rounding.
Sample SampleTree(const Texture& texture, glm::dvec2 p_P);

}  // namespace moontrace
