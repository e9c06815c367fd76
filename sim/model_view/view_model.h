#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "sim/physics/label_place.h"
#include "sim/physics/mujoco_compat.h"
#include "sim/physics/scene.h"
#include "sim/physics/scene_pose.h"

namespace moontrace {

/// A MuJoCo model with its labels as a viewer shows it; never changed once it is made, shared by
/// threads.
struct ViewModel {
  struct Label {
    std::string name;  ///< as NameOf has it
    std::string text;
    int geom = -1;    ///< that it lies on
    int drawn = -1;   ///< that is seen there: another one where a solid was fitted to a mesh
    double lift = 0;  ///< of what is drawn over it, so far the mesh may lie off [m]
    Solid solid;
    LabelChart chart;
    std::shared_ptr<const TextureField> field;  ///< null: blank, or that of the page
    Box text_P;                                 ///< what its text covers [m]
  };
  ModelPtr m;  ///< its own
  std::vector<Label> labels;
  std::size_t page = 0;              ///< the label that is the page P
  int proxy_body = -1;               ///< moontrace_proxy
  int handle_body = -1, mocap = -1;  ///< moontrace_handle; -1: none
  ScenePose start;
};

/// What a scene shows, its labels laid; `others` as the scene was given them, `text` of the page.
std::shared_ptr<const ViewModel> MakeViewModel(const Scene& scene,
                                               const std::vector<LaidLabel>& others,
                                               std::string_view text);

/// The same where another label is the page. `before`: what is felt on the one that was; `label`
/// and `page`: of the one that is, which has `text`.
std::shared_ptr<const ViewModel> WithPage(const ViewModel& model, const LaidLabel& before,
                                          const Label& label, const LaidLabel& page,
                                          std::string_view text);

/// What one can look at.
struct ViewTarget {
  enum class Kind { kWhole, kTip, kCamera, kLabel, kGeom, kBody };
  Kind kind = Kind::kWhole;
  int number = 0;  ///< of the label in ViewModel::labels, else MuJoCo's
};

/// What a name means: "whole", "tip", a label, a geom, a body or a camera, in that order; a geom
/// that carries a label is that label. Throws InputError, one line that proposes the nearest.
ViewTarget FindTarget(const ViewModel& model, std::string_view name);

/// All such names but Moontrace's own, each once.
std::vector<std::string> TargetNames(const ViewModel& model);

/// A name as MuJoCo has it; empty: it has none. `type`: mjtObj.
std::string NameOf(const mjModel& m, int type, int number);

/// "cylinder" and so on.
const char* KindOfGeom(const mjModel& m, int geom);

}  // namespace moontrace
