/* Moontrace's interface for programs that have a MuJoCo of their own: texts on their models, felt
   by a tip, in their own loop.

       struct moontrace_scene_options options = {0};
       moontrace_scene* scene;
       options.size = sizeof options;
       options.mujoco = mjVERSION_HEADER;
       if (moontrace_scene_open(m, d, &options, &scene)) fputs(moontrace_scene_message(), stderr);
       while (...) {
         moontrace_scene_step(scene, m, d, &hand, &felt);   in place of mj_step(m, d)
         ... felt.force_world to the device ...
       }

   The model says where text lies, by labels in its <custom>, and has the bodies of Moontrace's
   models/proxy.xml: <include file="/usr/share/moontrace/models/proxy.xml"/>.

   Answers, structs, handles and units are those of moontrace.h. What a call was not done for says
   moontrace_scene_message. There is one library for each version of MuJoCo, with that in its name;
   it links that MuJoCo and refuses others.

   Model and data are the caller's, who may do with them between two calls what it likes, but for
   the model's layout and time step. What a call changes in the model it puts back. Every call is
   given both and refuses others than those the scene was opened with, but cannot know that memory
   was freed: close a scene before its model or data are deleted.

   An error within MuJoCo, which by itself ends the program, is answered by MOONTRACE_FAULT where it
   arises in one of these calls; the program's own handler is then not called. MuJoCo promises
   nothing for the data after that: moontrace_scene_reset begins anew.

   Frames: W, MuJoCo's world. P, the page, as in moontrace.h: of a flat one z is 0 on its face, of a
   round one P lies so that at the tip it touches it.

   C99 and C++, on machines with 64-bit pointers.
*/
/* C names and headers: NOLINTBEGIN */
#ifndef MOONTRACE_MUJOCO_H_
#define MOONTRACE_MUJOCO_H_

#include <moontrace.h>

#ifdef __cplusplus
extern "C" {
#endif

struct mjModel_; /* MuJoCo's mjModel and mjData */
struct mjData_;

/* The interface that this header describes. */
#define MOONTRACE_MUJOCO_INTERFACE 1u

/* Besides the answers of moontrace.h: the MuJoCo that runs, the one that the caller was compiled
   for, and the library's are not the same version. */
enum { MOONTRACE_WRONG_MUJOCO = 5 };

typedef struct moontrace_scene moontrace_scene; /* a model that carries text, bound to its data */
typedef struct moontrace_trace moontrace_trace; /* what one trace of a page gave */

/* Whether this library serves programs compiled for that interface, given as
   MOONTRACE_MUJOCO_INTERFACE, and for that MuJoCo, given as mjVERSION_HEADER. MOONTRACE_BAD_CALL:
   it is older; MOONTRACE_WRONG_MUJOCO. Any thread, any time. */
MOONTRACE_API int moontrace_scene_check(uint32_t interface_version, int mujoco);

/* The version of MuJoCo that the library was made for, as mj_version() counts. Any thread, any
   time. */
MOONTRACE_API int moontrace_scene_mujoco(void);

/* As moontrace_message, of the calls of this library. Any thread, any time: each has its own. */
MOONTRACE_API const char* moontrace_scene_message(void);

/* --- scenes ------------------------------------------------------------------------------------
 */

/* Zero or NULL is what is usual. */
struct moontrace_scene_options {
  uint32_t size;                       /* sizeof this struct, set by the caller */
  int32_t mujoco;                      /* mjVERSION_HEADER, as the caller was compiled */
  const char* text;                    /* of the page; NULL: that of its label */
  const char* script;                  /* by name or path; NULL: the label's, else moon */
  const struct moontrace_style* style; /* what is zero in it is as the label asks for */
  size_t label;           /* number of the label that is the page, from 0 in the model's order */
  size_t page;            /* of the text, from 0 */
  const char* model_path; /* the model's MJCF, which records keep; NULL: none are made */
  uint32_t direct;  /* 1: the force is that at the tip itself, as in the paper; 0: by the proxy */
  uint32_t law;     /* 0: the gradient of a potential; 1: the paper's */
  double stiffness; /* of the page; usual: 1000 [N/m] */
  double force_cap; /* usual: 4 [N] */
  double friction;  /* Coulomb's mu; usual: none */
  double coupling_stiffness; /* of tip and proxy; usual: 1000 [N/m] */
  double coupling_damping;   /* usual: 10 [N s/m] */
};

/* Binds model and data: sets the text of each label, finds proxy and geoms. Data stay in the state
   that they are in; what mj_fwdPosition computes from it is computed. The time step of the model is
   that of every step. Reads files of scripts.
   MOONTRACE_WRONG_MUJOCO: see there; then neither model nor data were looked at.
   MOONTRACE_BAD_INPUT: no label, one whose text has no room, no proxy or one that is held, a text
   that cannot be set, friction that is too high, too stiff for the time step.
   One thread at a time for a model and its data; other models any time. */
MOONTRACE_API int moontrace_scene_open(struct mjModel_* m, struct mjData_* d,
                                       const struct moontrace_scene_options* options,
                                       moontrace_scene** scene);

struct moontrace_scene_facts {
  uint32_t size;   /* sizeof this struct, set by the caller */
  int32_t mujoco;  /* that the library was made for */
  size_t labels;   /* of the model */
  size_t pages;    /* of the text */
  size_t letters;  /* on this page */
  size_t substeps; /* of MuJoCo in a step that touches */
  double tick;     /* of a step [s] */
  double width;    /* of the sheet [m] */
  double height;
  double proxy_mass;    /* [kg] */
  double force_bound;   /* greatest force on a hand that moves evenly; INFINITY where the page moves
                           [N] */
  double carried_press; /* greatest press that does not go through [N] */
  const char* text;     /* these two live as long as the scene */
  const char* remarks;  /* for people, one a line; may be empty */
};
/* One thread at a time for a scene. */
MOONTRACE_API int moontrace_scene_describe(const moontrace_scene* scene,
                                           struct moontrace_scene_facts* facts);

/* Where the hand holds the tip. */
struct moontrace_scene_input {
  uint32_t size;           /* sizeof this struct, set by the caller */
  uint32_t velocity_known; /* 1: `velocity` holds; 0: it is found from the places */
  double position[3];      /* W [m] */
  double velocity[3];      /* W [m/s] */
};

/* What a step gave. */
struct moontrace_scene_answer {
  uint32_t size;       /* sizeof this struct, set by the caller */
  uint32_t in_contact; /* the page is touched */
  uint32_t through;    /* pressed through the page, which is not felt until the tip is above it */
  uint32_t fault;      /* no force: the model's state was not finite, or something held the proxy */
  double force_world[3]; /* on the hand, W [N] */
  double force[3];       /* the same, P [N] */
  double tip[3];         /* P [m] */
  double proxy[3];       /* P, after the step; the tip itself when direct [m] */
  double page_force[3];  /* the page's on the proxy, P, friction included [N] */
  double depth;          /* of the proxy in the page [m] */
  double energy_out;     /* put out so far by sampling in time; a passive page gives none [J] */
};

/* One step of the model, in place of mj_step: the page's force acts on the proxy, and the opposite
   on what carries the page. Does not allocate, wait or write, unless it refuses.
   MOONTRACE_BAD_CALL: places or velocities that are not finite, another model or data, a time step
   that has changed; nothing is stepped. MOONTRACE_BAD_INPUT: the step was done with a fault, and
   `answer` says so. MOONTRACE_FAULT: an error within MuJoCo. The answer is all zero but where it is
   said otherwise. One thread at a time for a scene, and for all scenes of one model; a second one
   in the same scene is told MOONTRACE_BAD_CALL. */
MOONTRACE_API int moontrace_scene_step(moontrace_scene* scene, struct mjModel_* m,
                                       struct mjData_* d, const struct moontrace_scene_input* input,
                                       struct moontrace_scene_answer* answer);

/* Resets the data as mj_resetData and begins anew with the proxy at rest at a place over the page,
   P [m]. Threads as moontrace_scene_step. */
MOONTRACE_API int moontrace_scene_reset(moontrace_scene* scene, struct mjModel_* m,
                                        struct mjData_* d, const double tip[3]);

/* Where a place over the page, P, lies in the world now [m]. Threads as moontrace_scene_step. */
MOONTRACE_API int moontrace_scene_place(moontrace_scene* scene, struct mjModel_* m,
                                        struct mjData_* d, const double place[3], double world[3]);

/* NULL is closed already: MOONTRACE_DONE. Neither model nor data are looked at. Any thread; a step
   that runs in another one ends first. */
MOONTRACE_API int moontrace_scene_close(moontrace_scene* scene);

/* --- traces ------------------------------------------------------------------------------------
 */

/* How a page is traced. Zero or NULL is what is usual. */
struct moontrace_trace_options {
  uint32_t size;      /* sizeof this struct, set by the caller */
  uint32_t csv;       /* 1: the record's samples as CSV too */
  uint64_t seed;      /* of the hand's tremor and drift; usual: 1 */
  double speed;       /* greatest along a stroke; usual: 0.040 [m/s] */
  double press;       /* usual: 1, on ridges 0.2 [N] */
  const char* record; /* a new folder, as `moontrace trace --record` writes it, for `moontrace
                         replay`; needs the scene's model_path */
};

/* A simulated hand traces the page, as `moontrace trace` does: the same ticks to the last bit. The
   data are reset before. Takes a fraction of the time that is simulated. MOONTRACE_LACKING: the
   record cannot be written; nothing half-written is left. Threads as moontrace_scene_step. */
MOONTRACE_API int moontrace_trace_open(moontrace_scene* scene, struct mjModel_* m,
                                       struct mjData_* d,
                                       const struct moontrace_trace_options* options,
                                       moontrace_trace** trace);

/* How the trace went; errors are NAN where no stroke was followed. */
struct moontrace_trace_facts {
  uint32_t size;        /* sizeof this struct, set by the caller */
  uint32_t reserved;    /* 0 */
  size_t samples;       /* one a step */
  double duration;      /* [s] */
  double coverage;      /* of the strokes, 0 to 1 */
  double mean_error;    /* from the strokes' middle, in contact [m] */
  double rms_error;     /* [m] */
  double max_error;     /* [m] */
  double mean_force;    /* [N] */
  double peak_force;    /* [N] */
  double mean_speed;    /* [m/s] */
  double contact_share; /* of the time along strokes, 0 to 1 */
  double energy_out;    /* put out by sampling in time [J] */
  size_t excursions;    /* times that the tip left its groove */
  size_t lifts;
  size_t lifts_within_lines;
  size_t through;   /* times that the tip was pressed through */
  size_t faults;    /* steps without force */
  const char* json; /* all metrics, as `trace --json` names them; lives as long as the trace */
};
/* Any thread, any time. */
MOONTRACE_API int moontrace_trace_describe(const moontrace_trace* trace,
                                           struct moontrace_trace_facts* facts);

/* Arrays that samples are copied into; what is not wanted is NULL. */
struct moontrace_trace_samples {
  uint32_t size;     /* sizeof this struct, set by the caller */
  uint32_t reserved; /* 0 */
  size_t first;      /* number of the first one */
  size_t count;
  double* time;  /* [count], since the trace began [s] */
  double* tip;   /* [count][3], P [m] */
  double* proxy; /* [count][3], P [m] */
  double* force; /* [count][3], on the hand, P [N] */
  double* depth; /* [count], in the page [m] */
};
/* MOONTRACE_BAD_CALL: there are not so many. Any thread, any time. */
MOONTRACE_API int moontrace_trace_read(const moontrace_trace* trace,
                                       const struct moontrace_trace_samples* samples);

/* As moontrace_script_close. */
MOONTRACE_API int moontrace_trace_close(moontrace_trace* trace);

#ifdef __cplusplus
}
#endif

#endif /* MOONTRACE_MUJOCO_H_ */
/* NOLINTEND */
