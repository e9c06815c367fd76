/* A program of somebody else in C: the letters of a text and where they stand. */
#include <moontrace.h>
#include <stdio.h>
#include <string.h>

static int failed(void) {
  fprintf(stderr, "%s\n", moontrace_message());
  return 1;
}

int main(void) {
  moontrace_script* script = NULL;
  moontrace_text* text = NULL;
  moontrace_page* page = NULL;
  struct moontrace_script_facts script_facts;
  struct moontrace_page_facts facts;
  struct moontrace_letter letter;
  size_t i;

  if (moontrace_check(MOONTRACE_INTERFACE)) return failed();
  if (moontrace_script_open("moon", NULL, &script)) return failed();
  memset(&script_facts, 0, sizeof script_facts);
  script_facts.size = sizeof script_facts;
  if (moontrace_script_describe(script, &script_facts)) return failed();
  printf("%s\n", script_facts.title);
  if (moontrace_text_open(script, "moon", NULL, &text)) return failed();
  if (moontrace_page_open(text, 0, &page)) return failed();
  memset(&facts, 0, sizeof facts);
  facts.size = sizeof facts;
  if (moontrace_page_describe(page, &facts)) return failed();
  for (i = 0; i < facts.letters; ++i) {
    memset(&letter, 0, sizeof letter);
    letter.size = sizeof letter;
    if (moontrace_page_letter(page, i, &letter)) return failed();
    printf("%s at %.1f mm\n", letter.sign, 1000 * letter.x);
  }
  if (moontrace_page_close(page) || moontrace_text_close(text) || moontrace_script_close(script))
    return failed();
  return 0;
}
