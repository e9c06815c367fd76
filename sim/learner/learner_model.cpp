#include "sim/learner/learner_model.h"

#include <fmt/format.h>

#include "textures/resources.h"
#include "textures/toml_reader.h"

namespace moontrace {
namespace {

double InRange(const TomlTable& table, const char* key, double low, double high) {
  const double value = table.Number(key);
  if (!(value >= low && value <= high)) {
    table.Fail(key, fmt::format("{:.6g} is out of range: give {:.6g} to {:.6g}", value, low, high));
  }
  return value;
}

TwoRates ReadMemory(const TomlTable& table) {
  TwoRates rates;
  rates.slow_retention = InRange(table, "slow_retention", 0, 1);
  rates.slow_gain = InRange(table, "slow_gain", 0, 1);
  rates.fast_retention = InRange(table, "fast_retention", 0, 1);
  rates.fast_gain = InRange(table, "fast_gain", 0, 1);
  rates.slow_days = InRange(table, "slow_days", 1e-3, 1e5);
  rates.fast_days = InRange(table, "fast_days", 1e-3, 1e5);
  table.FailUnknown();
  return rates;
}

TracingSkill ReadTracing(const TomlTable& table) {
  TracingSkill skill;
  skill.press = InRange(table, "press_n", 0.01, 5);
  skill.speed = 1e-3 * InRange(table, "speed_mm_s", 1, 500);
  skill.deviation = 1e-3 * InRange(table, "deviation_mm", 0, 50);
  skill.deviation_share = InRange(table, "deviation_share", 0, 1);
  skill.general_share = InRange(table, "general_share", 0, 1);
  skill.restless_share = InRange(table, "restless_share", 0, 1);
  skill.flank_share = InRange(table, "flank_share", 0, 1);
  skill.dependence = InRange(table, "dependence_share", 0, 1);
  skill.lessons_a_trial = static_cast<int>(InRange(table, "lessons_a_trial", 0, 100));
  table.FailUnknown();
  return skill;
}

Exploration ReadExploration(const TomlTable& table) {
  Exploration plan;
  plan.press = InRange(table, "press_n", 0.01, 5);
  plan.spacing_share = InRange(table, "spacing_share", 0.02, 1);
  plan.margin_share = InRange(table, "margin_share", 0, 1);
  plan.speed = 1e-3 * InRange(table, "speed_mm_s", 1, 500);
  plan.speed_power = InRange(table, "speed_power", 0, 2);
  plan.at_size = 1e-3 * InRange(table, "at_size_mm", 1, 100);
  plan.acceleration = InRange(table, "acceleration_m_s2", 0.01, 100);
  plan.height = 1e-3 * InRange(table, "height_mm", 0.1, 20);
  table.FailUnknown();
  return plan;
}

Proprioception ReadProprioception(const TomlTable& table) {
  Proprioception sense;
  sense.noise = 1e-3 * InRange(table, "noise_mm", 0, 20);
  sense.wander = InRange(table, "wander_s", 1e-3, 100);
  sense.height_noise = 1e-3 * InRange(table, "height_noise_mm", 0, 5);
  table.FailUnknown();
  return sense;
}

FeelingRule ReadFeeling(const TomlTable& table) {
  FeelingRule rule;
  rule.least_depth = 1e-3 * InRange(table, "least_depth_mm", 0, 5);
  rule.depth_share = InRange(table, "depth_share", 0.01, 0.99);
  rule.slope = InRange(table, "slope", 0.01, 10);
  rule.softness = InRange(table, "softness_mm_n", 0, 100) / 1e3;
  rule.least_force = InRange(table, "least_force_n", 1e-4, 1);
  rule.gap = InRange(table, "gap_share", 0.01, 2);
  rule.least_part = InRange(table, "least_part_share", 0, 1);
  rule.blur_cells = InRange(table, "blur_cells", 0, 5);
  rule.least_spread = InRange(table, "least_spread_share", 0.01, 1);
  table.FailUnknown();
  return rule;
}

RecogniserRule ReadRecognition(const TomlTable& table) {
  RecogniserRule rule;
  rule.place_weight = InRange(table, "place_weight", 0, 100);
  rule.spread_weight = InRange(table, "spread_weight", 0, 100);
  rule.newest_share = InRange(table, "newest_share", 0, 1);
  rule.memory_days = InRange(table, "memory_days", 1e-3, 1e5);
  rule.same_at_least = InRange(table, "same_at_least", 0, 1);
  rule.word_margin = InRange(table, "word_margin", 0, 1);
  table.FailUnknown();
  return rule;
}

LearnerModel ReadLearner(const TomlTable& table) {
  LearnerModel model;
  model.memory = ReadMemory(table.Table("memory"));
  model.tracing = ReadTracing(table.Table("tracing"));
  model.exploration = ReadExploration(table.Table("exploration"));
  model.proprioception = ReadProprioception(table.Table("proprioception"));
  model.feeling = ReadFeeling(table.Table("feeling"));
  model.recognition = ReadRecognition(table.Table("recognition"));
  table.FailUnknown();
  return model;
}

}  // namespace

LearnerModel LoadLearner(const std::string& path) { return ReadLearner(TomlTable::Read(path)); }

LearnerModel ParseLearner(std::string_view text, const std::string& name) {
  return ReadLearner(TomlTable::Parse(text, name));
}

LearnerModel ShippedLearner() { return LoadLearner(ResourcePath("lessons/learner.toml")); }

}  // namespace moontrace
