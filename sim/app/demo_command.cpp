#include "sim/app/commands.h"

#include <fmt/core.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "sim/app/messages.h"
#include "sim/app/trace_picture.h"
#include "sim/picture/cairo_writer.h"
#include "sim/picture/picture_file.h"
#include "sim/setup/help.h"
#include "sim/setup/typeset_report.h"
#include "sim/trial/trial.h"
#include "textures/base/error.h"
#include "textures/base/output_file.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

namespace {

namespace fs = std::filesystem;

constexpr const char* kWord = "MOON";
constexpr double kSizes[] = {0.040, 0.020, 0.010, 0.006};  // [m]
constexpr double kBlankSize = 0.020;                       // [m]
constexpr double kBar = 0.98;                              // coverage that a size should reach

/// One line of the demo: traces the word at a size and leaves a picture.
TrialResult TraceWord(const DemoOptions& options, const Script& script, double size, bool blank,
                      Console& console) {
  const TypeStyle style = DefaultStyle(size, Relief::kEngraved, script);
  const Typeset set = SetText(kWord, script, style, {"custom", 0.3, 0.1, 0.01});
  TrialSetup setup;
  setup.script = &script;
  setup.page = &set.pages.front();
  setup.style = set.style;
  setup.blank = blank;
  setup.hand = ShippedHand();
  setup.plan.press = setup.hand.press;
  setup.seed = options.seed;
  setup.path_spacing = set.style.width / 20;
  setup.stop = console.stop();
  setup.alive = [&console](double done) { console.Alive(done); };
  TrialResult result = RunTrial(setup);

  const std::string name = fmt::format("moon-{:g}-mm{}.{}", 1e3 * size, blank ? "-blank" : "",
                                       HaveCairo() ? "png" : "svg");
  WritePicture((fs::path(options.folder) / name).string(),
               TracePicture(*setup.page, script, setup.style, blank, kWord, result));
  return result;
}

Json RowJson(double size, bool blank, const TrialResult& result) {
  Json row = {{"size_mm", 1e3 * size}, {"blank", blank}};
  row.update(TotalJson(result, true));
  return row;
}

}  // namespace

void AddOptions(CLI::App& app, DemoOptions& options) {
  AddSeed(app, options.seed);
  AddPath(app, "--folder", "DIR", options.folder, say::help::kDemoFolder);
  AddOptions(app, options.output);
}

int Run(const DemoOptions& options, Console& console) {
  MakeFolder(options.folder);
  const Script script = FindScript("moon");
  console.Result(say::DemoWelcome(kWord));
  console.Result(say::DemoWhatMoonIs());
  console.Result(say::DemoHand());
  console.Result(say::DemoCovered());
  Json rows = Json::array();
  double lost = 0;
  for (const double size : kSizes) {
    const TrialResult result = TraceWord(options, script, size, false, console);
    console.Result(say::DemoSize(size, result));
    rows.push_back(RowJson(size, false, result));
    if (result.score.total.coverage < kBar && lost == 0) lost = size;
  }
  const TrialResult blank = TraceWord(options, script, kBlankSize, true, console);
  console.Result(say::DemoBlank(kBlankSize, blank));
  console.Result(say::DemoWhyBlank());
  rows.push_back(RowJson(kBlankSize, true, blank));
  const std::string folder = fs::absolute(options.folder).lexically_normal().string();
  console.Result(say::DemoPictures());
  console.Path(folder);
  console.Result(say::DemoNext());
  if (options.output.json) console.Json(Dump({{"folder", folder}, {"sizes", rows}}));
  if (lost > 0) throw WorkFailed(say::DemoBelowBar(lost));
  return exit_code::kGood;
}

}  // namespace moontrace
