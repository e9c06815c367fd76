// A program that owns a MuJoCo loop: a tip presses on a page, then a simulated hand traces it.
//   consumer MODEL   an MJCF file with a label, into which models/proxy.xml is included
#include <mujoco/mujoco.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <moontrace_mujoco.hpp>

namespace {

struct Delete {
  void operator()(mjModel* m) const { mj_deleteModel(m); }
  void operator()(mjData* d) const { mj_deleteData(d); }
};

int Run(const char* path) {
  char error[500] = "";
  const std::unique_ptr<mjModel, Delete> m(mj_loadXML(path, nullptr, error, sizeof error));
  if (!m) {
    std::fprintf(stderr, "%s\n", error);
    return 1;
  }
  const std::unique_ptr<mjData, Delete> d(mj_makeData(m.get()));
  moontrace::SceneOptions options(mjVERSION_HEADER);
  options.text = "moon";
  moontrace::Scene scene(m.get(), d.get(), options);
  scene.Reset({0.005, 0.005, 0.001});
  moontrace::Felt felt;
  for (int i = 0; i < 300; ++i) felt = scene.Step(scene.PlaceOf({0.005, 0.005, -0.0005}));
  // paper and coupling of 1000 N/m each share 0.5 mm
  if (!(std::fabs(felt.force_world[2] - 0.25) < 0.01)) return 2;
  const moontrace::Trace trace(scene);
  const moontrace_trace_facts facts = trace.facts();
  if (trace.tips().size() != facts.samples) return 3;
  try {
    scene.Step({NAN, 0, 0});
    return 4;
  } catch (const moontrace::Error& refused) {
    if (refused.code() != MOONTRACE_BAD_CALL) return 5;
  }
  std::printf("%.2f N on the paper, %.0f %% of the text traced\n", felt.force_world[2],
              100 * facts.coverage);
  return 0;
}

}  // namespace

int main(int count, char** words) {
  try {
    return count == 2 ? Run(words[1]) : 7;
  } catch (const moontrace::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 8;
  }
}
