#include "sim/app/commands.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <iostream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "sim/console/line_buffer.h"
#include "sim/console/line_reader.h"
#include "sim/tutor/tutor_command.h"
#include "sim/tutor/tutor_messages.h"
#include "sim/tutor/tutor_socket.h"
#include "textures/base/error.h"
#include "textures/base/nearest_word.h"

namespace moontrace {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kLongestLine = 4000;                  // of the lesson [bytes]
constexpr std::size_t kMostUnsent = std::size_t{1} << 16U;  // [bytes]
constexpr int kAtOnce = 20;                                 // lines read before they are sent
constexpr int kPatience = 50;                               // [ms] until Ctrl-C is looked for
constexpr std::chrono::seconds kLastAnswer{5};

FileDescriptor Connected(const std::string& learner_given) {
  const std::string folder = TutorFolder();
  std::string learner = learner_given;
  if (learner.empty()) {
    const std::vector<std::string> live = LearnersWithTutorSockets(folder);
    if (live.size() > 1) throw LackError(say::SeveralLessons(live));
    if (live.empty()) throw LackError(say::NoLessonRuns("", ""));
    learner = live.front();
  }
  const std::string path = folder + "/" + TutorSocketName(learner);
  FileDescriptor fd = ConnectTo(path);
  const int error = errno;
  if (!fd && (error == ENOENT || error == ECONNREFUSED)) {
    const std::string nearest = NearestWord(learner, LearnersWithTutorSockets(folder));
    throw LackError(say::NoLessonRuns(learner, nearest));
  }
  if (!fd) throw LackError(say::LessonRefused(path, std::generic_category().message(error)));
  if (!PeerIsOwner(fd.get())) throw LackError(say::LessonRefused(path, "it is another user's"));
  return fd;
}

/// A conversation with a lesson.
class Talk {
 public:
  Talk(FileDescriptor fd, bool json, Console& console)
      : fd_(std::move(fd)), json_(json), console_(console), lines_(console.in()) {}

  void Run() {
    while (open_ || !in_.empty()) {
      console_.CheckStop();
      if (leaving_ && Clock::now() >= until_) throw WorkFailed(say::LessonSilent());
      Wait();
      if (!leaving_) Listen();
      if (open_) Send();
      if (open_) Receive();
      while (const std::optional<std::string> line = in_.Next()) Show(*line);
      console_.out().flush();
    }
    if (!leaving_) Show(say::LessonEnded());
    console_.out().flush();
  }

 private:
  void Wait() {
    const bool hears = !leaving_ && &console_.in() == &std::cin && out_.size() < kMostUnsent;
    const int writes = out_.empty() ? 0 : POLLOUT;
    pollfd polled[] = {{fd_.get(), static_cast<short>(POLLIN | writes), 0},
                       {hears ? STDIN_FILENO : -1, POLLIN, 0}};
    poll(polled, 2, kPatience);
  }

  /// The tutor's lines; their end is a "quit", so that all is answered before it.
  void Listen() {
    for (int lines = 0; lines < kAtOnce && out_.size() < kMostUnsent; ++lines) {
      const std::optional<std::string> line = lines_.Next(0);
      if (!line) break;
      out_ += *line + "\n";
      if (IsQuit(*line)) return Leave();
    }
    if (!lines_.ended()) return;
    out_ += "quit\n";
    Leave();
  }

  static bool IsQuit(const std::string& line) {
    const auto read = ReadTutorCommand(line);
    const TutorCommand* command = std::get_if<TutorCommand>(&read);
    return command != nullptr && command->word == TutorWord::kQuit;
  }

  void Leave() {
    leaving_ = true;
    until_ = Clock::now() + kLastAnswer;
  }

  void Send() {
    while (!out_.empty()) {
      const ssize_t sent = send(fd_.get(), out_.data(), out_.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      if (sent < 0) return;  // what the lesson still said is read first
      out_.erase(0, static_cast<std::size_t>(sent));
    }
  }

  void Receive() {
    char block[4096];
    const ssize_t count = recv(fd_.get(), block, sizeof block, MSG_DONTWAIT);
    if (count > 0) {
      in_.Feed({block, static_cast<std::size_t>(count)});
      if (leaving_) until_ = Clock::now() + kLastAnswer;
      return;
    }
    open_ = count < 0 && (errno == EAGAIN || errno == EINTR);
  }

  void Show(const std::string& line) {
    if (json_) return console_.Json(nlohmann::json{{"line", line}}.dump());
    console_.Result(line);
  }

  FileDescriptor fd_;
  bool json_;
  Console& console_;
  LineReader lines_;
  LineBuffer in_{kLongestLine};
  std::string out_;
  bool open_ = true;
  bool leaving_ = false;
  Clock::time_point until_;
};

}  // namespace

void AddOptions(CLI::App& app, TutorOptions& options) {
  app.add_option("--learner", options.learner, say::help::kTutorLearner)->type_name("NAME");
  AddOptions(app, options.output);
}

int Run(const TutorOptions& options, Console& console) {
  Talk(Connected(options.learner), options.output.json, console).Run();
  return exit_code::kGood;
}

}  // namespace moontrace
