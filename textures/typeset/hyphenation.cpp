#include "textures/typeset/hyphenation.h"

#include "textures/base/error.h"

#ifdef MOONTRACE_HAVE_HYPHEN

#include <fmt/format.h>
#include <hyphen.h>
#include <utf8proc.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "textures/base/nearest_word.h"
#include "textures/base/text_file.h"
#include "textures/base/utf8.h"

namespace moontrace {

namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = "/usr/share/hyphen";
constexpr std::size_t kLongestWord = 100;  // [characters]; no word of a language is longer

// The package of Debian 12 that holds the patterns of a language; empty where none does.
std::string PackageOf(std::string_view language) {
  constexpr std::string_view kPackages =
      " af as be bg bn ca cs da de el en-gb en-us es fr gl gu hi hr hu id is it kn lt lv ml mn mr "
      "nl "
      "no or pa pl pt-br pt-pt ro ru sk sl sr sv ta te th uk zu ";
  std::string name = LowerCase(language);
  std::replace(name.begin(), name.end(), '_', '-');
  const std::string first = name.substr(0, name.find('-'));
  const bool norwegian = first == "nb" || first == "nn";
  for (const std::string& one : {name, norwegian ? std::string("no") : first}) {
    const bool plain = one.find(' ') == std::string::npos;
    if (plain && kPackages.find(" " + one + " ") != std::string_view::npos) return "hyphen-" + one;
  }
  return {};
}

std::string FileOf(const std::string& language) {
  std::vector<std::string> names;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(kFolder, none)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind("hyph_", 0) != 0 || entry.path().extension() != ".dic") continue;
    names.push_back(name.substr(5, name.size() - 9));
    if (names.back() == language) return entry.path().string();
  }
  std::sort(names.begin(), names.end());
  const std::string package = PackageOf(language);
  const auto same = std::find_if(names.begin(), names.end(), [&language](const std::string& name) {
    return LowerCase(name) == LowerCase(language);
  });
  std::string nearest = same == names.end() ? std::string() : *same;
  if (nearest.empty() && package.empty()) nearest = NearestWord(language, names);
  std::string advice;
  if (!package.empty()) advice = "on Debian, \"apt install " + package + "\"; ";
  if (!nearest.empty()) advice = "did you mean " + nearest + "? ";
  throw InputError(fmt::format("no hyphenation patterns '{}': {}there are {}", Shown(language),
                               advice,
                               names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
}

}  // namespace

struct Hyphenation::Patterns {
  HyphenDict* dictionary = nullptr;
  bool latin1 = false;

  /// `word` in the patterns' encoding; empty where it has no form there.
  std::string Encoded(const std::u32string& word) const {
    std::string bytes;
    for (const char32_t c : word) {
      const auto lower = static_cast<char32_t>(utf8proc_tolower(static_cast<utf8proc_int32_t>(c)));
      if (!latin1) {
        bytes += ToUtf8(lower);
      } else if (lower < 256) {
        bytes += static_cast<char>(lower);
      } else {
        return {};
      }
    }
    return bytes;
  }

  /// The characters (from 1) in front of which the word may be broken.
  std::vector<std::size_t> BreaksIn(const std::u32string& word) const {
    std::vector<std::size_t> breaks;
    if (word.size() > kLongestWord) return breaks;
    const std::string bytes = Encoded(word);
    if (bytes.empty()) return breaks;
    std::vector<char> marks(bytes.size() + 5);
    char** changes = nullptr;
    int* places = nullptr;
    int* cuts = nullptr;
    if (hnj_hyphen_hyphenate2(dictionary, bytes.c_str(), static_cast<int>(bytes.size()),
                              marks.data(), nullptr, &changes, &places, &cuts) == 0) {
      for (std::size_t i = 0; i + 1 < word.size(); ++i) {
        const bool changes_letters = changes != nullptr && changes[i] != nullptr;
        if ((marks[i] & 1) != 0 && !changes_letters) breaks.push_back(i + 1);
      }
    }
    for (std::size_t i = 0; changes != nullptr && i < bytes.size(); ++i) std::free(changes[i]);
    std::free(changes);
    std::free(places);
    std::free(cuts);
    return breaks;
  }
};

Hyphenation::Hyphenation(const std::string& language) : patterns_(std::make_unique<Patterns>()) {
  const std::string file = FileOf(language);
  patterns_->dictionary = hnj_hyphen_load(file.c_str());
  if (patterns_->dictionary == nullptr) throw InputError(file + ": holds no hyphenation patterns");
  const std::string encoding = patterns_->dictionary->cset;
  patterns_->latin1 = encoding == "ISO8859-1";
  if (patterns_->dictionary->utf8 == 0 && !patterns_->latin1) {
    hnj_hyphen_free(patterns_->dictionary);
    throw InputError(file + ": its patterns are in " + Shown(encoding) + ", not in UTF-8");
  }
}

Hyphenation::~Hyphenation() { hnj_hyphen_free(patterns_->dictionary); }

void Hyphenation::Mark(std::string_view text, std::vector<Sign>& signs) const {
  const auto written = [](const Sign& sign) { return !sign.space && sign.begin < sign.end; };
  const auto first = std::find_if(signs.begin(), signs.end(), written);
  if (first == signs.end()) return;
  const std::size_t line_end = std::find_if(signs.rbegin(), signs.rend(), written)->end;
  std::vector<std::uint32_t> breaks;  // bytes of the text, ascending
  std::u32string word;
  std::vector<std::size_t> at_byte;
  const auto end_word = [&] {
    for (const std::size_t i : patterns_->BreaksIn(word)) {
      breaks.push_back(static_cast<std::uint32_t>(at_byte[i]));
    }
    word.clear();
    at_byte.clear();
  };
  for (std::size_t at = first->begin; at < line_end;) {
    char32_t c = 0;
    const std::size_t length = Decode(text.substr(at), c);
    if (length == 0) break;
    if (IsLetter(c)) {
      word += c;
      at_byte.push_back(at);
    } else {
      end_word();
    }
    at += length;
  }
  end_word();
  for (std::size_t i = 0; i + 1 < signs.size(); ++i) {
    const Sign& next = signs[i + 1];
    signs[i].hyphen_after = written(signs[i]) && written(next) && signs[i].end <= next.begin &&
                            std::binary_search(breaks.begin(), breaks.end(), next.begin);
  }
}

}  // namespace moontrace

#else

namespace moontrace {

struct Hyphenation::Patterns {};
Hyphenation::Hyphenation(const std::string&) {
  throw LackError("this build cannot hyphenate: install libhyphen-dev and build again");
}
Hyphenation::~Hyphenation() = default;
void Hyphenation::Mark(std::string_view, std::vector<Sign>&) const {}

}  // namespace moontrace

#endif
