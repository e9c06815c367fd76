#pragma once

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <atomic>
#include <cstring>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "sim/console/line_buffer.h"
#include "sim/tutor/tutor_socket.h"

namespace moontrace {

/// A speech-dispatcher for tests: speaks SSIP on a Unix socket, and writes down what it was asked.
class FakeSsip {
 public:
  struct Manner {
    int dies_at = -1;     ///< hangs up instead of answering this command, from 0
    bool silent = false;  ///< never answers
    bool ends = true;     ///< each message ends at once
    std::string refuses;  ///< answers 4xx to commands that begin so
    std::string garbage;  ///< is sent in place of the first answer
  };

  FakeSsip(const std::string& path, Manner manner) : manner_(std::move(manner)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
    listening_ = FileDescriptor(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    const int bound =
        bind(listening_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address);
    if (bound == 0 && listen(listening_.get(), 4) == 0) thread_ = std::thread([this] { Serve(); });
  }
  ~FakeSsip() {
    end_ = true;
    if (thread_.joinable()) thread_.join();
  }

  /// Commands, and texts as "text: ...", in order.
  std::vector<std::string> Log() const {
    const std::lock_guard<std::mutex> guard(mutex_);
    return log_;
  }
  bool Heard(const std::string& line) const {
    for (const std::string& heard : Log()) {
      if (heard == line) return true;
    }
    return false;
  }
  /// The end of message `number`, from 1, is told now.
  void TellEnd(int number) { Send("702-" + std::to_string(number) + "\r\n702-1\r\n702 END\r\n"); }

 private:
  void Serve() {
    while (!end_ && client_ < 0) {
      pollfd polled{listening_.get(), POLLIN, 0};
      if (poll(&polled, 1, 5) > 0)
        client_ = accept4(listening_.get(), nullptr, nullptr, SOCK_CLOEXEC);
    }
    while (!end_ && client_ >= 0) {
      pollfd polled{client_, POLLIN, 0};
      if (poll(&polled, 1, 5) <= 0) continue;
      char block[1024];
      const ssize_t count = recv(client_, block, sizeof block, 0);
      if (count <= 0) break;
      in_.Feed({block, static_cast<std::size_t>(count)});
      while (const auto line = in_.Next()) {
        if (!Take(*line)) return HangUp();
      }
    }
    HangUp();
  }

  void HangUp() {
    if (client_ >= 0) close(client_);
    client_ = -1;
    listening_.Close();
  }

  void Note(const std::string& line) {
    const std::lock_guard<std::mutex> guard(mutex_);
    log_.push_back(line);
  }

  void Send(const std::string& bytes) const {
    [[maybe_unused]] const ssize_t sent = send(client_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }

  /// False: hang up.
  bool Take(const std::string& line) {
    if (in_text_ && line != ".") {
      Note("text: " + line);
      return true;
    }
    if (!in_text_) Note(line);
    if (!in_text_ && commands_++ == manner_.dies_at) return false;
    if (manner_.silent) return true;
    if (!manner_.garbage.empty()) {
      Send(manner_.garbage);
      return true;
    }
    if (!manner_.refuses.empty() && line.find(manner_.refuses) == 0) {
      Send("408 ERR PARAMETER INVALID\r\n");
    } else if (!in_text_ && line == "SPEAK") {
      Send("230 OK RECEIVING DATA\r\n");
      in_text_ = true;
    } else if (in_text_ || line.find("CHAR ") == 0) {
      in_text_ = false;
      const std::string number = std::to_string(++messages_);
      Send("225-" + number + "\r\n225 OK MESSAGE QUEUED\r\n");
      Send("701-" + number + "\r\n701-1\r\n701 BEGIN\r\n");
      if (manner_.ends) TellEnd(messages_);
    } else {
      Send("200 OK\r\n");
    }
    return true;
  }

  Manner manner_;
  FileDescriptor listening_;
  std::atomic<int> client_{-1};
  LineBuffer in_{10000};
  bool in_text_ = false;
  int commands_ = 0, messages_ = 0;
  mutable std::mutex mutex_;
  std::vector<std::string> log_;
  std::atomic<bool> end_{false};
  std::thread thread_;
};

}  // namespace moontrace
