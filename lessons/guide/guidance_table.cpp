#include "lessons/guide/guidance_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "textures/base/error.h"
#include "textures/base/resources.h"
#include "textures/base/text_file.h"
#include "textures/base/toml_reader.h"

namespace moontrace {

namespace {

constexpr std::size_t kGreatestBytes = 1 << 16;

/// A column of a mode: ten numbers, help 1 to 10.
struct Column {
  const char* key;
  double GuidanceGains::*member;
  double least, most;  ///< accepted
  bool grows;          ///< with help; otherwise it shrinks
};
constexpr Column kStiffness = {"stiffness_n_per_m", &GuidanceGains::stiffness, 20, 400, true};
constexpr Column kDamping = {"damping_ns_per_m", &GuidanceGains::damping, 0, 10, true};
constexpr Column kDeadZone = {"dead_zone_widths", &GuidanceGains::dead_zone_widths, 0, 5, false};
constexpr Column kCue = {"cue_amplitude_n", &GuidanceGains::cue_amplitude, 0.01, 1, true};

double NumberWithin(const TomlTable& table, const std::string& key, double least, double most) {
  const double value = table.Number(key);
  if (value < least || value > most) {
    table.Fail(key,
               fmt::format("{} is not from {} to {}; give a number there", value, least, most));
  }
  return value;
}

template <class Levels>
void ReadColumn(const TomlTable& table, const Column& column, Levels& levels) {
  const std::vector<double> values = table.Numbers(column.key);
  if (values.size() != kMostHelp) {
    table.Fail(column.key, fmt::format("{} numbers; give {}, for help 1 to {}", values.size(),
                                       kMostHelp, kMostHelp));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double value = values[i];
    if (value < column.least || value > column.most) {
      table.Fail(column.key, fmt::format("{} is not from {} to {}; give a number there", value,
                                         column.least, column.most));
    }
    const double step = i == 0 ? 0 : value - values[i - 1];
    if (column.grows ? step < 0 : step > 0) {
      table.Fail(column.key, fmt::format("{} after {}; numbers may only {}", value, values[i - 1],
                                         column.grows ? "grow" : "shrink"));
    }
    levels[i + 1].*column.member = value;
  }
  // help 0 has no force; the lengths go on evenly to there
  levels[0].*column.member = column.grows ? 0 : levels[1].*column.member;
}

GuidanceGains ReadCommon(const TomlTable& table) {
  GuidanceGains gains;
  gains.cap = NumberWithin(table, "cap_n", 0.05, GuidanceTable::kHardCap);
  gains.bead_speed = 1e-3 * NumberWithin(table, "bead_speed_mm_s", 1, 500);
  gains.leash_widths = NumberWithin(table, "leash_widths", 0.5, 20);
  table.FailUnknown();
  return gains;
}

FadeRule ReadFade(const TomlTable& table) {
  FadeRule rule;
  rule.linear_step = NumberWithin(table, "linear_step", 0, kMostHelp);
  const std::int64_t good = table.Integer("gate_good");
  if (good < 1 || good > 100) table.Fail("gate_good", "is not from 1 to 100; give a number there");
  rule.gate_good = static_cast<int>(good);
  rule.forgetting = NumberWithin(table, "forgetting", 0, 0.999);
  rule.gain = NumberWithin(table, "gain", 0, 100);
  rule.dead_zone = NumberWithin(table, "dead_zone_widths", 0, 5);
  table.FailUnknown();
  return rule;
}

/// Between two levels: all members but the cap by their shares.
GuidanceGains Mixed(const GuidanceGains& a, const GuidanceGains& b, double share) {
  GuidanceGains gains = a;
  for (const Column* column : {&kStiffness, &kDamping, &kDeadZone, &kCue}) {
    double& value = gains.*column->member;
    value += share * (b.*column->member - value);
  }
  return gains;
}

}  // namespace

GuidanceTable GuidanceTable::Load(const std::string& path) {
  return Parse(ReadTextFile(path, kGreatestBytes), path);
}

GuidanceTable GuidanceTable::Parse(std::string_view text, const std::string& name) {
  const TomlTable file = TomlTable::Parse(text, name);
  GuidanceTable table;
  const GuidanceGains common = ReadCommon(file.Table("common"));
  for (Levels& levels : table.levels_) levels.fill(common);
  const auto read = [&](GuidanceMode mode, const std::vector<Column>& columns) {
    const TomlTable section = file.Table(std::string(NameOf(mode)));
    Levels& levels = table.levels_[static_cast<std::size_t>(mode)];
    for (const Column& column : columns) ReadColumn(section, column, levels);
    section.FailUnknown();
  };
  read(GuidanceMode::kAttract, {kStiffness, kDamping, kDeadZone});
  read(GuidanceMode::kRail, {kStiffness, kDamping});
  read(GuidanceMode::kBead, {kStiffness, kDamping});
  read(GuidanceMode::kAmplify, {kStiffness});
  read(GuidanceMode::kCorridor, {kDeadZone, kCue});
  table.fade_ = ReadFade(file.Table("fade"));
  file.FailUnknown();
  return table;
}

GuidanceTable GuidanceTable::Shipped() { return Load(ResourcePath("lessons/guidance.toml")); }

GuidanceGains GuidanceTable::GainsOf(GuidanceMode mode, double help) const {
  const Levels& levels = levels_[static_cast<std::size_t>(mode)];
  const double held = help > 0 ? std::min(help, static_cast<double>(kMostHelp)) : 0;
  const auto below = static_cast<std::size_t>(held);
  if (below >= kMostHelp) return levels[kMostHelp];
  return Mixed(levels[below], levels[below + 1], held - static_cast<double>(below));
}

FadeRule FadeRuleNamed(const FadeSettings& settings) {
  static const FadeRule shipped = GuidanceTable::Shipped().fade();
  const std::optional<FadeRule::Kind> kind = FadeKindOf(settings.rule);
  if (!kind) {
    throw InputError(
        fmt::format("fade rule '{:.40}' is none; use one of {}", settings.rule, kFadeRules));
  }
  FadeRule rule = shipped;
  rule.kind = *kind;
  return rule;
}

}  // namespace moontrace
