/* The template's device with one fault, chosen when it is compiled: FAULT is one of the names
   below. A fault strikes on read number 200, so that the device works before. What write gets goes
   to the file that MOONTRACE_TEST_FORCES names, so that a test can see the last command; with the
   time before it [s] to the one that MOONTRACE_TEST_TIMES names. */
#define moontrace_device_entry template_entry
#include "template.c"
#undef moontrace_device_entry

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#define NONE 0
#define NAN_POSITION 1
#define HANG 2
#define CRASH 3
#define EXIT 4
#define WRONG_VERSION 5
#define LOST 6
#define CRASH_AT_OPEN 7
#define REFUSE 8
#define SCRIBBLE 9
#define BAD_DESCRIPTION 10
#define NOT_READY 11
#define SLOW 12 /* from the first read on */
#define FORKS 13
#define NAN_AT_ONCE 14  /* from the first read on */
#define CODE_AT_ONCE 15 /* likewise */
#define WRONG_SIZE 16

static int reads = 0;
static int forces = -1;
static int times = -1;

static int faulty_describe(struct moontrace_description* d) {
  const int result = describe(d);
  if (FAULT == BAD_DESCRIPTION) d->workspace[1] = 0.0 / (d->workspace[1] - 0.08);
  return result;
}

static void* faulty_open(char* error, size_t size) {
  const char* path = getenv("MOONTRACE_TEST_FORCES");
  const char* times_path = getenv("MOONTRACE_TEST_TIMES");
  if (FAULT == CRASH_AT_OPEN) abort();
  if (FAULT == REFUSE) {
    snprintf(error, size, "no arm found: plug it in");
    return NULL;
  }
  if (path != NULL) forces = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0600);
  if (times_path != NULL) {
    times = open(times_path, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0600);
  }
  if (FAULT == FORKS && fork() == 0) { /* a driver's own process; its number goes to the file */
    const double self[3] = {getpid(), 0, 0};
    if (forces < 0 || write(forces, self, sizeof self) < 0) _exit(1);
    for (;;) pause();
  }
  return open_device(error, size);
}

static int faulty_read(void* self, struct moontrace_reading* reading) {
  const int result = read_device(self, reading);
  const struct timespec slow = {0, 50000000};
  if (FAULT == SLOW) nanosleep(&slow, NULL);
  if (FAULT == NAN_AT_ONCE) reading->position[1] = 0.0 / reads;
  if (FAULT == CODE_AT_ONCE) return 77;
  if (++reads < 200) return result;
  switch (FAULT) {
    case NAN_POSITION:
      reading->position[1] = 0.0 / (reads - reads);
      break;
    case HANG:
      for (;;) pause();
    case CRASH:
      signal(SIGSEGV, SIG_DFL); /* a sanitizer's own handler takes its time to report */
      raise(SIGSEGV);
      break;
    case EXIT:
      syscall(SYS_exit_group, 3); /* a sanitizer's own exit waits: that would be a hang */
      break;
    case LOST:
      return MOONTRACE_LOST;
    case SCRIBBLE: /* over the reading and its neighbours on the stack, then a crash */
      memset((char*)reading - 256, 0xff, 4096);
      break;
    case NOT_READY:
      return reads < 400 ? MOONTRACE_NOT_READY : result;
    default:
      break;
  }
  return result;
}

static int faulty_write(void* self, const double force[3]) {
  struct timespec now;
  double timed[4];
  if (forces >= 0 && write(forces, force, 3 * sizeof *force) < 0) return MOONTRACE_LOST;
  clock_gettime(CLOCK_MONOTONIC, &now);
  timed[0] = now.tv_sec + 1e-9 * now.tv_nsec;
  memcpy(timed + 1, force, 3 * sizeof *force);
  if (times >= 0 && write(times, timed, sizeof timed) < 0) return MOONTRACE_LOST;
  return write_device(self, force);
}

static void faulty_close(void* self) {
  const double mark[3] = {-1, -1, -1}; /* an orderly end */
  if (forces >= 0 && write(forces, mark, sizeof mark) > 0) close(forces);
  close_device(self);
}

const struct moontrace_device* moontrace_device_entry(void) {
  static struct moontrace_device device = {MOONTRACE_DEVICE_VERSION,
                                           sizeof(struct moontrace_device),
                                           faulty_describe,
                                           faulty_open,
                                           faulty_read,
                                           faulty_write,
                                           faulty_close};
  if (FAULT == WRONG_VERSION) device.version = 2;
  if (FAULT == WRONG_SIZE) device.size = 8;
  return &device;
}
