#include <gtest/gtest.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <set>

#include "sim/view/view_messages.h"
#include "sim/view/view_window.h"
#include "sim/view/viewer.h"
#include "tests/sim/display_fixture.h"
#include "tests/sim/view_fixture.h"
#include "textures/base/error.h"

// last: its macros are everywhere
#if __has_include(<X11/Xlib.h>)
#include <X11/Xlib.h>
#include <dlfcn.h>
#undef None
#undef Status
#undef Success
#endif

namespace moontrace {
namespace {

#if __has_include(<X11/Xlib.h>)

/// Sends WM_DELETE_WINDOW to the window of this name.
bool AskToClose(const char* name) {
  void* xlib = dlopen("libX11.so.6", RTLD_NOW);
  if (xlib == nullptr) return false;
  const auto open = reinterpret_cast<decltype(&XOpenDisplay)>(dlsym(xlib, "XOpenDisplay"));
  const auto atom = reinterpret_cast<decltype(&XInternAtom)>(dlsym(xlib, "XInternAtom"));
  const auto tree = reinterpret_cast<decltype(&XQueryTree)>(dlsym(xlib, "XQueryTree"));
  const auto name_of = reinterpret_cast<decltype(&XFetchName)>(dlsym(xlib, "XFetchName"));
  const auto send = reinterpret_cast<decltype(&XSendEvent)>(dlsym(xlib, "XSendEvent"));
  const auto release = reinterpret_cast<decltype(&XFree)>(dlsym(xlib, "XFree"));
  const auto close = reinterpret_cast<decltype(&XCloseDisplay)>(dlsym(xlib, "XCloseDisplay"));
  ::Display* display = open(nullptr);
  if (display == nullptr) return false;
  Window root = 0, parent = 0, *children = nullptr;
  unsigned int count = 0;
  tree(display, DefaultRootWindow(display), &root, &parent, &children, &count);
  bool sent = false;
  for (unsigned int i = 0; i < count; ++i) {
    char* title = nullptr;
    if (name_of(display, children[i], &title) == 0 || title == nullptr) continue;
    if (std::string(title).rfind(name, 0) == 0) {
      XEvent event{};
      event.xclient.type = ClientMessage;
      event.xclient.window = children[i];
      event.xclient.message_type = atom(display, "WM_PROTOCOLS", False);
      event.xclient.format = 32;
      event.xclient.data.l[0] = static_cast<long>(atom(display, "WM_DELETE_WINDOW", False));
      sent = send(display, children[i], False, NoEventMask, &event) != 0;
    }
    release(title);
  }
  if (children != nullptr) release(children);
  close(display);
  return sent;
}

#endif

class SlowViewWindow : public testing::Test {
 protected:
  void SetUp() override {
    if (!IsInstalled("Xvfb") || !IsInstalled("xdotool")) {
      GTEST_SKIP() << "without xvfb and xdotool";
    }
    display_ = std::make_unique<TestDisplay>();
    ASSERT_TRUE(display_->runs());
  }

  void Open(const ViewerOptions& options = {}) {
    try {
      viewer_ = std::make_unique<Viewer>(options);
    } catch (const LackError& lack) {
      GTEST_SKIP() << lack.what();  // built without GLFW
    }
    viewer_->Show(PageOf("moon"));
    viewer_->SetPanel(SmallPanel());
    viewer_->SetPanelValues(SmallValues());
    ASSERT_TRUE(Drawn(3));
    // without a window manager keys go to the window under the mouse
    ASSERT_TRUE(display_->MoveTo(700, 300));
  }
  bool Drawn(std::size_t frames) {
    const auto tell = [&] {
      // something new in every frame
      ViewMoment moment;
      moment.time = (time_ += 0.01);
      viewer_->Add(moment);
      return viewer_->report().frames >= frames;
    };
    return Eventually(tell);
  }
  bool Keys(const std::vector<std::string>& keys) {
    std::vector<std::string> words = {"key", "--clearmodifiers"};
    words.insert(words.end(), keys.begin(), keys.end());
    return display_->Do(words);
  }
  std::string Line() {
    std::optional<ViewLine> line;
    Eventually([&] { return (line = viewer_->NextLine()).has_value(); });
    of_panel_ = line && line->of_panel;
    return line ? line->text : "(nothing)";
  }

  std::unique_ptr<TestDisplay> display_;
  std::unique_ptr<Viewer> viewer_;  // ends before its display
  bool of_panel_ = false;           // the line that was heard last
  double time_ = 0;
};

TEST_F(SlowViewWindow, EachPanelControlSaysItsLineByKeys) {
  Open();
  if (!viewer_) return;
  ASSERT_TRUE(Keys({"Tab", "Right"}));
  EXPECT_EQ(Line(), "size 13 mm");
  ASSERT_TRUE(Keys({"Tab", "Right"}));
  EXPECT_EQ(Line(), "mode bead");
  ASSERT_TRUE(Keys({"Tab", "Return"}));
  EXPECT_EQ(Line(), "again");
  EXPECT_TRUE(of_panel_);
  ASSERT_TRUE(Keys({"shift+Tab", "Down"}));
  EXPECT_EQ(Line(), "mode attract");
}

// Down the panel, click by click: wherever the controls are, each is heard.
TEST_F(SlowViewWindow, EachPanelControlSaysItsLineByMouse) {
  Open();
  if (!viewer_) return;
  std::set<std::string> words;
  for (int y = 40; y < 240; y += 12) {
    ASSERT_TRUE(display_->Click(140, y));
    ASSERT_TRUE(Drawn(viewer_->report().frames + 2));
    while (std::optional<ViewLine> line = viewer_->NextLine()) {
      EXPECT_TRUE(line->of_panel) << line->text;
      words.insert(line->text.substr(0, line->text.find(' ')));
    }
  }
  EXPECT_EQ(words, (std::set<std::string>{"again", "mode", "size"}));
}

TEST_F(SlowViewWindow, WordsAreTyped) {
  Open();
  if (!viewer_) return;
  ASSERT_TRUE(display_->Do({"type", "helx"}));
  ASSERT_TRUE(Keys({"BackSpace"}));
  ASSERT_TRUE(display_->Do({"type", "p 3"}));
  ASSERT_TRUE(Keys({"Return"}));
  EXPECT_EQ(Line(), "help 3");
  EXPECT_FALSE(of_panel_);
  // a line that was begun does not hold up the stop
  ASSERT_TRUE(display_->Do({"type", "siz"}));
  ASSERT_TRUE(Keys({"Escape"}));
  EXPECT_EQ(Line(), "stop");
  EXPECT_FALSE(of_panel_) << "it is not the tutor who stops";
  ASSERT_TRUE(Keys({"space", "space"}));
  EXPECT_EQ(Line(), "go");
  EXPECT_EQ(Line(), "stop");  // the panel has no "pause"
}

TEST_F(SlowViewWindow, MouseAimsAndPresses) {
  std::mutex mutex;
  PointerAim last;
  ViewerOptions options;
  options.pointer = [&](const PointerAim& aim) {
    const std::lock_guard<std::mutex> lock(mutex);
    last = aim;
  };
  Open(options);
  if (!viewer_) return;
  const auto aims = [&](bool presses, double at_least) {
    return Eventually([&] {
      const std::lock_guard<std::mutex> lock(mutex);
      return last.over_page && (last.press > at_least) == presses;
    });
  };
  EXPECT_TRUE(aims(false, 0));
  ASSERT_TRUE(display_->Do({"mousedown", "1"}));
  EXPECT_TRUE(aims(true, 0));
  ASSERT_TRUE(display_->Do({"click", "4", "click", "4"}));  // two notches away from the hand
  EXPECT_TRUE(aims(true, 0.95));
  ASSERT_TRUE(display_->Do({"mouseup", "1"}));
  EXPECT_TRUE(aims(false, 0));
  viewer_.reset();  // it tells this function's variables
}

#if __has_include(<X11/Xlib.h>)

// As a window manager asks it to close.
TEST_F(SlowViewWindow, TellsWhenItIsClosed) {
  Open();
  if (!viewer_) return;
  EXPECT_FALSE(viewer_->closed());
  ASSERT_TRUE(AskToClose("Moontrace"));
  EXPECT_TRUE(Eventually([&] { return viewer_->closed(); }));
  EXPECT_EQ(viewer_->failure(), "");
}

#endif

TEST_F(SlowViewWindow, LivesThroughSizesAndDisappearing) {
  Open();
  if (!viewer_) return;
  for (const char* size : {"1", "60", "330", "900"}) {
    ASSERT_TRUE(display_->Do({"search", "--name", "Moontrace", "windowsize", size, size}));
    ASSERT_TRUE(Drawn(viewer_->report().frames + 2));
  }
  EXPECT_EQ(viewer_->NextNotice(), say::ViewTooSmall());  // once
  EXPECT_EQ(viewer_->NextNotice(), std::nullopt);
  ASSERT_TRUE(display_->Do({"search", "--name", "Moontrace", "windowunmap"}));
  ASSERT_TRUE(display_->Do({"search", "--name", "Moontrace", "windowmap"}));
  EXPECT_TRUE(Drawn(viewer_->report().frames + 2));
  EXPECT_EQ(viewer_->failure(), "");
}

TEST_F(SlowViewWindow, WithoutADisplayIsRefusedInOneLine) {
  display_->Kill();
  try {
    Viewer viewer{ViewerOptions{}};
    FAIL() << "opened";
  } catch (const LackError& lack) {
    const std::string text = lack.what();
    EXPECT_EQ(text.find('\n'), std::string::npos);
    EXPECT_LE(text.size(), 80U);
  }
}

TEST_F(SlowViewWindow, LosingTheDisplayIsToldAndEndsNothing) {
  Open();
  if (!viewer_) return;
  viewer_.reset();
  // in a program of its own: it may not end in the usual way (DisplayWasLost)
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  const auto lose = [this] {
    Open();
    display_->Kill();
    const bool told = Eventually([&] {
      ViewMoment moment;
      moment.time = (time_ += 0.01);
      viewer_->Add(moment);
      return !viewer_->failure().empty();
    });
    const bool why = viewer_->failure().find("display was lost") != std::string::npos;
    const bool silent = !viewer_->NextLine();
    viewer_.reset();  // does not wait for it
    bool refused = false;
    try {
      const Viewer another{ViewerOptions{}};
    } catch (const LackError&) {
      refused = true;
    }
    const bool known = ViewWindow::DisplayWasLost();
    std::fprintf(stderr, "told %d why %d silent %d refused %d known %d\n", told, why, silent,
                 refused, known);
    std::_Exit(0);
  };
  EXPECT_EXIT(lose(), testing::ExitedWithCode(0), "told 1 why 1 silent 1 refused 1 known 1");
}

}  // namespace
}  // namespace moontrace
