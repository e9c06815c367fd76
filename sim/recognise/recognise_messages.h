#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "sim/reader/page_reader.h"
#include "sim/reading/reading_score.h"
#include "textures/fonts/script.h"
#include "textures/typeset/typeset.h"

/// Sentences of `moontrace recognise`.
namespace moontrace::say {

std::string ReadingOutcome(const ReadingScore& score);
/// `signs`: that lay there.
std::string NothingRead(double seconds, std::size_t signs);
/// `seconds`: of the whole reading.
std::string ReadingTime(const ReadingScore& score, double seconds, double real_time_factor);
/// What stood there and what was read instead, the most frequent first; empty where there is none.
std::string Confusions(const ReadingScore& score, const Script& script);
std::string AsRead();
/// What was read, for speech: what was felt and not known (U+FFFD) is called so.
std::string Spoken(std::string_view read);
/// Of Braille, behind the cells.
std::string InPrint();
/// The profile does not measure or push along the paper, or not up and down where signs are not
/// followed.
std::string ReadsWhereLettersAreFelt(std::string_view profile, bool followed);
std::string ReaderStopped(std::size_t page);
/// Beforehand, of pages on which the reader is known to get lost.
std::string ReaderMissesWideGaps();
std::string ReaderFollowsNoGuides();
std::string ReaderKnowsLinksToTheRight();
/// The tip went through the paper so often.
std::string ReaderPressedThrough(std::size_t page, std::size_t count);

/// In a view's panel: a sign that is thought to have been felt (empty: none of the script), how
/// sure, and what the hand is at.
std::string Belief(std::string_view sign, double probability);
std::string Doing(ReaderActivity activity);

std::string ReadingPictureTitle(const Script& script, const TypeStyle& style);
std::string ReadingPictureWords(std::string_view text, std::string_view read);
std::string ReadingPictureLegend(const TypeStyle& style, bool followed, bool blank);

namespace help {
inline constexpr const char* kRecognise =
    "a simulated reader that only feels reads the text and is scored";
inline constexpr const char* kReaderPress =
    "press of the hand in N. Default 1, on ridges 0.2, on dots of Braille 0.35, raised 0.06.";
inline constexpr const char* kReaderDevice =
    "the reader's hand is on that device: a profile's name, such as moontrace-raw, or its file. It "
    "gets the place in the device's steps and the force that is commanded; the page lies "
    "within its reach. Default: read exactly.";
inline constexpr const char* kReaderUnsure =
    "the hand is unsure of its place: rms error in mm that wanders over 1.5 s. Default 0.";
inline constexpr const char* kReaderBlank = "the reader is given paper without grooves.";
inline constexpr const char* kReaderSeed =
    "of tremor, drift, how the page lies and what the reader does by chance, a whole number. "
    "Default 1.";
}  // namespace help

}  // namespace moontrace::say
