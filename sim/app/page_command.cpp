#include "sim/app/commands.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <vector>

#include "sim/app/messages.h"
#include "sim/picture/link_messages.h"
#include "sim/picture/page_picture.h"
#include "sim/picture/picture_file.h"
#include "sim/picture/picture_messages.h"
#include "sim/picture/structure_messages.h"
#include "sim/setup/help.h"
#include "sim/setup/setup_messages.h"
#include "sim/setup/typeset_report.h"
#include "sim/setup/writing_messages.h"
#include "textures/base/error.h"
#include "textures/relief/groove_links.h"
#include "textures/typeset/back_translate.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

namespace {

constexpr std::size_t kMostLinesSaid = 100;
constexpr std::size_t kMostWordsSaid = 20;
// Pages: for the lines that are said, and one more to see that there are others.
constexpr std::size_t kMostKept = 101;
static_assert(kMostKept > kMostLinesSaid);

/// A text as it was set. Of a book only the first pages are kept, in `set`; the counts are of all.
struct Book {
  const std::string& text;
  const Script& script;
  Typeset set;
  PageCounts counts;
};

/// `rows` takes what each page's rows hold, if not null.
Book SetBook(const std::string& text, const Script& script, const TypeStyle& style,
             const PageSpec& page, RowSigns* rows, Console& console) {
  Book book{text, script, {}, {}};
  std::vector<TextPage> kept;
  PageLinker linker(script, style);
  book.set = SetPages(text, script, style, page, [&](TextPage&& one) {
    console.CheckStop();
    if (!one.glyphs.empty()) {
      console.Alive(static_cast<double>(one.glyphs.back().source_end) /
                    static_cast<double>(text.size()));
    }
    linker.Keep(one);
    AddCounts(one, script, style, book.counts);
    if (rows != nullptr) rows->Add(one);
    if (kept.size() < kMostKept) kept.push_back(std::move(one));
  });
  book.set.pages = std::move(kept);
  return book;
}

/// Gives all pages in order. Those that were not kept are set once more.
void VisitPages(const Book& book, const std::function<void(const TextPage&)>& visit) {
  if (book.set.pages.size() == book.counts.pages) {
    for (const TextPage& page : book.set.pages) visit(page);
  } else {
    SetPages(book.text, book.script, book.set.style, book.set.page,
             [&visit](TextPage&& page) { visit(page); });
  }
}

/// The names of a line's signs, words apart: "t h e, c a t".
std::string Signs(const TextPage& page, std::size_t first, std::size_t last, const Script& script) {
  std::string signs;
  for (std::size_t i = first; i < last; ++i) {
    if (i > first) signs += page.glyphs[i].word == page.glyphs[i - 1].word ? " " : ", ";
    signs += script.glyphs[page.glyphs[i].glyph].name;
  }
  return signs;
}

void SayLines(const Book& book, Console& console) {
  std::size_t said = 0;
  for (std::size_t p = 0; p < book.set.pages.size(); ++p) {
    const TextPage& page = book.set.pages[p];
    std::size_t first = 0;
    while (first < page.glyphs.size()) {
      const std::size_t line = page.glyphs[first].line;
      std::size_t last = first;
      while (last < page.glyphs.size() && page.glyphs[last].line == line) ++last;
      if (said++ == kMostLinesSaid) {
        console.Result(say::LinesLeftOut(book.counts.lines - kMostLinesSaid));
        return;
      }
      console.Result(
          say::PageLine(p, book.counts.pages, line, Signs(page, first, last, book.script)));
      first = last;
    }
  }
}

/// Empty for plain lines, which most are.
const char* KindJson(LineKind kind) {
  switch (kind) {
    case LineKind::kPlain:
      return "";
    case LineKind::kHeading:
      return ",\"kind\":\"heading\"";
    case LineKind::kQuotation:
      return ",\"kind\":\"quotation\"";
    case LineKind::kHead:
      return ",\"kind\":\"head\"";
  }
  return "";
}

/// A page's signs; `names` are the glyphs' names as JSON strings. Formatted here, not through a
/// tree of values: a book has millions.
std::string PageJson(const TextPage& page, const std::vector<std::string>& names) {
  std::string json = fmt::format("{{\"lines\":{},\"glyphs\":[", page.lines);
  for (const PlacedGlyph& glyph : page.glyphs) {
    json += fmt::format("{{\"name\":{},\"origin_mm\":[{},{}],\"line\":{},\"source\":[{},{}]{}{}}},",
                        names[glyph.glyph], 1e3 * glyph.origin_P.x, 1e3 * glyph.origin_P.y,
                        glyph.line, glyph.source_begin, glyph.source_end, KindJson(glyph.kind),
                        glyph.link ? ",\"link\":true" : "");
  }
  if (!page.glyphs.empty()) json.pop_back();
  return json + "]}";
}

Json ReadBackJson(const BackTranslation& back) {
  Json json = {{"text", back.text},
               {"wanted", back.wanted},
               {"words", back.words},
               {"differ_count", back.differ_count},
               {"left_out", back.left_out},
               {"replaced", back.replaced},
               {"alike_count", back.alike_count},
               {"differ", Json::array()}};
  for (const DifferentWord& word : back.differ) {
    json["differ"].push_back({{"was", word.first}, {"became", word.second}, {"alike", word.alike}});
  }
  return json;
}

void SayReadBack(const BackTranslation& back, Console& console) {
  console.Result(say::ReadBackOutcome(back));
  const std::size_t said = std::min(back.differ.size(), kMostWordsSaid);
  for (std::size_t i = 0; i < said; ++i) {
    console.Result(say::ReadOtherwise(back.differ[i].first, back.differ[i].second));
  }
  if (back.alike_count > 0) console.Result(say::WrittenAlike(back.alike_count));
  if (back.differ_count > said) console.Result(say::MoreWords(back.differ_count - said));
  std::size_t lines = 0;
  for (std::size_t at = 0; at < back.text.size() && lines < kMostLinesSaid; ++lines) {
    const std::size_t end = std::min(back.text.find('\n', at), back.text.size());
    if (end > at)
      console.Result(say::ReadBackLine(std::string_view(back.text).substr(at, end - at)));
    at = end + 1;
  }
}

/// One object, written page by page: a book's signs are never all held as JSON at once.
void WriteJson(const Book& book, const std::vector<std::string>& pictures,
               const std::optional<BackTranslation>& back, Console& console) {
  std::ostream& out = console.out();
  Json head = TypesetJson(book.set, book.script, book.counts);
  head["lines"] = book.counts.lines;
  head["signs"] = book.counts.signs;
  head["pictures"] = pictures;
  if (back) head["read_back"] = ReadBackJson(*back);
  std::string text = Dump(head);
  text.pop_back();
  out << text << ",\"pages\":[";
  std::vector<std::string> names;
  for (const Glyph& glyph : book.script.glyphs) names.push_back(Dump(glyph.name));
  const char* comma = "";
  VisitPages(book, [&](const TextPage& page) {
    console.CheckStop();
    out << comma << PageJson(page, names);
    comma = ",";
  });
  out << "]}\n";
}

/// A picture of each page; their paths.
std::vector<std::string> DrawPages(const Book& book, const PageOptions& options, Console& console) {
  PagePictures pictures(options.picture, book.counts.pages);
  PageNumber number{0, book.counts.pages};
  VisitPages(book, [&](const TextPage& page) {
    console.CheckStop();
    console.Alive(static_cast<double>(number.page) / static_cast<double>(number.pages));
    pictures.Add(PagePicture(page, number, book.set, book.script, book.text, options.letters));
    ++number.page;
  });
  return pictures.Finish();
}

}  // namespace

void AddOptions(CLI::App& app, PageOptions& options) {
  AddOptions(app, options.text);
  AddOptions(app, options.style);
  AddOptions(app, options.layout);
  BeginGroup(app, help_group::kResults);
  AddPicture(app, options.picture, say::help::kPicture);
  AddFlag(app, "--letters", options.letters, say::help::kLetters);
  AddFlag(app, "--read-back", options.read_back, say::help::kReadBack);
  AddOptions(app, options.output);
}

int Run(const PageOptions& options, Console& console) {
  if (options.letters && options.picture.empty()) {
    throw UsageError(say::NeedsOther("--letters", "--picture"));
  }
  if (!options.picture.empty()) CheckPicturePath(options.picture);
  const std::string text = ReadText(options.text, "page", console);
  Script script = ScriptOf(options.style, nullptr, text);
  for (const std::string& remark : script.remarks) console.Remark(remark);
  const TypeStyle style = StyleOf(options.style, options.layout, script, nullptr);
  RowSigns rows;
  const Book book = SetBook(text, script, style, PageOf(options.layout),
                            options.read_back ? &rows : nullptr, console);
  const Typeset& set = book.set;
  std::vector<std::string> pictures;
  if (!options.picture.empty()) pictures = DrawPages(book, options, console);
  std::optional<BackTranslation> back;
  if (options.read_back) back = TranslateBack(text, script, style, &rows);
  if (options.output.json) {
    WriteJson(book, pictures, back, console);
    return exit_code::kGood;
  }
  console.Result(say::PageOutcome(book.counts));
  SayReplacements(set, [&console](const std::string& line) { console.Result(line); });
  console.Result(say::LetterShape(set.style));
  if (set.style.links.reach != LinkReach::kNone) {
    console.Result(say::Links(book.counts.links, set.style.links));
  }
  if (set.style.form != LetterForm{}) console.Result(say::Form(set.style.form));
  if (set.style.structure.read) console.Result(say::Structure(set));
  console.Result(say::Paper(set.page));
  SaySheet(set.style, book.counts.rules,
           [&console](const std::string& line) { console.Result(line); });
  SayLines(book, console);
  if (back) SayReadBack(*back, console);
  console.Result(pictures.empty() ? say::PageNext() : say::PictureIn());
  for (const std::string& picture : pictures) console.Path(picture);
  return exit_code::kGood;
}

}  // namespace moontrace
