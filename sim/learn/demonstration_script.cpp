#include "sim/learn/demonstration_script.h"

#include <cstddef>

#include "sim/console/line_wrap.h"
#include "textures/base/resources.h"
#include "textures/base/text_file.h"
#include "textures/base/toml_reader.h"
#include "textures/base/units.h"

namespace moontrace {

namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 20;

DemonstrationStep StepOf(const TomlTable& table) {
  DemonstrationStep step;
  step.show = table.String("show", "");
  const double size_mm = table.Number("size_mm", kMillimetres * step.size);
  step.size = InRange(table, "size_mm", size_mm, 1, 200) / kMillimetres;
  step.say = Sentences(table.String("say", ""));
  step.ask = table.String("ask", "");
  if (step.ask.empty()) {
    for (const char* key : {"answers", "right", "wrong"}) {
      if (table.Has(key)) table.Fail(key, "nothing is asked; give ask, or leave it out");
    }
  } else {
    step.answers = table.Strings("answers");
    if (step.answers.empty()) table.Fail("answers", "empty; give one answer at least");
    step.right = table.String("right");
    step.wrong = table.String("wrong");
  }
  table.FailUnknown();
  return step;
}

}  // namespace

std::vector<DemonstrationStep> ParseDemonstration(std::string_view toml, const std::string& name) {
  const TomlTable table = TomlTable::Parse(toml, name);
  std::vector<DemonstrationStep> steps;
  for (const TomlTable& step : table.Tables("steps")) steps.push_back(StepOf(step));
  if (steps.empty()) table.Fail("steps", "none; give one [[steps]] at least");
  table.FailUnknown();
  return steps;
}

std::vector<DemonstrationStep> ShippedDemonstration() {
  const std::string path = ResourcePath("lessons/demonstration.toml");
  return ParseDemonstration(ReadTextFile(path, kMostBytes), path);
}

}  // namespace moontrace
