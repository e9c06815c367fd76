/* A program that links another MuJoCo than the stepping library's is refused, whatever it was
   compiled for, and its model is not looked at. */
#include <stdio.h>
#include <string.h>

#include "moontrace_mujoco.h"

static int refused(int compiled_for) {
  struct moontrace_scene_options options = {0};
  moontrace_scene* scene = NULL;
  char nothing[1] = {0};
  options.size = sizeof options;
  options.mujoco = compiled_for;
  if (moontrace_scene_check(MOONTRACE_MUJOCO_INTERFACE, compiled_for) != MOONTRACE_WRONG_MUJOCO)
    return 0;
  if (moontrace_scene_open((struct mjModel_*)(void*)nothing, (struct mjData_*)(void*)nothing,
                           &options, &scene) != MOONTRACE_WRONG_MUJOCO)
    return 0;
  puts(moontrace_scene_message());
  return scene == NULL && strstr(moontrace_scene_message(), "3012000 runs") != NULL;
}

int main(void) { return refused(3012000) && refused(moontrace_scene_mujoco()) ? 0 : 1; }
