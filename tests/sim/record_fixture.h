#pragma once

#include <stdlib.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <iterator>
#include <string>
#include <utility>

#include "sim/physics/scene.h"
#include "sim/trial/record.h"
#include "textures/base/error.h"
#include "textures/field/field.h"

namespace moontrace::test {

/// A folder of its own for one test, gone with it.
class TempFolder {
 public:
  TempFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "record-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~TempFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

inline std::string ReadBytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline void WriteBytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

inline void FlipBit(const std::string& path, std::size_t byte, int bit) {
  std::string bytes = ReadBytes(path);
  bytes.at(byte) = static_cast<char>(static_cast<unsigned char>(bytes[byte]) ^ (1U << bit));
  WriteBytes(path, bytes);
}

/// The line of the exception of this kind, or "" when none comes.
template <typename Error>
std::string LineOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

inline constexpr glm::dvec2 kMiddle_P{0.105, 0.150};  ///< of the groove [m]

/// One straight groove of a 12 mm letter's profile, 40 mm long, in the middle of an A4 page.
inline TextureField GrooveField() {
  Group group;
  group.elements.push_back({Line{kMiddle_P - glm::dvec2(0.02, 0), kMiddle_P + glm::dvec2(0.02, 0)},
                            Profile{1.4e-3, 0.7e-3, 0.28e-3}});
  return TextureField(Texture{{Layer{Finish(std::move(group)), Relief::kEngraved}}});
}

/// A tip that presses about 1 mm into the page and circles across the groove, by closed forms.
inline DeviceState InputAt(std::size_t tick, const Pose& X_WP) {
  const double t = 0.001 * static_cast<double>(tick);
  const glm::dvec3 p_P(kMiddle_P.x + 4e-3 * std::sin(2.1 * t), kMiddle_P.y + 1e-3 * std::sin(9 * t),
                       -1e-3 + 4e-4 * std::sin(31 * t));
  DeviceState input;
  input.time = t;
  input.p_D = ToWorld(X_WP, p_P);
  input.buttons = tick % 1000 < 500 ? 0U : 5U;
  return input;
}

inline SceneOptions RubbingOptions() {
  SceneOptions options;
  options.friction = 0.1;
  options.tilt = 0.2;
  return options;
}

/// A scene at rest on the page where InputAt begins.
inline Scene SceneAtRest(const TextureField& field, const SceneOptions& options) {
  Scene scene = Scene::Load("", options);
  scene.SetField(&field);
  scene.Reset(FromWorld(scene.X_WP(), InputAt(0, scene.X_WP()).p_D));
  return scene;
}

inline RecordHead HeadFor(const TextureField& field) {
  RecordHead head;
  head.parameters_json = R"({"size_mm":12,"text":"MOON"})";
  head.field_hash = field.Hash();
  head.seed = 18446744073709551615U;  // the greatest: a double would lose it
  return head;
}

/// Records ticks [begin, end) of InputAt from the state that the scene is in. Returns the rows.
inline std::vector<RecordRow> RecordTicks(const std::string& folder, const TextureField& field,
                                          Scene& scene, std::size_t begin, std::size_t end,
                                          bool also_csv = false) {
  Recorder recorder(folder, HeadFor(field), scene);
  std::vector<RecordRow> rows;
  const Pose X_WP = scene.X_WP();
  for (std::size_t tick = begin; tick < end; ++tick) {
    RecordRow row;
    row.input = InputAt(tick, X_WP);
    row.output = scene.Tick(row.input);
    row.phase = 2;
    row.stroke = static_cast<double>(tick / 100);
    recorder.Add(row);
    rows.push_back(row);
    if (tick % 500 == 0) recorder.AddEvent(row.input.time, "half second", "tick \"quoted\"");
  }
  recorder.Finish(R"({"coverage":0.5})", also_csv);
  return rows;
}

}  // namespace moontrace::test
