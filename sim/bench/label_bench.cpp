// Labels on objects: a tick among ten of them, and MuJoCo's own contact with the same body as a
// mesh.
#include <fmt/core.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "sim/bench/bench_page.h"
#include "sim/bench/row.h"
#include "sim/bench/timing.h"
#include "sim/physics/mujoco_compat.h"
#include "sim/physics/scene.h"
#include "textures/fonts/script_library.h"
#include "textures/relief/glyph_group.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

namespace {

constexpr double kRadius = 0.04, kHalf = 0.05;  // of a can with a label round it [m]
constexpr double kPressed = 1e-3;               // [m]
constexpr double kSpeed = 0.05;                 // [m/s]
constexpr std::size_t kTicks = 5000;            // once around a can at that speed

const char kHead[] =
    "<mujoco><option timestep='0.001' gravity='0 0 0'><flag contact='disable'/></option>";
const char kProxy[] =
    "<body name='moontrace_proxy'><joint type='slide' axis='1 0 0'/>"
    "<joint type='slide' axis='0 1 0'/><joint type='slide' axis='0 0 1'/>"
    "<geom type='sphere' mass='0.05' size='0.00025' contype='0' conaffinity='0'/></body>";

/// Ten labelled objects, of the kinds that carry text, the first a can at the origin.
std::string TenObjects() {
  const char* const kinds[] = {"type='cylinder' size='0.04 0.05'",
                               "type='box' size='0.04 0.03 0.02'", "type='sphere' size='0.04'",
                               "type='capsule' size='0.02 0.04'",
                               "type='ellipsoid' size='0.05 0.04 0.03'"};
  std::string labels, geoms;
  for (int i = 0; i < 10; ++i) {
    labels += fmt::format("<text name='moontrace:thing{}' data='{{middle_mm=[0,0]}}'/>", i);
    geoms += fmt::format("<geom name='thing{}' {} pos='{:g} 0 0' contype='0' conaffinity='0'/>", i,
                         kinds[i % 5], 0.11 * i);
  }
  return std::string(kHead) + "<custom>" + labels + "</custom><worldbody>" + geoms + kProxy +
         "</worldbody></mujoco>";
}

std::string OnePlane() {
  return std::string(kHead) +
         "<custom><text name='moontrace:page' data='{}'/></custom><worldbody><geom name='page' "
         "type='plane' size='0 0 0.05' contype='0' conaffinity='0'/>" +
         kProxy + "</worldbody></mujoco>";
}

/// A word's grooves and what they cover.
struct Word {
  TextureField field;
  Box covers;  ///< [m]
};
Word WordOf(const std::string& text) {
  const Script script = FindScript("moon");
  const TypeStyle style = DefaultStyle(0.01, Relief::kEngraved, script);
  const PageSpec paper{"custom", 0.2, 0.03, 0.005};
  const TextPage page = SetText(text, script, style, paper).pages.front();
  Word word{TextureField(BuildTexture(page, script, style)), {}};
  for (const PlacedGlyph& glyph : page.glyphs) {
    Include(word.covers, Box{glyph.origin_P, glyph.origin_P + glm::dvec2(style.size)});
  }
  return word;
}

/// Round the can at one height, and over a plane as far.
std::vector<DeviceState> RoundACan(double z) {
  std::vector<DeviceState> inputs;
  for (std::size_t i = 0; i < kTicks; ++i) {
    DeviceState input;
    input.time = 1e-3 * static_cast<double>(i);
    const double angle = kSpeed * input.time / kRadius, r = kRadius - kPressed;
    input.p_D = {r * std::sin(angle), -r * std::cos(angle), z};
    inputs.push_back(input);
  }
  return inputs;
}
std::vector<DeviceState> OverAPlane(const Box& covers) {
  std::vector<DeviceState> inputs;
  const double width = covers.max.x - covers.min.x;
  for (std::size_t i = 0; i < kTicks; ++i) {
    DeviceState input;
    input.time = 1e-3 * static_cast<double>(i);
    const double along = std::fmod(kSpeed * input.time, width);
    input.p_D = {covers.min.x + along, 0.5 * (covers.min.y + covers.max.y), -kPressed};
    inputs.push_back(input);
  }
  return inputs;
}

double Run(Scene& scene, const std::vector<DeviceState>& inputs) {
  double sum = 0;
  for (const DeviceState& input : inputs) sum += scene.Tick(input).force_W.z;
  return sum;
}

/// The can as a mesh of so many facets, and a tip on three slides.
ModelPtr MeshModel(int facets, double tip_radius) {
  std::string corners;
  for (int i = 0; i < facets; ++i) {
    const double a = 2 * std::numbers::pi * i / facets;
    for (const double z : {-kHalf, kHalf}) {
      corners +=
          fmt::format("{:.9g} {:.9g} {:g} ", kRadius * std::cos(a), kRadius * std::sin(a), z);
    }
  }
  const std::string contact = "condim='1' solref='0.002 1'";
  const std::string xml = fmt::format(
      "<mujoco><option timestep='0.001' gravity='0 0 0'/><asset><mesh name='can' vertex='{}'/>"
      "</asset><worldbody><geom type='mesh' mesh='can' {}/><body><joint type='slide' axis='1 0 0'/>"
      "<joint type='slide' axis='0 1 0'/><joint type='slide' axis='0 0 1'/>"
      "<geom type='sphere' mass='0.05' size='{:g}' {}/></body></worldbody></mujoco>",
      corners, contact, tip_radius, contact);
  std::string warning;
  return CompileMjcf(xml, "bench.xml", "bench", warning);
}

/// How a force changes from tick to tick, less what going round changes evenly.
class Roughness {
 public:
  void Add(glm::dvec3 aim, glm::dvec3 force) {
    const double across = std::hypot(aim.x, aim.y);
    const glm::dvec3 out(aim.x / across, aim.y / across, 0), around(-out.y, out.x, 0);
    const glm::dvec2 now(glm::dot(force, out), glm::dot(force, around));
    constexpr std::size_t kSettled = 500;
    if (count_++ > kSettled) {
      const glm::dvec2 change = now - last_;
      squares_ += glm::dot(change, change);
    }
    last_ = now;
  }
  double rms() const { return std::sqrt(squares_ / static_cast<double>(count_)); }  ///< [N a tick]

 private:
  std::size_t count_ = 0;
  double squares_ = 0;
  glm::dvec2 last_{0, 0};
};

/// Dragged as Scene's coupling does.
double RunMesh(const mjModel& m, double tip_radius, const std::vector<DeviceState>& inputs,
               Roughness* roughness) {
  const DataPtr d = MakeData(m, "bench");
  const auto aim_of = [&](const DeviceState& input) {
    const double longer = (kRadius - kPressed + tip_radius) / (kRadius - kPressed);
    return glm::dvec3(longer * input.p_D.x, longer * input.p_D.y, input.p_D.z);
  };
  for (int axis = 0; axis < 3; ++axis) d->qpos[axis] = 1.1 * aim_of(inputs.front())[axis];
  for (const DeviceState& input : inputs) {
    const glm::dvec3 aim = aim_of(input);
    glm::dvec3 force;
    for (int axis = 0; axis < 3; ++axis) {
      force[axis] = 1000 * (aim[axis] - d->qpos[axis]) - 14 * d->qvel[axis];
      d->qfrc_applied[axis] = force[axis];
    }
    if (roughness != nullptr) roughness->Add(aim, -force);
    mj_step(&m, d.get());
  }
  return d->qpos[0];
}

}  // namespace

BenchRows BenchLabels() {
  BenchRows rows;
  const Word word = WordOf("the moon");
  Scene plane = Scene::FromXml(OnePlane(), "bench.xml", SceneOptions{});
  plane.SetField(&word.field);
  const std::shared_ptr<const TextureField> shared(&word.field, [](const TextureField*) {});
  SceneOptions options;
  options.text_P = word.covers;
  Scene ten = Scene::FromXml(TenObjects(), "bench.xml", options);
  ten.SetField(&word.field);
  for (std::size_t i = 1; i < 10; ++i) ten.SetLabel({i, shared, word.covers});

  const std::vector<DeviceState> over = OverAPlane(word.covers), on_text = RoundACan(0);
  const Turns tick = ByTurns(
      21, [&] { Keep(Run(ten, on_text)); }, [&] { Keep(Run(plane, over)); });
  rows.push_back(
      AtMost("tick round one of ten labelled objects, against a page", tick.ratio, "times", 2));

  // beside the text: MuJoCo's mesh is its hull and has no grooves
  constexpr double kBeside = 0.03, kTip = 0.25e-3;  // [m]
  constexpr int kFacets = 96;
  const std::vector<DeviceState> beside = RoundACan(kBeside);
  const ModelPtr mesh = MeshModel(kFacets, kTip);
  const Turns step = ByTurns(
      21, [&] { Keep(RunMesh(*mesh, kTip, beside, nullptr)); }, [&] { Keep(Run(ten, beside)); });
  rows.push_back(AtLeast("tick there against a step with MuJoCo's mesh of that can", step.ratio,
                         "times faster", 1));
  Roughness ours, theirs;
  for (const DeviceState& input : beside) ours.Add(input.p_D, ten.Tick(input).force_W);
  RunMesh(*mesh, kTip, beside, &theirs);
  rows.push_back(AtMost("change of the force from tick to tick, against that mesh",
                        ours.rms() / theirs.rms(), "times", 0.5));
  rows.push_back(Shown("that change", 1e3 * ours.rms(), "mN"));
  rows.push_back(Shown("that change on the mesh", 1e3 * theirs.rms(), "mN"));
  return rows;
}

}  // namespace moontrace
