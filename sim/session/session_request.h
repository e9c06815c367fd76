#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "devices/core/mailbox.h"
#include "devices/hand/aimed_stylus.h"
#include "sim/session/device_choice.h"
#include "sim/setup/text_setup.h"

namespace moontrace {

/// A text to be felt in real time.
struct SessionRequest {
  TextRequest text;
  LiveOptions live;
  std::optional<double> press;  ///< [N]
  bool blank = false;
  /// A text of one line lies in the sheet's middle, not at its upper left.
  bool centred = false;
  /// Standard input gave the text, so that no words can come from it.
  bool input_taken = false;
  std::uint64_t seed = 1;  ///< of the simulated hand
  /// Of the device "mouse", where a window's mouse means the tip to be, frame P; none: no window.
  std::shared_ptr<Mailbox<StylusAim>> aims = {};

  double rate() const { return live.rate.value_or(1000); }  ///< [Hz]
};

}  // namespace moontrace
