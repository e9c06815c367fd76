#include "textures/typeset/back_translate.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <unordered_map>
#include <utility>

#include "textures/base/utf8.h"
#include "textures/typeset/braille_reader.h"
#include "textures/typeset/fold.h"
#include "textures/typeset/make_writer.h"
#include "textures/typeset/older_punctuation.h"
#include "textures/typeset/typeset.h"
#include "textures/typeset/writer.h"

namespace moontrace {
namespace {

constexpr std::size_t kMostDiffering = 1000;
constexpr const char* kUnknown = "\uFFFD";

// Reads the signs of one line.
class Reader {
 public:
  virtual ~Reader() = default;
  virtual std::string Read(const std::vector<Sign>& signs) = 0;
};

// By the rules of a script, applied in reverse.
class SignReader : public Reader {
 public:
  SignReader(const Script& script, double grade);
  std::string Read(const std::vector<Sign>& signs) override;

 private:
  struct Group {
    std::vector<std::uint32_t> glyphs;
    std::string print;
    Contraction::Where where = Contraction::Where::kAnywhere;
  };
  const Group* Match(const std::vector<Sign>& signs, std::size_t at, bool letter_before) const;
  bool IsLetterSign(const std::vector<Sign>& signs, std::size_t at) const;

  std::unordered_map<std::uint32_t, char32_t> letters_, digits_;
  std::set<std::uint32_t> starts_;  // glyphs that begin a group
  std::vector<Group> groups_;       // in the order they are tried
  std::uint32_t numeral_ = ~std::uint32_t{0};
};

SignReader::SignReader(const Script& script, double grade) {
  const auto bind = [&script](auto& map, const std::string& name, char32_t c) {
    const std::size_t glyph = script.Find(name);
    if (glyph != Script::npos) map.emplace(static_cast<std::uint32_t>(glyph), c);
  };
  for (const auto& [c, name] : script.signs) {
    bind(letters_, name, c);
    const auto forms = script.forms.find(name);
    if (forms == script.forms.end()) continue;
    for (const auto& form : forms->second) bind(letters_, form.second, c);
  }
  for (const auto& [c, name] : script.digits) {
    bind(digits_, name, c);
    const auto forms = script.forms.find(name);
    if (forms == script.forms.end()) continue;
    for (const auto& form : forms->second) bind(digits_, form.second, c);
  }
  if (!script.digits.empty()) {
    numeral_ = static_cast<std::uint32_t>(script.Find(script.numeral_sign));
  }
  for (const Contraction& contraction : script.contractions) {
    if (contraction.grade > grade) continue;
    Group group{{}, contraction.print, contraction.where};
    for (const std::string& name : contraction.signs) {
      group.glyphs.push_back(static_cast<std::uint32_t>(script.Find(name)));
    }
    starts_.insert(group.glyphs.front());
    groups_.push_back(std::move(group));
  }
  const auto is_whole = [](const Group& group) {
    return group.where == Contraction::Where::kWholeWord;
  };
  std::stable_sort(groups_.begin(), groups_.end(), [&](const Group& a, const Group& b) {
    if (a.glyphs.size() != b.glyphs.size()) return a.glyphs.size() > b.glyphs.size();
    return is_whole(a) && !is_whole(b);
  });
}

bool SignReader::IsLetterSign(const std::vector<Sign>& signs, std::size_t at) const {
  if (at >= signs.size() || signs[at].space) return false;
  const auto letter = letters_.find(signs[at].glyph);
  return letter != letters_.end() ? IsLetter(letter->second) : starts_.count(signs[at].glyph) > 0;
}

const SignReader::Group* SignReader::Match(const std::vector<Sign>& signs, std::size_t at,
                                           bool letter_before) const {
  for (const Group& group : groups_) {
    const std::size_t end = at + group.glyphs.size();
    if (end > signs.size()) continue;
    bool same = true;
    for (std::size_t i = at; i < end && same; ++i) {
      const bool here = !signs[i].space && (i == at || !signs[i].begins_row);
      same = here && signs[i].glyph == group.glyphs[i - at];
    }
    if (!same) continue;
    const bool behind = IsLetterSign(signs, end);
    switch (group.where) {
      case Contraction::Where::kAnywhere:
        return &group;
      case Contraction::Where::kWholeWord:
        if (!letter_before && !behind) return &group;
        break;
      case Contraction::Where::kPartOfWord:
        if (letter_before || behind) return &group;
        break;
      case Contraction::Where::kWordEnd:
        if (letter_before && !behind) return &group;
        break;
    }
  }
  return nullptr;
}

std::string SignReader::Read(const std::vector<Sign>& signs) {
  std::string text;
  bool in_number = false, letter_before = false;
  for (std::size_t at = 0; at < signs.size();) {
    const std::uint32_t glyph = signs[at].glyph;
    const auto digit = digits_.find(glyph);
    if (signs[at].begins_row) in_number = false;
    if (signs[at].space || glyph == numeral_) {
      if (signs[at].space) text += ' ';
      in_number = !signs[at].space;
      letter_before = false;
      ++at;
      continue;
    }
    if (in_number && digit != digits_.end()) {
      text += ToUtf8(digit->second);
      ++at;
      continue;
    }
    in_number = false;
    if (const Group* group = Match(signs, at, letter_before)) {
      text += group->print;
      letter_before = IsLetter(ToCodePoints(group->print).back());
      at += group->glyphs.size();
      continue;
    }
    const auto letter = letters_.find(glyph);
    text += letter != letters_.end() ? ToUtf8(letter->second) : kUnknown;
    letter_before = letter != letters_.end() && IsLetter(letter->second);
    ++at;
  }
  return text;
}

// By liblouis.
class CellReader : public Reader {
 public:
  CellReader(const Script& script, const TypeStyle& style)
      : reader_(script, style), cells_(script.glyphs.size(), 0) {
    for (char32_t dots = 1; dots < 256; ++dots) {
      const auto sign = script.signs.find(0x2800 + dots);
      const std::size_t glyph =
          sign == script.signs.end() ? Script::npos : script.Find(sign->second);
      if (glyph != Script::npos) cells_[glyph] = static_cast<std::uint8_t>(dots);
    }
  }
  std::string Read(const std::vector<Sign>& signs) override {
    std::vector<std::uint8_t> cells;
    cells.reserve(signs.size());
    for (const Sign& sign : signs) cells.push_back(sign.space ? 0 : cells_[sign.glyph]);
    return reader_.Read(cells);
  }

 private:
  BrailleReader reader_;
  std::vector<std::uint8_t> cells_;  // of each glyph
};

/// A word of what is wanted, and the bytes of the text that it stands for: none of a word that a
/// character's replacement has behind its first ("and" of &, in its whole).
struct WantedWord {
  std::string folded;
  std::size_t begin = 0, end = 0;
};

// The characters that have signs, in order, parted at blanks.
std::vector<WantedWord> Wanted(const std::vector<FoldedChar>& line) {
  std::vector<WantedWord> words;
  bool in_word = false;
  for (const FoldedChar& c : line) {
    if (c.kind == FoldedChar::Kind::kSpace) in_word = false;
    if (c.kind != FoldedChar::Kind::kSign) continue;
    if (!std::exchange(in_word, true)) words.push_back({{}, c.begin, c.begin});
    words.back().folded += ToUtf8(c.code);
    words.back().end = c.end;
  }
  return words;
}

std::vector<std::string> Words(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    if (end > at) words.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

// Glyphs of a text; kNoGlyph for a space.
class Rewriter {
 public:
  Rewriter(const Writer& writer, const Script& script) : writer_(writer), script_(script) {}
  bool Alike(const std::string& one, const std::string& other) const {
    return GlyphsOf(one) == GlyphsOf(other);
  }

 private:
  std::vector<std::uint32_t> GlyphsOf(const std::string& text) const;

  const Writer& writer_;
  const Script& script_;
};

std::vector<std::uint32_t> Rewriter::GlyphsOf(const std::string& text) const {
  constexpr std::uint32_t kNoGlyph = ~std::uint32_t{0};
  std::vector<std::uint32_t> glyphs;
  if (text.empty()) return glyphs;
  Folder folder(text, script_, [this](char32_t c) { return writer_.Has(c); });
  Typeset notes;
  std::vector<FoldedChar> line;
  std::vector<Sign> signs;
  while (folder.NextLine(line)) writer_.Write(text, 1, line, signs, notes);
  for (const Sign& sign : signs) glyphs.push_back(sign.space ? kNoGlyph : sign.glyph);
  return glyphs;
}

std::string Joined(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) text += (i > 0 ? " " : "") + words[i];
  return text;
}

void Compare(const std::string& read, const std::vector<WantedWord>& want, std::string_view text,
             const Rewriter& rewriter, BackTranslation& result) {
  const std::vector<std::string> have = Words(read);
  std::vector<std::string> folded;
  folded.reserve(want.size());
  for (const WantedWord& word : want) folded.push_back(word.folded);
  const std::string have_text = Joined(have), want_text = Joined(folded);
  const bool all_alike = have_text != want_text && rewriter.Alike(have_text, want_text);
  result.words += want.size();
  for (std::size_t i = 0; i < std::max(have.size(), want.size()); ++i) {
    const std::string wanted = i < want.size() ? want[i].folded : std::string();
    DifferentWord word;
    if (i < have.size()) word.second = have[i];
    if (wanted == word.second) continue;
    word.alike = all_alike || rewriter.Alike(wanted, word.second);
    ++result.differ_count;
    if (word.alike) ++result.alike_count;
    if (result.differ.size() >= kMostDiffering) continue;
    const bool of_text = i < want.size() && want[i].begin < want[i].end;
    word.first =
        of_text ? std::string(text.substr(want[i].begin, want[i].end - want[i].begin)) : wanted;
    result.differ.push_back(std::move(word));
  }
  result.text += have_text + '\n';
  result.wanted += want_text + '\n';
}

}  // namespace

void RowSigns::Add(const TextPage& page) {
  std::size_t row = ~std::size_t{0};
  for (const PlacedGlyph& placed : page.glyphs) {
    if (placed.kind == LineKind::kHead || placed.bridge) continue;
    Sign sign;
    sign.begin = static_cast<std::uint32_t>(placed.source_begin);
    sign.end = static_cast<std::uint32_t>(placed.source_end);
    if (!signs_.empty() && placed.word != word_) {
      sign.space = true;
      sign.end = sign.begin;
      signs_.push_back(sign);
      sign.end = static_cast<std::uint32_t>(placed.source_end);
      sign.space = false;
    }
    sign.glyph = static_cast<std::uint32_t>(placed.glyph);
    sign.begins_row = placed.line != row;
    row = placed.line;
    word_ = placed.word;
    signs_.push_back(sign);
  }
}

std::vector<Sign> RowSigns::Before(std::size_t end) {
  std::vector<Sign> signs;
  for (; next_ < signs_.size() && (signs_[next_].begin < end || signs_[next_].end <= end);
       ++next_) {
    signs.push_back(signs_[next_]);
  }
  return signs;
}

BackTranslation TranslateBack(std::string_view text, const Script& script, const TypeStyle& style,
                              RowSigns* rows) {
  const std::unique_ptr<Writer> writer = MakeWriter(script, style);
  std::unique_ptr<Reader> reader;
  if (script.braille_tables.empty()) {
    reader = std::make_unique<SignReader>(script, style.grade);
  } else {
    reader = std::make_unique<CellReader>(script, style);
  }
  Folder folder(text, script, [&writer](char32_t c) { return writer->Has(c); });
  const Rewriter rewriter(*writer, script);
  BackTranslation result;
  Typeset notes;  // only counted here; SetText reports them one by one
  std::vector<FoldedChar> line;
  std::vector<Sign> signs;
  while (folder.NextLine(line)) {
    signs.clear();
    const std::size_t end = line.empty() ? 0 : line.back().end;
    if (style.structure.read) TakeMarks(text, line, folder.begins_line());
    if (style.older_punctuation) UseOlderPunctuation(text, script, line);
    writer->Write(text, folder.line_number(), line, signs, notes);
    if (rows != nullptr) signs = rows->Before(end);
    Compare(reader->Read(signs), Wanted(line), text, rewriter, result);
  }
  result.left_out = notes.missing_count + notes.untaught_count;
  result.replaced = notes.folded_count;
  return result;
}

}  // namespace moontrace
