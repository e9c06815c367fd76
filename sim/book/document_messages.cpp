#include "sim/book/document_messages.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "sim/console/wording.h"
#include "textures/base/text_file.h"

namespace moontrace::say {
namespace {

/// "3 pictures have" or "1 picture has".
std::string Has(std::size_t count, const char* one, const char* many) {
  return Counted(count, one, many) + (count == 1 ? " has" : " have");
}

std::string Is(std::size_t count, const char* one, const char* many) {
  return Counted(count, one, many) + (count == 1 ? " is" : " are");
}

std::string Begins(const std::string& example, const char* before = ", the first ") {
  return example.empty() ? "." : before + Quoted(example) + ".";
}

}  // namespace

std::string NoDocument() { return "read needs a file: moontrace read FILE"; }

std::string ForgetNeedsFile() {
  return "--forget needs a file, or its number in the list: moontrace read 2 --forget";
}

std::string TextAlone() {
  return "--text writes the text alone; give it without --json and --print";
}

std::string SimulateAlone() { return "--simulate needs no device: leave out --device"; }

std::string BrailleReadBy(std::string_view table) {
  return fmt::format("Braille, read as print by the table {}; --script braille keeps its cells.",
                     OneLine(table, 60));
}

std::string NoSuchMessages(std::string_view given) {
  return fmt::format("--messages is \"{}\": choose text or moon", OneLine(given));
}

std::string HowToFeelBook() {
  return "No device with motors: read by touch with --device NAME, or try the words with "
         "--device simulated.";
}

std::string DeviceRefused(std::string_view device, std::string_view problem) {
  return fmt::format("Not usable: {}, which has motors: {}.", OneLine(device, 60),
                     OneLine(problem, 300));
}

std::string HowToFeelRefused() {
  return "Once that is mended, read it by touch; or try the words with --device simulated.";
}

std::string HowToFeelInput() {
  return "Read by touch with --device NAME; no word can be typed then, since the text is the "
         "input.";
}

std::string NothingSet(const std::string& file, std::string_view why) {
  return fmt::format("{}: {}; --text shows the text, --script NAME sets it in another script",
                     file == "-" ? "standard input" : OneLine(file, 200), OneLine(why, 200));
}

std::string DocumentName(const Document& document, const std::string& file) {
  if (!document.title.empty()) return document.title;
  return file == "-" ? "standard input" : std::filesystem::path(file).filename().string();
}

std::string DocumentSummary(const Document& document, const std::string& file,
                            const std::size_t* pages) {
  const auto headings = static_cast<std::size_t>(
      std::count_if(document.blocks.begin(), document.blocks.end(),
                    [](const Block& block) { return block.kind == BlockKind::kHeading; }));
  std::string line = Quoted(OneLine(DocumentName(document, file), 100));
  std::vector<std::string> authors;
  for (const std::string& author : document.authors) authors.push_back(OneLine(author));
  if (authors.size() > 3) authors.resize(3);
  if (!authors.empty()) line += " by " + Joined(authors, " and ");
  line += fmt::format(
      ", {}, {}: ", document.language.empty() ? "language not told" : OneLine(document.language),
      NameOf(document.format));
  if (document.format == DocumentFormat::kEpub) {
    line += Counted(document.parts.size(), "part, ", "parts, ");
  }
  line += Counted(headings, "heading", "headings");
  if (pages != nullptr) line += ", " + Counted(*pages, "page", "pages");
  return line + ".";
}

std::string LeftOutOf(const LeftOutCount& left_out) {
  const std::size_t n = left_out.count;
  const std::string& example = left_out.example;
  switch (left_out.what) {
    case LeftOut::kHiddenPart:
      return "Not read: " + Counted(n, "hidden part", "hidden parts") + Begins(example);
    case LeftOut::kPicture:
      return Has(n, "picture", "pictures") + " no description" + Begins(example);
    case LeftOut::kDrawing:
      return Is(n, "drawing", "drawings") + " not laid out to be felt; the words are read" +
             Begins(example);
    case LeftOut::kMedia:
      return "Left out: " +
             Counted(n, "sound, video or embedded page", "sounds, videos or embedded pages") +
             Begins(example);
    case LeftOut::kReading:
      return "Left out: " + Counted(n, "reading beside a character", "readings beside characters") +
             Begins(example);
    case LeftOut::kGuessedCoding:
      return fmt::format(
          "The encoding was guessed: {}. If words look wrong, iconv -f NAME -t UTF-8 FILE makes it "
          "UTF-8.",
          OneLine(left_out.example));
    case LeftOut::kBadByte:
      return Has(n, "place", "places") +
             " bytes of no character; a replacement character stands there" +
             Begins(example, ", first in ");
    case LeftOut::kUnknownEntity:
      return Is(n, "entity", "entities") + " unknown and left as written" + Begins(example);
    case LeftOut::kDeepElement:
      return Is(n, "element", "elements") + " nested too deep: the text is kept, the kind is not" +
             Begins(example);
    case LeftOut::kFaultyPart:
      return Has(n, "chapter", "chapters") +
             " faulty names as XML; the words are read all the same" + Begins(example);
    case LeftOut::kBrokenPart:
      return Is(n, "chapter", "chapters") + " damaged, read as web pages are" + Begins(example);
    case LeftOut::kMissingPart:
      return Is(n, "part", "parts") + " missing in the book" + Begins(example);
    case LeftOut::kStandIn:
      return Is(n, "chapter", "chapters") +
             " made by a script, which is not run; what stands in is read" + Begins(example);
    case LeftOut::kUnreadablePart:
      return "Left out: " + Counted(n, "chapter that is no text", "chapters that are no text") +
             Begins(example);
    case LeftOut::kOutsidePart:
      return "Refused: " +
             Counted(n, "chapter whose address leaves", "chapters whose addresses leave") +
             " the book" + Begins(example);
    case LeftOut::kEncryptedPart:
      return Is(n, "file", "files") + " encrypted, none of them a chapter" + Begins(example);
    case LeftOut::kBrokenContents:
      return Is(n, "table of contents", "tables of contents") + " damaged and not used" +
             Begins(example);
    case LeftOut::kLaterPart:
      return Counted(n, "part stands", "parts stand") + " outside the reading order, at the end" +
             Begins(example);
  }
  return {};
}

std::string ContentsOutcome(std::size_t lines) {
  return "Contents: " + Counted(lines, "line", "lines") + ".";
}

std::string ContentsLine(const ContentsEntry& entry) {
  return fmt::format("Level {}: {}{}", entry.level, OneLine(entry.title, 200),
                     entry.block == kNoBlock && !entry.group ? " (leads nowhere)" : "");
}

std::string MoreContents(std::size_t count) {
  return fmt::format("And {} more of the contents; --json has all.", count);
}

std::string SetOfKnown(std::size_t signs) {
  return fmt::format(
      "Set in the {} that you know. Two level lines, one above the other, stand for a word with "
      "other signs; when it is read by touch, it is said as you come to them.",
      Counted(signs, "sign", "signs"));
}

std::string LeftOutWordsAre(const LeftOutWords& counts) {
  if (counts.left_out == 0) return "No word is left out.";
  return fmt::format("Left out: {} of {}. Two level lines stand for each.", counts.left_out,
                     Counted(counts.words, "word", "words"));
}

std::string PrintedDocument(std::size_t pages, double size) {
  return fmt::format("Printed: {} for swell paper, letters {} mm high.",
                     Counted(pages, "page", "pages"), Short(kMillimetres * size, 2));
}

}  // namespace moontrace::say
