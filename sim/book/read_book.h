#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "lessons/documents/document.h"
#include "sim/book/read_list.h"
#include "sim/console/console.h"
#include "sim/session/device_choice.h"
#include "sim/setup/options.h"

namespace moontrace {

/// Of characters that were replaced so many are said of each kind, then how many more there are:
/// who opens a book wants to read.
inline constexpr std::size_t kReplacementsSaid = 3;

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
/// is kept whatever is thrown. Where it cannot be, reading goes on, and the error comes at the end.
void ReadBook(const Document& document, const std::string& file, const ReadBookOptions& options,
              Console& console);

/// Lays on the device what was read and can be read on, a title a line, until a press on one
/// chooses it. None: there is nothing, which is told there too, or whoever was asked has left.
/// Throws as ReadBook.
std::optional<ListedFile> ChooseReading(const ReadBookOptions& options, Console& console);

/// Lays on the device why there is no book to read, until a press or a word. Throws Interrupted.
void TellInPlaceOfBook(const std::string& sentence, const ReadBookOptions& options,
                       Console& console);

}  // namespace moontrace
