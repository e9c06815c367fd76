#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "lessons/documents/document.h"
#include "textures/typeset/left_out.h"

/// Sentences about documents that are read.
namespace moontrace::say {

std::string NoDocument();
std::string ForgetNeedsFile();
std::string TextAlone();
std::string SimulateAlone();
std::string NoSuchMessages(std::string_view given);
/// `table`: of liblouis.
std::string BrailleReadBy(std::string_view table);
/// Where nothing is plugged in.
std::string HowToFeelBook();
/// Where something is, `problem`: why it cannot be opened.
std::string DeviceRefused(std::string_view device, std::string_view problem);
std::string HowToFeelRefused();
/// Of standard input.
std::string HowToFeelInput();
/// Why no sign of a text could be set, and what helps. `file`: "-" is standard input.
std::string NothingSet(const std::string& file, std::string_view why);
/// Its title, otherwise its file's name.
std::string DocumentName(const Document& document, const std::string& file);
/// "\"Title\" by A. Author, en, EPUB: 3 parts, 12 headings, 40 pages." Without `pages` none are
/// told. A document without a title has its file's name.
std::string DocumentSummary(const Document& document, const std::string& file,
                            const std::size_t* pages);
std::string LeftOutOf(const LeftOutCount& left_out);
/// "Contents: 12 lines." and such a line.
std::string ContentsOutcome(std::size_t lines);
std::string ContentsLine(const ContentsEntry& entry);
std::string MoreContents(std::size_t count);
/// Where only signs that were taught are set: how many these are, and what stands for other words.
std::string SetOfKnown(std::size_t signs);
std::string LeftOutWordsAre(const LeftOutWords& counts);
std::string PrintedDocument(std::size_t pages, double size);  ///< [m]

namespace help {
inline constexpr const char* kRead =
    "reads a book, a web page, a text or a Braille file: by touch, from where you left off; says "
    "what it holds, "
    "prints it";
inline constexpr const char* kReadFile =
    "the document, or its number in the list of what was read; - is standard input. Without one: "
    "that list.";
inline constexpr const char* kReadForget =
    "forgets the place and the bookmarks kept of FILE; the file stays.";
inline constexpr const char* kReader =
    "whose place is kept, a name of your choice. Default the only one in the records.";
inline constexpr const char* kReadRecords =
    "file of the records. Default the one in your data folder.";
inline constexpr const char* kReadBraille =
    "table of liblouis by which Braille files are read. Default that of the book's language, else "
    "en-ueb-g2.ctb; with --script braille their cells are felt as they are.";
inline constexpr const char* kReadMessages =
    "moon lays answers under the tip as a line of their own, a press takes them away, and two "
    "presses give a menu of words: for readers without sight and hearing. Default text.";
inline constexpr const char* kReadKnown =
    "only the signs that the learner has been taught are set, by the records: contractions are "
    "spelled out; for a word with other signs two level lines stand, and it is said as you come to "
    "them.";
inline constexpr const char* kReadTutor =
    "lets a tutor in from another terminal (moontrace tutor): hears what you hear, follows the "
    "line, moves you, sends texts.";
inline constexpr const char* kReadTurn =
    "turn each page as the tip reaches a strip of rough paper below its last line, at the right.";
inline constexpr const char* kReadSimulate =
    "the simulated stylus reads, in real time, to the end of the text.";
inline constexpr const char* kReadDevice =
    "what moves the tip: a name from moontrace devices, plugin:PATH, simulated. Default the first "
    "device with motors; without one only what the document holds is said.";
inline constexpr const char* kReadText =
    "write the document as text, with the marks that page --structure reads.";
inline constexpr const char* kReadPrint =
    "write the pages in their true size for swell paper: .pdf, .svg or .png.";
inline constexpr const char* kReadMost =
    "largest file, or all parts of a book unpacked, in MB, 1 to 1024. Default 64.";
}  // namespace help

}  // namespace moontrace::say
