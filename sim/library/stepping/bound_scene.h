#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "sim/library/stepping/mujoco_errors.h"
#include "sim/physics/scene.h"

namespace moontrace {

/// A scene on a caller's model and data. What a scene sets in its model stands there only while one
/// of these functions runs, so that the caller has its own model between them. An error within
/// MuJoCo is answered, and from then on refused until Reset. One thread at a time for a model.
class BoundScene {
 public:
  /// `xml`: what the model was made of, for records; may be empty.
  BoundScene(mjModel_* m, mjData_* d, std::string xml) : m_(m), d_(d), xml_(std::move(xml)) {}
  BoundScene(const BoundScene&) = delete;
  BoundScene& operator=(const BoundScene&) = delete;

  /// Makes the scene, anew with other options: Scene::Bind. The tick is the model's time step.
  /// Throws as that, MujocoError.
  void Bind(SceneOptions options);
  /// Throws UsageError: these are not the model and data as they were bound, as far as it can be
  /// seen, or the time step is another.
  void Require(const mjModel_* m, const mjData_* d) const;

  /// Throws MujocoError, at once and until Reset after it was thrown once.
  TickResult Tick(const DeviceState& input);
  /// Throws MujocoError.
  void Reset(glm::dvec3 tip_P);
  /// Work on the scene in which MuJoCo runs, with the scene's settings in the model. Throws
  /// MujocoError.
  template <class Work>
  void Run(Work&& work);
  /// The same without MuJoCo; what `work` throws is thrown.
  template <class Work>
  void RunWithout(Work&& work);

  Scene& scene() { return *scene_; }
  const Scene& scene() const { return *scene_; }

 private:
  /// Of a model, that a scene changes.
  struct Settings {
    double timestep = 0, mean_inertia = 0;
    int jacobian = 0, disabled = 0, enabled = 0;
  };
  /// Which buffers a model and its data had: others are other ones.
  struct Identity {
    const void *of_model = nullptr, *of_data = nullptr;
    bool operator==(const Identity&) const = default;
  };
  class InPlace;
  Settings Read() const noexcept;
  void Write(const Settings& settings) noexcept;
  static Identity IdentityOf(const mjModel_& m, const mjData_& d) noexcept;
  [[noreturn]] void Broke();

  mjModel_* m_;
  mjData_* d_;
  std::string xml_;
  std::optional<Scene> scene_;
  Identity identity_;
  double tick_ = 0;      ///< [s]
  Settings own_;         ///< the scene's; of flags those that it sets, and all but what it clears
  bool broken_ = false;  ///< by an error within MuJoCo
};

/// The scene's settings in the model while this lives.
class BoundScene::InPlace {
 public:
  explicit InPlace(BoundScene& bound) noexcept : bound_(bound), callers_(bound.Read()) {
    // flags that the caller has set meanwhile hold
    bound_.Write({bound_.own_.timestep, bound_.own_.mean_inertia, bound_.own_.jacobian,
                  callers_.disabled | bound_.own_.disabled,
                  callers_.enabled & bound_.own_.enabled});
  }
  ~InPlace() {
    bound_.own_.timestep = bound_.Read().timestep;  // of the sub-steps that it is set for
    bound_.Write(callers_);
  }
  InPlace(const InPlace&) = delete;
  InPlace& operator=(const InPlace&) = delete;

 private:
  BoundScene& bound_;
  Settings callers_;
};

template <class Work>
void BoundScene::Run(Work&& work) {
  bool whole = false;
  {
    const InPlace settings(*this);
    whole = RunMujoco(work);
  }
  if (!whole) Broke();
}

template <class Work>
void BoundScene::RunWithout(Work&& work) {
  const InPlace settings(*this);
  work();
}

}  // namespace moontrace
