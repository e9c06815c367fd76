#pragma once

#include <mujoco/mujoco.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace moontrace {

/// A rigid body that floats: one free joint in the world, bodies welded to it at most. MuJoCo's
/// integrators let the angular momentum of a body that turns, and the momentum of one whose centre
/// of mass is not its frame's origin, drift by an amount of the order of the step, 1e-3 of what a
/// touch gives it. While it is touched its velocity is set so that both change by exactly the
/// impulse of the forces that acted.
class FloatingBody {
 public:
  FloatingBody() = default;
  /// Of the body that `body` belongs to; does nothing unless that floats. Bodies jointed to it stay
  /// MuJoCo's own affair.
  FloatingBody(const mjModel& m, int body);
  bool floats() const noexcept { return qpos_ >= 0; }
  /// Both are the same body of the same model.
  bool Is(const FloatingBody& other) const noexcept { return qpos_ == other.qpos_; }

  /// Before a step: keeps what it needs. No allocation.
  void Begin(const mjData& d) noexcept;
  /// After it: corrects velocity and place by what the step changed in the velocity, which is the
  /// impulse that MuJoCo found: with h the step, c the centre of mass, I the inertia in the body's
  /// frame, w the turning there,
  ///   L' = L + h R (I dw/h + w x I w),  m v_c' = m (v_c + h a_c),  c' = c + h v_c'.
  void End(double step, mjData& d) const noexcept;

 private:
  struct Motion {
    glm::dmat3 R{1.0};            ///< body to world
    glm::dvec3 p{0, 0, 0};        ///< of the frame's origin [m]
    glm::dvec3 v{0, 0, 0};        ///< of it [m/s]
    glm::dvec3 turning{0, 0, 0};  ///< in the body's frame [rad/s]
  };
  Motion MotionOf(const mjData& d) const noexcept;

  int qpos_ = -1, dof_ = 0;
  glm::dvec3 centre_{0, 0, 0};              ///< of mass, in the body's frame [m]
  glm::dmat3 inertia_{1.0}, inverse_{1.0};  ///< about it, in the body's frame [kg m^2]
  Motion before_;
};

}  // namespace moontrace
