#include "sim/app/commands.h"

#include <glm/geometric.hpp>

#include <nlohmann/json.hpp>

#include "sim/app/messages.h"
#include "sim/setup/help.h"
#include "sim/setup/typeset_report.h"
#include "sim/trial/trial.h"
#include "textures/base/error.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

namespace {

/// What the probe found, in the units of the report.
struct Reading {
  double displacement_mm = 0;
  double depth_mm = 0;
  glm::dvec2 gradient{0, 0};
  glm::dvec3 normal{0, 0, 1};
  glm::dvec3 force_n{0, 0, 0};
};

Json ReadingJson(const Reading& r) {
  Json json;
  json["displacement_mm"] = r.displacement_mm;
  json["gradient"] = {r.gradient.x, r.gradient.y};
  json["normal"] = {r.normal.x, r.normal.y, r.normal.z};
  json["depth_mm"] = r.depth_mm;
  json["force_n"] = {r.force_n.x, r.force_n.y, r.force_n.z};
  return json;
}

void SayReading(const Reading& r, Console& console) {
  console.Result(say::ProbeOutcome(1e-3 * r.depth_mm, glm::length(r.force_n)));
  console.Result(say::NamedNumbers("displacement_mm", &r.displacement_mm, 1));
  console.Result(say::NamedNumbers("gradient", &r.gradient.x, 2));
  console.Result(say::NamedNumbers("normal", &r.normal.x, 3));
  console.Result(say::NamedNumbers("depth_mm", &r.depth_mm, 1));
  console.Result(say::NamedNumbers("force_n", &r.force_n.x, 3));
}

}  // namespace

void AddOptions(CLI::App& app, ProbeOptions& options) {
  constexpr double kFarthest = 10000;  // [mm]
  AddNumber(app, "X", options.point[0], -kFarthest, kFarthest, 1e-3, say::help::kX);
  AddNumber(app, "Y", options.point[1], -kFarthest, kFarthest, 1e-3, say::help::kY);
  AddNumber(app, "Z", options.point[2], -kFarthest, kFarthest, 1e-3, say::help::kZ);
  AddOptions(app, options.text);
  AddOptions(app, options.style);
  AddOptions(app, options.layout);
  AddOptions(app, options.surface);
  AddOptions(app, options.output);
}

int Run(const ProbeOptions& options, Console& console) {
  if (!options.point[0] || !options.point[1] || !options.point[2]) {
    throw UsageError(say::NoPoint());
  }
  const std::string text = ReadText(options.text, "probe X Y Z", console);
  Script script = ScriptOf(options.style, nullptr, text);
  for (const std::string& remark : script.remarks) console.Remark(remark);
  const TypeStyle style = StyleOf(options.style, options.layout, script, nullptr);
  const Typeset set = SetText(text, script, style, PageOf(options.layout));
  const TextPage& page = set.pages.front();
  const TextureField field = PageField(page, script, set.style, false);

  const glm::dvec3 origin_P(page.glyphs.front().origin_P, 0.0);
  const glm::dvec3 p_P =
      origin_P + glm::dvec3(*options.point[0], *options.point[1], *options.point[2]);
  const Contact contact = Touch(options.surface, field, p_P);
  Reading reading;
  reading.displacement_mm = 1e3 * contact.sample.displacement;
  reading.depth_mm = 1e3 * contact.depth;
  reading.gradient = contact.sample.gradient;
  reading.normal = NormalOf(contact.sample.gradient);
  reading.force_n = contact.force_P;
  if (options.output.json) {
    console.Json(Dump(ReadingJson(reading)));
  } else {
    SayReading(reading, console);
  }
  SayReplacements(set, [&console](const std::string& line) { console.Remark(line); });
  return exit_code::kGood;
}

}  // namespace moontrace
