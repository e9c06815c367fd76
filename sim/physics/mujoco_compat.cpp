#include "sim/physics/mujoco_compat.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <type_traits>

#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

/// The model this thread is loading, for the error handler.
thread_local const char* loading = nullptr;

class Loading {
 public:
  explicit Loading(const std::string& name) { loading = name.c_str(); }
  ~Loading() { loading = nullptr; }
  Loading(const Loading&) = delete;
  Loading& operator=(const Loading&) = delete;
};

extern "C" void MoontraceMujocoError(const char* message) {
  const char* name = loading;
  const std::string text = OneLine(message, 300);
  if (name != nullptr) {
    std::fprintf(stderr, "%s: MuJoCo cannot load it: %s; make the model smaller or mend it\n", name,
                 text.c_str());
  } else {
    std::fprintf(stderr, "MuJoCo stopped: %s\n", text.c_str());
  }
  std::fflush(stderr);
  std::_Exit(name != nullptr ? 3 : 4);
}

extern "C" void MoontraceMujocoWarning(const char* /*message*/) {}

/// MuJoCo's message on one line: its lines joined by "; ".
std::string Joined(const char* message) {
  std::string joined;
  for (const char* c = message; *c != '\0'; ++c) {
    if (*c != '\n') {
      joined += *c;
    } else if (!joined.empty() && joined.back() != ' ') {
      joined += "; ";
    }
  }
  while (!joined.empty() && (joined.back() == ' ' || joined.back() == ';')) joined.pop_back();
  return OneLine(joined, 400);
}

struct DeleteVfs {
  void operator()(mjVFS* vfs) const noexcept {
    mj_deleteVFS(vfs);
    delete vfs;
  }
};

/// A virtual file system holding one file. On the heap: 2.2.2's mjVFS takes 2 MB.
std::unique_ptr<mjVFS, DeleteVfs> MakeVfs(const std::string& path, const std::string& xml) {
  auto bare = std::make_unique<mjVFS>();
  mj_defaultVFS(bare.get());
  std::unique_ptr<mjVFS, DeleteVfs> vfs(bare.release());
  const int size = static_cast<int>(xml.size());
#if mjVERSION_HEADER >= 313  // mj_addBufferVFS appeared in 3.1.3, the older functions went in 3.2.0
  const bool added = mj_addBufferVFS(vfs.get(), path.c_str(), xml.data(), size) == 0;
#else
  const bool added = mj_makeEmptyFileVFS(vfs.get(), path.c_str(), size) == 0;
  const int index = added ? mj_findFileVFS(vfs.get(), path.c_str()) : -1;
  if (index >= 0) std::memcpy(vfs->filedata[index], xml.data(), xml.size());
#endif
  if (!added) vfs.reset();
  return vfs;
}

/// The bytes have another name since 3.2.
template <class Model>
unsigned char* BytesOf(Model& m, int texture) noexcept {
  if constexpr (requires { m.tex_data; }) {
    return m.tex_data + m.tex_adr[texture];
  } else {
    return m.tex_rgb + m.tex_adr[texture];
  }
}

template <class Camera>
double HalfWidth(const Camera& camera, double aspect) noexcept {
  if constexpr (requires { camera.frustum_width; }) {
    if (camera.frustum_width > 0) return camera.frustum_width;
  }
  return 0.5 * aspect * (static_cast<double>(camera.frustum_top) - camera.frustum_bottom);
}

template <class Camera>
bool Orthographic(const Camera& camera) noexcept {
  if constexpr (requires { camera.orthographic; }) return camera.orthographic != 0;
  return false;
}

/// Lights of 3.3 and later have a type.
template <class Light>
bool Directional(const Light& light) noexcept {
  if constexpr (requires { light.directional; }) {
    return light.directional != 0;
  } else {
    return light.type == 1;  // mjLIGHT_DIRECTIONAL
  }
}

template <class Geom>
bool Textured(const Geom& geom) noexcept {
  if constexpr (requires { geom.texid; }) {
    return geom.texid >= 0;
  } else {
    return geom.matid >= 0;
  }
}

/// Newer functions that follow a ray also give the normal.
template <class Ray, class... Arguments>
double Follow(Ray ray, Arguments... arguments) {
  if constexpr (std::is_invocable_v<Ray, Arguments...>) {
    return ray(arguments...);
  } else {
    return ray(arguments..., nullptr);
  }
}

template <class Values>
bool AreZero(const Values* values, int count) noexcept {
  return std::all_of(values, values + count, [](Values value) { return value == 0; });
}

bool HasConstraints(const mjModel& m) noexcept {
  return (m.opt.disableflags & mjDSBL_CONTACT) == 0 || m.neq > 0 || m.ntendon > 0 ||
         !AreZero(m.jnt_limited, static_cast<int>(m.njnt)) ||
         !AreZero(m.dof_frictionloss, static_cast<int>(m.nv));
}

#if mjVERSION_HEADER < 230  // later ones have more passive forces than are looked for here
bool HasPassiveForces(const mjModel& m) noexcept {
  return m.ntendon > 0 || m.opt.density != 0 || m.opt.viscosity != 0 || mjcb_passive != nullptr ||
         !AreZero(m.jnt_stiffness, m.njnt) || !AreZero(m.dof_damping, m.nv);
}
#endif

}  // namespace

void QuietMujoco() {
  static std::once_flag once;
  std::call_once(once, [] {
    if (mju_user_error == nullptr) mju_user_error = MoontraceMujocoError;
    if (mju_user_warning == nullptr) mju_user_warning = MoontraceMujocoWarning;
  });
}

ModelPtr CompileMjcf(const std::string& xml, const std::string& path, const std::string& name,
                     std::string& warning) {
  // MuJoCo keeps the last model it read in a global
  static std::mutex one_at_a_time;
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  QuietMujoco();
  const Loading mark(name);
  const auto vfs = MakeVfs(path, xml);
  if (!vfs) throw InputError(name + ": MuJoCo does not take the file; give it a shorter name");
  std::array<char, 1000> message{};
  ModelPtr model(
      mj_loadXML(path.c_str(), vfs.get(), message.data(), static_cast<int>(message.size())));
  const std::string said = Joined(message.data());
  if (!model) {
    throw InputError(name + ": MuJoCo cannot load it: " + said + "; mend the model there");
  }
  warning = said;
  return model;
}

DataPtr MakeData(const mjModel& m, const std::string& name) {
  const Loading mark(name);
  DataPtr data(mj_makeData(&m));
  if (!data) throw InputError(name + ": too large for this machine's memory; make it smaller");
  return data;
}

bool KeepAwake([[maybe_unused]] mjModel& m) noexcept {
#if mjVERSION_HEADER >= 340
  if ((m.opt.enableflags & mjENBL_SLEEP) != 0) {
    m.opt.enableflags &= ~mjENBL_SLEEP;
    return true;
  }
#endif
  return false;
}

void SkipIdleStages(mjModel& m) noexcept {
  if (m.nsensor == 0) m.opt.disableflags |= mjDSBL_SENSOR;
  if (!HasConstraints(m)) m.opt.disableflags |= mjDSBL_CONSTRAINT;
#if mjVERSION_HEADER < 230
  if (!HasPassiveForces(m)) m.opt.disableflags |= mjDSBL_PASSIVE;
#endif
}

void SetCollision(mjModel& m, int geom, int contype, int conaffinity) noexcept {
  m.geom_contype[geom] = contype;
  m.geom_conaffinity[geom] = conaffinity;
#if mjVERSION_HEADER >= 300
  m.body_contype[m.geom_bodyid[geom]] |= contype;
  m.body_conaffinity[m.geom_bodyid[geom]] |= conaffinity;
#endif
}

bool TiesSites([[maybe_unused]] const mjModel& m, [[maybe_unused]] int equality) noexcept {
#if mjVERSION_HEADER >= 320
  return m.eq_objtype[equality] == mjOBJ_SITE;
#else
  return false;
#endif
}

unsigned char* TextureBytes(mjModel& m, int texture) noexcept { return BytesOf(m, texture); }

void Connect(mjvGeom& geom, int type, double width, const double from[3], const double to[3]) {
#if mjVERSION_HEADER >= 237
  mjv_connector(&geom, type, width, from, to);
#else
  mjv_makeConnector(&geom, type, width, from[0], from[1], from[2], to[0], to[1], to[2]);
#endif
}

double HalfWidthOf(const mjvGLCamera& camera, double aspect) noexcept {
  return HalfWidth(camera, aspect);
}
bool IsOrthographic(const mjvGLCamera& camera) noexcept { return Orthographic(camera); }
bool IsDirectional(const mjvLight& light) noexcept { return Directional(light); }
bool MayHaveTexture(const mjvGeom& geom) noexcept { return Textured(geom); }

RayHit FirstOnRay(const mjModel& m, const mjData& d, const double from[3], const double along[3]) {
  const mjtByte shown[mjNGROUP] = {1, 1, 1, 0, 0, 0};  // as mjv_defaultOption has it
  RayHit hit;
  hit.distance = Follow(&mj_ray, &m, &d, from, along, &shown[0], mjtByte{1}, -1, &hit.geom);
  return hit;
}

double DistanceOnRay(const mjModel& m, const mjData& d, int geom, const double from[3],
                     const double along[3]) {
  const std::ptrdiff_t i = geom;
  return Follow(&mju_rayGeom, d.geom_xpos + 3 * i, d.geom_xmat + 9 * i, m.geom_size + 3 * i, from,
                along, m.geom_type[i]);
}

}  // namespace moontrace
