#include "sim/loop/loop.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <future>
#include <utility>

#include "sim/loop/device_feel.h"
#include "sim/loop/pacing.h"
#include "textures/base/error.h"

namespace moontrace {

namespace {

constexpr int kReopenEvery = 500;   ///< [ms]
constexpr int kLongestWait = 8000;  ///< [ms]
constexpr int kSteady = 2000;       ///< a device that stays this long is not faulty [ms]
constexpr int kPoll = 1;            ///< [ms]
constexpr std::chrono::milliseconds kLongestAnswer(1500);

/// As the safety stage sees a late loop: a period and kWatchdogTime more. [ns]
std::int64_t Silence(double rate) {
  return static_cast<std::int64_t>(1e9 * (1 / rate + kWatchdogTime));
}

}  // namespace

Loop::Loop(Scene scene, std::shared_ptr<const TextureField> field, std::unique_ptr<Device> device,
           DeviceSource source, const DevicePlace& place, const LoopOptions& options,
           ThreadStart start)
    : options_(options),
      mail_(options.rate),
      scale_(place.scale),
      watchdog_(Silence(options.rate)),
      field_(std::move(field)),
      tick_(std::move(scene), *field_, std::move(device), place, options, mail_),
      source_(std::move(source)) {
  try {
    Start(start);
  } catch (const std::exception& error) {
    End();
    tick_.Release();  // also where the ticking thread could not be started
    throw LackError(fmt::format("the haptic loop cannot start its threads ({}); end other programs",
                                error.what()));
  }
}

Loop::~Loop() { End(); }

void Loop::Start(ThreadStart start) {
  std::promise<std::string> begun;
  std::future<std::string> priority = begun.get_future();
  ticking_ = true;
  ticker_ = start([this, &begun] {
    begun.set_value(AskForPriority());
    TickOn();
    ticking_ = false;
  });
  not_realtime_ = priority.get();
  if (not_realtime_.empty()) not_realtime_ = memory_lock_.problem();
  watcher_ = start([this] { Watch(); });
  supervisor_ = start([this] { Supervise(); });
}

void Loop::TickOn() {
  Pacing pacing(clock_, options_.rate);
  const std::int64_t start = clock_.Now();
  while (!ending_.load(std::memory_order_relaxed)) {
    const Wake wake = pacing.Wait();
    const bool late = watchdog_.Beat(wake.time);
    tick_.Run(1e-9 * static_cast<double>(wake.time - start), late);
    ++report_.ticks;
    report_.lost_ticks += wake.lost;
    const double lateness = 1e-3 * static_cast<double>(wake.lateness);
    report_.lateness.Add(lateness);
    // one that TakeLateness reads between the two lines is reported twice: no harm
    if (lateness > lateness_.load(std::memory_order_relaxed)) {
      lateness_.store(lateness, std::memory_order_relaxed);
    }
    report_.cost.Add(1e-3 * static_cast<double>(clock_.Now() - wake.time));
  }
  tick_.Release();
}

bool Loop::SleepUnlessEnding(int milliseconds) {
  std::unique_lock lock(mutex_);
  wake_.wait_for(lock, std::chrono::milliseconds(milliseconds), [this] { return ending_.load(); });
  return !ending_;
}

void Loop::Watch() {
  AskForPriority(1);
  while (SleepUnlessEnding(kPoll)) {
    if (watchdog_.Look(clock_.Now())) late_loops_.fetch_add(1, std::memory_order_relaxed);
  }
}

void Loop::Supervise() {
  int waited = 0, wait = 0, held = 0;  // [ms]
  while (SleepUnlessEnding(kPoll)) {
    // destroying and opening may block for long: no other thread waits for this one
    const std::unique_ptr<Device> detached = TakeDetached();
    if (detached != nullptr) {
      lost_ = true;
      waited = 0;
      // a device that is lost again at once is tried at growing intervals
      wait = held < kSteady ? std::clamp(2 * wait, kReopenEvery, kLongestWait) : 0;
    }
    held += kPoll;
    if (!lost_ || (waited += kPoll) < wait) continue;
    waited = held = 0;
    Reopen();
    lost_ = !WhyLost().empty();
    wait = std::max(wait, kReopenEvery);
  }
}

std::unique_ptr<Device> Loop::TakeDetached() {
  std::unique_ptr<Device> detached;
  {
    const std::lock_guard lock(mutex_);
    detached.reset(mail_.detached.exchange(nullptr, std::memory_order_acquire));
    asking_ = detached != nullptr;
  }
  if (detached == nullptr) return detached;
  std::string why = detached->WhyLost();
  {
    const std::lock_guard lock(mutex_);
    why_gone_ = std::move(why);
    asking_ = false;
  }
  answered_.notify_all();
  return detached;
}

std::string Loop::WhyGone() {
  std::unique_lock lock(mutex_);
  answered_.wait_for(lock, kLongestAnswer, [this] {
    return !asking_ && mail_.detached.load(std::memory_order_acquire) == nullptr;
  });
  return why_gone_;
}

void Loop::Reopen() {
  std::string why;
  try {
    std::unique_ptr<Device> device = source_(ending_);
    mail_.reopened.store(device.release(), std::memory_order_release);
  } catch (const std::exception& error) {
    if (ending_) return;
    why = error.what();
  }
  const std::lock_guard lock(mutex_);
  why_lost_ = std::move(why);
}

std::string Loop::WhyLost() const {
  const std::lock_guard lock(mutex_);
  return why_lost_;
}

void Loop::ChangePage(PageChange change) {
  PostedPage posted;
  const std::size_t label = change.label.value_or(tick_.scene().options().label);
  posted.ready = tick_.scene().MakeReady(label, change.field.get(), change.text_P);
  posted.page = change.page;
  posted.anchor = change.anchor;
  posted.place_P = change.place_P;
  posted.tilt = change.tilt;
  posted.device = std::move(change.device);
  mail_.wanted_page.store(&posted, std::memory_order_release);
  while (mail_.done_page.exchange(nullptr, std::memory_order_acquire) != &posted) {
    if (!ticking_) return;  // nothing is felt any more: the new page goes as it came
    std::this_thread::sleep_for(std::chrono::milliseconds(kPoll));
  }
  field_ = std::move(change.field);
}

void Loop::Guide(std::shared_ptr<const GuidancePlan> plan) {
  if (plan != nullptr) {
    GuidancePlan held = *plan;
    held.gains = HeldBy(tick_.limits(), held.gains, scale_);
    plan = std::make_shared<const GuidancePlan>(std::move(held));
  }
  const PostedPush posted{plan.get()};
  mail_.wanted_push.store(&posted, std::memory_order_release);
  while (mail_.done_push.exchange(nullptr, std::memory_order_acquire) != &posted) {
    if (!ticking_) return;  // nothing is pushed any more
    std::this_thread::sleep_for(std::chrono::milliseconds(kPoll));
  }
  plan_ = std::move(plan);
}

void Loop::End() {
  {
    const std::lock_guard lock(mutex_);
    if (ending_.exchange(true)) return;
  }
  wake_.notify_all();
  for (std::thread* thread : {&ticker_, &watcher_, &supervisor_}) {
    if (thread->joinable()) thread->join();
  }
  delete mail_.reopened.exchange(nullptr);
  TakeDetached();
  report_.late_loops = late_loops_;
  report_.samples_dropped = mail_.samples.dropped();
  report_.events_dropped = mail_.events.dropped();
  report_.safety_counts = tick_.safety().counts();
}

}  // namespace moontrace
