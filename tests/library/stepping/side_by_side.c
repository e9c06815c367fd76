/* Two stepping libraries, each with its own MuJoCo, in one process: each steps its own model and
   refuses the other's.
     side_by_side MODEL LIBRARY MUJOCO LIBRARY MUJOCO
   of libmoontrace-mujoco-VERSION.so.0 and libmujoco.so.VERSION */
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>

#include "moontrace_mujoco.h"

struct side {
  int version;
  struct mjModel_* m;
  struct mjData_* d;
  int (*open)(struct mjModel_*, struct mjData_*, const struct moontrace_scene_options*,
              moontrace_scene**);
  int (*step)(moontrace_scene*, struct mjModel_*, struct mjData_*,
              const struct moontrace_scene_input*, struct moontrace_scene_answer*);
  int (*close)(moontrace_scene*);
  const char* (*message)(void);
};

static void fail(const char* what) {
  fprintf(stderr, "%s\n", what);
  exit(1);
}

/* A pointer to a function, which ISO C keeps apart from those to objects. */
static void find(void* library, const char* name, void* function) {
  *(void**)function = dlsym(library, name);
  if (!*(void**)function) fail(dlerror());
}

static struct side side_of(const char* model, const char* stepping, const char* mujoco) {
  struct side side = {0};
  int (*version)(void);
  struct mjModel_* (*load)(const char*, const void*, char*, int);
  struct mjData_* (*make)(const struct mjModel_*);
  char error[500] = "";
  void* const library = dlopen(stepping, RTLD_NOW | RTLD_LOCAL);
  void* const own = library ? dlopen(mujoco, RTLD_NOW | RTLD_LOCAL) : NULL;
  if (!own) fail(dlerror());
  find(library, "moontrace_scene_mujoco", &version);
  find(library, "moontrace_scene_open", &side.open);
  find(library, "moontrace_scene_step", &side.step);
  find(library, "moontrace_scene_close", &side.close);
  find(library, "moontrace_scene_message", &side.message);
  side.version = version();
  find(own, "mj_version", &version);
  if (version() != side.version) fail("the library was made for another MuJoCo");
  find(own, "mj_loadXML", &load);
  find(own, "mj_makeData", &make);
  side.m = load(model, NULL, error, sizeof error);
  if (!side.m) fail(error);
  side.d = make(side.m);
  return side;
}

static int open_with(const struct side* library, const struct side* model,
                     moontrace_scene** scene) {
  struct moontrace_scene_options options = {0};
  options.size = sizeof options;
  options.mujoco = model->version;
  options.text = "moon";
  return library->open(model->m, model->d, &options, scene);
}

/* The force on a hand that presses 0.5 mm deep [N]. */
static double pressed(const struct side* side) {
  struct moontrace_scene_input hand = {0};
  struct moontrace_scene_answer felt = {0};
  moontrace_scene* scene = NULL;
  int i;
  hand.size = sizeof hand;
  felt.size = sizeof felt;
  hand.position[0] = hand.position[1] = 0.005;
  hand.position[2] = -0.0005;
  if (open_with(side, side, &scene)) fail(side->message());
  for (i = 0; i < 300; ++i) {
    if (side->step(scene, side->m, side->d, &hand, &felt)) fail(side->message());
  }
  if (side->close(scene)) fail(side->message());
  return felt.force_world[2];
}

int main(int count, char** words) {
  struct side sides[2];
  int i;
  if (count != 6) return 2;
  for (i = 0; i < 2; ++i) sides[i] = side_of(words[1], words[2 + 2 * i], words[3 + 2 * i]);
  for (i = 0; i < 2; ++i) {
    moontrace_scene* scene = NULL;
    const double force = pressed(&sides[i]);
    printf("MuJoCo %d: %.3f N\n", sides[i].version, force);
    /* two springs of 1000 N/m share 0.5 mm */
    if (!(force > 0.24 && force < 0.26)) fail("another force than that of the springs");
    if (open_with(&sides[i], &sides[1 - i], &scene) != MOONTRACE_WRONG_MUJOCO || scene)
      fail("the other's model was not refused");
    printf("refused: %s\n", sides[i].message());
  }
  return 0;
}
