#pragma once

#include <cstddef>
#include <glm/vec3.hpp>

#include "textures/field/piece.h"
#include "textures/field/surface.h"

namespace moontrace {

/// What the tip feels through. `kProxy`: the proxy meets the page and a virtual coupling ties it to
/// the handle. `kDirect` (the paper): the force at the device's position.
enum class Rendering { kProxy, kDirect };

/// What the tip feels of a model's geoms without a label: nothing; a smooth surface, as of a label
/// `{}`; MuJoCo's own contacts with the proxy, where the coupling gives at most the force cap.
enum class Unlabelled { kNothing, kPlain, kContacts };

/// Everything that a tick depends on besides the model, the field and the input.
struct SceneOptions {
  Surface surface;
  Rendering rendering = Rendering::kProxy;
  double coupling_stiffness = 1000;    ///< [N/m]
  double coupling_damping = 10;        ///< [N s/m]
  double friction = 0;                 ///< Coulomb mu, mu * s_max < 0.9
  double presliding_stiffness = 2000;  ///< of elastic friction [N/m]
  double tick = 0.001;                 ///< [s]
  double tilt = 0;                     ///< raises the page's far edge [rad]
  Unlabelled unlabelled = Unlabelled::kNothing;
  std::size_t label = 0;  ///< of the model's, that is the page P
  Box text_P{};  ///< what its text covers; where the label gives the text's middle, or is round
};

/// Throws InputError naming the first value that is not finite or out of its range.
void Check(const SceneOptions& options);

/// What one tick gave. P: the page's frame.
struct TickResult {
  glm::dvec3 tip_P{0, 0, 0};    ///< [m]
  glm::dvec3 v_P{0, 0, 0};      ///< of the tip [m/s], where the input knew it
  bool velocity_known = false;  ///< it did
  glm::dvec3 proxy_P{0, 0, 0};  ///< after the step [m]; the tip itself when direct
  glm::dvec3 force_P{0, 0, 0};  ///< to the device [N]
  glm::dvec3 force_W{0, 0, 0};  ///< the same in the world's frame, what Device::Write receives
  glm::dvec3 page_force_P{0, 0,
                          0};  ///< the page's on the proxy (tip when direct), friction included [N]
  double depth = 0;  ///< of the proxy (tip) in the page [m], > 0 in contact; 0 while through
  int geom = -1;     ///< that is touched, MuJoCo's number; -1: none
  double energy_out =
      0;               ///< energy created so far by sampling, as the passivity observer sees it [J]
  double stored = 0;   ///< held by coupling, page, friction and the proxy's motion at its start [J]
  bool fault = false;  ///< MuJoCo warned or a value was not finite: the force is zero
  /// Something besides page and coupling moves the proxy, so that no bound of the force holds: a
  /// fault.
  bool held = false;
  /// Pressed through the paper: the force fades within 30 ms, and the page is felt again once the
  /// proxy (tip when direct) is above it.
  bool through = false;
};

}  // namespace moontrace
