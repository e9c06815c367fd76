/* A program that owns a MuJoCo loop: a tip goes along over a text and presses on it.
     consumer MODEL   an MJCF file with a label, into which models/proxy.xml is included */
#include <moontrace_mujoco.h>
#include <mujoco/mujoco.h>
#include <stdio.h>

static int failed(void) {
  fprintf(stderr, "%s\n", moontrace_scene_message());
  return 1;
}

/* Two seconds over the page, 0.3 mm into it; the greatest force on the hand [N], below 0: failed.
 */
static double stroke(moontrace_scene* scene, mjModel* m, mjData* d) {
  const double start[3] = {0.015, 0.280, 0.0};
  double greatest = 0;
  int i;
  if (moontrace_scene_reset(scene, m, d, start)) return -1;
  for (i = 0; i < 2000; ++i) {
    struct moontrace_scene_input hand = {0};
    struct moontrace_scene_answer felt = {0};
    double place[3];
    hand.size = sizeof hand;
    felt.size = sizeof felt;
    place[0] = start[0] + 0.00002 * i;
    place[1] = start[1];
    place[2] = i < 500 ? -0.0003 * i / 500 : -0.0003; /* slowly down */
    if (moontrace_scene_place(scene, m, d, place, hand.position)) return -1;
    if (moontrace_scene_step(scene, m, d, &hand, &felt)) return -1; /* in place of mj_step */
    if (felt.force_world[2] > greatest) greatest = felt.force_world[2];
  }
  return greatest;
}

int main(int count, char** words) {
  char error[500] = "";
  struct moontrace_scene_options options = {0};
  moontrace_scene* scene = NULL;
  mjModel* m;
  mjData* d;
  double greatest;
  if (count != 2) return 2;
  if (moontrace_scene_check(MOONTRACE_MUJOCO_INTERFACE, mjVERSION_HEADER)) return failed();
  m = mj_loadXML(words[1], NULL, error, sizeof error);
  if (!m) {
    fprintf(stderr, "%s\n", error);
    return 1;
  }
  d = mj_makeData(m);
  options.size = sizeof options;
  options.mujoco = mjVERSION_HEADER;
  options.text = "moon";
  if (moontrace_scene_open(m, d, &options, &scene)) return failed();
  greatest = stroke(scene, m, d);
  if (greatest < 0) return failed();
  printf("MuJoCo %s: %.1f s, %.2f N\n", mj_versionString(), d->time, greatest);
  if (moontrace_scene_close(scene)) return failed();
  mj_deleteData(d);
  mj_deleteModel(m);
  return 0;
}
