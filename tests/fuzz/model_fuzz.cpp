// A model put together from well-formed parts, as the bytes choose, so that MuJoCo compiles most of
// them and what this program looks for in a compiled model is searched: labels, page, proxy and
// whatever could hold the proxy. A scene of it ticks, or it is refused with one line. Bytes behind
// the first zero byte are the label's TOML.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>

#include "sim/physics/scene.h"
#include "tests/fuzz/one_line.h"
#include "textures/base/error.h"
#include "textures/base/xml_text.h"

namespace {

using namespace moontrace;

#define FREE_SLIDES                                                               \
  "<joint name='x' type='slide' axis='1 0 0'/><joint type='slide' axis='0 1 0'/>" \
  "<joint type='slide' axis='0 0 1'/>"

constexpr std::array<const char*, 17> kInWorld = {
    "<geom name='page' type='plane' size='.1 .1 .1'/>",
    "<geom name='page' type='box' size='.1 .1 .01' contype='0' conaffinity='0'/>",
    "<geom name='page' type='plane' size='0 0 1' pos='0 0 -1' euler='10 0 0'/>",
    "<geom name='page' type='sphere' size='.1'/>",
    "<geom name='page:1' type='plane' size='1e-9 1 1'/>",
    "<body name='sheet' pos='0 0 1'><freejoint/><geom name='page' type='box' size='.1 .1 .01'/>"
    "</body>",
    "<body name='sheet'><joint name='hinge'/><geom name='page' type='box' size='1 1 1'/></body>",
    "<body name='moontrace_proxy'>" FREE_SLIDES
    "<geom name='tip' size='.002' mass='.05' contype='0' conaffinity='0'/></body>",
    "<body name='moontrace_proxy'>" FREE_SLIDES "<geom name='tip' size='.002' mass='1e-9'/></body>",
    "<body name='moontrace_proxy'>" FREE_SLIDES
    "<geom size='.01' contype='0' conaffinity='0'/><site name='s'/><body><geom size='.1' "
    "contype='0' conaffinity='0'/></body></body>",
    "<body name='moontrace_proxy'>" FREE_SLIDES
    "<geom size='.01' contype='0' conaffinity='0'/><body><joint name='hinge'/><geom size='.1'/>"
    "</body></body>",
    "<body name='moontrace_proxy'><geom size='.01'/></body>",
    "<body name='moontrace_proxy'><freejoint name='x'/><geom size='.01'/></body>",
    "<body name='moontrace_handle' mocap='true'/>",
    "<body name='moontrace_handle'><joint name='hinge'/><geom size='.01'/></body>",
    "<site name='s'/>",
    "<camera name='page'/>"};
constexpr std::array<const char*, 22> kBeside = {
    "<equality><weld body1='moontrace_proxy'/></equality>",
    "<equality><connect body1='sheet' body2='moontrace_proxy' anchor='0 0 0'/></equality>",
    "<equality><joint joint1='x'/></equality>",
    "<equality><joint joint1='hinge' joint2='x'/></equality>",
    "<tendon><fixed name='t'><joint joint='x' coef='1'/></fixed></tendon>",
    "<tendon><spatial name='t'><site site='s'/><site site='s'/></spatial></tendon>",
    "<actuator><motor joint='x'/></actuator>",
    "<actuator><motor tendon='t'/></actuator>",
    "<actuator><motor site='s'/></actuator>",
    "<actuator><adhesion body='moontrace_proxy' ctrlrange='0 1'/></actuator>",
    "<equality><tendon tendon1='t'/></equality>",
    "<contact><pair geom1='page' geom2='tip'/></contact>",
    "<keyframe><key qpos='0 0 0'/></keyframe>",
    "<keyframe><key mpos='0 0 0' mquat='1 0 0 0'/></keyframe>",
    "<option timestep='1e-9' integrator='RK4'/>",
    "<option timestep='.05' gravity='0 0 1e9'/>",
    "<option timestep='1e9'/>",
    "<compiler angle='radian' coordinate='global'/>",
    "<compiler boundmass='1e9'/>",
    "<default><geom contype='1' mass='1e9'/><joint stiffness='1' damping='1'/></default>",
    "<sensor><touch site='s'/></sensor>",
    "<custom><text name='other' data='x'/><numeric name='n' data='1'/></custom>"};

std::string ModelOf(std::span<const std::uint8_t> choices, std::string_view label) {
  std::string world, beside;
  for (const std::uint8_t choice : choices) {
    const std::size_t number = choice % (kInWorld.size() + kBeside.size());
    if (number < kInWorld.size()) {
      world += kInWorld[number];
    } else {
      beside += kBeside[number - kInWorld.size()];
    }
  }
  return "<mujoco>" + beside + "<custom><text name='moontrace:page' data=\"" + EscapedXml(label) +
         "\"/></custom><worldbody>" + world + "</worldbody></mujoco>";
}

void Use(Scene scene) {
  for (int i = 0; i < 3; ++i) {
    DeviceState tip;
    tip.time = 0.001 * i;
    const TickResult result = scene.Tick(tip);
    for (int axis = 0; axis < 3; ++axis) {
      if (!std::isfinite(result.force_W[axis])) std::abort();
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t zero = bytes.find('\0');
  const std::size_t choices = std::min<std::size_t>(std::min(zero, size), 20);
  const std::string_view label =
      zero == std::string_view::npos ? "{text='moon'}" : bytes.substr(zero + 1);
  try {
    Use(Scene::FromXml(ModelOf({data, choices}, label), "m.xml", {}));
  } catch (const InputError& error) {
    MustBeOneLine(error.what());
  }
  return 0;
}
