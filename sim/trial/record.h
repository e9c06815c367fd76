#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "devices/core/device.h"
#include "lessons/guide/guidance.h"
#include "sim/physics/scene.h"
#include "sim/physics/scene_push.h"

namespace moontrace {

/// One tick as recorded: inputs, then outputs, one row of `samples.f64`. Columns are named in
/// trial.json.
struct RecordRow {
  DeviceState input;
  TickResult output;
  double phase = 0;    ///< TracePhase as a number
  double stroke = -1;  ///< intended stroke, -1 in the air
};

/// What a record says of itself besides the samples. `parameters_json` holds the caller's own
/// parameters (text, script, style, plan), enough to build page and field again.
struct RecordHead {
  std::string parameters_json;
  std::uint64_t field_hash = 0;
  std::uint64_t seed = 0;
  std::string subject_kind = "simulated";
};

/// Throws as Recorder does where the folder is not empty, before any work is done.
void CheckRecordFolder(const std::string& folder);

/// Writes a trial folder: trial.json, model.xml, samples.f64, events.jsonl (design section 5).
/// Writes to a sibling folder `DIR.partial` and renames on Finish: nothing half-written is left
/// under the final name, not even by a power cut, and a failed recording is removed. What a killed
/// one left in `DIR.partial` is replaced; one that runs holds a lock on it. Throws LackError
/// (unwritable folder, full disk: what, where) and InputError (the folder exists and is not empty,
/// another recording runs, `DIR.partial` holds what no recording wrote). Add is called between
/// ticks, never in one.
class Recorder {
 public:
  Recorder(const std::string& folder, const RecordHead& head, const Scene& scene);
  ~Recorder();
  void Add(const RecordRow& row);
  void AddEvent(double time, const std::string& what, const std::string& detail);
  /// Closes with the results (JSON text) and the digests of every file.
  void Finish(const std::string& result_json, bool also_csv);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// A record read back and checked: sizes, digests, columns. Throws InputError: missing, cut short,
/// altered.
struct Record {
  RecordHead head;
  SceneOptions options;
  std::string model_xml;
  std::vector<double> state;  ///< Scene::State at the first tick
  std::vector<RecordRow> rows;
  std::string result_json;
  std::string made_by;  ///< program, compiler, MuJoCo, processor, one line
  /// With `tolerant`: the line about altered samples that would have been thrown, else empty.
  std::string altered;
};
/// With `tolerant` an altered samples file is let through, so that a check can name the tick.
/// Replay compares what Scene::Tick computed; only `altered` reports other changes.
Record ReadRecord(const std::string& folder, bool tolerant = false);

/// Runs the recorded inputs through a scene again, with the push that was recorded within the
/// forces (nullptr: none), and with the model's other labels. `first_difference` is the first tick
/// whose outputs are not equal to the bit, or rows.size(). Throws InputError: `field` is not the
/// recorded one (hash), the model does not load, the state is another program's.
struct ReplayResult {
  std::size_t ticks = 0;
  std::size_t first_difference = 0;
  std::string column;  ///< first that differs, by its name in samples.f64
};
ReplayResult Replay(const Record& record, const TextureField& field,
                    const GuidancePlan* push = nullptr, const TickWatch& watch = {},
                    const std::vector<LaidLabel>& others = {});

}  // namespace moontrace
