#include "devices/hand/hand.h"

#include <fmt/core.h>

#include <toml++/toml.h>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>

#include "devices/core/toml_file.h"

namespace moontrace {
namespace {

/// A key of the file, in the file's unit.
struct Key {
  const char* name;
  double HandModel::*member;
  double unit;   ///< SI per unit of the file
  double least;  ///< accepted range, in the file's unit
  double most;
};
constexpr Key kKeys[] = {
    {"mass_kg", &HandModel::mass, 1, 1e-3, 10},
    {"stiffness_n_per_m", &HandModel::stiffness, 1, 1, 1e5},
    {"damping_ns_per_m", &HandModel::damping, 1, 1e-3, 1e3},
    {"press_n", &HandModel::press, 1, 0.01, 20},
    {"light_press_n", &HandModel::light_press, 1, 0.01, 20},
    {"tremor_rms_mm", &HandModel::tremor_rms, 1e-3, 0, 10},
    {"tremor_low_hz", &HandModel::tremor_low, 1, 0.1, 100},
    {"tremor_high_hz", &HandModel::tremor_high, 1, 0.1, 100},
    {"drift_share", &HandModel::drift, 1, 0, 1},
    {"drift_wavelength_mm", &HandModel::drift_wavelength, 1e-3, 1, 1e5},
};
constexpr const char* kLateTicks = "late_ticks";
constexpr int kMostLateTicks = 100;

[[noreturn]] void Fail(const std::string& name, const toml::source_region& where,
                       const std::string& what) {
  throw std::runtime_error(
      fmt::format("{}:{}:{}: {}", name, where.begin.line, where.begin.column, what));
}

const toml::node& Require(const toml::table& table, const char* key, const std::string& name) {
  const toml::node* node = table.get(key);
  if (node == nullptr) {
    throw std::runtime_error(fmt::format("{}: {} is missing: add it with a number", name, key));
  }
  return *node;
}

void CheckKeysKnown(const toml::table& table, const std::string& name) {
  std::string known = kLateTicks;
  for (const Key& key : kKeys) known += fmt::format(", {}", key.name);
  for (auto it = table.begin(); it != table.end(); ++it) {
    const std::string_view found = it->first.str();
    bool is_known = found == kLateTicks;
    for (const Key& key : kKeys) is_known = is_known || found == key.name;
    if (!is_known) {
      Fail(name, it->first.source(),
           fmt::format("unknown key '{}': the keys are {}", found.substr(0, 40), known));
    }
  }
}

double ReadNumber(const toml::table& table, const Key& key, const std::string& name) {
  const toml::node& node = Require(table, key.name, name);
  const double value = node.is_number() ? node.value_or(std::nan("")) : std::nan("");
  if (!(value >= key.least && value <= key.most)) {
    Fail(name, node.source(),
         fmt::format("{} is not a number from {} to {}: give one", key.name, key.least, key.most));
  }
  return value * key.unit;
}

int ReadLateTicks(const toml::table& table, const std::string& name) {
  const toml::node& node = Require(table, kLateTicks, name);
  const std::int64_t value = node.is_integer() ? node.value_or(std::int64_t{-1}) : -1;
  if (value < 0 || value > kMostLateTicks) {
    Fail(
        name, node.source(),
        fmt::format("{} is not a whole number from 0 to {}: give one", kLateTicks, kMostLateTicks));
  }
  return static_cast<int>(value);
}

}  // namespace

HandModel ParseHand(std::string_view text, const std::string& name) {
  toml::table table;
  try {
    table = toml::parse(text);
  } catch (const toml::parse_error& error) {
    Fail(name, error.source(), fmt::format("{}: correct the TOML", error.description()));
  }
  CheckKeysKnown(table, name);
  HandModel hand;
  for (const Key& key : kKeys) hand.*key.member = ReadNumber(table, key, name);
  hand.late_ticks = ReadLateTicks(table, name);
  if (hand.tremor_low >= hand.tremor_high) {
    Fail(name, Require(table, "tremor_low_hz", name).source(),
         "tremor_low_hz is not below tremor_high_hz: lower it");
  }
  return hand;
}

HandModel LoadHand(const std::string& path) {
  return ParseHand(ReadTomlFile(path, "a hand's"), path);
}

}  // namespace moontrace
