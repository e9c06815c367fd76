#include "sim/study/study_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "devices/catalogue/catalogue.h"
#include "lessons/guide/guidance.h"
#include "lessons/guide/guidance_path.h"
#include "lessons/guide/guidance_table.h"
#include "sim/reading/reading_setup.h"
#include "sim/study/simulated_learner.h"
#include "sim/study/size_threshold.h"
#include "sim/trial/trial.h"
#include "textures/base/error.h"
#include "textures/fonts/script_library.h"

namespace moontrace {
namespace {

LearnerModel ModelOf(const StudyProtocol& protocol) {
  LearnerModel model = protocol.learner.empty() ? ShippedLearner() : LoadLearner(protocol.learner);
  if (protocol.press) model.tracing.press = *protocol.press;
  return model;
}

std::optional<DeviceProfile> DeviceOf(const StudyProtocol& protocol) {
  if (protocol.device.empty()) return std::nullopt;
  DeviceProfile device = FindProfile(protocol.device, ProfilesFolder());
  if (protocol.staircase && !CanBeReadOn(device.limits, false)) {
    throw InputError(fmt::format(
        "{} does not measure and push all that exploring takes: name another device, or "
        "leave out [staircase]",
        protocol.device));
  }
  return device;
}

class StudyLearner {
 public:
  StudyLearner(const StudyProtocol& protocol, const StudyPlace& place)
      : protocol_(protocol),
        place_(place),
        condition_(protocol.conditions.at(place.condition)),
        trials_(TrialsOf(protocol, condition_, place.seed)),
        script_(FindScript(protocol.script)),
        table_(GuidanceTable::Shipped()),
        device_(DeviceOf(protocol)),
        // The seed alone: the same person in each condition.
        learner_(ModelOf(protocol), ShippedHand(), place.seed, device_ ? &*device_ : nullptr) {}

  void Run(const std::vector<StudyRow>& rows, const std::function<void(const StudyRow&)>& each) {
    for (std::size_t i = 0; i < trials_.size(); ++i) {
      const StudyTrial& trial = trials_[i];
      if (trial.day > learner_.day()) learner_.Wait(trial.day - learner_.day());
      if (i < rows.size()) {
        learner_.Relive(trial.letter, rows[i].felt_error);
      } else {
        each(Trace(trial, i + 1));
      }
    }
    if (protocol_.staircase && rows.size() <= trials_.size()) each(Threshold());
  }

 private:
  StudyRow Begin(const StudyTrial& trial, std::size_t number) const {
    StudyRow row;
    row.study = protocol_.digest;
    row.condition = condition_.name;
    row.seed = place_.seed;
    row.trial = number;
    row.given = trial;
    return row;
  }

  const ItemPage& Page(const std::string& letter, double size) {
    auto& page = pages_[{letter, size}];
    if (!page) {
      page = std::make_unique<ItemPage>(
          SetItem(letter, script_, size, {1, protocol_.groove_depth_share}));
    }
    return *page;
  }

  StudyRow Trace(const StudyTrial& trial, std::size_t number) {
    StudyRow row = Begin(trial, number);
    const ItemPage& page = Page(trial.letter, trial.size);
    GuidancePlan plan{trial.mode, table_.GainsOf(trial.mode, trial.help), nullptr};
    const bool pushed = trial.mode != GuidanceMode::kOff && trial.help > 0;
    if (pushed) plan.path = MakeGuidancePath(page.strokes);
    const TracedItem traced = learner_.Trace(trial.letter, page, pushed ? &plan : nullptr);
    const Trial& m = traced.measured;
    row.coverage = m.coverage;
    row.mean_error = m.mean_error;
    row.rms_error = m.rms_error;
    row.wander_offs = m.wander_offs;
    row.duration = m.duration;
    row.mean_force = m.mean_force;
    row.mean_guidance = m.mean_guidance;
    row.felt_error = traced.felt_error;
    if (!(m.duration > 0)) row.excluded = "the page was not touched";
    return row;
  }

  StudyRow Threshold() {
    const StudyStaircase& stairs = *protocol_.staircase;
    std::vector<std::string> letters = protocol_.letters;
    for (const std::string& letter : letters) {
      const ItemPage page = SetItem(letter, script_, stairs.start);
      for (int i = 0; i < stairs.lessons; ++i) {
        learner_.shapes().Remember(letter, learner_.Feel(page), learner_.day());
      }
    }
    StaircaseRule rule;
    rule.start = stairs.start;
    rule.least = stairs.least;
    rule.most = stairs.start;
    rule.down = stairs.down;
    rule.stop_trials = stairs.trials;
    const SizeThreshold found = FindSizeThreshold(
        learner_, script_, letters, rule, static_cast<std::size_t>(stairs.staircases), place_.seed);
    StudyRow row = Begin({"size-threshold", learner_.day(), "", 0}, trials_.size() + 1);
    row.given.size = found.size.value_or(0);
    if (!found.size) row.excluded = "no staircase turned often enough";
    row.coverage =
        found.trials > 0 ? static_cast<double>(found.right) / static_cast<double>(found.trials) : 0;
    return row;
  }

  const StudyProtocol& protocol_;
  StudyPlace place_;
  const StudyCondition& condition_;
  std::vector<StudyTrial> trials_;
  Script script_;
  GuidanceTable table_;
  std::optional<DeviceProfile> device_;
  SimulatedLearner learner_;
  std::map<std::pair<std::string, double>, std::unique_ptr<ItemPage>> pages_;
};

/// One page has one row.
StudyRow ReadStudyPage(const StudyProtocol& protocol, const StudyPlace& place,
                       const std::function<void()>& check) {
  const ReadingCell& cell = protocol.reading->cells.at(place.condition);
  StudyRow row;
  row.study = protocol.digest;
  row.condition = cell.name;
  row.seed = place.seed;
  row.trial = 1;
  const std::string text = SweepText(*protocol.reading, place.seed);
  row.page = StudyPage{cell, ReadPage(cell, text, place.seed, check)};
  return row;
}

}  // namespace

std::vector<StudyPlace> PlacesOf(const StudyProtocol& protocol, int shard, int shards) {
  std::vector<StudyPlace> places;
  std::size_t number = 0;
  for (std::size_t c = 0; c < protocol.conditions.size(); ++c) {
    // No shard has the same learners in each condition: that would look like a whole study.
    const std::size_t shift = protocol.learners % shards == 0 ? c : 0;
    for (int i = 0; i < protocol.learners; ++i) {
      const auto turn = static_cast<int>((number++ + shift) % static_cast<std::size_t>(shards));
      if (turn + 1 == shard) {
        places.push_back({c, protocol.first_seed + static_cast<std::uint64_t>(i)});
      }
    }
  }
  return places;
}

std::size_t RowsOf(const StudyProtocol& protocol, const StudyPlace& place) {
  if (protocol.reading) return 1;
  const std::size_t trials =
      TrialsOf(protocol, protocol.conditions.at(place.condition), place.seed).size();
  return trials + (protocol.staircase ? 1 : 0);
}

void RunStudyLearner(const StudyProtocol& protocol, const StudyPlace& place,
                     const std::vector<StudyRow>& rows,
                     const std::function<void(const StudyRow&)>& each,
                     const std::function<void()>& check) {
  for (const StudyRow& row : rows) {
    if (row.study != protocol.digest) {
      throw InputError("rows were made by another protocol: give another --output");
    }
  }
  if (rows.size() >= RowsOf(protocol, place)) return;
  if (protocol.reading) return each(ReadStudyPage(protocol, place, check));
  StudyLearner(protocol, place).Run(rows, each);
}

}  // namespace moontrace
