#pragma once

#include <atomic>
#include <cstddef>

#include "devices/core/device.h"
#include "devices/core/mailbox.h"
#include "lessons/guide/guidance.h"
#include "sim/loop/loop_types.h"
#include "sim/loop/spsc_queue.h"
#include "sim/physics/scene.h"
#include "sim/physics/scene_pose.h"

namespace moontrace {

/// A page change, passed to the tick and back.
struct PostedPage {
  ReadyPage ready;  ///< as Scene::MakeReady gives it
  std::uint32_t page = 0;
  std::optional<PageAnchor> anchor;
  std::optional<DevicePlace> place_P;  ///< PageChange::place_P
  std::optional<double> tilt;          ///< PageChange::tilt
  std::unique_ptr<Device> device;      ///< in: the new one or none; out: the one it replaced
};

/// A plan of a push, passed to the tick and back; nullptr: no push from now on.
struct PostedPush {
  const GuidancePlan* plan = nullptr;
};

/// Everything that passes between the tick and other threads. The tick never waits for them. The
/// sender of a pointer keeps what it points to until the pointer comes back.
struct LoopMail {
  /// The queue holds this many seconds of samples: as long as a reader may sleep.
  static constexpr double kSampleSeconds = 2;

  explicit LoopMail(double rate)
      : samples(static_cast<std::size_t>(rate * kSampleSeconds)), events(256) {}

  std::atomic<PostedPage*> wanted_page{nullptr};        ///< to the tick
  std::atomic<PostedPage*> done_page{nullptr};          ///< from the tick
  std::atomic<const PostedPush*> wanted_push{nullptr};  ///< to the tick
  std::atomic<const PostedPush*> done_push{nullptr};    ///< from the tick: it is in use
  std::atomic<Device*> reopened{nullptr};               ///< to the tick: a lost device
  std::atomic<Device*> detached{nullptr};               ///< from the tick: lost, to be destroyed
  std::atomic<bool> stop{false};                        ///< to the tick
  std::atomic<bool> go_on{false};                       ///< to the tick
  Mailbox<LoopSnapshot> snapshot;                       ///< from the tick
  PoseMail pose;                                        ///< from the tick
  SpscQueue<LoopSample> samples;                        ///< from the tick
  SpscQueue<LoopEvent> events;                          ///< from the tick
};

}  // namespace moontrace
