// A hundred documents and more of many kinds: what their readers would see is in the document, and
// what the document's text holds is a glyph's, or told to be missing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "lessons/documents/html_tree.h"
#include "lessons/documents/open_document.h"
#include "lessons/documents/transcribe.h"
#include "lessons/documents/zip_archive.h"
#include "tests/lessons/documents/stored_book.h"
#include "textures/base/text_file.h"
#include "textures/base/utf8.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

using Counts = std::map<char32_t, std::size_t>;

/// Spaces, and what has no mark in print: controls, soft hyphens, joiners, byte order marks.
bool IsUnseen(char32_t c) {
  return c <= U' ' || (c >= 0x7F && c <= 0xA0) || c == 0xAD || (c >= 0x2000 && c <= 0x200F) ||
         (c >= 0x2028 && c <= 0x202F) || (c >= 0x205F && c <= 0x206F) || c == 0x3000 ||
         c == 0xFEFF || (c >= 0xFE00 && c <= 0xFE0F) || c == 0x1680;
}

Counts SeenIn(std::string_view text) {
  Counts counts;
  for (const char32_t c : ToCodePoints(text)) {
    if (!IsUnseen(c)) ++counts[c];
  }
  return counts;
}

/// Characters of `wanted` that `had` lacks.
std::string Lacking(const Counts& wanted, const Counts& had) {
  std::string lacking;
  for (const auto& [c, count] : wanted) {
    const auto found = had.find(c);
    const std::size_t there = found == had.end() ? 0 : found->second;
    if (there < count) lacking += ToUtf8(c) + "x" + std::to_string(count - there) + " ";
  }
  return lacking;
}

/// A file, and what a reader of it would see.
struct Sample {
  std::string name, bytes, seen;
};

const std::vector<std::vector<std::string>>& Passages() {
  static const std::vector<std::vector<std::string>> passages = {
      {"The tide tables", "High water comes at 4:15, low water at 10:32 (\"neaps\" & springs).",
       "Mind the rocks; the light's range is 12 miles - and no more!"},
      {"Der Leuchtturm", "Über den Dünen steht ein Turm; größer ist keiner.",
       "Er wird um 18 Uhr entzündet: »Gute Nacht«, sagt der Wärter."},
      {"Le phare", "L'été, la mer est calme – où êtes-vous, cher gardien ?",
       "« Ça va », répond-il. Il a 37 ans & trois bœufs."},
      {"Latarnia morska", "Zażółć gęślą jaźń, mówi latarnik.", "Światło widać z 20 mil."},
      {"Маяк", "Свет маяка виден далеко в море.", "Смотритель живёт там 12 лет."},
      {"Ο φάρος", "Το φως φαίνεται από μακριά.", "Ο φύλακας μένει εκεί."},
      {"Sums", "2 + 2 = 4; 3 × 4 ≠ 13 ± 1; ½ of 10 € is 5 €.", "x² and H₂O, 50 % at 20 °C → ∞"},
      {"# Not a heading", "> nor a [quotation](of anything) * or _this_ \\ `that`",
       "<tags> are &amp; words here | ~ ^ { }"}};
  return passages;
}

std::string Seen(const std::vector<std::string>& passage) {
  return passage[0] + passage[1] + passage[2];
}

std::string Utf16(const std::string& text, bool little) {
  std::string bytes;
  const auto put = [&](char32_t c) {
    const char low = static_cast<char>(c & 0xFFU), high = static_cast<char>((c >> 8U) & 0xFFU);
    bytes += little ? low : high;
    bytes += little ? high : low;
  };
  put(0xFEFF);
  for (const char32_t c : ToCodePoints(text)) put(c);  // none beyond U+FFFF
  return bytes;
}

/// Western characters of one byte; false where one is not among them.
bool Latin1(const std::string& text, std::string& bytes) {
  for (const char32_t c : ToCodePoints(text)) {
    if (c > 0xFF) return false;
    bytes += static_cast<char>(c);
  }
  return true;
}

std::string Escaped(const std::string& text, bool by_number) {
  std::string escaped;
  for (const char32_t c : ToCodePoints(text)) {
    if (c == U'<' || c == U'>' || c == U'&' || (by_number && c > 0x7E)) {
      escaped += "&#" + std::to_string(static_cast<unsigned>(c)) + ";";
    } else {
      escaped += ToUtf8(c);
    }
  }
  return escaped;
}

/// The three texts of a passage in the markup of a kind.
std::string Markup(const std::vector<std::string>& passage, std::size_t kind) {
  const auto text = [&](std::size_t i) { return Escaped(passage[i], kind % 2 == 1); };
  switch (kind) {
    case 0:
      return "<h1>" + text(0) + "</h1><p>" + text(1) + "</p><p>" + text(2) + "</p>";
    case 1:
      return "<h2>" + text(0) + "</h2><ul><li>" + text(1) + "</li><li><ol><li>" + text(2) +
             "</li></ol></li></ul>";
    case 2:
      return "<table><caption>" + text(0) + "</caption><tr><th>" + text(1) + "</th><td>" + text(2) +
             "</td></tr></table>";
    case 3:
      return "<p>" + text(0) + "</p><blockquote><p>" + text(1) + "</p></blockquote><pre>" +
             text(2) + "</pre>";
    case 4:
      return "<dl><dt>" + text(0) + "</dt><dd>" + text(1) + "</dd></dl><p><a href='#x'>" + text(2) +
             "</a></p>";
    default:
      return "<figure><svg><title>" + text(0) + "</title><text>" + text(1) +
             "</text></svg><figcaption><em>" + text(2) + "</em></figcaption></figure>";
  }
}

std::vector<Sample> MadeByHand() {
  std::vector<Sample> samples;
  for (const std::vector<std::string>& passage : Passages()) {
    const std::string seen = Seen(passage);
    const std::string plain = passage[0] + "\n\n" + passage[1] + "\n\n" + passage[2] + "\n";
    samples.push_back({passage[0] + ".txt", plain, seen});
    samples.push_back({passage[0] + ".le.txt", Utf16(plain, true), seen});
    samples.push_back({passage[0] + ".be.txt", Utf16(plain, false), seen});
    std::string western;
    if (Latin1(plain, western)) samples.push_back({passage[0] + ".1.txt", western, seen});
    for (std::size_t kind = 0; kind < 6; ++kind) {
      const std::string number = std::to_string(kind);
      if (CanReadHtml()) {
        samples.push_back({passage[0] + number + ".html",
                           "<!DOCTYPE html><html><meta charset='utf-8'><body>" +
                               Markup(passage, kind) + "</body></html>",
                           seen});
      }
      if (!CanReadZip()) continue;
      samples.push_back({passage[0] + number + ".epub",
                         StoredZip(Book({Chapter(Markup(passage, kind)), Chapter("<p>.</p>")})),
                         seen + "."});
    }
  }
  return samples;
}

std::string Without(std::string text, const std::string& begin, const std::string& end) {
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
    const std::size_t close = text.find(end, at + begin.size());
    text.erase(at, close == std::string::npos ? close : close + end.size() - at);
  }
  return text;
}

/// A plain page of HTML without its tags; empty where there is more to it.
std::string Stripped(std::string html) {
  std::string lower = LowerCase(html);
  for (const char* more : {"<sup", "<sub", "<rt", "hidden", "display:", "<textarea", "<template",
                           "<math", "<select", "<noscript", "<iframe", "<![cdata"}) {
    if (lower.find(more) != std::string::npos) return {};
  }
  if (lower.size() != html.size()) return {};
  const std::size_t body = lower.find("<body");
  if (body == std::string::npos || lower.find("<script", body) != std::string::npos ||
      lower.find("<style", body) != std::string::npos) {
    return {};
  }
  html = Without(Without(html.substr(body), "<!--", "-->"), "<", ">");
  std::string text;
  for (std::size_t at = 0; at < html.size(); ++at) {
    const std::size_t end = html[at] == '&' ? html.find(';', at) : std::string::npos;
    if (html[at] != '&') {
      text += html[at];
      continue;
    }
    if (end == std::string::npos || end - at > 10) return {};
    const std::string name = html.substr(at + 1, end - at - 1);
    if (name[0] == '#') {
      const bool hexadecimal = name[1] == 'x' || name[1] == 'X';
      text += ToUtf8(static_cast<char32_t>(
          std::stoul(name.substr(hexadecimal ? 2 : 1), nullptr, hexadecimal ? 16 : 10)));
    } else {
      text += NamedCharacters(name).value_or("&" + name + ";");
    }
    at = end;
  }
  return text;
}

/// What Debian's packages have to say, as much as there is.
std::vector<Sample> OfThisMachine() {
  constexpr std::size_t kMostOfAKind = 40;
  std::vector<std::filesystem::path> paths;
  std::error_code ignored;
  for (std::filesystem::recursive_directory_iterator at("/usr/share/doc", ignored), end; at != end;
       at.increment(ignored)) {
    if (at->is_regular_file(ignored) && at->file_size(ignored) < 60'000)
      paths.push_back(at->path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<Sample> samples;
  std::map<std::string, std::size_t> kinds;
  for (const std::filesystem::path& path : paths) {
    const bool page = path.extension() == ".html";
    const std::string name = path.filename();
    const bool text = path.extension() == ".txt" || name == "copyright" || name == "README" ||
                      path.extension() == ".md";
    if (!page && !text) continue;
    std::ifstream file(path);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    const bool odd = std::any_of(bytes.begin(), bytes.end(), [](char c) {
      return c == '\f' || c == '\b' || c == '\0' || c == '\x1b';
    });
    if (bytes.empty() || odd || FirstBadUtf8(bytes) ||
        bytes.starts_with("<!DOCTYPE html") != page) {
      continue;
    }
    const std::string seen = page ? Stripped(bytes) : bytes;
    if (seen.empty() || ++kinds[page ? "page" : name] > kMostOfAKind) continue;
    samples.push_back({path, bytes, seen});
  }
  return samples;
}

std::string AllOf(const Document& document) {
  std::string all = document.title;
  for (const Block& block : document.blocks) all += block.text + block.label + block.column_name;
  for (const LeftOutCount& one : document.left_out) all += one.example;
  return all;
}

/// Which bytes of a transcription are marks of structure, not text.
std::vector<bool> MarksIn(const Transcription& text) {
  std::vector<bool> marks(text.text.size());
  for (const TranscribedLink& link : text.links) {
    marks[link.begin - 1] = true;
    const std::size_t end = text.text.find(')', link.end);
    for (std::size_t i = link.end; i <= end; ++i) marks[i] = true;
  }
  for (std::size_t line = 0; line < text.text.size();) {
    std::size_t at = line;
    while (text.text[at] == '#' || text.text[at] == '>') ++at;
    if (text.text[at] == ' ' || text.text[at] == '\n') {
      for (std::size_t i = line; i < at; ++i) marks[i] = true;
    }
    line = text.text.find('\n', line);
    line = line == std::string::npos ? text.text.size() : line + 1;
  }
  for (std::size_t i = 0; i + 1 < text.text.size(); ++i) {
    const bool escape = std::string("[#>\\").find(text.text[i + 1]) != std::string::npos;
    if (text.text[i] == '\\' && escape) marks[i] = true;
  }
  return marks;
}

/// Characters of a text that no glyph stands for, in Moon.
Counts Unset(const Transcription& text, const Typeset& set) {
  std::vector<bool> there = MarksIn(text);
  for (const TextPage& page : set.pages) {
    for (const PlacedGlyph& glyph : page.glyphs) {
      for (std::size_t i = glyph.source_begin; i < glyph.source_end; ++i) there[i] = true;
    }
  }
  Counts unset;
  for (std::size_t at = 0; at < text.text.size();) {
    char32_t c = 0;
    const std::size_t length =
        std::max<std::size_t>(1, Decode(std::string_view(text.text).substr(at), c));
    if (!there[at] && !IsUnseen(c)) ++unset[c];
    at += length;
  }
  return unset;
}

TEST(SlowHundredDocuments, LoseNoCharacterWithoutAMessage) {
  std::vector<Sample> samples = MadeByHand();
  const std::size_t by_hand = samples.size();
  for (Sample& sample : OfThisMachine()) samples.push_back(std::move(sample));
  const Script script = FindScript("moon");
  TypeStyle style = DefaultStyle(0.012, Relief::kEngraved, script);
  style.structure.read = true;
  std::size_t characters = 0, missing = 0;
  for (const Sample& sample : samples) {
    const Document document = ReadDocument(sample.bytes, sample.name, {});
    EXPECT_EQ(Lacking(SeenIn(sample.seen), SeenIn(AllOf(document))), "") << sample.name;
    const Transcription text = Transcribe(document);
    const Typeset set = SetText(text.text, script, style, FindPage("a4"));
    Counts told;
    for (const auto* list : {&set.missing, &set.folded}) {
      for (const Replacement& one : *list) {
        for (const char32_t c : ToCodePoints(one.was)) ++told[c];
      }
    }
    // else the lists hold the first thousand only
    if (set.missing_count + set.folded_count <= set.missing.size() + set.folded.size()) {
      EXPECT_EQ(Lacking(Unset(text, set), told), "") << sample.name;
    }
    missing += set.missing_count;
    characters += text.text.size();
  }
  if (CanReadHtml() && CanReadZip()) {
    EXPECT_GE(by_hand, 100U);
  }
  std::printf("%zu documents, %zu bytes of text, %zu characters told to be missing\n",
              samples.size(), characters, missing);
}

}  // namespace
}  // namespace moontrace
