#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/physics/build_info.h"
#include "sim/trial/record.h"

namespace moontrace {

/// A running digest of samples.f64 is kept after so many ticks, so that a check can name the region
/// that was altered.
inline constexpr std::size_t kDigestEvery = 1000;
/// The longest record: two hours twenty at 1 kHz. Keeps what a reader must hold below 2 GB.
inline constexpr std::size_t kGreatestTicks = std::size_t{1} << 23;
/// The greatest trial.json and model.xml.
inline constexpr std::size_t kGreatestTextBytes = std::size_t{64} << 20;
/// The greatest events.jsonl.
inline constexpr std::size_t kGreatestEventBytes = std::size_t{1} << 30;

/// What trial.json holds (schema version 1). Everything but the samples, the model and the events.
struct TrialSheet {
  RecordHead head;
  SceneOptions options;
  std::vector<double> state;  ///< Scene::State before the first tick, finite
  BuildInfo build;
  std::string start_time_utc;  ///< ISO 8601, "2025-01-31T12:00:00Z"
  std::size_t ticks = 0;
  std::vector<std::uint64_t> sample_digests;  ///< running, every kDigestEvery ticks and at the end
  std::uint64_t model_digest = 0;
  std::uint64_t events_digest = 0;
  std::uint64_t csv_digest = 0;  ///< valid if `has_csv`
  bool has_csv = false;
  std::string result_json = "{}";
  /// Whether the file's own digest holds: over its compact JSON text with sorted keys, without that
  /// one member. Set by ParseTrial.
  bool digest_holds = false;
};

/// The text of trial.json. Numbers are written so that they read back equal to the bit. Throws
/// InputError: parameters or results are not a JSON object or too large, a state that is not
/// finite.
std::string FormatTrial(const TrialSheet& sheet);

/// Reads the text of trial.json; `where` stands in messages. Bounded in nesting and values. Throws
/// InputError: not JSON (line, column), another schema version, missing or foreign columns, a
/// missing or senseless value.
TrialSheet ParseTrial(std::string_view text, const std::string& where);

/// One line of events.jsonl, newline included.
std::string FormatEvent(double time, const std::string& what, const std::string& detail);

}  // namespace moontrace
