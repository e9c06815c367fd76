#include "devices/hid/hid_link.h"

#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <optional>
#include <thread>
#include <utility>

#include "devices/core/mailbox.h"
#include "devices/guardian/guardian.h"
#include "devices/helper/priority.h"
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

std::vector<std::vector<std::uint8_t>> BytesOf(const std::vector<HidReport>& reports) {
  std::vector<std::vector<std::uint8_t>> bytes;
  bytes.reserve(reports.size());
  for (const HidReport& report : reports) {
    bytes.emplace_back(report.span().begin(), report.span().end());
  }
  return bytes;
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
        outputs(options.outputs) {
    if (options.release.empty()) return;
    guardian.emplace(
        GuardedDevice{path, options.name, BytesOf(options.release), BytesOf(options.farewell)});
  }

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
  void CollectAnew() noexcept;
  bool SendDue(double now) noexcept;
  bool SendForce(const HidReport& report) noexcept;
  void TellPushes() noexcept;
  bool SayFarewell() noexcept;
  void WriteUntilClosed() noexcept;

  const HidLinkOptions options;
  HidHandle reading, writing;

  std::vector<Mailbox<HidReport>> inputs;
  std::vector<HidReport> newest;  // of a drain; size 0: none. The reading thread's
  std::vector<std::uint32_t> counts;
  std::atomic<std::uint32_t> strays{0};

  std::vector<Output> outputs;
  double put_at = -1, renewed_at = -1;  // the writing thread's [s]

  std::optional<Guardian> guardian;
  std::uint64_t releases = 0;  // of the guardian, as the writing thread last saw
  std::atomic<bool> guardian_ended{false};

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
  if (guardian && guardian->IsDying()) return false;
  write_began.store(Now(), std::memory_order_relaxed);
  const bool taken = writing.Write(report.span());
  write_began.store(0, std::memory_order_relaxed);
  if (!taken) alive.store(false, std::memory_order_relaxed);
  return taken;
}

/// The guardian has commanded zero: what the device has is no longer what was sent last, and the
/// next force counts even if it is the same.
void HidLink::Impl::CollectAnew() noexcept {
  const std::uint64_t count = guardian->Releases();
  if (count == releases) return;
  releases = count;
  for (Output& output : outputs) {
    output.sent_at = -1;
    output.due = false;  // from before it: too old
  }
  renewed_at = -1;
}

void HidLink::Impl::Collect(double now) noexcept {
  if (guardian) CollectAnew();
  for (Output& output : outputs) {
    if (output.box.Take(output.wanted)) {
      put_at = now;
      if (guardian) guardian->Beat(now);
      output.due = output.due || output.sent_at < 0 || !SameBytes(output.wanted, output.sent);
    }
    const bool is_fresh = put_at >= 0 && now - put_at < options.stale_after;
    output.due = output.due || (options.repeat_every > 0 && is_fresh && output.sent_at >= 0 &&
                                now - output.sent_at >= options.repeat_every);
  }
}

/// The guardian knows of a force before the device does.
bool HidLink::Impl::SendForce(const HidReport& report) noexcept {
  if (guardian && report.pushes) guardian->SetPushes(true);
  return Send(report);
}

void HidLink::Impl::TellPushes() noexcept {
  if (!guardian) return;
  guardian->SetPushes(
      std::ranges::any_of(outputs, [](const Output& output) { return output.sent.pushes; }));
}

bool HidLink::Impl::SendDue(double now) noexcept {
  bool has_sent = false;
  for (Output& output : outputs) {
    if (!output.due) continue;
    if (!SendForce(output.wanted)) return false;
    output.sent = output.wanted;
    output.sent_at = now;
    output.due = false;
    has_sent = true;
  }
  if (has_sent) TellPushes();
  const bool is_fresh = put_at >= 0 && now - put_at < options.stale_after;
  if (is_fresh && now - renewed_at >= options.renew_every) {
    renewed_at = now;
    for (const HidReport& report : options.renewed) {
      if (!Send(report)) return false;
    }
  }
  return true;
}

/// False if not all of it was taken in time.
bool HidLink::Impl::SayFarewell() noexcept {
  const double began = Now();
  Collect(began);
  for (const Output& output : outputs) {
    if (output.due && (Now() - began > kFarewellTime || !SendForce(output.wanted))) return false;
  }
  for (const HidReport& report : options.farewell) {
    if (Now() - began > kFarewellTime || !Send(report)) return false;
  }
  return true;
}

void HidLink::Impl::WriteAll() noexcept {
  if (!guardian) {
    WriteUntilClosed();
    if (alive.load(std::memory_order_relaxed)) SayFarewell();
    return;
  }
  LifeNote note(guardian->ProgramLife());
  WriteUntilClosed();
  // What the program could not say itself the guardian says: it takes this for a death.
  if (alive.load(std::memory_order_relaxed) && SayFarewell()) note.End();
}

void HidLink::Impl::WriteUntilClosed() noexcept {
  while (!closing.load(std::memory_order_acquire)) {
    const double now = Now();
    Collect(now);
    if (!SendDue(now)) return;
    if (guardian && !guardian->IsAlive()) {  // killed: no force without one
      SayFarewell();
      guardian_ended.store(true, std::memory_order_relaxed);
      alive.store(false, std::memory_order_relaxed);
      return;
    }
    std::this_thread::sleep_for(kPoll);
  }
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
    RunAhead(kCarriesForces);  // else the guardian lets go of forces that are held up
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

void HidLink::Put(std::size_t place, std::span<const std::uint8_t> report, bool pushes) noexcept {
  HidReport out;
  out.pushes = pushes;
  out.size = static_cast<std::uint16_t>(std::min(report.size(), HidReport::kMostBytes));
  std::copy_n(report.begin(), out.size, out.bytes.begin());
  put_at_ = Now();
  impl_->outputs[place].box.Put(out);
}

bool HidLink::WasLetGo() noexcept {
  if (!impl_->guardian) return false;
  const std::uint64_t releases = impl_->guardian->Releases();
  if (releases == releases_) return false;
  releases_ = releases;
  return Now() - put_at_ < Guardian::kLongestSilence;
}

bool HidLink::IsAlive() const noexcept { return impl_->alive.load(std::memory_order_relaxed); }

std::string HidLink::WhyLost() const {
  return impl_->guardian_ended.load(std::memory_order_relaxed) ? "its guardian process ended" : "";
}

std::uint32_t HidLink::Strays() const noexcept {
  return impl_->strays.load(std::memory_order_relaxed);
}

double HidLink::WaitingWrite() const noexcept {
  const double began = impl_->write_began.load(std::memory_order_relaxed);
  return began > 0 ? std::max(0.0, Now() - began) : 0;
}

}  // namespace moontrace
