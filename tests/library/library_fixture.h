#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "sim/library/moontrace.h"

namespace moontrace {

/// Handles that are closed at the end; a failure to open one fails the test.
struct OpenPage {
  explicit OpenPage(const char* words, const moontrace_style* style = nullptr,
                    const char* name = "moon") {
    EXPECT_EQ(moontrace_script_open(name, nullptr, &script), MOONTRACE_DONE) << moontrace_message();
    EXPECT_EQ(moontrace_text_open(script, words, style, &text), MOONTRACE_DONE)
        << moontrace_message();
    EXPECT_EQ(moontrace_page_open(text, 0, &page), MOONTRACE_DONE) << moontrace_message();
  }
  ~OpenPage() {
    moontrace_page_close(page);
    moontrace_text_close(text);
    moontrace_script_close(script);
  }
  OpenPage(const OpenPage&) = delete;
  OpenPage& operator=(const OpenPage&) = delete;

  moontrace_script* script = nullptr;
  moontrace_text* text = nullptr;
  moontrace_page* page = nullptr;
};

template <class Struct>
Struct Sized() {
  Struct given{};
  given.size = sizeof given;
  return given;
}

}  // namespace moontrace
