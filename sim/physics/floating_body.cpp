#include "sim/physics/floating_body.h"

#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace moontrace {
namespace {

/// MuJoCo's, row by row; glm goes column by column.
glm::dmat3 MatrixOf(const mjtNum* R) {
  return {R[0], R[3], R[6], R[1], R[4], R[7], R[2], R[5], R[8]};
}

glm::dmat3 Turn(const mjtNum* quat) noexcept {
  mjtNum R[9];
  mju_quat2Mat(R, quat);
  return MatrixOf(R);
}

glm::dvec3 VectorOf(const mjtNum* v) noexcept { return {v[0], v[1], v[2]}; }

/// Inertia of a mass at `p` about the origin.
glm::dmat3 OfPoint(double mass, glm::dvec3 p) {
  return mass * (glm::dmat3(glm::dot(p, p)) - glm::outerProduct(p, p));
}

/// A welded body's frame in that of the body that floats.
struct Frame {
  glm::dmat3 R{1.0};
  glm::dvec3 p{0, 0, 0};
};

Frame FrameIn(const mjModel& m, int root, int body) {
  Frame frame;
  for (int b = body; b != root; b = m.body_parentid[b]) {
    const glm::dmat3 R = Turn(m.body_quat + std::ptrdiff_t{4} * b);
    frame = {R * frame.R, R * frame.p + VectorOf(m.body_pos + std::ptrdiff_t{3} * b)};
  }
  return frame;
}

}  // namespace

FloatingBody::FloatingBody(const mjModel& m, int body) {
  const int root = m.body_weldid[body];
  if (root == 0 || m.body_parentid[root] != 0 || m.body_jntnum[root] != 1) return;
  const int joint = m.body_jntadr[root];
  if (m.jnt_type[joint] != mjJNT_FREE) return;
  double mass = 0;
  glm::dvec3 moment(0);
  glm::dmat3 about_origin(0.0);
  for (int b = root; b < static_cast<int>(m.nbody); ++b) {
    if (m.body_rootid[b] != root) continue;
    if (m.body_weldid[b] != root) return;  // jointed to it
    const Frame frame = FrameIn(m, root, b);
    const glm::dvec3 at = frame.R * VectorOf(m.body_ipos + std::ptrdiff_t{3} * b) + frame.p;
    const glm::dmat3 R = frame.R * Turn(m.body_iquat + std::ptrdiff_t{4} * b);
    const mjtNum* principal = m.body_inertia + std::ptrdiff_t{3} * b;
    const glm::dmat3 own(glm::dvec3(principal[0], 0, 0), glm::dvec3(0, principal[1], 0),
                         glm::dvec3(0, 0, principal[2]));
    mass += m.body_mass[b];
    moment += m.body_mass[b] * at;
    about_origin += R * own * glm::transpose(R) + OfPoint(m.body_mass[b], at);
  }
  for (int i = 0; i < 6; ++i) {
    if (m.dof_armature[m.jnt_dofadr[joint] + i] != 0) return;  // no inertia of a rigid body
  }
  if (!(mass > 0)) return;
  centre_ = moment / mass;
  inertia_ = about_origin - OfPoint(mass, centre_);
  inverse_ = glm::inverse(inertia_);
  qpos_ = m.jnt_qposadr[joint];
  dof_ = m.jnt_dofadr[joint];
}

FloatingBody::Motion FloatingBody::MotionOf(const mjData& d) const noexcept {
  const mjtNum* q = d.qpos + qpos_;
  const mjtNum* v = d.qvel + dof_;
  mjtNum unit[4] = {q[3], q[4], q[5], q[6]};
  mju_normalize4(unit);
  return {Turn(unit), VectorOf(q), VectorOf(v), VectorOf(v + 3)};
}

void FloatingBody::Begin(const mjData& d) noexcept {
  if (floats()) before_ = MotionOf(d);
}

void FloatingBody::End(double step, mjData& d) const noexcept {
  if (!floats()) return;
  const Motion after = MotionOf(d);
  const glm::dvec3& w = before_.turning;
  const glm::dvec3 change = (after.turning - w) / step;
  // angular momentum about the centre of mass, in the world
  const glm::dvec3 momentum_B = inertia_ * w;
  const glm::dvec3 rate_B = inertia_ * change + glm::cross(w, momentum_B);
  const glm::dvec3 momentum_W = before_.R * (momentum_B + step * rate_B);
  const glm::dvec3 turning = inverse_ * (momentum_W * after.R);
  // the centre of mass
  const glm::dvec3 arm_W = before_.R * centre_, w_W = before_.R * w;
  const glm::dvec3 centre_rate = before_.v + glm::cross(w_W, arm_W);
  const glm::dvec3 centre_change = (after.v - before_.v) / step +
                                   glm::cross(before_.R * change, arm_W) +
                                   glm::cross(w_W, glm::cross(w_W, arm_W));
  const glm::dvec3 v_c = centre_rate + step * centre_change;
  const glm::dvec3 new_arm_W = after.R * centre_;
  const glm::dvec3 p = before_.p + arm_W + step * v_c - new_arm_W;
  const glm::dvec3 v = v_c - glm::cross(after.R * turning, new_arm_W);
  for (int i = 0; i < 3; ++i) {
    d.qpos[qpos_ + i] = p[i];
    d.qvel[dof_ + i] = v[i];
    d.qvel[dof_ + 3 + i] = turning[i];
  }
}

}  // namespace moontrace
