/* A plug-in for Moontrace: a template. Follow the numbered steps; what each function must do is in
   devices/moontrace_device.h.

   1. Copy this file, and moontrace_device.h beside it.
   2. Fill in describe(): what your device is and can do. Measure or take the maker's figures; write
      peak_force low at first.
   3. Put your device's handle and state into struct self.
   4. Open it in open_device(). Say in one line what is wrong and how to mend it if it cannot be.
   5. Turn what your driver tells into metres and frame D in read_device().
   6. Turn newtons in frame D into what your driver wants in write_device().
   7. Let go and close in close_device().
   8. Build it: cc -std=c99 -Wall -shared -fPIC -o mydevice.so mydevice.c
   9. Put it where only root or you can write; Moontrace says which folder is not.
  10. Try it, hand off the device first: moontrace devices test plugin:/home/me/mydevice.so

   As it stands it builds and behaves as a mass of 0.1 kg that hangs on a spring: you can feel your
   way from there. */
#include "moontrace_device.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Step 3. */
struct self {
  double position[3]; /* [m] */
  double velocity[3]; /* [m/s] */
  double force[3];    /* [N] */
};

static const double kMass = 0.1;       /* [kg] */
static const double kStiffness = 50.0; /* [N/m] */
static const double kDamping = 2.0;    /* [N s/m] */
static const double kRate = 1000.0;    /* [Hz] */

/* Step 2. */
static int describe(struct moontrace_description* d) {
  int i;
  snprintf(d->title, sizeof d->title, "Spring and mass (template)");
  d->rate = kRate;
  for (i = 0; i < 3; ++i) d->workspace[i] = 0.08;
  d->measures = 7; /* x, y, z */
  d->pushes = 7;
  d->buttons = 1;
  d->peak_force = 3.0;
  d->continuous_force = 1.0;
  d->heat_time = 20.0;
  d->stiffness = 1000.0;
  d->damping = kDamping;
  d->position_step = 1e-5;
  d->delay = 0.001;
  d->dead_man = 0.02;
  return 0;
}

/* Step 4. */
static void* open_device(char* error, size_t size) {
  struct self* self = calloc(1, sizeof *self);
  if (self == NULL) snprintf(error, size, "no memory: close other programs");
  return self;
}

/* Step 5. Here: one period of the mass's motion, velocity first, so that it stays stable. */
static int read_device(void* handle, struct moontrace_reading* reading) {
  struct self* self = handle;
  int i;
  for (i = 0; i < 3; ++i) {
    const double pull = self->force[i] - kStiffness * self->position[i];
    self->velocity[i] += (pull - kDamping * self->velocity[i]) / kMass / kRate;
    self->position[i] += self->velocity[i] / kRate;
    reading->position[i] = self->position[i];
    reading->velocity[i] = self->velocity[i];
  }
  reading->velocity_known = 1;
  reading->buttons = 0;
  return MOONTRACE_OK;
}

/* Step 6. */
static int write_device(void* handle, const double force[3]) {
  struct self* self = handle;
  memcpy(self->force, force, sizeof self->force);
  return MOONTRACE_OK;
}

/* Step 7. */
static void close_device(void* handle) { free(handle); }

const struct moontrace_device* moontrace_device_entry(void) {
  static const struct moontrace_device device = {
      MOONTRACE_DEVICE_VERSION, sizeof(struct moontrace_device), describe, open_device, read_device,
      write_device, close_device};
  return &device;
}
