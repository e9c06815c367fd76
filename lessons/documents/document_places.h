#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/documents/document.h"
#include "lessons/documents/transcribe.h"

namespace moontrace {

/// Places of a document in its transcription: bytes of Transcription::text.

/// The block that a byte stands in; 0 before the first.
std::size_t BlockAt(const Transcription& text, std::size_t byte);

/// The headings that a place stands below, the outermost first; a heading is below itself.
std::vector<std::size_t> HeadingTrail(const Document& document, std::size_t block);

/// The printed page that a place stands on; null: none is marked before it.
const TranscribedPage* PrintPageAt(const Transcription& text, std::size_t byte);

/// The link at a byte, with its brackets; null: there is none.
const TranscribedLink* LinkAt(const Transcription& text, std::size_t byte);

/// The sentence around a byte, at most some 200 bytes to either side, as words: without marks of
/// structure.
std::string SentenceAt(std::string_view text, std::size_t byte);

/// What was read at a byte: the sentence; of an item of a list and a cell of a table, of these.
std::string ReadAt(const Document& document, const Transcription& text, std::size_t byte);

/// A piece of a transcription as words: without the marks of headings, quotations and links, on one
/// line.
std::string WordsOf(std::string_view piece);

/// So many bytes before a place and from it on are kept to find it again, less broken characters.
inline constexpr std::size_t kAround = 80;
struct Around {
  std::string before, behind;
};
Around AroundOf(std::string_view text, std::size_t byte);

/// Where a place lies in a text that was changed since: the longest of what stood around it that is
/// still there, on both sides or all of one, at least 40 bytes or all that was kept, and of several
/// the nearest to the same share of the text. None: its words are gone. `byte` of `length` was the
/// place. Linear in the text.
std::optional<std::size_t> FindAgain(std::string_view text, const Around& around, std::size_t byte,
                                     std::size_t length);
/// The same share of a text that was changed: where a place is put whose words are gone.
std::size_t SameShare(std::string_view text, std::size_t byte, std::size_t length);

/// Short pieces of a text at even shares of it, by which an edited text is told from another one
/// that begins alike; at most some 550 bytes.
std::string LandmarksOf(std::string_view text);
/// How many of the landmarks still stand in a text, 0 to 1; 0 without landmarks. Linear in the
/// text.
double LandmarksIn(std::string_view text, std::string_view landmarks);

}  // namespace moontrace
