#include "sim/page_view/surface_worker.h"

#include <pthread.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <thread>
#include <utility>

namespace moontrace {

namespace {

constexpr int kNice = 5;
constexpr unsigned kMostThreads = 4;

std::size_t Threads() { return std::clamp(std::thread::hardware_concurrency(), 1U, kMostThreads); }

}  // namespace

void GiveWayToTheLoop() noexcept {
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
  // on Linux a thread has its own niceness, by its number
  setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), kNice);
}

struct SurfaceWorker::State {
  std::mutex mutex;
  std::condition_variable changed;
  std::optional<SurfaceWish> wish;
  std::optional<Surface> done;
  bool working = false, stop = false;
  std::thread thread;

  void Run() {
    GiveWayToTheLoop();
    std::unique_lock<std::mutex> lock(mutex);
    for (;;) {
      changed.wait(lock, [this] { return stop || wish; });
      if (stop) return;
      SurfaceWish now = std::move(*wish);
      wish.reset();
      working = true;
      lock.unlock();
      Raster raster = ShadeField(*now.page->field, now.view_P, now.page->sheet_P, now.width,
                                 now.height, now.shade, Threads());
      lock.lock();
      done = Surface{std::move(raster), std::move(now)};
      working = false;
      changed.notify_all();
    }
  }
};

SurfaceWorker::SurfaceWorker() : state_(std::make_unique<State>()) {
  state_->thread = std::thread([state = state_.get()] { state->Run(); });
}

SurfaceWorker::~SurfaceWorker() {
  {
    const std::lock_guard<std::mutex> lock(state_->mutex);
    state_->stop = true;
  }
  state_->changed.notify_all();
  state_->thread.join();
}

void SurfaceWorker::Wish(SurfaceWish wish) {
  {
    const std::lock_guard<std::mutex> lock(state_->mutex);
    state_->wish = std::move(wish);
  }
  state_->changed.notify_all();
}

std::optional<SurfaceWorker::Surface> SurfaceWorker::Take() {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  return std::exchange(state_->done, std::nullopt);
}

void SurfaceWorker::Await() {
  std::unique_lock<std::mutex> lock(state_->mutex);
  state_->changed.wait(lock, [this] { return !state_->wish && !state_->working; });
}

}  // namespace moontrace
