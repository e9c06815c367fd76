#include "tests/devices/fake/bus_socket.h"

#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <csignal>
#include <memory>
#include <thread>
#include <vector>

namespace moontrace::fake {
namespace {

bool AddressOf(const std::string& path, sockaddr_un& address) {
  address = {};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) return false;
  path.copy(address.sun_path, path.size());
  return true;
}

/// One thread for all connections. Never ends.
class Server {
 public:
  Server(int listener, Serve serve, Hang hang) : serve_(serve), hang_(hang) {
    waits_.push_back({listener, POLLIN, 0});
    handles_.push_back(nullptr);
  }

  void Run() {
    for (;;) {
      if (poll(waits_.data(), waits_.size(), -1) <= 0) continue;
      for (std::size_t i = 1; i < waits_.size();) i += waits_[i].revents == 0 || Take(i) ? 1 : 0;
      if (waits_[0].revents == 0) continue;
      const int connection = accept4(waits_[0].fd, nullptr, nullptr, SOCK_CLOEXEC);
      if (connection < 0) continue;
      waits_.push_back({connection, POLLIN, 0});
      handles_.push_back(nullptr);
    }
  }

 private:
  /// False: the connection is gone, and its place with it.
  bool Take(std::size_t i) {
    const ssize_t got = recv(waits_[i].fd, call_.get(), sizeof(Call), 0);
    if (got != static_cast<ssize_t>(sizeof(Call))) {
      if (handles_[i] != nullptr) hang_(handles_[i]);
      close(waits_[i].fd);
      const auto place = static_cast<std::ptrdiff_t>(i);
      waits_.erase(waits_.begin() + place);
      handles_.erase(handles_.begin() + place);
      return false;
    }
    *answer_ = {};
    serve_(handles_[i], *call_, *answer_);
    send(waits_[i].fd, answer_.get(), sizeof(Answer), MSG_NOSIGNAL);
    return true;
  }

  const Serve serve_;
  const Hang hang_;
  std::vector<pollfd> waits_;
  std::vector<void*> handles_;
  std::unique_ptr<Call> call_ = std::make_unique<Call>();
  std::unique_ptr<Answer> answer_ = std::make_unique<Answer>();
};

}  // namespace

void ServeBus(const std::string& path, Serve serve, Hang hang) {
  sockaddr_un address;
  const int listener = socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0);
  if (listener < 0 || !AddressOf(path, address) ||
      bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
      listen(listener, 16) != 0) {
    return;
  }
  std::thread([listener, serve, hang] {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    sched_param priority = {};
    priority.sched_priority = 46;  // hardware waits for nobody
    pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority);
    Server(listener, serve, hang).Run();
  }).detach();
}

int ConnectToBus(const char* path) {
  sockaddr_un address;
  const int connection = socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0);
  if (connection < 0) return -1;
  if (AddressOf(path, address) &&
      connect(connection, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) {
    return connection;
  }
  close(connection);
  return -1;
}

bool CallBus(int connection, const Call& call, Answer& answer) {
  return send(connection, &call, sizeof call, MSG_NOSIGNAL) == static_cast<ssize_t>(sizeof call) &&
         recv(connection, &answer, sizeof answer, 0) == static_cast<ssize_t>(sizeof answer);
}

}  // namespace moontrace::fake
