#include "sim/app/bench_command.h"

#include <nlohmann/json.hpp>

#include "sim/app/messages.h"
#include "sim/bench/row.h"

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

void AddOptions(CLI::App& app, BenchOptions& options) { AddOptions(app, options.output); }

int Run(const BenchOptions& options, Console& console) {
  Json rows = Json::array();
  std::size_t bars = 0, missed = 0;
  for (BenchRows (*part)() : {BenchField, BenchPaper, BenchPhysics, BenchTracing}) {
    for (const BenchRow& row : part()) {
      rows.push_back(RowJson(row));
      if (!options.output.json) console.Result(say::BenchLine(row));

      bars += row.holds ? 1 : 0;
      missed += row.holds && !*row.holds ? 1 : 0;
    }
    if (console.stop() != nullptr && *console.stop()) throw Interrupted();
  }
  if (options.output.json) {
    console.Json(rows.dump(2));
  } else {
    console.Result(say::BenchOutcome(bars, missed));
  }
  return exit_code::kGood;
}

}  // namespace moontrace
