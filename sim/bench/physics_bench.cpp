#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "devices/hand/simulated_stylus.h"
#include "sim/bench/bench_page.h"
#include "sim/bench/row.h"
#include "sim/bench/timing.h"
#include "sim/physics/mujoco_compat.h"
#include "sim/physics/scene.h"
#include "sim/physics/scene_push.h"
#include "sim/safety/safety.h"
#include "sim/trial/plan.h"
#include "sim/trial/trial.h"

namespace moontrace {

namespace {

/// A finger's path over the page at 50 mm/s, pressed 1 mm in.
std::vector<DeviceState> Slide(const BenchPage& page, std::size_t ticks) {
  std::vector<DeviceState> inputs;
  for (const glm::dvec2 p : SlidingPoints(page, ticks)) {
    DeviceState input;
    input.time = 1e-3 * static_cast<double>(inputs.size());
    input.p_D = {p, -1e-3};
    inputs.push_back(input);
  }
  return inputs;
}

double RunScene(Scene& scene, const std::vector<DeviceState>& inputs) {
  double sum = 0;
  for (const DeviceState& input : inputs) sum += scene.Tick(input).force_P.z;
  return sum;
}

/// The proxy pulled behind the tip by hand, so that it moves as ours does.
void Pull(mjData& d, glm::dvec3 aim) {
  for (int axis = 0; axis < 3; ++axis) {
    d.qfrc_applied[axis] = 1000 * (aim[axis] - d.qpos[axis]) - 14 * d.qvel[axis];
  }
}

/// The bare model on the same slide: mj_step without a field and without us.
double RunBare(Scene& scene, const std::vector<DeviceState>& inputs) {
  mjData* d = scene.data();
  for (const DeviceState& input : inputs) {
    Pull(*d, input.p_D);
    mj_step(scene.model(), d);
  }
  return d->time;
}

std::string Number(double value) { return fmt::format("{:.9g}", value); }

/// MuJoCo's own means for the same page: a height field, and a tip on three slides.
ModelPtr HeightFieldModel(const BenchPage& page, const TextureField& field, int columns, int rows,
                          double tip_radius, bool leaning) {
  const double depth = field.greatest_displacement();
  const std::string half_x = Number(page.size.x / 2), half_y = Number(page.size.y / 2);
  const std::string contact = "condim='1' friction='0.2 0 0' solref='0.002 1'";
  const std::string radius = Number(tip_radius);
  const std::string tip =
      leaning ? "<geom type='capsule' fromto='0 0 0 0.03 0 0.06' mass='0.05' size='" + radius + "' "
              : "<geom type='sphere' mass='0.05' size='" + radius + "' ";
  const std::string xml =
      "<mujoco><option timestep='0.001' gravity='0 0 0'/><asset><hfield name='page' ncol='" +
      std::to_string(columns) + "' nrow='" + std::to_string(rows) + "' size='" + half_x + " " +
      half_y + " " + Number(depth) +
      " 0.002'/></asset><worldbody><geom type='hfield' "
      "hfield='page' pos='" +
      half_x + " " + half_y + " " + Number(-depth) + "' " + contact +
      "/><body name='tip'><joint type='slide' axis='1 0 0'/><joint type='slide' axis='0 1 0'/>"
      "<joint type='slide' axis='0 0 1'/>" +
      tip + contact + "/></body></worldbody></mujoco>";
  std::string warning;
  ModelPtr m = CompileMjcf(xml, "bench.xml", "bench", warning);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const glm::dvec2 p = page.size * glm::dvec2(column, row) / glm::dvec2(columns - 1, rows - 1);
      m->hfield_data[row * columns + column] =
          static_cast<float>(1 + field.SampleAt(p).displacement / depth);
    }
  }
  return m;
}

/// Drags the tip as Scene's coupling does.
double RunHeightField(const mjModel& m, double tip_radius, const std::vector<DeviceState>& inputs) {
  const DataPtr d = MakeData(m, "bench");
  for (int axis = 0; axis < 3; ++axis) d->qpos[axis] = inputs.front().p_D[axis];
  d->qpos[2] = tip_radius;
  for (const DeviceState& input : inputs) {
    Pull(*d, input.p_D + glm::dvec3(0, 0, tip_radius));
    mj_step(&m, d.get());
  }
  return d->qpos[2];
}

/// The height field's model with our page in its place: one page, one tip on three slides, no desk
/// and no drawn stylus in either.
Scene PageOnlyScene() {
  return Scene::FromXml(
      "<mujoco><option timestep='0.001' gravity='0 0 0'><flag contact='disable'/></option><custom>"
      "<text name='moontrace:page' data='{}'/></custom><worldbody><geom name='page' type='plane' "
      "size='0 0 0.05' contype='0' conaffinity='0'/><body name='moontrace_proxy'>"
      "<joint type='slide' axis='1 0 0'/><joint type='slide' axis='0 1 0'/>"
      "<joint type='slide' axis='0 0 1'/><geom type='sphere' mass='0.05' size='0.00025' "
      "contype='0' conaffinity='0'/></body></worldbody></mujoco>",
      "bench.xml", SceneOptions{});
}

/// Both do the same slide by turns, so that a busy machine slows both; short ones, so that a core
/// that is taken away for a while spoils few of them.
void AddHeightField(const BenchPage& page, const TextureField& field, BenchRows& rows) {
  Scene scene = PageOnlyScene();
  scene.SetField(&field);
  const auto add = [&](const char* tip, double radius, bool leaning, std::size_t ticks,
                       double bar) {
    const ModelPtr model = HeightFieldModel(page, field, 4000, 2000, radius, leaning);
    const std::vector<DeviceState> inputs = Slide(page, ticks);
    const Turns turns = ByTurns(
        21, [&] { Keep(RunHeightField(*model, radius, inputs)); },
        [&] { Keep(RunScene(scene, inputs)); });
    rows.push_back(AtLeast(fmt::format("against MuJoCo's height field, {}", tip), turns.ratio,
                           "times faster", bar));
    rows.push_back(Shown(fmt::format("step of that height field, {}", tip),
                         1e6 * turns.first / static_cast<double>(ticks), "us"));
  };
  add("sphere of 0.25 mm", 0.25e-3, false, 4000, 15);
  add("sphere of 0.05 mm", 0.05e-3, false, 4000, 8);
  add("leaning stylus", 0.25e-3, true, 400, 200);
}

/// The whole tick: device, sample, step, guiding push, safety, device.
void AddTick(const BenchPage& page, const TextureField& field, BenchRows& rows) {
  TextPage sheet;
  for (const PlacedGlyph& glyph : page.sheet.glyphs) {
    if (glyph.line < 1) sheet.glyphs.push_back(glyph);
  }
  Scene scene = Scene::Load("", SceneOptions{});
  scene.SetField(&field);
  const HandModel hand = ShippedHand();
  const std::vector<IntendedStroke> strokes = IntendedStrokes(sheet, page.script, page.style);
  const Plan plan = MakeOraclePlan(strokes, PlanOptions{}, scene.X_WP());
  const auto stylus = MakeSimulatedStylus(hand, plan.path_W, 1e-3, 1);
  ScenePush push(PlanOf(GuidanceAt(GuidanceMode::kBead, 6), strokes), 1e-3);
  Safety safety(stylus->Limits(), 1e-3);
  const auto ticks = static_cast<std::size_t>(std::min(plan.duration * 1e3, 100000.0));
  std::vector<double> times;
  times.reserve(ticks);
  double whole = 0;
  for (std::size_t i = 0; i < ticks; ++i) {
    const double begin = Now();
    SafetyInput input;
    input.status = stylus->Read(input.device);
    input.time = 1e-3 * static_cast<double>(i);
    TickResult result = scene.Tick(input.device);
    push.Add(scene.X_WP(), result);
    input.force = result.force_W;
    stylus->Write(safety.Advance(input).force);
    times.push_back(Now() - begin);
    whole += times.back();
  }
  std::sort(times.begin(), times.end());
  rows.push_back(
      AtMost("whole tick, mean", 1e6 * whole / static_cast<double>(times.size()), "us", 3));
  rows.push_back(AtMost("whole tick, 99.9 percent",
                        1e6 * times[static_cast<std::size_t>(0.999 * static_cast<double>(ticks))],
                        "us", 30));
}

}  // namespace

BenchRows BenchPhysics() {
  BenchRows rows;
  const BenchPage page = MakeBenchPage(1, 4);
  const TextureField field(page.texture);
  const std::vector<DeviceState> inputs = Slide(page, 20000);
  Scene scene = Scene::Load("", SceneOptions{});
  scene.SetField(&field);
  Scene bare = Scene::Load("", SceneOptions{});
  const Turns steps = ByTurns(
      41, [&] { Keep(RunScene(scene, inputs)); }, [&] { Keep(RunBare(bare, inputs)); });
  const double ticks = static_cast<double>(inputs.size());
  rows.push_back(
      AtMost("mj_step with coupling and field against bare mj_step", steps.ratio, "times", 1.3));
  rows.push_back(Shown("mj_step with coupling and field", 1e6 * steps.first / ticks, "us"));
  rows.push_back(Shown("bare mj_step of the same model", 1e6 * steps.second / ticks, "us"));
  AddHeightField(page, field, rows);
  AddTick(page, field, rows);
  return rows;
}

}  // namespace moontrace
