#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/glm.hpp>
#include <limits>

#include "devices/core/device_error.h"
#include "devices/core/profile.h"
#include "devices/core/toml_file.h"
#include "textures/base/enum_names.h"
#include "textures/base/nearest_word.h"
#include "textures/base/units.h"

namespace moontrace {
namespace {

constexpr std::size_t kMostIds = 64;

/// A number of the file, in the file's unit.
struct Number {
  const char* key;
  double* value;
  double unit;         ///< SI per unit of the file
  double least, most;  ///< in the file's unit
  bool needed = false;
};

/// Three numbers, one an axis.
struct Triple {
  const char* key;
  double* value;  ///< the first of three
  double unit;
  double least, most;
};

constexpr std::string_view NameOf(DeviceKind kind) {
  switch (kind) {
    case DeviceKind::kPid:
      return "pid";
    case DeviceKind::kWoodenHaptics:
      return "wooden-haptics";
    case DeviceKind::kRawHid:
      return "raw-hid";
    case DeviceKind::kPuck:
      return "puck";
    case DeviceKind::kPlugin:
      return "plugin";
  }
  return {};
}

/// The table of a kind's own keys, or nothing.
std::string_view TableOf(DeviceKind kind) {
  switch (kind) {
    case DeviceKind::kPid:
      return "stick";
    case DeviceKind::kWoodenHaptics:
      return "arm";
    case DeviceKind::kPuck:
      return "puck";
    case DeviceKind::kRawHid:
    case DeviceKind::kPlugin:
      break;
  }
  return {};
}

struct AxisName {
  const char* name;
  std::uint16_t usage;  ///< USB HID Usage Tables, generic desktop page
};
constexpr AxisName kAxes[] = {{"x", 0x30},      {"y", 0x31},    {"z", 0x32},
                              {"rx", 0x33},     {"ry", 0x34},   {"rz", 0x35},
                              {"slider", 0x36}, {"dial", 0x37}, {"wheel", 0x38}};

/// Reads one file; every complaint names the file and the place.
class Reader {
 public:
  explicit Reader(std::string name) : name_(std::move(name)) {}

  [[noreturn]] void Fail(const toml::source_region& where, const std::string& what) const {
    throw DeviceError(
        fmt::format("{}:{}:{}: {}", name_, where.begin.line, where.begin.column, what));
  }

  const toml::node& Require(const toml::table& table, const char* key) const {
    const toml::node* node = table.get(key);
    if (node == nullptr) Fail(table.source(), fmt::format("{} is missing: add it", key));
    return *node;
  }

  void CheckKeys(const toml::table& table, const std::vector<std::string>& known) const {
    for (auto it = table.begin(); it != table.end(); ++it) {
      const std::string key(it->first.str());
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      const std::string nearest = NearestName(key, known);
      std::string names;
      for (const std::string& name : known) names += (names.empty() ? "" : ", ") + name;
      Fail(it->first.source(), fmt::format("unknown key '{}': {}", key.substr(0, 40),
                                           nearest.empty() ? "the keys are " + names
                                                           : "did you mean " + nearest + "?"));
    }
  }

  double NumberAt(const toml::node& node, const char* key, double least, double most) const {
    const double value = node.is_number() ? node.value_or(std::nan("")) : std::nan("");
    if (!(value >= least && value <= most)) {
      Fail(node.source(),
           fmt::format("{} is not a number from {} to {}: give one", key, least, most));
    }
    return value;
  }

  std::int64_t WholeAt(const toml::node& node, const char* key, std::int64_t most) const {
    const std::int64_t value = node.is_integer() ? node.value_or(std::int64_t{-1}) : -1;
    if (value < 0 || value > most) {
      Fail(node.source(),
           fmt::format("{} is not a whole number from 0 to {}: give one", key, most));
    }
    return value;
  }

  std::string TextAt(const toml::node& node, const char* key) const {
    if (!node.is_string()) Fail(node.source(), fmt::format("{} is no text: put it in quotes", key));
    return node.value_or(std::string());
  }

  void ReadNumbers(const toml::table& table, const std::vector<Number>& numbers) const {
    for (const Number& number : numbers) {
      const toml::node* node = table.get(number.key);
      if (node == nullptr && !number.needed) continue;
      *number.value =
          number.unit * NumberAt(Require(table, number.key), number.key, number.least, number.most);
    }
  }

  void ReadTriples(const toml::table& table, const std::vector<Triple>& triples) const {
    for (const Triple& triple : triples) {
      const toml::node& node = Require(table, triple.key);
      const toml::array* array = node.as_array();
      if (array == nullptr || array->size() != 3) {
        Fail(node.source(), fmt::format("{} is no list of three numbers: give one", triple.key));
      }
      for (std::size_t i = 0; i < 3; ++i) {
        triple.value[i] =
            triple.unit * NumberAt(*array->get(i), triple.key, triple.least, triple.most);
      }
    }
  }

  const toml::table& TableAt(const toml::table& table, const char* key) const {
    const toml::node& node = Require(table, key);
    const toml::table* found = node.as_table();
    if (found == nullptr) Fail(node.source(), fmt::format("{} is no table: write [{}]", key, key));
    return *found;
  }

 private:
  std::string name_;
};

template <class Entries>
std::vector<std::string> KeysOf(const Entries& entries, std::vector<std::string> others) {
  for (const auto& entry : entries) others.emplace_back(entry.key);
  return others;
}

/// "x", "-slider": an axis and the direction in which it grows.
AxisMap ReadAxis(const Reader& reader, const toml::table& table, const char* key) {
  const toml::node& node = reader.Require(table, key);
  std::string text = reader.TextAt(node, key);
  AxisMap map;
  if (!text.empty() && text.front() == '-') {
    map.sign = -1;
    text.erase(0, 1);
  }
  for (const AxisName& axis : kAxes) {
    if (text == axis.name) {
      map.usage = axis.usage;
      return map;
    }
  }
  reader.Fail(
      node.source(),
      fmt::format("{} names no axis: give x, y, z, rx, ry, rz, slider, dial or wheel", key));
}

void ReadStick(const Reader& reader, const toml::table& table, StickMap& stick) {
  const std::vector<Number> numbers = {{"full_force_n", &stick.full_force, 1, 0.1, 200, true}};
  reader.CheckKeys(
      table, KeysOf(numbers, {"right_axis", "away_axis", "press", "press_button", "press_axis"}));
  reader.ReadNumbers(table, numbers);
  stick.right = ReadAxis(reader, table, "right_axis");
  stick.away = ReadAxis(reader, table, "away_axis");
  const toml::node& press = reader.Require(table, "press");
  const std::string presser = reader.TextAt(press, "press");
  if (presser == "setting") {
    stick.press = StickMap::Press::kSetting;
  } else if (presser == "button") {
    stick.press = StickMap::Press::kButton;
    stick.press_button =
        static_cast<int>(reader.WholeAt(reader.Require(table, "press_button"), "press_button", 31));
  } else if (presser == "axis") {
    stick.press = StickMap::Press::kAxis;
    stick.press_axis = ReadAxis(reader, table, "press_axis");
  } else {
    reader.Fail(press.source(), "press is none of \"setting\", \"button\", \"axis\": give one");
  }
}

void ReadArm(const Reader& reader, const toml::table& table, ArmGeometry& arm) {
  std::array<double, 3> body{}, capstan{};
  const std::vector<Triple> triples = {
      {"link_mm", arm.link.data(), 1e-3, 10, 1000},
      {"body_diameter_mm", body.data(), 1e-3, 1, 1000},
      {"capstan_diameter_mm", capstan.data(), 1e-3, 1, 1000},
      {"counts_per_turn", arm.counts.data(), 1, 1, 1e6},
      {"encoder_sign", arm.encoder_sign.data(), 1, -1, 1},
      {"current_sign", arm.current_sign.data(), 1, -1, 1},
      {"motor_constant_nm_per_a", arm.motor_constant.data(), 1, 1e-4, 10},
      {"origin_mm", &arm.origin_M.x, 1e-3, -1000, 1000},
      {"rest_deg", arm.rest.data(), kDegree, -180, 180},
  };
  const std::vector<Number> numbers = {{"peak_current_a", &arm.peak_current, 1, 0.01, 30, true}};
  reader.CheckKeys(table, KeysOf(triples, KeysOf(numbers, {"report_bytes"})));
  reader.ReadTriples(table, triples);
  reader.ReadNumbers(table, numbers);
  const toml::node& bytes = reader.Require(table, "report_bytes");
  arm.report_bytes = static_cast<std::size_t>(reader.WholeAt(bytes, "report_bytes", 64));
  if (arm.report_bytes != 8 && arm.report_bytes != 14 && arm.report_bytes != 64) {
    reader.Fail(bytes.source(), "report_bytes is none of 8, 14, 64: give one");
  }
  for (std::size_t i = 0; i < 3; ++i) {
    arm.reduction[i] = body[i] / capstan[i];
    if (std::abs(arm.encoder_sign[i]) != 1 || std::abs(arm.current_sign[i]) != 1) {
      reader.Fail(table.source(), "a sign is neither 1 nor -1: give one of them");
    }
  }
}

void ReadPuck(const Reader& reader, const toml::table& table, PuckMap& puck) {
  const std::vector<Number> numbers = {
      {"full_scale_counts", &puck.full_scale, 1, 1, 32767, true},
      {"dead_zone_counts", &puck.dead_zone, 1, 0, 32767, true},
      {"top_speed_mm_per_s", &puck.top_speed, 1e-3, 0.1, 1000, true},
  };
  const char* const axes[] = {"right_axis", "away_axis", "up_axis"};
  reader.CheckKeys(table, KeysOf(numbers, {axes[0], axes[1], axes[2]}));
  reader.ReadNumbers(table, numbers);
  for (std::size_t i = 0; i < 3; ++i) {
    const AxisMap map = ReadAxis(reader, table, axes[i]);
    if (map.usage > 0x32) {
      reader.Fail(table.source(), fmt::format("{} is none of x, y, z: give one", axes[i]));
    }
    puck.axis[i] = map.usage - 0x30;
    puck.sign[i] = map.sign;
  }
  if (puck.dead_zone >= puck.full_scale) {
    reader.Fail(table.source(), "dead_zone_counts is not below full_scale_counts: lower it");
  }
}

void ReadIds(const Reader& reader, const toml::table& table, std::vector<DeviceProfile::Id>& ids) {
  const toml::node* node = table.get("id");
  if (node == nullptr) return;
  const toml::array* array = node->as_array();
  if (array == nullptr || array->size() > kMostIds) {
    reader.Fail(node->source(),
                fmt::format("id is no list of at most {} tables: write [[id]]", kMostIds));
  }
  for (std::size_t i = 0; i < array->size(); ++i) {
    const toml::table* entry = array->get(i)->as_table();
    if (entry == nullptr) reader.Fail(array->get(i)->source(), "id is no table: write [[id]]");
    reader.CheckKeys(*entry, {"vendor", "product", "own"});
    const toml::node& own = reader.Require(*entry, "own");
    if (!own.is_boolean()) reader.Fail(own.source(), "own is neither true nor false: give one");
    ids.push_back({static_cast<std::uint16_t>(
                       reader.WholeAt(reader.Require(*entry, "vendor"), "vendor", 0xFFFF)),
                   static_cast<std::uint16_t>(
                       reader.WholeAt(reader.Require(*entry, "product"), "product", 0xFFFF)),
                   own.value_or(false)});
  }
}

/// "xyz", "xy", "": which axes.
glm::bvec3 ReadAxes(const Reader& reader, const toml::table& table, const char* key) {
  const toml::node& node = reader.Require(table, key);
  const std::string text = reader.TextAt(node, key);
  if (text.find_first_not_of("xyz") != std::string::npos) {
    reader.Fail(node.source(), fmt::format("{} is not made of x, y, z: write \"xyz\"", key));
  }
  for (const char axis : {'x', 'y', 'z'}) {
    if (std::count(text.begin(), text.end(), axis) > 1) {
      reader.Fail(node.source(), fmt::format("{} has {} twice: write it once", key, axis));
    }
  }
  return {text.find('x') != std::string::npos, text.find('y') != std::string::npos,
          text.find('z') != std::string::npos};
}

std::vector<Number> ProfileNumbers(DeviceProfile& profile) {
  DeviceLimits& limits = profile.limits;
  return {
      {"peak_force_n", &limits.peak_force, 1, 0, 100, true},
      {"continuous_force_n", &limits.continuous_force, 1, 0.01, 100},
      {"heat_time_s", &limits.heat_time, 1, 0.1, 1e5},
      {"peak_power_w", &limits.peak_power, 1, 0.01, 1000},
      {"force_rate_n_per_s", &limits.force_rate, 1, 3000, 1e6},
      {"stiffness_n_per_m", &limits.stiffness, 1, 1, 1e5, true},
      {"damping_ns_per_m", &limits.damping, 1, 0, 100, true},
      {"silence_ms", &limits.silence, 1e-3, 1, 10000, true},
      {"dead_man_ms", &limits.dead_man, 1e-3, 0, 60000, true},
      {"rate_hz", &profile.rate, 1, 10, 10000, true},
      {"delay_ms", &profile.delay, 1e-3, 0, 100, true},
      {"position_step_um", &profile.position_step, 1e-6, 0, 10000},
      {"force_step_mn", &profile.force_step, 1e-3, 0, 10000},
      {"coulomb_friction_n", &profile.coulomb_friction, 1, 0, 20},
      {"velocity_cutoff_hz", &profile.velocity_cutoff, 1, 0, 5000},
      {"read_mm", &profile.read_size, 1e-3, 0, 1000},
  };
}

DeviceKind ReadKind(const Reader& reader, const toml::table& table) {
  const toml::node& node = reader.Require(table, "kind");
  const std::optional<DeviceKind> kind = ValueNamed(reader.TextAt(node, "kind"), &NameOf);
  if (kind) return *kind;
  reader.Fail(node.source(),
              fmt::format("kind is none of {}: give one", fmt::join(AllNames(&NameOf), ", ")));
}

void CheckForces(const Reader& reader, const toml::table& table, const DeviceLimits& limits) {
  const bool heats = std::isfinite(limits.continuous_force);
  if (heats && limits.continuous_force > limits.peak_force) {
    reader.Fail(reader.Require(table, "continuous_force_n").source(),
                "continuous_force_n is above peak_force_n: lower it");
  }
  if (heats != (limits.heat_time > 0)) {
    reader.Fail(table.source(), "continuous_force_n and heat_time_s belong together: give both");
  }
  if (glm::any(limits.pushes) && !(limits.peak_force > 0)) {
    reader.Fail(reader.Require(table, "peak_force_n").source(),
                "peak_force_n is 0 though the device pushes: give its force");
  }
}

void ReadProfile(const Reader& reader, const toml::table& table, DeviceProfile& profile) {
  profile.kind = ReadKind(reader, table);
  const std::vector<Number> numbers = ProfileNumbers(profile);
  std::vector<std::string> known = {"title",  "kind",    "id",          "measures",
                                    "pushes", "buttons", "workspace_mm"};
  if (!TableOf(profile.kind).empty()) known.emplace_back(TableOf(profile.kind));
  reader.CheckKeys(table, KeysOf(numbers, known));
  profile.title = reader.TextAt(reader.Require(table, "title"), "title");
  ReadIds(reader, table, profile.ids);
  reader.ReadNumbers(table, numbers);
  profile.limits.measures = ReadAxes(reader, table, "measures");
  if (!profile.limits.measures.x || !profile.limits.measures.y) {
    reader.Fail(reader.Require(table, "measures").source(),
                "measures lacks x or y: a page is felt on devices that measure both");
  }
  profile.limits.pushes = ReadAxes(reader, table, "pushes");
  profile.limits.buttons =
      static_cast<int>(reader.WholeAt(reader.Require(table, "buttons"), "buttons", 32));
  if (table.get("workspace_mm") != nullptr) {
    // The file gives the whole extent, the limits the distance from the middle to each edge.
    reader.ReadTriples(table, {{"workspace_mm", &profile.limits.workspace_D.x, 0.5e-3, 1, 2000}});
  }
  CheckForces(reader, table, profile.limits);
  switch (profile.kind) {
    case DeviceKind::kPid:
      ReadStick(reader, reader.TableAt(table, "stick"), profile.stick);
      if (profile.stick.full_force < profile.limits.peak_force) {
        reader.Fail(reader.Require(table, "peak_force_n").source(),
                    "peak_force_n is above the stick's full_force_n: lower it");
      }
      break;
    case DeviceKind::kWoodenHaptics:
      ReadArm(reader, reader.TableAt(table, "arm"), profile.arm);
      break;
    case DeviceKind::kPuck:
      ReadPuck(reader, reader.TableAt(table, "puck"), profile.puck);
      break;
    case DeviceKind::kRawHid:
    case DeviceKind::kPlugin:
      break;  // no keys of their own
  }
}

}  // namespace

DeviceProfile ParseProfile(std::string_view text, const std::string& name) {
  const Reader reader(name);
  toml::table table;
  try {
    table = toml::parse(text);
  } catch (const toml::parse_error& error) {
    reader.Fail(error.source(), fmt::format("{}: correct the TOML", error.description()));
  }
  DeviceProfile profile;
  profile.name = std::filesystem::path(name).stem().string();
  ReadProfile(reader, table, profile);
  return profile;
}

DeviceProfile LoadProfile(const std::string& path) {
  return ParseProfile(ReadTomlFile(path, "a device's"), path);
}

}  // namespace moontrace
