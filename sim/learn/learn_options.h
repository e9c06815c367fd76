#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim/session/device_choice.h"
#include "sim/session/view_options.h"
#include "sim/setup/options.h"

namespace moontrace {

/// `learn`: lessons.
struct LearnOptions {
  OutputOptions output;  ///< `--quiet` only
  std::string learner;   ///< pseudonym; empty: the one in the records, or asked for
  std::string course = "learn-moon";
  std::string records;          ///< path; empty: the default
  LiveOptions live;             ///< `device` empty: the first one with motors
  std::optional<double> press;  ///< [N]
  std::uint64_t seed = 1;
  bool brief = false;  ///< outcomes only, from now on
  bool speak = false, sound = false, tutor = false;
  std::string sounds;  ///< with `sound`: a file of the user's, see LoadSounds
  ViewOptions view;
  std::string keys;  ///< empty: off; "true": the usual keys; otherwise a file

  bool simulate = false;  ///< a simulated learner goes through the course, unattended
  int days = 0;           ///< with `simulate`: sessions, one a day; 0: until the course is done

  std::string print;           ///< picture to write instead of a lesson
  std::string lesson;          ///< with `print`: id; empty: the first
  std::optional<double> size;  ///< with `print` [m]
};

}  // namespace moontrace
