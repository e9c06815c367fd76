#include "devices/hid/hid_link.h"

#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <thread>
#include <utility>

#include "devices/core/mailbox.h"
#include "devices/hid/hid_port.h"

namespace moontrace {
namespace {

constexpr int kReadTimeout = 20;                 // [ms], the longest that unplugging stays unseen
constexpr int kMostDrained = 64;                 // the kernel's queue holds 63
constexpr double kFarewellTime = 0.1;            // [s]
constexpr std::chrono::microseconds kPoll(250);  // the tick may not wake the writer

double Now() noexcept {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool SameBytes(const HidReport& a, const HidReport& b) noexcept {
  return std::ranges::equal(a.span(), b.span());
}

/// Signals belong to the main thread, and one would end a waiting read.
void BeginThread(const char* name) noexcept {
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
  pthread_setname_np(pthread_self(), name);
}

}  // namespace

std::span<const std::uint8_t> HidReport::span() const noexcept {
  return {bytes.data(), std::min<std::size_t>(size, kMostBytes)};
}

/// Shared by the link and both threads: the last of them closes the handles.
struct HidLink::Impl {
  Impl(const std::string& path, HidLinkOptions link_options)
      : options(std::move(link_options)),
        reading(HidHandle::Open(path)),
        writing(HidHandle::Open(path)),
        inputs(std::max<std::size_t>(options.inputs.size(), 1)),
        newest(inputs.size()),
        counts(inputs.size(), 0),
        outputs(options.outputs) {}

  struct Output {
    Mailbox<HidReport> box;
    HidReport wanted, sent;  // the writing thread's
    double sent_at = -1;     // [s]; < 0: nothing has been put yet
    bool due = false;
  };

  void ReadAll() noexcept;
  void Sort(const HidReport& report) noexcept;
  void WriteAll() noexcept;
  bool Send(const HidReport& report) noexcept;
  void Collect(double now) noexcept;
  bool SendDue(double now) noexcept;
  void SayFarewell() noexcept;

  const HidLinkOptions options;
  HidHandle reading, writing;

  std::vector<Mailbox<HidReport>> inputs;
  std::vector<HidReport> newest;  // of a drain; size 0: none. The reading thread's
  std::vector<std::uint32_t> counts;
  std::atomic<std::uint32_t> strays{0};

  std::vector<Output> outputs;
  double put_at = -1, renewed_at = -1;  // the writing thread's [s]

  std::atomic<bool> alive{true};
  std::atomic<bool> closing{false};
  std::atomic<double> write_began{0};  // [s]; 0: no write is waiting
  std::atomic<int> running{2};
};

void HidLink::Impl::Sort(const HidReport& report) noexcept {
  std::size_t place = 0;
  if (!options.inputs.empty()) {
    const auto found = std::find(options.inputs.begin(), options.inputs.end(), report.bytes[0]);
    if (found == options.inputs.end()) {
      strays.fetch_add(1, std::memory_order_relaxed);
      return;
    }
    place = static_cast<std::size_t>(found - options.inputs.begin());
  }
  newest[place] = report;
  newest[place].count = counts[place]++;
}

/// Drains to the newest before it hands anything over: the kernel keeps the oldest reports.
void HidLink::Impl::ReadAll() noexcept {
  HidReport report;
  while (!closing.load(std::memory_order_relaxed)) {
    int timeout = kReadTimeout;
    int drained = 0;
    for (; drained < kMostDrained; ++drained, timeout = 0) {
      const int n = reading.Read(report.bytes, timeout);
      if (n < 0) {
        alive.store(false, std::memory_order_relaxed);
        return;
      }
      if (n == 0) break;
      report.time = Now();
      report.size = static_cast<std::uint16_t>(n);
      Sort(report);
    }
    for (std::size_t i = 0; i < newest.size(); ++i) {
      if (newest[i].size > 0) inputs[i].Put(newest[i]);
      newest[i].size = 0;
    }
    if (drained == kMostDrained)
      std::this_thread::sleep_for(kPoll);  // a flood of reports: other threads must run too
  }
}

bool HidLink::Impl::Send(const HidReport& report) noexcept {
  write_began.store(Now(), std::memory_order_relaxed);
  const bool taken = writing.Write(report.span());
  write_began.store(0, std::memory_order_relaxed);
  if (!taken) alive.store(false, std::memory_order_relaxed);
  return taken;
}

void HidLink::Impl::Collect(double now) noexcept {
  for (Output& output : outputs) {
    if (output.box.Take(output.wanted)) {
      put_at = now;
      output.due = output.due || output.sent_at < 0 || !SameBytes(output.wanted, output.sent);
    }
    const bool is_fresh = put_at >= 0 && now - put_at < options.stale_after;
    output.due = output.due || (options.repeat_every > 0 && is_fresh && output.sent_at >= 0 &&
                                now - output.sent_at >= options.repeat_every);
  }
}

bool HidLink::Impl::SendDue(double now) noexcept {
  for (Output& output : outputs) {
    if (!output.due) continue;
    if (!Send(output.wanted)) return false;
    output.sent = output.wanted;
    output.sent_at = now;
    output.due = false;
  }
  const bool is_fresh = put_at >= 0 && now - put_at < options.stale_after;
  if (is_fresh && now - renewed_at >= options.renew_every) {
    renewed_at = now;
    for (const HidReport& report : options.renewed) {
      if (!Send(report)) return false;
    }
  }
  return true;
}

void HidLink::Impl::SayFarewell() noexcept {
  const double began = Now();
  Collect(began);
  for (const Output& output : outputs) {
    if (output.due && (Now() - began > kFarewellTime || !Send(output.wanted))) return;
  }
  for (const HidReport& report : options.farewell) {
    if (Now() - began > kFarewellTime || !Send(report)) return;
  }
}

void HidLink::Impl::WriteAll() noexcept {
  while (!closing.load(std::memory_order_acquire)) {
    const double now = Now();
    Collect(now);
    if (!SendDue(now)) return;
    std::this_thread::sleep_for(kPoll);
  }
  if (alive.load(std::memory_order_relaxed)) SayFarewell();
}

HidLink::HidLink(const std::string& path, HidLinkOptions options)
    : impl_(std::make_shared<Impl>(path, std::move(options))) {
  std::thread([impl = impl_] {
    BeginThread("hid-read");
    impl->ReadAll();
    impl->running.fetch_sub(1, std::memory_order_release);
  }).detach();
  std::thread([impl = impl_] {
    BeginThread("hid-write");
    impl->WriteAll();
    impl->running.fetch_sub(1, std::memory_order_release);
  }).detach();
}

HidLink::~HidLink() {
  impl_->closing.store(true, std::memory_order_release);
  const double began = Now();
  while (impl_->running.load(std::memory_order_acquire) > 0 && Now() - began < kFarewellTime) {
    std::this_thread::sleep_for(kPoll);
  }
}

bool HidLink::Take(std::size_t input, HidReport& report) noexcept {
  return impl_->inputs[input].Take(report);
}

void HidLink::Put(std::size_t place, std::span<const std::uint8_t> report) noexcept {
  HidReport out;
  out.size = static_cast<std::uint16_t>(std::min(report.size(), HidReport::kMostBytes));
  std::copy_n(report.begin(), out.size, out.bytes.begin());
  impl_->outputs[place].box.Put(out);
}

bool HidLink::IsAlive() const noexcept { return impl_->alive.load(std::memory_order_relaxed); }

std::uint32_t HidLink::Strays() const noexcept {
  return impl_->strays.load(std::memory_order_relaxed);
}

double HidLink::WaitingWrite() const noexcept {
  const double began = impl_->write_began.load(std::memory_order_relaxed);
  return began > 0 ? std::max(0.0, Now() - began) : 0;
}

}  // namespace moontrace
