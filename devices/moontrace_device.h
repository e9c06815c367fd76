/* Moontrace's interface for devices whose drivers are closed, or that are not HID.

   A plug-in is a shared object that defines moontrace_device_entry. Moontrace runs it in a process
   of its own: a crash, a hang or an exit there is a lost device here, nothing worse. Copy
   devices/plugins/template.c and follow its numbered steps.

   Units are SI: metres, newtons, seconds. Frame D: right-handed, x to the person's right, y away
   from the person, z up from the desk; its origin is the middle of the workspace.

   Threads: every function of one plug-in is called by one and the same thread, never two at once.
   describe comes first, then open, then in turn read and write at `rate`, last close. read and
   write must return well within a period; a plug-in that is silent for 0.1 s is ended and its
   device lost. open may take up to 10 s.

   Safety: write is given what Moontrace's own limits let through, never more than `peak_force` on
   an axis and always finite numbers. If Moontrace stops, hangs or ends, write gets zero within 20
   ms and, if it ended, close follows.

   C99 and C++. The structs only grow at their ends within a version; `size` tells how far.
*/
/* C names and headers: NOLINTBEGIN */
#ifndef MOONTRACE_DEVICE_H_
#define MOONTRACE_DEVICE_H_

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define MOONTRACE_DEVICE_VERSION 1u

/* What a device is and can do. All zero when describe gets it. Zero means "unknown" or "none" where
   it says so below. */
struct moontrace_description {
  uint32_t size;           /* sizeof this struct, set by Moontrace */
  char title[64];          /* for people, UTF-8, ends with 0 */
  double rate;             /* calls of read and write a second, 100 to 10000 [Hz] */
  double workspace[3];     /* from the origin to its edge along x, y, z, above 0 [m] */
  uint32_t measures;       /* bit 0, 1, 2: it measures x, y, z. At least x and y */
  uint32_t pushes;         /* bit 0, 1, 2: it pushes along x, y, z; 0: position only */
  uint32_t buttons;        /* how many, 0 to 32 */
  double peak_force;       /* on one axis for a moment, up to 100; above 0 if it pushes [N] */
  double continuous_force; /* on one axis for ever [N]; 0: the motors do not heat */
  double heat_time;        /* time constant by which the motors cool [s]; 0 only with the above */
  double peak_power;       /* given to the hand [W]; 0: without limit */
  double stiffness;        /* greatest that it renders stably, by its maker [N/m]; 0: unknown */
  double damping;          /* of the device alone [N s/m]; 0: unknown */
  double coulomb_friction; /* [N]; 0: unknown */
  double position_step;    /* resolution [m]; 0: unknown */
  double force_step;       /* resolution [N]; 0: unknown */
  double delay;            /* from force to motion and back, beside one period [s] */
  double dead_man;         /* after which the device itself lets go [s]; 0: it never does */
};

/* One reading. */
struct moontrace_reading {
  uint32_t size;           /* sizeof this struct, set by Moontrace */
  uint32_t buttons;        /* bit i: button i is held */
  double position[3];      /* of the tip [m] */
  double velocity[3];      /* of the tip [m/s], read only if velocity_known */
  uint32_t velocity_known; /* 0 or 1 */
  uint32_t reserved;       /* 0 */
};

/* What read and write return. */
enum {
  MOONTRACE_OK = 0,
  MOONTRACE_NO_NEW_DATA = 1, /* read: nothing new since the last call */
  MOONTRACE_NOT_READY = 2,   /* there, but its motors are off: a safety switch, not homed */
  MOONTRACE_LOST = 3         /* unplugged or broken: it is closed and stays lost */
};

struct moontrace_device {
  uint32_t version; /* MOONTRACE_DEVICE_VERSION; any other is refused */
  uint32_t size;    /* sizeof this struct */

  /* Fills in the description. Called before open, with nothing plugged in perhaps. 0 if good. */
  int (*describe)(struct moontrace_description* description);

  /* Opens the device and returns what the other functions get as `self`; NULL if it cannot, with
     the reason and how to mend it as one line in `error` (size bytes, UTF-8, ends with 0). */
  void* (*open)(char* error, size_t size);

  /* The newest reading. Leaves it as it is unless MOONTRACE_OK. */
  int (*read)(void* self, struct moontrace_reading* reading);

  /* The force to be felt from now on, frame D [N]. */
  int (*write)(void* self, const double force[3]);

  /* Lets go and closes. The last write before was zero. */
  void (*close)(void* self);
};

/* The one function that a plug-in defines. What it returns lives as long as the plug-in. */
#if defined(__GNUC__)
__attribute__((visibility("default")))
#endif
const struct moontrace_device*
moontrace_device_entry(void);

#ifdef __cplusplus
}
#endif

#endif /* MOONTRACE_DEVICE_H_ */
/* NOLINTEND */
