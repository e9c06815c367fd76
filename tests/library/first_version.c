/* A program as it was compiled against the first version of the library: with the declarations of
   then, not with today's header. It must run with every later library of the same soname, and the
   layouts must be those of then. Never change what stands here; add a file for a later version. */
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

typedef struct moontrace_script moontrace_script;
typedef struct moontrace_text moontrace_text;
typedef struct moontrace_page moontrace_page;

struct style_1 {
  uint32_t size, embossed, rules, raised_margin, structure, reserved;
  const char* sheet;
  double margin, letter_size, width, depth, rounding, letter_gap, word_gap, line_pitch, grade;
  const char *h_form, *table, *only, *lines, *links, *hyphenation;
};
struct script_facts_1 {
  uint32_t size, reserved;
  const char *name, *title, *author, *licence;
  size_t signs;
  double letter_size;
};
struct text_facts_1 {
  uint32_t size, reserved;
  size_t pages, letters, folded, missing;
  double letter_size, width, depth, line_pitch;
};
struct page_facts_1 {
  uint32_t size, reserved;
  double width, height;
  size_t letters, lines;
  double greatest_fall, greatest_rise, greatest_slope;
};
struct letter_1 {
  uint32_t size, reserved;
  const char* sign;
  double x, y;
  size_t line, word, source_begin, source_end;
};
struct samples_1 {
  uint32_t size, reserved;
  size_t count;
  const double* x;
  ptrdiff_t x_step;
  const double* y;
  ptrdiff_t y_step;
  double* displacement;
  ptrdiff_t displacement_step;
  double* gradient_x;
  ptrdiff_t gradient_x_step;
  double* gradient_y;
  ptrdiff_t gradient_y_step;
};
struct surface_1 {
  uint32_t size, law;
  double stiffness, force_cap;
};
struct forces_1 {
  uint32_t size, reserved;
  size_t count;
  const double* x;
  ptrdiff_t x_step;
  const double* y;
  ptrdiff_t y_step;
  const double* z;
  ptrdiff_t z_step;
  double* force_x;
  ptrdiff_t force_x_step;
  double* force_y;
  ptrdiff_t force_y_step;
  double* force_z;
  ptrdiff_t force_z_step;
};

int moontrace_check(uint32_t);
const char* moontrace_version(void);
const char* moontrace_message(void);
int moontrace_script_open(const char*, const char*, moontrace_script**);
int moontrace_script_describe(const moontrace_script*, struct script_facts_1*);
int moontrace_script_close(moontrace_script*);
int moontrace_text_open(const moontrace_script*, const char*, const struct style_1*,
                        moontrace_text**);
int moontrace_text_describe(const moontrace_text*, struct text_facts_1*);
int moontrace_text_close(moontrace_text*);
int moontrace_page_open(const moontrace_text*, size_t, moontrace_page**);
int moontrace_page_describe(const moontrace_page*, struct page_facts_1*);
int moontrace_page_letter(const moontrace_page*, size_t, struct letter_1*);
int moontrace_page_draw(const moontrace_page*, const char*, uint32_t);
int moontrace_page_close(moontrace_page*);
int moontrace_sample(const moontrace_page*, double, double, double[3]);
int moontrace_sample_many(const moontrace_page*, const struct samples_1*);
int moontrace_force(const moontrace_page*, const struct surface_1*, double, double, double,
                    double[3]);
int moontrace_force_many(const moontrace_page*, const struct surface_1*, const struct forces_1*);

#define REQUIRE(holds)                                                             \
  do {                                                                             \
    if (!(holds)) {                                                                \
      fprintf(stderr, "line %d: %s; %s\n", __LINE__, #holds, moontrace_message()); \
      return 1;                                                                    \
    }                                                                              \
  } while (0)

/* An I, 20 mm high, and the deepest point of its groove. */
static int read_page(moontrace_text* text) {
  moontrace_page* page = NULL;
  struct text_facts_1 set = {sizeof set, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  struct page_facts_1 facts = {sizeof facts, 0, 0, 0, 0, 0, 0, 0, 0};
  struct letter_1 letter = {sizeof letter, 0, NULL, 0, 0, 9, 9, 9, 9};
  struct surface_1 surface = {sizeof surface, 0, 500, 2};
  struct samples_1 samples = {sizeof samples, 0, 200, NULL, 8, NULL, 0, NULL, 8, NULL, 0, NULL, 0};
  struct forces_1 forces = {sizeof forces, 0, 1,    NULL, 0,    NULL, 0, NULL, 0,
                            NULL,          0, NULL, 0,    NULL, 8};
  double x[200], height[200], y, z = -0.0004, one[3], force, deepest = 0;
  int i;

  REQUIRE(moontrace_text_describe(text, &set) == 0);
  REQUIRE(set.pages == 1 && set.letters == 1 && set.missing == 0 && set.letter_size == 0.020);
  REQUIRE(moontrace_page_open(text, 0, &page) == 0);
  REQUIRE(moontrace_page_describe(page, &facts) == 0);
  REQUIRE(fabs(facts.width - 0.060) < 1e-12 && fabs(facts.height - 0.050) < 1e-12);
  REQUIRE(facts.letters == 1 && facts.lines == 1 && facts.greatest_rise == 0);
  REQUIRE(moontrace_page_letter(page, 0, &letter) == 0);
  REQUIRE(letter.sign[0] == 'i' && letter.line == 0 && letter.source_begin == 0 &&
          letter.source_end == 1);

  y = letter.y + 0.010; /* half the letter's height */
  for (i = 0; i < 200; ++i) x[i] = letter.x + 0.0001 * i;
  samples.x = x;
  samples.y = &y;
  samples.displacement = height;
  REQUIRE(moontrace_sample_many(page, &samples) == 0);
  for (i = 0; i < 200; ++i) deepest = height[i] < deepest ? height[i] : deepest;
  /* half the groove's width, as deep as it goes, within the 0.05 mm between two points */
  REQUIRE(deepest < 0 && fabs(deepest + set.depth) < 0.0001 && deepest >= -facts.greatest_fall);
  REQUIRE(moontrace_sample(page, x[7], y, one) == 0 && one[0] == height[7]);

  x[0] = y = 0.002; /* flat paper: a spring of 500 N/m, 0.4 mm deep */
  REQUIRE(moontrace_force(page, &surface, x[0], y, z, one) == 0 && fabs(one[2] - 0.2) < 1e-12);
  forces.x = x;
  forces.y = &y;
  forces.z = &z;
  forces.force_z = &force;
  REQUIRE(moontrace_force_many(page, &surface, &forces) == 0 && force == one[2]);
  REQUIRE(moontrace_page_draw(page, "/no/such/folder/i.svg", 0) == 4);
  REQUIRE(moontrace_page_close(page) == 0);
  REQUIRE(moontrace_page_close(page) == 2);
  return 0;
}

int main(void) {
  moontrace_script* script = NULL;
  moontrace_text* text = NULL;
  struct script_facts_1 facts = {sizeof facts, 0, NULL, NULL, NULL, NULL, 0, 0};
  struct style_1 style = {sizeof style,
                          0,
                          0,
                          0,
                          0,
                          0,
                          "60x50",
                          0,
                          0.020,
                          0,
                          0,
                          0,
                          0,
                          0,
                          0,
                          0,
                          NULL,
                          NULL,
                          NULL,
                          "left-to-right",
                          "none",
                          NULL};

  REQUIRE(moontrace_check(1) == 0 && moontrace_version()[0] != '\0');
  REQUIRE(moontrace_script_open("moon", NULL, &script) == 0);
  REQUIRE(moontrace_script_describe(script, &facts) == 0 && facts.signs > 26);
  REQUIRE(moontrace_text_open(script, "i", &style, &text) == 0);
  REQUIRE(moontrace_script_close(script) == 0);
  if (read_page(text) != 0) return 1;
  REQUIRE(moontrace_text_close(text) == 0);
  return 0;
}
