// The program in a window, by mouse and keyboard.

#include <gtest/gtest.h>

#include "lessons/records/records.h"
#include "tests/sim/display_fixture.h"
#include "tests/sim/learn_fixture.h"
#include "tests/sim/pty_fixture.h"

// behind the others, whose names its macros would take
#if __has_include(<X11/Xlib.h>)
#include <X11/Xlib.h>
#include <dlfcn.h>
#define MOONTRACE_HAVE_XLIB
#endif

namespace moontrace {
namespace {

/// What a window manager does when its user closes a window. False: without Xlib, or no window.
bool CloseWindow(const std::string& name) {
#ifdef MOONTRACE_HAVE_XLIB
  FILE* found = popen(("xdotool search --name " + name).c_str(), "r");
  unsigned long window = 0;
  const bool there = found != nullptr && std::fscanf(found, "%lu", &window) == 1;
  if (found != nullptr) pclose(found);
  void* xlib = dlopen("libX11.so.6", RTLD_NOW);
  if (!there || xlib == nullptr) return false;
  const auto open = reinterpret_cast<decltype(&XOpenDisplay)>(dlsym(xlib, "XOpenDisplay"));
  const auto atom = reinterpret_cast<decltype(&XInternAtom)>(dlsym(xlib, "XInternAtom"));
  const auto send = reinterpret_cast<decltype(&XSendEvent)>(dlsym(xlib, "XSendEvent"));
  const auto close = reinterpret_cast<decltype(&XCloseDisplay)>(dlsym(xlib, "XCloseDisplay"));
  ::Display* display = open(nullptr);
  if (display == nullptr) return false;
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = window;
  event.xclient.message_type = atom(display, "WM_PROTOCOLS", 0);
  event.xclient.format = 32;
  event.xclient.data.l[0] = static_cast<long>(atom(display, "WM_DELETE_WINDOW", 0));
  const bool sent = send(display, window, 0, NoEventMask, &event) != 0;
  close(display);
  return sent;
#else
  return name.empty();
#endif
}

class SlowViewByHand : public LearnTest {
 protected:
  void SetUp() override {
    if (!IsInstalled("Xvfb") || !IsInstalled("xdotool")) {
      GTEST_SKIP() << "without xvfb and xdotool";
    }
    SKIP_WITHOUT_TERMINALS();
    display_ = std::make_unique<TestDisplay>();
    ASSERT_TRUE(display_->runs());
  }

  /// A window whose title holds this.
  bool Titled(const std::string& part) const {
    return Eventually([&] { return display_->Do({"search", "--name", part}); });
  }
  /// Begins, and waits until the window has told an answer: then panel and loop are there.
  bool Begin(const std::vector<std::string>& args) {
    session_ = std::make_unique<PtySession>(args);
    if (!Titled("Moontrace") || !display_->MoveTo(700, 300)) return false;
    session_->Send("back\n");
    return Titled("one page only");
  }
  bool Keys(std::vector<std::string> keys) const {
    keys.insert(keys.begin(), {"key", "--clearmodifiers"});
    return display_->Do(keys);
  }

  std::unique_ptr<TestDisplay> display_;
  std::unique_ptr<PtySession> session_;  // ends before its display
};

/// The controls of the panel in their order: the key that changes each, and what is said then.
const std::pair<const char*, const char*> kPanel[] = {
    {"Right", "Letters of 13 mm"},         {"Right", "Depth 110 percent"},
    {"Right", "Width 110 percent"},        {"Right", "Embossed"},
    {"Right", "H has the form arc"},       {"Right", "Lines apart 110 percent"},
    {"Right", "Page tilted by 5 degrees"}, {"Right", "Paper sine"},
    {"Return", "Stopped. Say go"},         {"Return", "Going on"},
    {"Return", "one page only"},           {"Return", "one page only"}};

TEST_F(SlowViewByHand, EachControlOfThePanelIsSaidAndDone) {
  ASSERT_TRUE(Begin({"view", "hat"})) << session_->all();
  for (const auto& [key, said] : kPanel) {
    ASSERT_TRUE(Keys({"Tab", key}));
    ASSERT_TRUE(session_->WaitFor(said)) << said << '\n' << session_->all();
  }
  ASSERT_TRUE(display_->Do({"type", "quit"}));
  ASSERT_TRUE(Keys({"Return"}));
  EXPECT_EQ(session_->Wait(), 0);
  EXPECT_NE(session_->all().find("Ran "), std::string::npos);
}

TEST_F(SlowViewByHand, TheReportHasWhatThePanelChanged) {
  ASSERT_TRUE(Begin({"view", "hat", "--json", "--quiet"})) << session_->all();
  for (const auto& [key, said] : kPanel) {
    ASSERT_TRUE(Keys({"Tab", key}));
    ASSERT_TRUE(Titled(said)) << said;
  }
  ASSERT_TRUE(display_->Do({"type", "quit"}));
  ASSERT_TRUE(Keys({"Return"}));
  EXPECT_EQ(session_->Wait(), 0);
  const std::string all = session_->all();
  const auto json = nlohmann::json::parse(all.substr(all.find('{')));
  EXPECT_EQ(json["device"]["name"], "mouse");
  EXPECT_DOUBLE_EQ(json["size_mm"], 13);
  // the design's 0.1165 em, 1.1 times; ridges a quarter as high as wide, 1.1 times
  EXPECT_NEAR(json["width_mm"], 0.1165 * 13 * 1.1, 1e-9);
  EXPECT_NEAR(json["depth_mm"], 0.1165 * 13 * 1.1 / 4 * 1.1, 1e-9);
  EXPECT_NEAR(json["line_pitch_mm"], 1.8 * 13 * 1.1, 1e-9);
  EXPECT_EQ(json["embossed"], true);
  EXPECT_EQ(json["h_form"], "arc");
  EXPECT_NEAR(json["tilt_deg"], 5, 1e-9);
  EXPECT_EQ(json["texture"]["kind"], "sine") << json["texture"];
  EXPECT_GT(json["view"]["frames"], 0);
  EXPECT_GE(json["safety"]["stopped"], 1);
}

TEST_F(SlowViewByHand, TheMousePressesAndTheGrooveAnswers) {
  ASSERT_TRUE(Begin({"view", "i", "--size-mm", "40", "--json", "--quiet"})) << session_->all();
  // down along the middle of the page's view, wherever the sign is
  ASSERT_TRUE(display_->Do({"mousedown", "1"}));
  EXPECT_TRUE(Eventually([&] {
    session_->Send("where\n");
    return display_->Do({"search", "--name", "page pushes with"});
  }));
  ASSERT_TRUE(display_->Do({"mouseup", "1"}));
  session_->Send("quit\n");
  EXPECT_EQ(session_->Wait(), 0);
  const std::string all = session_->all();
  const auto json = nlohmann::json::parse(all.substr(all.find('{')));
  EXPECT_GT(json["touching"], 0);
  EXPECT_GT(json["peak_force_n"], 0.1);
}

TEST_F(SlowViewByHand, ClosingTheWindowEndsItInOrder) {
  ASSERT_TRUE(Begin({"loop", "hat", "--view"})) << session_->all();
  if (!CloseWindow("Moontrace")) GTEST_SKIP() << "without Xlib";
  EXPECT_EQ(session_->Wait(), 0);
  EXPECT_NE(session_->all().find("Window closed: this ends."), std::string::npos);
  EXPECT_NE(session_->all().find("Ran "), std::string::npos);
  ExpectStream(session_->all());
}

/// The exit code of a command whose input is /dev/null; -1: it did not end within a minute.
int CodeWithoutInput(const std::vector<std::string>& args) {
  std::cout.flush();
  const pid_t child = fork();
  if (child == 0) {
    const int nothing = open("/dev/null", O_RDWR);
    for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nothing, fd);
    Console console(std::cin, std::cout, std::cerr);
    _exit(RunCli(args, console));
  }
  int status = 0;
  const bool ended = Eventually([&] { return waitpid(child, &status, WNOHANG) == child; });
  if (ended) return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  kill(child, SIGKILL);
  waitpid(child, &status, 0);
  return -1;
}

TEST_F(SlowViewByHand, InputThatHasEndedEndsTheWindowToo) {
  EXPECT_EQ(CodeWithoutInput({"view", "hat"}), 0);
  EXPECT_EQ(CodeWithoutInput({"loop", "hat", "--view"}), 0);
}

TEST_F(SlowViewByHand, ADisplayThatIsLostIsOneLineAndTheLoopGoesOn) {
  ASSERT_TRUE(Begin({"loop", "hat", "--view"})) << session_->all();
  display_->Kill();
  ASSERT_TRUE(session_->WaitFor("isplay was lost")) << session_->all();
  EXPECT_TRUE(session_->Ask("where")) << session_->all();
  session_->Send("quit\n");
  EXPECT_EQ(session_->Wait(), 0);
}

TEST_F(SlowViewByHand, ThePanelIsTheTutorsInALesson) {
  session_ = std::make_unique<PtySession>(Learn({"--view"}));
  ASSERT_TRUE(session_->WaitFor("say next to go on.")) << session_->all();
  ASSERT_TRUE(Titled("Moontrace") && display_->MoveTo(700, 300));
  session_->Send("where\n");
  ASSERT_TRUE(Titled("[Ll]esson 1 of 2")) << session_->all();
  // help, mode, then the buttons: stop, pause, go, again, next, next lesson, show; size, depth
  ASSERT_TRUE(Keys({"Tab", "Tab", "Tab", "Return"}));
  EXPECT_TRUE(session_->WaitFor("Stopped. Say go")) << session_->all();
  ASSERT_TRUE(Keys({"Tab", "Tab", "Return"}));
  EXPECT_TRUE(session_->WaitFor("Going on.")) << session_->all();
  ASSERT_TRUE(Keys({"Tab", "Tab", "Tab", "Tab", "Tab", "Right"}));
  EXPECT_TRUE(session_->WaitFor("17 mm")) << session_->all();
  ASSERT_TRUE(Keys({"Tab", "Right"}));
  EXPECT_TRUE(session_->WaitFor("Depth 110 percent")) << session_->all();
  // the word that lessons tell the learner to say is the learner's here too
  ASSERT_TRUE(display_->Do({"type", "next"}));
  ASSERT_TRUE(Keys({"Return"}));
  if (!CloseWindow("Moontrace")) GTEST_SKIP() << "without Xlib";
  EXPECT_EQ(session_->Wait(), 0);
  EXPECT_NE(session_->all().find("Ended: "), std::string::npos);
  EXPECT_EQ(session_->all().find("The next lesson"), std::string::npos);
  ExpectStream(session_->all());
  std::vector<std::string> kept;
  for (const RecordedEvent& event : Records::OpenToRead(In("records.sqlite")).Events("ann")) {
    if (event.kind == "tutor") kept.push_back(event.text);
  }
  EXPECT_EQ(kept, (std::vector<std::string>{"stop", "go", "size 17 mm", "depth 110 %"}));
}

TEST_F(SlowViewByHand, TheKeyboardIsTheLearners) {
  session_ = std::make_unique<PtySession>(
      std::vector<std::string>{"learn", "--course", In("course"), "--records", In("records.sqlite"),
                               "--learner", "ann", "--device", "mouse", "--view"});
  ASSERT_TRUE(session_->WaitFor("say next to go on.")) << session_->all();
  ASSERT_TRUE(Titled("Moontrace") && display_->MoveTo(700, 300));
  session_->Send("where\n");
  ASSERT_TRUE(Titled("[Ll]esson 1 of 2")) << session_->all();
  const auto type = [this](const std::string& line) {
    return display_->Do({"type", line}) && Keys({"Return"});
  };
  ASSERT_TRUE(Keys({"Escape"}));
  EXPECT_TRUE(session_->WaitFor("Stopped. Say go")) << session_->all();
  ASSERT_TRUE(type("go"));
  EXPECT_TRUE(session_->WaitFor("Going on.")) << session_->all();
  ASSERT_TRUE(type("size 20"));  // a word that only tutors have
  EXPECT_TRUE(session_->WaitFor("Letters of 20 mm")) << session_->all();
  const std::size_t before = session_->all().size();
  ASSERT_TRUE(type("where"));
  EXPECT_TRUE(session_->WaitFor("Lesson 1 of 2, step 1 of 8")) << session_->all();
  EXPECT_EQ(session_->all().find("ann: Lesson", before), std::string::npos) << "as a tutor hears";
  ASSERT_TRUE(type("quit"));
  EXPECT_EQ(session_->Wait(), 0);  // though nobody answers at the terminal
  EXPECT_EQ(session_->all().find("may the path"), std::string::npos) << session_->all();
  EXPECT_EQ(session_->all().find("Tutor: "), std::string::npos) << session_->all();
  std::vector<std::string> kept;
  for (const RecordedEvent& event : Records::OpenToRead(In("records.sqlite")).Events("ann")) {
    if (event.kind == "stop" || event.kind == "tutor")
      kept.push_back(event.kind + " " + event.text);
  }
  EXPECT_EQ(kept, (std::vector<std::string>{"stop learner", "tutor size 20"}));
}

TEST_F(SlowViewByHand, NothingIsFeltOfAMouse) {
  session_ = std::make_unique<PtySession>(
      std::vector<std::string>{"learn", "--course", In("course"), "--records", In("records.sqlite"),
                               "--learner", "ann", "--device", "mouse", "--view"});
  EXPECT_TRUE(session_->WaitFor("nothing is felt")) << session_->all();
  session_->Send("quit\n\n");
  EXPECT_EQ(session_->Wait(), 0);
}

}  // namespace
}  // namespace moontrace
