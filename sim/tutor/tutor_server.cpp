#include "sim/tutor/tutor_server.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include "sim/console/line_buffer.h"
#include "sim/tutor/tutor_messages.h"
#include "sim/tutor/tutor_socket.h"
#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kLongestLine = 1000;  // [bytes]
constexpr std::size_t kMostTutors = 8;
constexpr std::size_t kMostWaiting = 8;                     // lines of one tutor
constexpr std::size_t kMostUnread = std::size_t{1} << 16U;  // [bytes] that a tutor has not read
constexpr std::chrono::milliseconds kLastWords{200};        // for what is still to be sent
constexpr int kRest = 200;                                  // [ms] when nobody can be let in

constexpr std::size_t kMostSentences = 100;  // that nobody has taken

enum class Part { kStay, kLeft, kDropped };

}  // namespace

struct TutorServer::State {
  struct Tutor {
    FileDescriptor fd;
    std::size_t number = 0;
    LineBuffer in{kLongestLine};
    std::string out;
    bool dismissed = false;  ///< goes once `out` is sent
  };
  /// From the lesson to the thread.
  struct Letter {
    std::size_t tutor = 0;  ///< 0: all
    std::string line;
    bool dismiss = false;
  };

  State(const std::string& folder_of_socket, const std::string& learner,
        std::string_view greeting_in)
      : folder(folder_of_socket),
        socket((RequireTutorFolder(folder), folder + "/" + TutorSocketName(learner))),
        wake(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
        greeting(greeting_in) {
    if (!wake) throw LackError(say::CannotOpenSocket(socket.path(), "no descriptor is left"));
  }

  void Wake() const {
    const std::uint64_t one = 1;
    [[maybe_unused]] const ssize_t written = write(wake.get(), &one, sizeof one);
  }
  void Post(Letter letter) {
    {
      const std::lock_guard<std::mutex> guard(mutex);
      if (count == 0) return;
      letters.push_back(std::move(letter));
    }
    Wake();
  }
  void Note(std::string sentence) {
    const std::lock_guard<std::mutex> guard(mutex);
    if (sentences.size() < kMostSentences) sentences.push_back(std::move(sentence));
  }

  // The thread's.
  void Run();
  bool Round(bool ending);
  void TakeLetters();
  void LetIn();
  bool Crowded(std::size_t number) const;
  void Read(Tutor& tutor);
  void Deliver(Tutor& tutor);
  Part Send(Tutor& tutor) const;
  void LetGo(std::size_t index, Part part);

  std::string folder;
  TutorSocket socket;
  FileDescriptor wake;
  std::string greeting;

  mutable std::mutex mutex;  ///< never held while anything can wait
  std::deque<Line> lines;
  std::map<std::size_t, std::size_t> waiting;  ///< lines of each tutor in `lines`
  std::deque<Letter> letters;
  std::vector<std::string> sentences;
  std::size_t count = 0;  ///< of tutors
  bool ending = false;

  std::vector<Tutor> tutors;  ///< the thread's
  std::size_t last_number = 0;
  bool resting = false;  ///< no file descriptor was left for a new tutor

  std::deque<Line> batch;  ///< the caller's, see Next
  bool batch_ended = true;
  std::thread thread;
};

void TutorServer::State::Run() {
  Clock::time_point end = Clock::time_point::max();
  while (true) {
    bool is_ending = false;
    {
      const std::lock_guard<std::mutex> guard(mutex);
      is_ending = ending;
    }
    if (is_ending && end == Clock::time_point::max()) {
      end = Clock::now() + kLastWords;
      for (Tutor& tutor : tutors) tutor.dismissed = true;
    }
    if (!Round(is_ending)) return;
    if (is_ending && (tutors.empty() || Clock::now() >= end)) return;
  }
}

/// Waits for what comes, takes it, sends what is to be sent; false if it cannot wait any more.
bool TutorServer::State::Round(bool is_ending) {
  std::vector<pollfd> polled = {{wake.get(), POLLIN, 0}};
  polled.push_back({resting || is_ending ? -1 : socket.fd(), POLLIN, 0});
  for (const Tutor& tutor : tutors) {
    const bool listens = !tutor.dismissed && !Crowded(tutor.number);
    const int events = (listens ? POLLIN : 0) | (tutor.out.empty() ? 0 : POLLOUT);
    polled.push_back({tutor.fd.get(), static_cast<short>(events), 0});
  }
  const int patience = is_ending ? 10 : (resting ? kRest : -1);
  const int ready = poll(polled.data(), polled.size(), patience);
  if (ready < 0 && errno != EINTR) return false;
  resting = false;
  std::uint64_t woken = 0;
  if ((polled[0].revents & POLLIN) != 0 && read(wake.get(), &woken, sizeof woken) < 0) woken = 0;
  TakeLetters();
  for (std::size_t i = tutors.size(); i-- > 0;) {  // from the back: some go
    Tutor& tutor = tutors[i];
    if (ready > 0 && (polled[i + 2].revents & (POLLIN | POLLHUP | POLLERR)) != 0) Read(tutor);
    Deliver(tutor);
    const Part part = Send(tutor);
    if (part != Part::kStay) LetGo(i, part);
  }
  if (ready > 0 && (polled[1].revents & POLLIN) != 0) LetIn();
  return true;
}

void TutorServer::State::TakeLetters() {
  std::deque<Letter> taken;
  {
    const std::lock_guard<std::mutex> guard(mutex);
    taken.swap(letters);
  }
  for (const Letter& letter : taken) {
    for (Tutor& tutor : tutors) {
      if (letter.tutor != 0 && letter.tutor != tutor.number) continue;
      if (tutor.out.size() <= kMostUnread) tutor.out += letter.line;
      tutor.dismissed = tutor.dismissed || letter.dismiss;
    }
  }
}

void TutorServer::State::LetIn() {
  FileDescriptor fd(accept4(socket.fd(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
  if (!fd) {
    resting = errno != EAGAIN && errno != EINTR && errno != ECONNABORTED;
    return;
  }
  if (!PeerIsOwner(fd.get())) return Note(say::StrangerRefused());
  if (tutors.size() >= kMostTutors) {
    const std::string line = say::TooManyTutors(kMostTutors) + "\n";
    [[maybe_unused]] const ssize_t sent = send(fd.get(), line.data(), line.size(), MSG_NOSIGNAL);
    return;
  }
  Tutor tutor;
  tutor.fd = std::move(fd);
  tutor.number = ++last_number;
  tutor.out = greeting + "\n";
  tutors.push_back(std::move(tutor));
  {
    const std::lock_guard<std::mutex> guard(mutex);
    count = tutors.size();
  }
  Note(say::TutorCame(last_number));
  Send(tutors.back());  // the greeting; last, when this tutor is counted
}

/// Whether so many lines of this tutor wait for the lesson that no more are read from it.
bool TutorServer::State::Crowded(std::size_t number) const {
  const std::lock_guard<std::mutex> guard(mutex);
  const auto found = waiting.find(number);
  return found != waiting.end() && found->second >= kMostWaiting;
}

void TutorServer::State::Read(Tutor& tutor) {
  char block[1024];
  const ssize_t count_read = recv(tutor.fd.get(), block, sizeof block, 0);
  if (count_read > 0) {
    tutor.in.Feed({block, static_cast<std::size_t>(count_read)});
    if (tutor.in.TakeDropped()) tutor.out += say::TutorLineTooLong(kLongestLine) + "\n";
    return;
  }
  const bool later = count_read < 0 && (errno == EAGAIN || errno == EINTR);
  if (!later) tutor.fd.Close();
}

/// Hands whole lines over to the lesson, as many as may wait.
void TutorServer::State::Deliver(Tutor& tutor) {
  const std::lock_guard<std::mutex> guard(mutex);
  std::size_t& waits = waiting[tutor.number];
  while (waits < kMostWaiting) {
    std::optional<std::string> line = tutor.in.Next();
    if (!line) return;
    lines.push_back({tutor.number, OneLine(*line, kLongestLine)});
    ++waits;
  }
}

Part TutorServer::State::Send(Tutor& tutor) const {
  if (!tutor.fd) return tutor.in.empty() ? Part::kLeft : Part::kStay;
  while (!tutor.out.empty()) {
    const ssize_t sent = send(tutor.fd.get(), tutor.out.data(), tutor.out.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0 && errno != EAGAIN && errno != EWOULDBLOCK) return Part::kLeft;
    if (sent < 0) break;
    tutor.out.erase(0, static_cast<std::size_t>(sent));
  }
  if (tutor.out.size() > kMostUnread) return Part::kDropped;
  return tutor.dismissed && tutor.out.empty() ? Part::kLeft : Part::kStay;
}

void TutorServer::State::LetGo(std::size_t index, Part part) {
  const std::size_t number = tutors[index].number;
  tutors.erase(tutors.begin() + static_cast<std::ptrdiff_t>(index));
  {
    const std::lock_guard<std::mutex> guard(mutex);
    count = tutors.size();
    waiting.erase(number);
  }
  Note(part == Part::kDropped ? say::TutorDropped(number) : say::TutorLeft(number));
}

TutorServer::TutorServer(const std::string& learner, std::string_view greeting)
    : state_(std::make_unique<State>(TutorFolder(), learner, greeting)) {
  state_->thread = std::thread([state = state_.get()] { state->Run(); });
}

TutorServer::~TutorServer() {
  {
    const std::lock_guard<std::mutex> guard(state_->mutex);
    state_->ending = true;
  }
  state_->Wake();
  state_->thread.join();
}

std::optional<TutorServer::Line> TutorServer::Next() {
  State& state = *state_;
  if (state.batch.empty()) {
    // nullopt ends every batch, so that a loop over Next ends however fast a tutor types
    if (!std::exchange(state.batch_ended, true)) return std::nullopt;
    {
      const std::lock_guard<std::mutex> guard(state.mutex);
      if (state.lines.empty()) return std::nullopt;
      state.batch.swap(state.lines);
      for (auto& waits : state.waiting) waits.second = 0;
    }
    state.batch_ended = false;
    state.Wake();  // there is room again
  }
  Line line = std::move(state.batch.front());
  state.batch.pop_front();
  return line;
}

void TutorServer::Answer(std::size_t tutor, std::string_view line) {
  if (tutor != 0) state_->Post({tutor, OneLine(line, kLongestLine) + "\n", false});
}

void TutorServer::SendToAll(std::string_view line) {
  state_->Post({0, OneLine(line, kLongestLine) + "\n", false});
}

void TutorServer::Dismiss(std::size_t tutor) {
  if (tutor != 0) state_->Post({tutor, "", true});
}

std::vector<std::string> TutorServer::TakeSentences() {
  const std::lock_guard<std::mutex> guard(state_->mutex);
  return std::exchange(state_->sentences, {});
}

std::size_t TutorServer::tutors() const {
  const std::lock_guard<std::mutex> guard(state_->mutex);
  return state_->count;
}

const std::string& TutorServer::path() const { return state_->socket.path(); }

}  // namespace moontrace
