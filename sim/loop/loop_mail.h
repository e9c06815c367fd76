#pragma once

#include <atomic>
#include <cstddef>

#include "devices/core/device.h"
#include "devices/core/mailbox.h"
#include "lessons/guide/guidance.h"
#include "sim/loop/loop_types.h"
#include "sim/loop/spsc_queue.h"

namespace moontrace {

/// A page change on its way through the tick.
struct PostedPage {
  const TextureField* field = nullptr;
  int substeps = 1;  ///< Scene::CheckField of it
  std::uint32_t page = 0;
  std::optional<PageAnchor> anchor;
  std::optional<double> tilt;      ///< PageChange::tilt
  std::unique_ptr<Device> device;  ///< in: the new one or none; out: the one it replaced
};

/// A plan of a push on its way to the tick; none: no push from now on.
struct PostedPush {
  const GuidancePlan* plan = nullptr;
};

/// Everything that goes between the tick and other threads. The tick takes and leaves, and never
/// waits; whoever posts a pointer keeps what it points to until it comes back.
struct LoopMail {
  /// Queues hold so many seconds of samples: as long as a reader may sleep.
  static constexpr double kSampleSeconds = 2;

  explicit LoopMail(double rate)
      : samples(static_cast<std::size_t>(rate * kSampleSeconds)), events(256) {}

  std::atomic<PostedPage*> wanted_page{nullptr};        ///< to the tick
  std::atomic<PostedPage*> done_page{nullptr};          ///< from the tick
  std::atomic<const PostedPush*> wanted_push{nullptr};  ///< to the tick
  std::atomic<const PostedPush*> done_push{nullptr};    ///< from the tick: it is in use
  std::atomic<Device*> fresh{nullptr};                  ///< to the tick: opened again
  std::atomic<Device*> worn{nullptr};                   ///< from the tick: lost, to be destroyed
  std::atomic<bool> stop{false};                        ///< to the tick
  std::atomic<bool> go_on{false};                       ///< to the tick
  Mailbox<LoopSnapshot> snapshot;                       ///< from the tick
  SpscQueue<LoopSample> samples;                        ///< from the tick
  SpscQueue<LoopEvent> events;                          ///< from the tick
};

}  // namespace moontrace
