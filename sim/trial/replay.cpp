#include <fmt/core.h>

#include <bit>
#include <cstdint>
#include <optional>

#include "sim/trial/record.h"
#include "sim/trial/record_columns.h"
#include "textures/base/digest.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

/// The first output column whose bits differ, or kAfterOutputs. Bits, not values: minus zero is not
/// zero, and a NaN equals itself.
std::size_t FirstDifference(const RecordColumns& a, const RecordColumns& b) noexcept {
  for (std::size_t i = kFirstOutput; i < kAfterOutputs; ++i) {
    if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) return i;
  }
  return kAfterOutputs;
}

}  // namespace

ReplayResult Replay(const Record& record, const TextureField& field, const GuidancePlan* push,
                    const TickWatch& watch, const std::vector<LaidLabel>& others) {
  if (field.Hash() != record.head.field_hash) {
    throw InputError(fmt::format("record: page digest {} here, {} recorded: use the script of then",
                                 ToHex(field.Hash()), ToHex(record.head.field_hash)));
  }
  Scene scene = Scene::FromXml(record.model_xml, "the record's model.xml", record.options);
  scene.SetField(&field);
  for (const LaidLabel& other : others) scene.SetLabel(other);
  const std::size_t state_size = scene.State().size();
  if (record.state.size() != state_size) {
    throw InputError(
        fmt::format("record: the initial state has {} numbers, this program's {}; "
                    "replay it with {}",
                    record.state.size(), state_size, record.made_by));
  }
  scene.SetState(record.state);

  std::optional<ScenePush> pushing;
  if (push != nullptr) pushing.emplace(*push, record.options.tick);
  ReplayResult result;
  result.ticks = record.rows.size();
  result.first_difference = record.rows.size();
  for (std::size_t tick = 0; tick < record.rows.size(); ++tick) {
    RecordRow again = record.rows[tick];
    again.output = scene.Tick(again.input);
    GuidanceResult pushed;
    if (pushing) pushed = pushing->Add(scene.X_WP(), again.output);
    if (watch) watch(again.input.time, again.output, pushed, scene);
    const std::size_t column = FirstDifference(ToColumns(again), ToColumns(record.rows[tick]));
    if (column == kAfterOutputs) continue;
    result.first_difference = tick;
    result.column = kRecordColumns[column];
    break;
  }
  return result;
}

}  // namespace moontrace
