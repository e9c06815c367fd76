/* The template's device in a hand that lets itself be led: nothing draws it back, and it goes as
   hard as a hand's own damping lets it (devices/hand.toml, 3 N s/m). */
#define moontrace_device_entry template_entry
#include "template.c"
#undef moontrace_device_entry

static int loose_read(void* handle, struct moontrace_reading* reading) {
  struct self* self = handle;
  int i;
  for (i = 0; i < 3; ++i) {
    self->velocity[i] += (self->force[i] - 3.0 * self->velocity[i]) / kMass / kRate;
    self->position[i] += self->velocity[i] / kRate;
    reading->position[i] = self->position[i];
    reading->velocity[i] = self->velocity[i];
  }
  reading->velocity_known = 1;
  reading->buttons = 0;
  return MOONTRACE_OK;
}

const struct moontrace_device* moontrace_device_entry(void) {
  static struct moontrace_device device;
  device = *template_entry();
  device.read = loose_read;
  (void)kStiffness;
  return &device;
}
