#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lessons/documents/document.h"
#include "lessons/records/readings.h"
#include "sim/console/console.h"
#include "sim/session/device_choice.h"
#include "sim/setup/options.h"

namespace moontrace {

/// How a document is felt.
struct ReadBookOptions {
  StyleOptions style;
  LayoutOptions layout;
  LiveOptions live;             ///< `device`: that there is one has been found out
  std::optional<double> press;  ///< [N]
  std::uint64_t seed = 1;       ///< of the simulated hand
  std::string learner;          ///< empty: the only one in the records
  std::string records;          ///< path
  bool turns = false;           ///< see BookOptions
  bool moon = false;            ///< likewise
  bool tutor = false;           ///< tutors may come in from other terminals
  bool known = false;           ///< only signs that the learner has been taught are set
  bool alone = false;           ///< nobody turns pages: the simulated hand reads to the end
};

/// Lets a document be felt in real time, from where its reader left off, until "quit". `file`: its
/// path, "-" for standard input. Throws InputError, LackError, DeviceError, Interrupted; the place
/// is kept whatever is thrown.
void ReadBook(const Document& document, const std::string& file, const ReadBookOptions& options,
              Console& console);

/// Lays on the device why there is no book to read, until a press or a word. Throws Interrupted.
void TellInPlaceOfBook(const std::string& sentence, const ReadBookOptions& options,
                       Console& console);

/// What was read, and by whom.
struct KnownReading {
  ReadDocument reading;
  std::string learner;
  /// Whether its file still holds it, as far as is known without opening it.
  enum class File : std::uint8_t { kThere, kGone, kHoldsAnother, kWasInput };
  File file = File::kThere;
};
/// The newest first: their numbers, from 1, are those that `read` alone says; of one learner, if
/// one is named. `records`: path; empty where there is none. Throws as Records.
std::vector<KnownReading> KnownReadings(const std::string& learner, const std::string& records);
/// The one that `given` means: its number, or its file, of which it is what was read there last.
/// Throws InputError: there is none.
KnownReading ReadingMeant(const std::string& given, const std::string& learner,
                          const std::string& records);

/// Says what was read last, with its places.
void ListReadings(const std::vector<KnownReading>& readings, bool names, bool json,
                  Console& console);
/// Forgets place and bookmarks of one, which cannot be undone. Throws as Records.
void ForgetReading(const KnownReading& reading, const std::string& records, Console& console);

}  // namespace moontrace
