#include "sim/audio/ssip.h"

#include <fmt/core.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "textures/base/text_file.h"

namespace moontrace {

namespace {

constexpr std::chrono::milliseconds kPatience{2000};
constexpr std::chrono::milliseconds kHurriedPatience{200};
constexpr int kSlice = 10;                            // [ms] until `hurry` is asked again
constexpr std::chrono::seconds kLongestImportant{5};  // that is left to speak on
constexpr std::size_t kLongestText = 2000;            // [bytes]

std::string NameOf(Priority priority) {
  switch (priority) {
    case Priority::kImportant:
      return "IMPORTANT";
    case Priority::kMessage:
      return "MESSAGE";
    case Priority::kText:
      return "TEXT";
    case Priority::kNotification:
      return "NOTIFICATION";
    case Priority::kProgress:
      return "PROGRESS";
  }
  return {};
}

/// A part of a name: of letters, digits, - and _ only.
std::string NamePart(std::string_view text) {
  std::string part;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    part += plain || c == '-' ? c : '_';
  }
  return part.empty() ? "learner" : part;
}

}  // namespace

std::string SsipText(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20U || c == '\x7f') c = ' ';
  }
  line = OneLine(line, kLongestText);
  const bool doubled = !line.empty() && line.front() == '.';
  return fmt::format("{}{}\r\n.\r\n", doubled ? "." : "", line);
}

Ssip::Ssip(Hurry hurry) : hurry_(std::move(hurry)) {}

bool Ssip::Fail(Fault fault) {
  fault_ = fault;
  fd_.Close();
  return false;
}

bool Ssip::Connect(const std::string& path) {
  fd_ = ConnectTo(path);
  return fd_ || Fail(Fault::kNotThere);
}

bool Ssip::Greet(const SpeechOptions& options) {
  const std::string language = NamePart(options.language);
  const bool good =
      Do(fmt::format("SET SELF CLIENT_NAME {}:moontrace:lesson", NamePart(options.user))) &&
      // the end of each message is reported, so that nothing important is cut short
      Do("SET SELF NOTIFICATION END ON") && Do("SET SELF NOTIFICATION CANCEL ON") &&
      (options.language.empty() || Do("SET SELF LANGUAGE " + language)) &&
      (options.rate == 0 || SetRate(options.rate)) && Do("SET SELF PRIORITY TEXT");
  return good || (fault_ == Fault::kNone ? Fail(Fault::kRefused) : false);
}

bool Ssip::SetRate(int rate) {
  return Do(fmt::format("SET SELF RATE {}", std::clamp(rate, -100, 100)));
}

bool Ssip::Speak(Priority priority, std::string_view text) {
  if (!Queue(priority, "SPEAK") || !SendText(text)) return false;
  if (priority == Priority::kImportant && !message_.empty()) {
    important_.insert(message_);
    important_until_ = Clock::now() + kLongestImportant;
  }
  return true;
}

bool Ssip::Spell(std::string_view word) {
  return Do("SET SELF SPELLING ON") && Speak(Priority::kText, word) && Do("SET SELF SPELLING OFF");
}

bool Ssip::Character(std::string_view character) {
  if (character == " ") character = "space";
  return Queue(Priority::kText, "CHAR " + OneLine(character, 20));
}

bool Ssip::Cancel() {
  Clock::time_point now = Clock::now();
  while (Fetch(now)) {  // only what has come already
  }
  while (const std::optional<std::string> line = in_.Next()) TakeLine(*line);
  if (fault_ != Fault::kNone) return false;
  if (!important_.empty() && Clock::now() < important_until_) return true;
  important_.clear();
  return Do("CANCEL SELF");
}

void Ssip::Leave() {
  if (fd_) Send("QUIT\r\n");
}

bool Ssip::Do(const std::string& command) { return Send(command + "\r\n") && Answered(); }

bool Ssip::Queue(Priority priority, const std::string& command) {
  if (priority != priority_) {
    if (!Do("SET SELF PRIORITY " + NameOf(priority))) {
      return false;
    }
    priority_ = priority;
  }
  return Do(command);
}

bool Ssip::SendText(std::string_view text) { return Send(SsipText(text)) && Answered(); }

bool Ssip::Send(std::string_view bytes) {
  const Clock::time_point until = Clock::now() + kPatience;
  while (!bytes.empty()) {
    if (!fd_) return Fail(Fault::kGone);
    const ssize_t sent = send(fd_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent > 0) bytes.remove_prefix(static_cast<std::size_t>(sent));
    if (sent > 0 || (sent < 0 && errno == EINTR)) continue;
    if (sent < 0 && errno != EAGAIN) return Fail(Fault::kGone);
    if (Clock::now() >= until || hurry_()) return Fail(Fault::kSilent);
    pollfd polled{fd_.get(), POLLOUT, 0};
    poll(&polled, 1, kSlice);
  }
  return true;
}

/// Waits for the answer to a command. Its last line has a blank behind the code.
bool Ssip::Answered() {
  message_.clear();
  refused_ = false;
  Clock::time_point until = Clock::now() + kPatience;
  bool answered = false;
  while (!answered) {
    while (const std::optional<std::string> line = in_.Next()) {
      if (TakeLine(*line)) {
        answered = true;
        break;
      }
    }
    if (!answered && !Fetch(until)) return fault_ == Fault::kNone ? Fail(Fault::kSilent) : false;
  }
  return fault_ == Fault::kNone && !refused_;
}

/// Bytes from the service; false if none came until then, or none will.
bool Ssip::Fetch(Clock::time_point& until) {
  while (fd_) {
    pollfd polled{fd_.get(), POLLIN, 0};
    if (hurry_()) until = std::min(until, Clock::now() + kHurriedPatience);
    const bool waits = Clock::now() < until;
    if (poll(&polled, 1, waits ? kSlice : 0) > 0) {
      char block[1024];
      const ssize_t count = recv(fd_.get(), block, sizeof block, MSG_DONTWAIT);
      if (count > 0) {
        in_.Feed({block, static_cast<std::size_t>(count)});
        return true;
      }
      if (count == 0 || (errno != EAGAIN && errno != EINTR)) return Fail(Fault::kGone);
    }
    if (!waits) return false;
  }
  return Fail(Fault::kGone);
}

/// True for the last line of an answer. "225-17" before it is the number of a message.
bool Ssip::TakeLine(const std::string& line) {
  const bool has_code = line.size() >= 3 && std::all_of(line.begin(), line.begin() + 3, [](char c) {
                          return c >= '0' && c <= '9';
                        });
  if (!has_code) {
    refusal_ = line;
    Fail(Fault::kRefused);
    return true;
  }
  if (line[0] == '7') {
    TakeEvent(line);
    return false;
  }
  if (line.size() > 3 && line[3] == '-') {
    message_ = line.substr(4);
    return false;
  }
  refused_ = line[0] != '1' && line[0] != '2';
  if (refused_) refusal_ = line;
  return true;
}

/// "702-MESSAGE", "702-CLIENT", "702 END"; 703 is a message that was cancelled.
void Ssip::TakeEvent(const std::string& line) {
  const bool last = line.size() > 3 && line[3] == ' ';
  if (!last && event_message_.empty())
    event_message_ = line.substr(std::min<std::size_t>(4, line.size()));
  if (!last) return;
  if (line.compare(0, 3, "702") == 0 || line.compare(0, 3, "703") == 0) {
    important_.erase(event_message_);
  }
  event_message_.clear();
}

}  // namespace moontrace
