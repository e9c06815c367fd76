#pragma once

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "sim/library/stepping/moontrace_mujoco.h"
#include "sim/physics/scene.h"
#include "tests/library/library_fixture.h"
#include "tests/source_path.h"

namespace moontrace {

/// A folder of this test's own, removed at its end.
class OwnFolder {
 public:
  OwnFolder()
      : path_(
            std::filesystem::temp_directory_path() /
            ("moontrace-stepping-" + std::to_string(getpid()) + "-" + std::to_string(++number_))) {
    std::filesystem::create_directories(path_);
  }
  ~OwnFolder() { std::filesystem::remove_all(path_); }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  static inline int number_ = 0;
  std::filesystem::path path_;
};

inline std::string BytesOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A program's own model and data: those of a shipped model, with the proxy in it.
struct OwnModel {
  explicit OwnModel(const std::string& name) : OwnModel(name, {}) {}
  /// `change`: the model's text, changed.
  OwnModel(const std::string& name, const std::function<void(std::string&)>& change) {
    std::string xml = Scene::Load(SourcePath("models/" + name), {}).model_xml();
    if (change) change(xml);
    std::ofstream(path) << xml;
    char error[500] = "";
    m = mj_loadXML(path.c_str(), nullptr, error, sizeof error);
    EXPECT_NE(m, nullptr) << error;
    m->opt.timestep = 0.001;  // the program's tick
    d = mj_makeData(m);
  }
  ~OwnModel() {
    mj_deleteData(d);
    mj_deleteModel(m);
  }
  OwnModel(const OwnModel&) = delete;
  OwnModel& operator=(const OwnModel&) = delete;

  OwnFolder folder;
  std::string path = (folder / "own.xml").string();
  mjModel* m = nullptr;
  mjData* d = nullptr;
};

/// Options as a caller that was compiled like these tests gives them.
inline moontrace_scene_options SceneOptionsOf(const char* text = nullptr) {
  auto options = Sized<moontrace_scene_options>();
  options.mujoco = mjVERSION_HEADER;
  options.text = text;
  return options;
}

/// A scene that is closed at the end.
struct OpenScene {
  OpenScene(const OwnModel& own, const moontrace_scene_options& options) {
    EXPECT_EQ(moontrace_scene_open(own.m, own.d, &options, &scene), MOONTRACE_DONE)
        << moontrace_scene_message();
  }
  ~OpenScene() { moontrace_scene_close(scene); }
  OpenScene(const OpenScene&) = delete;
  OpenScene& operator=(const OpenScene&) = delete;
  moontrace_scene* scene = nullptr;
};

inline moontrace_scene_input HandAt(double x, double y, double z) {
  auto input = Sized<moontrace_scene_input>();
  input.position[0] = x;
  input.position[1] = y;
  input.position[2] = z;
  return input;
}

}  // namespace moontrace
