#pragma once

#include <glm/vec3.hpp>
#include <memory>

#include "devices/core/device.h"
#include "devices/core/mailbox.h"
#include "devices/hand/hand.h"

namespace moontrace {

/// Where a hand that is steered live, by a mouse or pen, wants its tip to be.
struct StylusAim {
  glm::dvec3 p_D{0, 0, 0};  ///< on the page's surface [m]
  double press = 0;         ///< into the page [N]; 0: the tip is lifted
};

/// The stylus in a simulated hand that follows the newest aim: the simulated stylus's spring,
/// damper and delay, without tremor and drift, so that a groove holds its tip as it would hold a
/// hand's. Before the first aim it hovers over the origin; a distant aim is approached through the
/// air, at 1 m/s at most. `press_direction_D`: unit, into the page. `tick` [s]. Throws
/// std::invalid_argument as MakeSimulatedStylus.
std::unique_ptr<Device> MakeAimedStylus(const HandModel& hand,
                                        std::shared_ptr<Mailbox<StylusAim>> aims,
                                        glm::dvec3 press_direction_D, double tick);

}  // namespace moontrace
