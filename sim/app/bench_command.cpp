#include "sim/app/commands.h"

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "sim/app/messages.h"
#include "sim/bench/row.h"
#include "sim/setup/help.h"

namespace moontrace {

namespace {

using Json = nlohmann::ordered_json;

Json RowJson(const BenchRow& row) {
  Json json;
  json["name"] = row.name;
  json["value"] = row.value;
  json["unit"] = row.unit;
  json["bar"] = row.bar.empty() ? Json(nullptr) : Json(row.bar);
  json["holds"] = row.holds ? Json(*row.holds) : Json(nullptr);
  return json;
}

}  // namespace

void AddOptions(CLI::App& app, BenchOptions& options) {
  AddOptions(app, options.output);
  AddFlag(app, "--stability", options.stability, say::help::kStability);
  AddFlag(app, "--heat", options.heat, say::help::kHeat);
}

int Run(const BenchOptions& options, Console& console) {
  console.Remark(say::BenchBegins());
  BenchRows rows;
  std::vector<BenchRows (*)()> parts;
  if (options.stability) parts.push_back(BenchStability);
  if (options.heat) parts.push_back(BenchHeat);
  if (parts.empty()) {
    for (const auto part :
         {BenchField, BenchLibrary, BenchPhysics, BenchLabels, BenchTracing, BenchPaper}) {
      parts.push_back(part);
    }
  }
  for (const auto part : parts) {
    for (BenchRow& row : part()) rows.push_back(std::move(row));
    if (console.stop() != nullptr && *console.stop()) throw Interrupted();
  }
  if (options.output.json) {
    Json json = Json::array();
    for (const BenchRow& row : rows) json.push_back(RowJson(row));
    console.Json(json.dump(2));
    return exit_code::kGood;
  }
  std::size_t bars = 0, missed = 0;
  for (const BenchRow& row : rows) {
    bars += row.holds ? 1 : 0;
    missed += row.holds && !*row.holds ? 1 : 0;
  }
  console.Result(say::BenchOutcome(bars, missed));
  for (const BenchRow& row : rows) console.Result(say::BenchLine(row));
  // again at the end, which is what stands on the screen
  console.Result(say::BenchOutcome(bars, missed));
  return exit_code::kGood;
}

}  // namespace moontrace
