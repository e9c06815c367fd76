#include "sim/physics/friction.h"

#include <glm/geometric.hpp>

namespace moontrace {

glm::dvec3 Friction::Advance(double mu, double stiffness, glm::dvec3 p_P, glm::dvec3 normal_P,
                             double normal_force) noexcept {
  if (!(normal_force > 0)) {
    *this = Friction();
    return {0, 0, 0};
  }
  if (touching_ != 0) stretch_P_ += p_P - last_P_;
  last_P_ = p_P;
  touching_ = 1;
  stretch_P_ -= glm::dot(stretch_P_, normal_P) * normal_P;
  const double greatest = mu * normal_force / stiffness;
  const double length = glm::length(stretch_P_);
  if (length > greatest) stretch_P_ *= greatest / length;
  return -stiffness * stretch_P_;
}

}  // namespace moontrace
