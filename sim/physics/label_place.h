#pragma once

#include <mujoco/mujoco.h>

#include <cstddef>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>

#include "sim/physics/label.h"
#include "textures/objects/solid_contact.h"

namespace moontrace {

/// A label with what is felt there.
struct LaidLabel {
  std::size_t label = 0;                      ///< its number in the model, from 0
  std::shared_ptr<const TextureField> field;  ///< null: blank
  Box text_P;                                 ///< what of its page the text covers [m]
};

/// What a geom of MuJoCo is as a solid; none: a kind without a chart.
std::optional<Solid> SolidOf(const mjModel& m, int geom);

/// Where a label's page lies; `text_P` is what its text covers, or empty. A label that gives the
/// middle of its text lies so; on round faces the middle of the text is the middle of the chart.
LabelPlace PlaceOn(const Label& label, const Solid& solid, const Box& text_P);

/// A label with a texture, or blank with null.
LabelOnSolid Lay(const Label& label, const Solid& solid, const TextureField* field,
                 const Box& text_P);

/// How large a page may be: to the far edges of the face, from the page's origin, or the whole face
/// for a label that gives the middle of its text; infinite where there is no edge [m].
glm::dvec2 ExtentOf(const Label& label, const Solid& solid);

/// Whether the text has room on its face.
bool HasRoom(const Label& label, const Solid& solid, const Box& text_P);

/// By how much lengths on the page err within the text, against the surface.
double LengthErrorOf(const Label& label, const Solid& solid, const Box& text_P);

/// Whether texts of two labels, on geoms of that solid, lie on one another somewhere.
bool LieTogether(const Label& a, const Box& text_A, const Label& b, const Box& text_B,
                 const Solid& solid);

}  // namespace moontrace
