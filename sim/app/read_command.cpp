#include <algorithm>
#include <filesystem>
#include <istream>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "lessons/documents/braille_text.h"
#include "lessons/documents/brf_document.h"
#include "lessons/documents/open_document.h"
#include "lessons/documents/transcribe.h"
#include "sim/app/commands.h"
#include "sim/book/document_messages.h"
#include "sim/book/known_signs.h"
#include "sim/book/read_book.h"
#include "sim/book/read_list.h"
#include "sim/picture/page_picture.h"
#include "sim/picture/picture_file.h"
#include "sim/picture/picture_messages.h"
#include "sim/picture/structure_messages.h"
#include "sim/session/loop_messages.h"
#include "sim/session/view_feed.h"
#include "sim/setup/help.h"
#include "sim/setup/setup_messages.h"
#include "sim/setup/typeset_report.h"
#include "textures/base/error.h"
#include "textures/relief/groove_links.h"
#include "textures/typeset/left_out.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

constexpr std::size_t kMostContentsSaid = 20;

std::string ReadInput(std::size_t most_bytes, Console& console) {
  std::string bytes;
  char block[65536];
  while (console.in().read(block, sizeof block) || console.in().gcount() > 0) {
    bytes.append(block, static_cast<std::size_t>(console.in().gcount()));
    if (bytes.size() > most_bytes) break;  // refused with its size
    console.CheckStop();
  }
  if (console.in().bad()) throw InputError(say::CannotReadInput());
  return bytes;
}

/// Braille is read as what it says, unless its cells are to be felt.
Document Understood(Document document, const ReadOptions& options, Console& console) {
  const bool cells = options.style.script == "braille";
  if (options.braille.empty() && !IsBraille(document)) return document;
  if (cells && options.braille.empty()) return document;
  const std::string table =
      options.braille.empty() ? BrailleTableFor(document.language) : options.braille;
  ReadPatterns(document, table);
  console.Remark(say::BrailleReadBy(table));
  return document;
}

Document Open(const ReadOptions& options, Console& console) {
  OpenOptions open;
  open.marks = options.style.structure;
  if (options.most_bytes) open.limits.most_bytes = static_cast<std::size_t>(*options.most_bytes);
  if (options.file != "-") return Understood(OpenDocument(options.file, open), options, console);
  return Understood(
      ReadDocument(ReadInput(open.limits.most_bytes, console), "standard input", open), options,
      console);
}

/// A document as it was set; its pages are made again when they are drawn.
struct Reading {
  Script script;
  Typeset set;
  PageCounts counts;
  LeftOutWords words;
};

Reading SetDocument(const ReadOptions& options, const std::string& text, Console& console) {
  StyleOptions marked = options.style;
  marked.structure = true;
  Reading reading{ScriptOf(marked, nullptr, text), {}, {}, {}};
  for (const std::string& remark : reading.script.remarks) console.Remark(remark);
  const TypeStyle style = StyleOf(marked, options.layout, reading.script, nullptr);
  PageLinker linker(reading.script, style);
  reading.set = SetPages(text, reading.script, style, PageOf(options.layout), [&](TextPage&& page) {
    console.CheckStop();
    linker.Keep(page);
    AddCounts(page, reading.script, style, reading.counts);
    CountLeftOut(page, reading.script, reading.words);
  });
  return reading;
}

/// Of which nothing is left to set: that needs the file's name, and what helps.
[[noreturn]] void RefuseText(const ReadOptions& options, const NoSignError& error) {
  throw InputError(say::NothingSet(options.file, error.what()));
}

Reading SetOrRefuse(const ReadOptions& options, const std::string& text, Console& console) {
  try {
    return SetDocument(options, text, console);
  } catch (const NoSignError& error) {
    RefuseText(options, error);
  }
}

std::vector<std::string> Print(const ReadOptions& options, const std::string& text,
                               const std::string& title, const Reading& reading, Console& console) {
  PagePictures pictures(options.print, reading.counts.pages);
  std::size_t page = 0;
  SetPages(text, reading.script, reading.set.style, reading.set.page, [&](TextPage&& sheet) {
    console.CheckStop();
    console.Alive(static_cast<double>(page++) / static_cast<double>(reading.counts.pages));
    pictures.Add(SwellPage(sheet, reading.set, reading.script, title));
  });
  return pictures.Finish();
}

Json BlockJson(const Block& block) {
  Json json = {{"kind", NameOf(block.kind)}, {"text", block.text}};
  if (block.level != 0) json["level"] = block.level;
  if (block.quotation != 0) json["quotation"] = block.quotation;
  if (block.note) json["note"] = true;
  if (!block.label.empty()) json["label"] = block.label;
  if (!block.column_name.empty()) json["column_name"] = block.column_name;
  if (block.row != 0) json["row"] = block.row;
  if (block.column != 0) json["column"] = block.column;
  for (const DocumentMark& mark : block.marks) {
    Json one = {
        {"kind", NameOf(mark.kind)}, {"bytes", {mark.begin, mark.end}}, {"value", mark.value}};
    if (mark.target != kNoBlock) one["block"] = mark.target;
    json["marks"].push_back(std::move(one));
  }
  return json;
}

Json DocumentJson(const Document& document) {
  Json json = {{"format", NameOf(document.format)},
               {"title", document.title},
               {"authors", document.authors},
               {"language", document.language},
               {"encoding", document.encoding},
               {"parts", Json::array()},
               {"contents", Json::array()},
               {"left_out", Json::array()},
               {"blocks", Json::array()}};
  for (const DocumentPart& part : document.parts) {
    json["parts"].push_back({{"path", part.path}, {"block", part.first_block}});
  }
  for (const ContentsEntry& entry : ContentsOf(document)) {
    json["contents"].push_back(
        {{"title", entry.title},
         {"level", entry.level},
         {"block", entry.block == kNoBlock ? Json(nullptr) : Json(entry.block)}});
  }
  for (const LeftOutCount& one : document.left_out) {
    json["left_out"].push_back(
        {{"what", NameOf(one.what)}, {"count", one.count}, {"example", one.example}});
  }
  for (const Block& block : document.blocks) json["blocks"].push_back(BlockJson(block));
  return json;
}

void SayContents(const Document& document, Console& console) {
  const std::vector<ContentsEntry> contents = ContentsOf(document);
  if (contents.empty()) return;
  console.Result(say::ContentsOutcome(contents.size()));
  const std::size_t said = std::min(contents.size(), kMostContentsSaid);
  for (std::size_t i = 0; i < said; ++i) console.Result(say::ContentsLine(contents[i]));
  if (said < contents.size()) console.Result(say::MoreContents(contents.size() - said));
}

/// A document's text could hold what a terminal obeys; line ends and tabs are no such thing.
std::string Harmless(std::string text) {
  for (char& c : text) {
    if ((c >= 0 && c < ' ' && c != '\n' && c != '\t') || c == '\x7f') c = '?';
  }
  return text;
}

int WriteText(const ReadOptions& options, const Document& document, const std::string& text,
              Console& console) {
  console.Remark(say::DocumentSummary(document, options.file, nullptr));
  for (const LeftOutCount& one : document.left_out) console.Remark(say::LeftOutOf(one));
  console.out() << Harmless(text);
  return exit_code::kGood;
}

/// What is said of a document without feeling it.
int Describe(const ReadOptions& options, const Document& document, const std::string& text,
             Console& console) {
  const Reading reading = SetOrRefuse(options, text, console);
  std::vector<std::string> printed;
  if (!options.print.empty()) {
    printed = Print(options, text, say::DocumentName(document, options.file), reading, console);
  }
  if (options.output.json) {
    Json json = TypesetJson(reading.set, reading.script, reading.counts);
    json["document"] = DocumentJson(document);
    json["pages"] = reading.counts.pages;
    json["lines"] = reading.counts.lines;
    json["signs"] = reading.counts.signs;
    json["words"] = reading.words.words;
    json["left_out_words"] = reading.words.left_out;
    json["printed"] = printed;
    console.Json(Dump(json));
    return exit_code::kGood;
  }
  console.Result(say::DocumentSummary(document, options.file, &reading.counts.pages));
  for (const LeftOutCount& one : document.left_out) console.Result(say::LeftOutOf(one));
  if (options.known) console.Result(say::LeftOutWordsAre(reading.words));
  SayReplacements(
      reading.set, [&console](const std::string& line) { console.Result(line); },
      kReplacementsSaid);
  if (reading.set.structure.links + reading.set.structure.quotations > 0) {
    console.Result(say::Structure(reading.set));
  }
  SayContents(document, console);
  if (!printed.empty()) {
    console.Result(say::PrintedDocument(reading.counts.pages, reading.set.style.size));
  }
  for (const std::string& file : printed) console.Path(file);
  return exit_code::kGood;
}

/// What it is felt with, and where nothing is that could be felt with.
struct Feeling {
  std::optional<std::string> device;   ///< none: nothing was asked for, or nothing can be used
  std::optional<DeviceEntry> refused;  ///< it has motors and cannot be opened
};

Feeling FeelingOf(const ReadOptions& options) {
  if (options.text || options.output.json || !options.print.empty()) return {};
  if (options.simulate) return {"simulated", {}};
  if (!options.live.device.empty()) return {options.live.device, {}};
  if (options.file == "-") return {};  // no words could be typed
  std::optional<DeviceEntry> first = FirstForceDevice();
  if (first && !first->problem.empty()) return {{}, std::move(first)};
  if (!first) return {};
  return {first->name, {}};
}

void SayHowToFeel(const ReadOptions& options, const Feeling& feeling, Console& console) {
  if (options.file == "-") return console.Remark(say::HowToFeelInput());
  if (!feeling.refused) return console.Remark(say::HowToFeelBook());
  console.Result(say::DeviceRefused(feeling.refused->name, feeling.refused->problem));
  SayMending(*feeling.refused, console);
  console.Result(say::HowToFeelRefused());
}

ReadBookOptions BookOptionsOf(const ReadOptions& options, const std::string& device) {
  ReadBookOptions book;
  book.style = options.style;
  book.layout = options.layout;
  book.live = options.live;
  book.live.device = device;
  book.press = options.press;
  book.seed = options.seed;
  book.learner = options.learner;
  book.records = RecordsPathOf(options.records);
  book.turns = options.turns;
  book.moon = options.moon;
  book.tutor = options.tutor;
  book.known = options.known;
  book.alone = options.simulate;
  return book;
}

/// Who can neither see nor hear is told under the hand why there is no book.
Document OpenOrTell(const ReadOptions& options, const std::optional<std::string>& device,
                    Console& console) {
  try {
    return Open(options, console);
  } catch (const InputError& error) {
    if (!options.moon || !device) throw;
    TellInPlaceOfBook(error.what(), BookOptionsOf(options, *device), console);
    throw;
  }
}

int Read(const ReadOptions& options, Console& console) {
  const Feeling feeling = FeelingOf(options);
  const Document document = OpenOrTell(options, feeling.device, console);
  if (feeling.device) {
    try {
      ReadBook(document, options.file, BookOptionsOf(options, *feeling.device), console);
    } catch (const NoSignError& error) {
      RefuseText(options, error);
    }
    return exit_code::kGood;
  }
  const std::string text = Transcribe(document).text;
  if (options.text) return WriteText(options, document, text, console);
  const int code = Describe(options, document, text, console);
  if (!options.output.json && options.print.empty()) SayHowToFeel(options, feeling, console);
  return code;
}

/// Without a file, or to forget one.
int TellReadings(const ReadOptions& options, Console& console) {
  const std::string records = RecordsPathOf(options.records);
  if (options.forget) {
    ForgetReading(options.file, options.learner, records, console);
    return exit_code::kGood;
  }
  if (options.text || !options.print.empty()) throw UsageError(say::NoDocument());
  ListReadings(options.learner, records, options.output.json, console);
  return exit_code::kGood;
}

/// A number of the list becomes its file, and who reads it there reads on.
ReadOptions WithFile(const ReadOptions& options) {
  const bool number = options.file.find_first_not_of("0123456789") == std::string::npos;
  std::error_code ignored;
  if (!number || std::filesystem::exists(options.file, ignored)) return options;
  ListedFile meant = FileNumbered(options.file, options.learner, RecordsPathOf(options.records));
  ReadOptions read = options;
  read.file = std::move(meant.path);
  read.learner = std::move(meant.learner);
  return read;
}

/// Likewise of a number that is none.
ReadOptions NumberedOrTold(const ReadOptions& options, Console& console) {
  try {
    return WithFile(options);
  } catch (const InputError& error) {
    const std::optional<std::string> device =
        options.moon ? FeelingOf(options).device : std::nullopt;
    if (device) TellInPlaceOfBook(error.what(), BookOptionsOf(options, *device), console);
    throw;
  }
}

/// By touch, of what was read before. False: nothing was chosen.
bool ChooseFile(ReadOptions& options, const std::string& device, Console& console) {
  std::optional<ListedFile> file = ChooseReading(BookOptionsOf(options, device), console);
  if (!file) return false;
  options.file = std::move(file->path);
  options.learner = std::move(file->learner);
  return true;
}

void CheckTogether(const ReadOptions& options) {
  AimsFor(options.live.device, ViewOptions());  // refuses a mouse
  if (options.simulate && !IsSimulated(options.live.device)) {
    throw UsageError(say::SimulateAlone());
  }
  if (options.forget && (options.file.empty() || options.file == "-")) {
    throw UsageError(say::ForgetNeedsFile());
  }
  if (options.text && (options.output.json || !options.print.empty())) {
    throw UsageError(say::TextAlone());
  }
  if (options.print.empty()) return;
  if (!HasPictureEnding(options.print)) {
    throw UsageError(say::NotAPicture("--print", options.print));
  }
  CheckPicturePath(options.print);
}

}  // namespace

void AddOptions(CLI::App& app, ReadOptions& options) {
  AddPath(app, "FILE", "FILE", options.file, say::help::kReadFile);
  AddPath(app, "--learner", "NAME", options.learner, say::help::kReader);
  AddPath(app, "--records", "FILE", options.records, say::help::kReadRecords);
  AddFlag(app, "--forget", options.forget, say::help::kReadForget);
  AddFlag(app, "--turn", options.turns, say::help::kReadTurn);
  AddFlag(app, "--known", options.known, say::help::kReadKnown);
  AddFlag(app, "--tutor", options.tutor, say::help::kReadTutor);
  AddFlag(app, "--simulate", options.simulate, say::help::kReadSimulate);
  const auto read_messages = [&options](const std::string& given) {
    if (given != "moon" && given != "text") throw UsageError(say::NoSuchMessages(given));
    options.moon = given == "moon";
  };
  AddValue(app, "--messages", "WORD", read_messages, say::help::kReadMessages);
  AddOptions(app, options.live);
  Redescribe(app, "--device", say::help::kReadDevice);
  AddNumber(app, "--press-n", options.press, 0.01, 20, 1, say::help::kLoopPress);
  AddSeed(app, options.seed);
  constexpr double kMegabyte = 1 << 20;
  BeginGroup(app, help_group::kText);
  AddNumber(app, "--most-mb", options.most_bytes, 1, 1024, kMegabyte, say::help::kReadMost);
  AddPath(app, "--braille", "TABLE", options.braille, say::help::kReadBraille);
  BeginGroup(app, help_group::kResults);
  AddFlag(app, "--text", options.text, say::help::kReadText);
  AddPath(app, "--print", "FILE", options.print, say::help::kReadPrint);
  AddOptions(app, options.style);
  AddOptions(app, options.layout);
  AddOptions(app, options.output);
}

int Run(const ReadOptions& options, Console& console) {
  CheckTogether(options);
  if (options.forget) return TellReadings(options, console);
  ReadOptions read = options;
  if (options.file.empty()) {
    const std::optional<std::string> device =
        options.moon ? FeelingOf(options).device : std::nullopt;
    if (!device) return TellReadings(options, console);
    if (!ChooseFile(read, *device, console)) return exit_code::kGood;
  } else {
    read = NumberedOrTold(options, console);
  }
  if (!options.known) return Read(read, console);
  const std::string known = KnownSigns(RecordsPathOf(options.records), read.learner);
  read.style.only = known + "+" + kLeftOutMark;
  const auto signs = std::count(known.begin(), known.end(), '+');
  console.Remark(say::SetOfKnown(static_cast<std::size_t>(signs)));
  return Read(read, console);
}

}  // namespace moontrace
