#include "sim/study/learner_model.h"

#include "textures/base/resources.h"
#include "textures/base/toml_reader.h"

namespace moontrace {
namespace {

double Held(const TomlTable& table, const char* key, double low, double high) {
  return InRange(table, key, table.Number(key), low, high);
}

TwoRates ReadMemory(const TomlTable& table) {
  TwoRates rates;
  rates.slow_retention = Held(table, "slow_retention", 0, 1);
  rates.slow_gain = Held(table, "slow_gain", 0, 1);
  rates.fast_retention = Held(table, "fast_retention", 0, 1);
  rates.fast_gain = Held(table, "fast_gain", 0, 1);
  rates.slow_days = Held(table, "slow_days", 1e-3, 1e5);
  rates.fast_days = Held(table, "fast_days", 1e-3, 1e5);
  table.FailUnknown();
  return rates;
}

TracingSkill ReadTracing(const TomlTable& table) {
  TracingSkill skill;
  skill.press = Held(table, "press_n", 0.01, 5);
  skill.speed = 1e-3 * Held(table, "speed_mm_s", 1, 500);
  skill.deviation = 1e-3 * Held(table, "deviation_mm", 0, 50);
  skill.deviation_share = Held(table, "deviation_share", 0, 1);
  skill.general_share = Held(table, "general_share", 0, 1);
  skill.restless_share = Held(table, "restless_share", 0, 1);
  skill.flank_share = Held(table, "flank_share", 0, 1);
  skill.dependence = Held(table, "dependence_share", 0, 1);
  skill.lessons_a_trial = static_cast<int>(Held(table, "lessons_a_trial", 0, 100));
  table.FailUnknown();
  return skill;
}

Exploration ReadExploration(const TomlTable& table) {
  Exploration plan;
  plan.press = Held(table, "press_n", 0.01, 5);
  plan.spacing_share = Held(table, "spacing_share", 0.02, 1);
  plan.margin_share = Held(table, "margin_share", 0, 1);
  plan.put_share = Held(table, "put_share", 0, 1);
  plan.unsure = 1e-3 * Held(table, "unsure_mm", 0, 20);
  plan.speed = 1e-3 * Held(table, "speed_mm_s", 1, 500);
  plan.speed_power = Held(table, "speed_power", 0, 2);
  plan.at_size = 1e-3 * Held(table, "at_size_mm", 1, 100);
  table.FailUnknown();
  return plan;
}

FeelingRule ReadFeeling(const TomlTable& table) {
  FeelingRule rule;
  rule.depth = Held(table, "depth_share", 0.01, 0.99);
  rule.gap = Held(table, "gap_share", 0.01, 2);
  rule.least_part = Held(table, "least_part_share", 0, 1);
  rule.blur_cells = Held(table, "blur_cells", 0, 5);
  rule.least_spread = Held(table, "least_spread_share", 0.01, 1);
  table.FailUnknown();
  return rule;
}

RecogniserRule ReadRecognition(const TomlTable& table) {
  RecogniserRule rule;
  rule.place_weight = Held(table, "place_weight", 0, 100);
  rule.spread_weight = Held(table, "spread_weight", 0, 100);
  rule.newest_share = Held(table, "newest_share", 0, 1);
  rule.memory_days = Held(table, "memory_days", 1e-3, 1e5);
  rule.same_at_least = Held(table, "same_at_least", 0, 1);
  rule.word_margin = Held(table, "word_margin", 0, 1);
  table.FailUnknown();
  return rule;
}

LearnerModel ReadLearner(const TomlTable& table) {
  LearnerModel model;
  model.memory = ReadMemory(table.Table("memory"));
  model.tracing = ReadTracing(table.Table("tracing"));
  model.exploration = ReadExploration(table.Table("exploration"));
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
