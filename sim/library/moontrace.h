/* Moontrace's interface for programs in C, and through it for other languages: texts become pages
   of Moon, Braille or another stroke script, and a page is asked for its surface at any point, for
   the force that a tip feels there, for its letters, and for its picture.

       moontrace_script* script;
       moontrace_text* text;
       moontrace_page* page;
       double sample[3];
       if (moontrace_script_open("moon", NULL, &script) || moontrace_text_open(script, "moon", NULL,
   &text) || moontrace_page_open(text, 0, &page) || moontrace_sample(page, 0.05, 0.25, sample))
         fprintf(stderr, "%s\n", moontrace_message());

   Units are SI: metres, newtons. Frame P, the page: its origin is the sheet's lower left corner, x
   goes along the line of text, y up the page, z out of the paper; z = 0 is the flat surface. Text
   is UTF-8 and ends with 0.

   Answers: every function returns one of the codes below, but those that say otherwise. After any
   code but MOONTRACE_DONE nothing was made and `moontrace_message` says why. No exception and no
   signal comes out of a call.

   Handles: what moontrace_..._open made lives until it is closed. A page needs neither its text nor
   its script any more, nor a text its script. A handle that is null, of another kind, or already
   closed is answered by MOONTRACE_BAD_CALL, in every build. One that is closed while another thread
   is in a call with it lives until that call returns.

   Structs: the first field is the struct's size, which the caller sets: sizeof it, as compiled. A
   struct grows only at its end; a field that is zero means what it meant before there was such a
   field. Set the whole struct to zero first.

   C99 and C++, on machines with 64-bit pointers.
*/
/* C names and headers: NOLINTBEGIN */
#ifndef MOONTRACE_H_
#define MOONTRACE_H_

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define MOONTRACE_API __attribute__((visibility("default")))
#else
#define MOONTRACE_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* The interface that this header describes. It grows with each version that adds something. */
#define MOONTRACE_INTERFACE 2u

/* What functions return; the program's exit codes mean the same. */
enum {
  MOONTRACE_DONE = 0,
  MOONTRACE_FAULT = 1, /* a fault of the library */
  MOONTRACE_BAD_CALL =
      2, /* of the caller: a null pointer, a closed handle, a number out of range */
  MOONTRACE_BAD_INPUT = 3, /* a text, a script, a file, or settings that do not fit them */
  MOONTRACE_LACKING = 4    /* the machine lacks something: memory, a library, room, a permission */
};

typedef struct moontrace_script
    moontrace_script;                         /* a script: its signs and the rules to write by */
typedef struct moontrace_text moontrace_text; /* a text, set on pages */
typedef struct moontrace_page moontrace_page; /* one of these pages as a surface */
typedef struct moontrace_object moontrace_object; /* a solid that carries one (interface 2) */

/* Whether this library serves programs compiled for that interface, given as MOONTRACE_INTERFACE:
   MOONTRACE_DONE, or MOONTRACE_BAD_CALL if the library is older. Any thread, any time. */
MOONTRACE_API int moontrace_check(uint32_t interface_version);

/* The program's version that the library belongs to, such as "0.1.0". Any thread, any time. */
MOONTRACE_API const char* moontrace_version(void);

/* What was wrong with the last call of this thread that was not answered by MOONTRACE_DONE: one
   line, empty where there was none. Stays until the next such call of this thread. Any thread, any
   time: each thread has its own. */
MOONTRACE_API const char* moontrace_message(void);

/* --- scripts --------------------------------------------------------------------------------- */

/* A script by name ("moon", "braille"; `moontrace script list` has them all), or by the path of its
   file. Unless `text` is NULL, scripts of thousands of characters are read only as far as that text
   needs. Reads files. MOONTRACE_BAD_INPUT: no such script, or a broken file. Any thread, any time.
 */
MOONTRACE_API int moontrace_script_open(const char* name_or_path, const char* text,
                                        moontrace_script** script);

struct moontrace_script_facts {
  uint32_t size;     /* sizeof this struct, set by the caller */
  uint32_t reserved; /* 0 */
  const char* name;  /* these four live as long as the script */
  const char* title;
  const char* author;
  const char* licence;
  size_t signs;       /* how many it has */
  double letter_size; /* that its letters usually have [m] */
};
/* Any thread, any time. */
MOONTRACE_API int moontrace_script_describe(const moontrace_script* script,
                                            struct moontrace_script_facts* facts);

/* NULL is closed already: MOONTRACE_DONE. Any thread; of two that close one handle one is told
   MOONTRACE_BAD_CALL. */
MOONTRACE_API int moontrace_script_close(moontrace_script* script);

/* --- texts ----------------------------------------------------------------------------------- */

/* How a text is set. Zero or NULL is what is usual: for the script, at that size, on that sheet. */
struct moontrace_style {
  uint32_t size;          /* sizeof this struct, set by the caller */
  uint32_t embossed;      /* 0: grooves; 1: ridges */
  uint32_t rules;         /* 1: a raised rule on either side of each line */
  uint32_t raised_margin; /* 1: a ridge round the text */
  uint32_t structure;     /* 1: marks of headings, quotations and links are read, not set */
  uint32_t reserved;      /* 0 */
  const char* sheet;  /* "a4", "a5", "workspace", or width x height in mm, "120x90"; usual: a4 */
  double margin;      /* on all sides [m] */
  double letter_size; /* base line to top line on stroke centre lines [m] */
  double width;       /* of a stroke, rim to rim [m] */
  double depth;       /* of a groove, height of a ridge [m] */
  double rounding;    /* of a stroke's edges and floor [m] */
  double letter_gap;  /* added between letters, may be below zero [m] */
  double word_gap;    /* added between words, may be below zero [m] */
  double line_pitch;  /* base line to base line [m] */
  double grade;       /* of contractions that the script knows */
  const char* h_form; /* of Moon: "crescent", "arc", "pocket", "reverse-n" */
  const char* table;  /* of liblouis, for Braille */
  const char* only;   /* signs taught so far, "abc+th": the text is kept to these */
  const char* lines;  /* "left-to-right", "right-to-left", "alternate", "vertical" */
  const char* links;  /* grooves between letters: "none", "letters", "words" */
  const char* hyphenation; /* language of patterns, "en_US": words may break at a line's end */
};

/* Sets a text on as many pages as it takes. `style` may be NULL: all as usual. Linear in the text,
   of 16 MB at most. MOONTRACE_BAD_INPUT: no UTF-8, nothing that has a sign, a style that cannot be
   felt or does not fit the script. MOONTRACE_BAD_CALL: a number in `style` that is not finite, or
   one below zero where lengths are meant. MOONTRACE_LACKING: Braille without liblouis. Any thread,
   any time. */
MOONTRACE_API int moontrace_text_open(const moontrace_script* script, const char* text,
                                      const struct moontrace_style* style, moontrace_text** set);

struct moontrace_text_facts {
  uint32_t size;     /* sizeof this struct, set by the caller */
  uint32_t reserved; /* 0 */
  size_t pages;
  size_t letters;     /* signs on all pages */
  size_t folded;      /* characters written by another sign of the same meaning */
  size_t missing;     /* characters without a sign, left out */
  double letter_size; /* what the style came to [m] */
  double width;       /* [m] */
  double depth;       /* [m] */
  double line_pitch;  /* [m] */
};
/* Any thread, any time. */
MOONTRACE_API int moontrace_text_describe(const moontrace_text* set,
                                          struct moontrace_text_facts* facts);

/* As moontrace_script_close. */
MOONTRACE_API int moontrace_text_close(moontrace_text* set);

/* --- pages ----------------------------------------------------------------------------------- */

/* Makes a page, counted from 0, into a surface. MOONTRACE_BAD_CALL: there is no page of that
   number. Any thread, any time. */
MOONTRACE_API int moontrace_page_open(const moontrace_text* set, size_t number,
                                      moontrace_page** page);

struct moontrace_page_facts {
  uint32_t size;     /* sizeof this struct, set by the caller */
  uint32_t reserved; /* 0 */
  double width;      /* of the sheet [m] */
  double height;     /* of the sheet [m] */
  size_t letters;    /* signs on it */
  size_t lines;
  double greatest_fall;  /* deepest point below the paper, 0 or above [m] */
  double greatest_rise;  /* highest point above it, 0 or above [m] */
  double greatest_slope; /* [m/m] */
};
/* Any thread, any time. */
MOONTRACE_API int moontrace_page_describe(const moontrace_page* page,
                                          struct moontrace_page_facts* facts);

/* A sign on a page. */
struct moontrace_letter {
  uint32_t size;       /* sizeof this struct, set by the caller */
  uint32_t reserved;   /* 0 */
  const char* sign;    /* its name, such as "a", "th", "numeral"; lives as long as the page */
  double x;            /* left edge of its em box [m] */
  double y;            /* its base line [m] */
  size_t line;         /* on the page, from 0 at the top */
  size_t word;         /* in the text, from 0 */
  size_t source_begin; /* the bytes of the text that it stands for; none for the numeral sign */
  size_t source_end;
};
/* The sign of that number on the page, counted from 0. MOONTRACE_BAD_CALL: there is none. Any
   thread, any time. */
MOONTRACE_API int moontrace_page_letter(const moontrace_page* page, size_t number,
                                        struct moontrace_letter* letter);

/* With the letters in small print below each sign. */
#define MOONTRACE_PRINT 1u

/* Draws the page in its true size, as `moontrace page --picture` does, in the kind that the path's
   ending names: .svg, .pdf or .png. Nothing half-written is left. `flags`: 0 or MOONTRACE_PRINT.
   MOONTRACE_BAD_INPUT: another ending. MOONTRACE_LACKING: it cannot be written. Any thread, any
   time. */
MOONTRACE_API int moontrace_page_draw(const moontrace_page* page, const char* path, uint32_t flags);

/* As moontrace_script_close. */
MOONTRACE_API int moontrace_page_close(moontrace_page* page);

/* --- the surface ------------------------------------------------------------------------------ */

/* The surface at one point [m]: sample[0] its displacement from the paper [m], below zero in
   grooves; sample[1] and sample[2] the displacement's derivative along x and y [m/m]. Zero off the
   letters and off the sheet. Neither allocates nor waits. MOONTRACE_BAD_CALL: a point that is not
   finite; `sample` is then all zero. Any thread, any time. */
MOONTRACE_API int moontrace_sample(const moontrace_page* page, double x, double y,
                                   double sample[3]);

/* Many points: where the numbers of the first one lie, and how many bytes further on those of the
   next, below zero for arrays that run back. Coordinates may have a step of 0, one for all. What is
   not wanted is NULL. Nothing that is written may lie over what is read. */
struct moontrace_samples {
  uint32_t size;     /* sizeof this struct, set by the caller */
  uint32_t reserved; /* 0 */
  size_t count;      /* of points, may be 0 */
  const double* x;   /* [m] */
  ptrdiff_t x_step;  /* [bytes] */
  const double* y;
  ptrdiff_t y_step;
  double* displacement; /* [m] */
  ptrdiff_t displacement_step;
  double* gradient_x; /* [m/m] */
  ptrdiff_t gradient_x_step;
  double* gradient_y;
  ptrdiff_t gradient_y_step;
};
/* The same numbers as moontrace_sample gives one by one, to the last bit, in less time where
   neighbours follow each other. Fastest where x and y stand side by side, and so the three that are
   written, one point behind the other. No array is copied. A point that is not finite gets zeros;
   all others are done, and the answer is MOONTRACE_BAD_CALL. Any thread, any time. */
MOONTRACE_API int moontrace_sample_many(const moontrace_page* page,
                                        const struct moontrace_samples* samples);

/* How the page answers a tip. NULL in its place, or zeros: 1000 N/m, 4 N, the potential law. */
struct moontrace_surface {
  uint32_t size; /* sizeof this struct, set by the caller */
  uint32_t law;  /* 0: the gradient of a potential; 1: as in the paper, along the normal, cut off */
  double stiffness; /* [N/m] */
  double force_cap; /* greatest force [N] */
};

/* The force on a tip at a point (x, y, z) [N], zero outside the surface; z is the height above the
   flat paper. Neither allocates nor waits. MOONTRACE_BAD_CALL: a point that is not finite; `force`
   is then all zero. Any thread, any time. */
MOONTRACE_API int moontrace_force(const moontrace_page* page,
                                  const struct moontrace_surface* surface, double x, double y,
                                  double z, double force[3]);

/* Many points, as moontrace_samples. */
struct moontrace_forces {
  uint32_t size;     /* sizeof this struct, set by the caller */
  uint32_t reserved; /* 0 */
  size_t count;      /* of points, may be 0 */
  const double* x;   /* [m] */
  ptrdiff_t x_step;  /* [bytes] */
  const double* y;
  ptrdiff_t y_step;
  const double* z;
  ptrdiff_t z_step;
  double* force_x; /* [N] */
  ptrdiff_t force_x_step;
  double* force_y;
  ptrdiff_t force_y_step;
  double* force_z;
  ptrdiff_t force_z_step;
};
/* The same numbers as moontrace_force gives one by one, to the last bit; else as
   moontrace_sample_many. Any thread, any time. */
MOONTRACE_API int moontrace_force_many(const moontrace_page* page,
                                       const struct moontrace_surface* surface,
                                       const struct moontrace_forces* forces);

/* --- objects (interface 2) -------------------------------------------------------------------- */

/* A solid and where a page lies on it. Frame O, the object: its origin is the solid's middle (of a
   plane on it), z goes along the axis of what has one, out of a plane. Zero or NULL is what is
   usual. */
struct moontrace_shape {
  uint32_t size;    /* sizeof this struct, set by the caller */
  uint32_t corner;  /* 0: (u, v) is the middle of what stands on the page; 1: the page's corner */
  const char* kind; /* "plane", "box", "cylinder", "sphere", "capsule", "ellipsoid" */
  const char*
      face;       /* of a plane "top"; of a box also "bottom", "front" (-y), "back", "left", "right"
                     (+x); of a cylinder "top", "bottom", "round"; of the others "round". Usual:
                     "top" of a plane or box, else "round" */
  double half[3]; /* plane: half its length and width, 0 without an edge; box: half its lengths;
                     cylinder, capsule: radius, half the length without caps; sphere: radius;
                     ellipsoid: semi-axes [m] */
  double u;       /* on the face, from its middle, to the right as seen from outside; round faces:
                     around from the front [m] */
  double v;       /* up; round faces: along z [m] */
  double turn;    /* of the page on the face, to the left [rad] */
};

/* Lays a page on a solid. The page is needed no more. MOONTRACE_BAD_INPUT: no such kind, a face
   that it has not, no room for what stands on the page. MOONTRACE_BAD_CALL: a size that is not
   above zero, or a size or place above 1000 m. Any thread, any time. */
MOONTRACE_API int moontrace_object_open(const moontrace_page* page,
                                        const struct moontrace_shape* shape,
                                        moontrace_object** object);

struct moontrace_object_facts {
  uint32_t size;      /* sizeof this struct, set by the caller */
  uint32_t reserved;  /* 0 */
  const char* face;   /* that carries the page; lives for ever */
  double text_width;  /* of what stands on the page [m] */
  double text_height; /* [m] */
  double least_scale; /* lengths on the page over those on the surface there; 1: true to scale */
  double greatest_scale;
  double greatest_depth; /* below the surface, to where the nearest face is sure; INFINITY [m] */
};
/* Any thread, any time. */
MOONTRACE_API int moontrace_object_describe(const moontrace_object* object,
                                            struct moontrace_object_facts* facts);

/* Where a place over the page, P, z above it, lies in the frame O [m]. MOONTRACE_BAD_CALL: a place
   that is not finite. Any thread, any time. */
MOONTRACE_API int moontrace_object_place(const moontrace_object* object, double x, double y,
                                         double z, double place[3]);

/* The surface nearest to a point of O [m]: sample[0] the page's displacement there along the smooth
   surface's normal [m]; sample[1] to sample[3] its gradient in space [m/m]; sample[4] the point's
   height above the smooth surface, below zero inside [m]. Neither allocates nor waits.
   MOONTRACE_BAD_CALL: a point that is not finite; `sample` is then all zero. Any thread, any time.
 */
MOONTRACE_API int moontrace_object_sample(const moontrace_object* object, double x, double y,
                                          double z, double sample[5]);

/* The force on a tip at a point of O, along its axes [N]; else as moontrace_force. */
MOONTRACE_API int moontrace_object_force(const moontrace_object* object,
                                         const struct moontrace_surface* surface, double x,
                                         double y, double z, double force[3]);

/* Many points, as moontrace_samples. */
struct moontrace_object_samples {
  uint32_t size;     /* sizeof this struct, set by the caller */
  uint32_t reserved; /* 0 */
  size_t count;      /* of points, may be 0 */
  const double* x;   /* [m] */
  ptrdiff_t x_step;  /* [bytes] */
  const double* y;
  ptrdiff_t y_step;
  const double* z;
  ptrdiff_t z_step;
  double* displacement; /* [m] */
  ptrdiff_t displacement_step;
  double* gradient_x; /* [m/m] */
  ptrdiff_t gradient_x_step;
  double* gradient_y;
  ptrdiff_t gradient_y_step;
  double* gradient_z;
  ptrdiff_t gradient_z_step;
  double* height; /* [m] */
  ptrdiff_t height_step;
};
/* The same numbers as moontrace_object_sample gives one by one; a point that is not finite as in
   moontrace_sample_many. Any thread, any time. */
MOONTRACE_API int moontrace_object_sample_many(const moontrace_object* object,
                                               const struct moontrace_object_samples* samples);

/* The same numbers as moontrace_object_force gives one by one, else as moontrace_force_many. */
MOONTRACE_API int moontrace_object_force_many(const moontrace_object* object,
                                              const struct moontrace_surface* surface,
                                              const struct moontrace_forces* forces);

/* As moontrace_script_close. */
MOONTRACE_API int moontrace_object_close(moontrace_object* object);

#ifdef __cplusplus
}
#endif

#endif /* MOONTRACE_H_ */
/* NOLINTEND */
