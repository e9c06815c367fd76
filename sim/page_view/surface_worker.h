#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "sim/page_view/view_page.h"
#include "sim/picture/field_shading.h"

namespace moontrace {

/// What is to be shaded.
struct SurfaceWish {
  std::shared_ptr<const ViewPage> page;
  Box view_P;  ///< what the picture covers [m]
  std::size_t width = 0, height = 0;
  PageShade shade;
  std::uint64_t number = 0;  ///< the wisher's
};

/// Shades pages on threads of its own, which give way to the loop's; always the newest wish, those
/// between are dropped.
class SurfaceWorker {
 public:
  SurfaceWorker();
  /// Waits for the surface that is being worked on.
  ~SurfaceWorker();
  SurfaceWorker(const SurfaceWorker&) = delete;
  SurfaceWorker& operator=(const SurfaceWorker&) = delete;

  void Wish(SurfaceWish wish);

  struct Surface {
    Raster raster;
    SurfaceWish of;
  };
  /// The newest surface that was not taken yet.
  std::optional<Surface> Take();
  /// Waits until no wish is open.
  void Await();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Lets the calling thread, and those it starts, run only when the loop leaves time; its signals go
/// to the program's first thread.
void GiveWayToTheLoop() noexcept;

}  // namespace moontrace
