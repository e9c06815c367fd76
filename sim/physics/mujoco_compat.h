#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <string>

namespace moontrace {

/// Everything that differs between MuJoCo 2.2.2 (Debian 12) and 3.x, and what replaces two
/// process-wide defaults of MuJoCo: to wait for Enter after an error, which a blind person cannot
/// see, and to write a log file into the user's folder.

/// What is lent is left to who lends it.
struct DeleteModel {
  bool lent = false;
  void operator()(mjModel* m) const noexcept {
    if (!lent) mj_deleteModel(m);
  }
};
struct DeleteData {
  bool lent = false;
  void operator()(mjData* d) const noexcept {
    if (!lent) mj_deleteData(d);
  }
};
using ModelPtr = std::unique_ptr<mjModel, DeleteModel>;
using DataPtr = std::unique_ptr<mjData, DeleteData>;

/// Sets MuJoCo's error and warning handlers unless the program already has its own: a warning is
/// kept silent (the scene reads MuJoCo's counters), an error writes one line to stderr and ends the
/// process at once: MuJoCo is C and must neither be thrown nor jumped through, and it promises
/// nothing after an error. Exit code 3 while `loading` names a model, else 4.
void QuietMujoco();

/// Compiles MJCF text through MuJoCo's virtual file system. `path` stands for the text: the files
/// it names are looked for beside it. Any thread; one at a time. Throws InputError of one line that
/// begins with `name`. What MuJoCo warned of is put into `warning`, one line.
ModelPtr CompileMjcf(const std::string& xml, const std::string& path, const std::string& name,
                     std::string& warning);

/// New data for a model. Throws InputError if there is no memory for it.
DataPtr MakeData(const mjModel& m, const std::string& name);

/// With what a geom collides, in the geom and, from 3.0 on, in its body's summary.
void SetCollision(mjModel& m, int geom, int contype, int conaffinity) noexcept;

/// Turns sleeping off (MuJoCo 3.4 on): forces on a sleeping body are lost. True if it was on.
bool KeepAwake(mjModel& m) noexcept;

/// Turns off those stages of MuJoCo's step that have nothing to work on in this model, as a page
/// and a proxy alone give none: constraints where contacts are off and there are no limits,
/// equalities, tendons and dry friction; passive forces where there are no springs, dampers and
/// fluid; sensors where there are none. A step gives the same state, bit for bit, in less time.
/// What the model asks for stays as it is.
void SkipIdleStages(mjModel& m) noexcept;

/// Whether a connect or weld ties sites, as MuJoCo 3.2 and later can, instead of bodies.
bool TiesSites(const mjModel& m, int equality) noexcept;

/// The bytes of a model's texture, red, green, blue, rows from the top down, to be changed before
/// mjr_uploadTexture; the texture has three channels.
unsigned char* TextureBytes(mjModel& m, int texture) noexcept;

/// Stretches a drawn arrow, line or capsule between two points of the world [m]. `width` [m], of
/// lines in pixels.
void Connect(mjvGeom& geom, int type, double width, const double from[3], const double to[3]);

/// Half of a picture's width on the near plane of a camera that draws it [m]; `aspect`: its width
/// over its height.
double HalfWidthOf(const mjvGLCamera& camera, double aspect) noexcept;
/// Whether a camera draws without perspective, as those of 3.1 and later can.
bool IsOrthographic(const mjvGLCamera& camera) noexcept;
/// Whether a light comes from one direction, not from one point.
bool IsDirectional(const mjvLight& light) noexcept;

/// Whether a drawn geom may have a texture: newer ones only know their material.
bool MayHaveTexture(const mjvGeom& geom) noexcept;

/// The first geom that a ray meets, of those in the shown groups, and how far it is [in lengths of
/// `along`]; -1, -1: none.
struct RayHit {
  int geom = -1;
  double distance = -1;
};
RayHit FirstOnRay(const mjModel& m, const mjData& d, const double from[3], const double along[3]);
/// How far a ray runs to one geom [in lengths of `along`]; -1: it misses.
double DistanceOnRay(const mjModel& m, const mjData& d, int geom, const double from[3],
                     const double along[3]);

}  // namespace moontrace
