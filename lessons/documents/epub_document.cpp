#include "lessons/documents/epub_document.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "lessons/documents/block_writer.h"
#include "lessons/documents/encoding.h"
#include "lessons/documents/epub_package.h"
#include "lessons/documents/html_source.h"
#include "lessons/documents/html_tree.h"
#include "lessons/documents/markup_elements.h"
#include "lessons/documents/markup_reader.h"
#include "lessons/documents/xml_markup.h"
#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);
constexpr std::size_t kMostEmbedded = 1000;  // pages within pages; more are left out

bool IsChapterType(const std::string& type) {
  return type == "application/xhtml+xml" || type == "text/html" || type == "image/svg+xml" ||
         type == "text/x-oeb1-document" || type == "application/x-dtbook+xml";
}

/// Whether an entry of another type is a chapter nevertheless.
bool LooksLikeChapter(std::string_view bytes) {
  const std::string head = LowerCase(DecodeText(bytes.substr(0, 2048)).text);
  return head.find("<html") != std::string::npos ||
         head.find("<!doctype html") != std::string::npos;
}

std::string Text(const std::string& bytes) {
  return DecodeText(bytes, DeclaredEncoding(bytes)).text;
}

/// Why a book holds no text, by the first of its parts that was left out, and what helps.
std::string WhyEmpty(const Document& document) {
  for (const LeftOutCount& one : document.left_out) {
    const std::string part = OneLine(one.example);
    switch (one.what) {
      case LeftOut::kUnreadablePart:
        return " (" + part +
               " in it is no text, and no text stands in for it); get another edition";
      case LeftOut::kMissingPart:
        return " (" + part + " in it is missing); get it again";
      case LeftOut::kOutsidePart:
        return " (" + part + ", a chapter of it, is elsewhere); get another edition";
      case LeftOut::kMedia:
        return " (it is sound, video or embedded pages); get another edition";
      case LeftOut::kHiddenPart:
        return " (its text is hidden); get another edition";
      default:
        break;
    }
  }
  return "; get it again";
}

class EpubReader {
 public:
  EpubReader(ZipArchive& zip, const std::string& name)
      : zip_(zip), name_(name), writer_(document_, name), reader_(writer_) {
    reader_.ReadEmbeddedBy([this](const std::string& path) { return ReadEmbedded(path); });
  }

  Document Run() {
    document_.format = DocumentFormat::kEpub;
    ReadMeta();
    RefuseEncrypted();
    for (const bool linear : {true, false}) {
      for (const EpubSpineItem& item : package_.spine) {
        if (item.linear == linear) ReadItem(item);
      }
    }
    for (const std::string& id : package_.missing) {
      NoteLeftOut(document_, LeftOut::kMissingPart, id);
    }
    if (document_.blocks.empty()) {
      throw InputError(name_ + ": holds no text that can be read" + WhyEmpty(document_));
    }
    if (document_.language.empty()) document_.language = reader_.language();
    reader_.LeadLinks();
    ReadContents();
    return std::move(document_);
  }

 private:
  void ReadMeta() {
    const std::optional<std::string> path = PackagePath();
    const std::optional<std::string> package = zip_.Read(*path);
    if (!package) {
      throw InputError(name_ + ": is a damaged book (" + OneLine(*path) +
                       ", its package, is missing); get it again");
    }
    package_ = ReadPackage(Text(*package), *path, name_);
    if (!package_.titles.empty()) document_.title = package_.titles.front();
    document_.authors = package_.authors;
    document_.language = package_.language;
  }

  /// Where the package lies. In eBraille 1.0 it is "package.opf" at the root, and the container is
  /// not needed.
  std::optional<std::string> PackagePath() {
    const std::optional<std::string> container = zip_.Read("META-INF/container.xml");
    if (!container) {
      constexpr const char* kOfBraille = "package.opf";
      document_.format = DocumentFormat::kEBraille;
      if (zip_.Read(kOfBraille)) return kOfBraille;
      throw InputError(name_ +
                       ": is a zip archive, but no EPUB book (META-INF/container.xml is missing); "
                       "save it as EPUB, HTML or text");
    }
    std::optional<std::string> path = ReadContainer(Text(*container));
    if (!path) {
      throw InputError(
          name_ +
          ": is a damaged book (META-INF/container.xml in it names no package); get it "
          "again");
    }
    return path;
  }

  void RefuseEncrypted() {
    if (const std::optional<std::string> xml = zip_.Read("META-INF/encryption.xml")) {
      encrypted_ = ReadEncryption(Text(*xml));
    }
    for (const EpubSpineItem& each : package_.spine) {
      const EpubItem& item = package_.items[each.item];
      if (!item.path || !IsEncrypted(*item.path)) continue;
      throw InputError(name_ +
                       ": is encrypted (copy protection), so only programs of its seller open it; "
                       "ask for a copy without");
    }
    if (!encrypted_.empty()) {
      NoteLeftOut(document_, LeftOut::kEncryptedPart, encrypted_.front(), encrypted_.size());
    }
  }

  bool IsEncrypted(const std::string& path) const {
    return std::binary_search(encrypted_.begin(), encrypted_.end(), path);
  }

  std::size_t ById(const std::string& id) const {
    for (std::size_t i = 0; !id.empty() && i < package_.items.size(); ++i) {
      if (package_.items[i].id == id) return i;
    }
    return kNone;
  }

  /// The item, or what stands in for it; kNone where nothing readable does.
  std::size_t Readable(std::size_t item) const {
    for (int step = 0; step < 20 && item != kNone; ++step) {
      if (IsChapterType(package_.items[item].media_type)) return item;
      item = ById(package_.items[item].fallback);
    }
    return kNone;
  }

  /// What is read for an item: another one where scripts make its text and its maker gave one.
  std::size_t StandIn(std::size_t item) {
    if (!HasWord(package_.items[item].properties, "scripted")) return Readable(item);
    const std::size_t other = Readable(ById(package_.items[item].fallback));
    if (other == kNone) return Readable(item);
    NoteLeftOut(document_, LeftOut::kStandIn, package_.items[item].address);
    return other;
  }

  void ReadItem(const EpubSpineItem& spine) {
    std::size_t index = StandIn(spine.item);
    const bool typed = index != kNone;
    if (!typed) index = spine.item;
    const EpubItem& item = package_.items[index];
    if (!item.path) {
      NoteLeftOut(document_, LeftOut::kOutsidePart, item.address);
      return;
    }
    const std::optional<std::string> bytes = zip_.Read(*item.path);
    if (!bytes) {
      NoteLeftOut(document_, LeftOut::kMissingPart, *item.path);
      return;
    }
    if (!typed && !LooksLikeChapter(*bytes)) {
      NoteLeftOut(document_, LeftOut::kUnreadablePart, *item.path);
      return;
    }
    if (!spine.linear) NoteLeftOut(document_, LeftOut::kLaterPart, *item.path);
    if (const auto& named = package_.items[spine.item].path; named && *named != *item.path) {
      reader_.AlsoAt(*named);
    }
    ReadChapter(*item.path, *bytes);
  }

  void ReadChapter(const std::string& path, const std::string& bytes) {
    reader_.BeginPart(path);
    ReadMarkup(path, bytes);
    reader_.EndPart();
  }

  /// Whether it is a page of the book, which has then been read.
  bool ReadEmbedded(const std::string& path) {
    if (++embedded_ > kMostEmbedded) return false;
    std::size_t item = 0;
    while (item < package_.items.size() && package_.items[item].path != path) ++item;
    if (item == package_.items.size()) return false;
    item = StandIn(item);
    if (item == kNone || !package_.items[item].path) return false;
    const std::string& read = *package_.items[item].path;
    const std::optional<std::string> bytes = zip_.Read(read);
    if (!bytes) return false;
    reader_.BeginEmbedded(read);
    ReadMarkup(read, *bytes);
    reader_.EndEmbedded();
    return true;
  }

  void ReadMarkup(const std::string& path, const std::string& bytes) {
    const DecodedText decoded = DecodeText(bytes, DeclaredEncoding(bytes));
    NoteLeftOut(document_, LeftOut::kBadByte, path, decoded.bad);
    const std::string name = name_ + ": " + OneLine(path);
    if (ReadXmlMarkup(decoded.text, name, reader_)) return;
    if (!CanReadHtml()) return NoteLeftOut(document_, LeftOut::kUnreadablePart, path);
    NoteLeftOut(document_, LeftOut::kBrokenPart, path);
    const TamedHtml tamed = TameHtml(decoded.text, name, true);
    NoteLeftOut(document_, LeftOut::kDeepElement, path, tamed.flattened);
    ReadHtmlMarkup(tamed.html, reader_);
  }

  std::optional<EpubNavigation> NavigationOf(std::optional<std::size_t> index, bool ncx) {
    if (!index) return std::nullopt;
    const EpubItem& item = package_.items[*index];
    const std::optional<std::string> bytes = item.path ? zip_.Read(*item.path) : std::nullopt;
    if (!bytes) {
      NoteLeftOut(document_, LeftOut::kMissingPart, item.address);
      return std::nullopt;
    }
    std::optional<EpubNavigation> read =
        ncx ? ReadNcx(Text(*bytes), *item.path) : ReadNavigation(Text(*bytes), *item.path);
    if (!read) NoteLeftOut(document_, LeftOut::kBrokenContents, *item.path);
    return read;
  }

  void ReadContents() {
    std::optional<EpubNavigation> navigation = NavigationOf(package_.navigation, false);
    if (!navigation || navigation->contents.empty()) {
      std::optional<EpubNavigation> older = NavigationOf(package_.ncx, true);
      if (older && navigation && older->pages.empty()) older->pages = navigation->pages;
      if (older) navigation = std::move(older);
    }
    if (!navigation) return;
    for (const EpubTarget& target : navigation->contents) {
      if (target.title.empty()) continue;
      document_.contents.push_back(
          {target.title, target.level, PlaceOf(target).block, target.group});
    }
    LeadGroups();
    MarkPages(navigation->pages);
  }

  /// A group leads where the first line below it does.
  void LeadGroups() {
    std::vector<ContentsEntry>& lines = document_.contents;
    for (std::size_t i = lines.size(); i > 0; --i) {
      ContentsEntry& line = lines[i - 1];
      if (!line.group || i == lines.size() || lines[i].level <= line.level) continue;
      line.block = lines[i].block;
    }
  }

  DocumentPlace PlaceOf(const EpubTarget& target) const {
    const DocumentPlace* place = reader_.Find(target.path, target.id);
    if (place == nullptr) place = reader_.Find(target.path, "");
    if (place == nullptr || place->block >= document_.blocks.size()) return {};
    return *place;
  }

  /// Pages that the chapters themselves do not mark.
  void MarkPages(const std::vector<EpubTarget>& pages) {
    std::set<std::string> known;
    for (const Block& block : document_.blocks) {
      for (const DocumentMark& mark : block.marks) {
        if (mark.kind == MarkKind::kPrintPage) known.insert(mark.value);
      }
    }
    for (const EpubTarget& page : pages) {
      const DocumentPlace place = PlaceOf(page);
      const std::string name = PageName(page.title).empty() ? page.title : PageName(page.title);
      if (place.block == kNoBlock || name.empty() || !known.insert(name).second) continue;
      Block& block = document_.blocks[place.block];
      const std::size_t at = std::min(place.offset, block.text.size());
      const auto behind = std::upper_bound(
          block.marks.begin(), block.marks.end(), at,
          [](std::size_t offset, const DocumentMark& mark) { return offset < mark.begin; });
      block.marks.insert(behind, {MarkKind::kPrintPage, at, at, name});
    }
  }

  ZipArchive& zip_;
  const std::string& name_;
  Document document_;
  EpubPackage package_;
  std::vector<std::string> encrypted_;
  std::size_t embedded_ = 0;  // pages within pages so far
  BlockWriter writer_;
  MarkupReader reader_;
};

}  // namespace

Document ReadEpub(ZipArchive& zip, const std::string& name) { return EpubReader(zip, name).Run(); }

}  // namespace moontrace
