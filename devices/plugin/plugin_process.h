#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

#include "devices/helper/helper_process.h"
#include "devices/plugin/wire/plugin_wire.h"
#include "textures/base/file_descriptor.h"

namespace moontrace {

/// The helper process of one plug-in, with the memory it shares and a thread that notices at once
/// when it ends and within 0.1 s when it hangs; then it is killed. Put, Take and IsAlive are for
/// the tick.
class PluginProcess {
 public:
  /// Starts the helper `host` on the plug-in `path` and waits, at most 10 s, until its device is
  /// open. Throws DeviceError.
  PluginProcess(const std::string& host, const std::string& path);
  /// Lets the helper command zero and close, at most 0.5 s, then kills it.
  ~PluginProcess();
  PluginProcess(const PluginProcess&) = delete;
  PluginProcess& operator=(const PluginProcess&) = delete;

  /// As the plug-in gave it, not yet checked.
  const moontrace_description& description() const noexcept { return helper_->description; }

  void Put(const plugin_wire::Command& command) noexcept { program_->command.Put(command); }
  bool Take(plugin_wire::Reading& reading) noexcept {
    return helper_->reading.Take(reading, seen_);
  }
  /// How it came to an end, "crashed (signal 11, Segmentation fault)" say; empty if it lives. Waits
  /// up to a second for a process that ends just now.
  std::string HowItEnded() const;
  bool IsAlive() const noexcept {
    return !lost_.load(std::memory_order_relaxed) &&
           helper_->phase.load(std::memory_order_acquire) == plugin_wire::Phase::kRunning;
  }

 private:
  void AwaitOpening(const std::string& path);
  void Watch();
  bool HasEnded(int milliseconds) const noexcept;
  int Reap() noexcept;

  SharedMemory memory_;
  plugin_wire::ProgramPage* program_;
  const plugin_wire::HelperPage* helper_;
  std::uint64_t seen_ = 0;
  FileDescriptor lifeline_;
  ::pid_t pid_ = -1;
  std::atomic<bool> lost_{false};
  std::atomic<bool> closing_{false};
  std::string ended_how_;  ///< the watcher thread's, until `is_over_`
  std::atomic<bool> is_over_{false};
  std::thread watcher_;
};

/// Where the helper program is.
inline std::string PluginHostPath() { return HelperPath("moontrace-plugin-host"); }

}  // namespace moontrace
