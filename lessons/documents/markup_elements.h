#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace moontrace {

/// An attribute of an element: name and value, references in it decoded.
struct MarkupAttribute {
  std::string_view name;
  std::string_view value;
};

/// The attributes of an element, as long as the call lasts that they are given to.
class MarkupAttributes {
 public:
  void Add(std::string_view name, std::string_view value) { list_.push_back({name, value}); }
  void clear() { list_.clear(); }
  bool Has(std::string_view name) const { return Find(name) != nullptr; }
  /// Empty where there is none.
  std::string_view operator[](std::string_view name) const {
    const MarkupAttribute* found = Find(name);
    return found == nullptr ? std::string_view() : found->value;
  }

 private:
  const MarkupAttribute* Find(std::string_view name) const {
    for (const MarkupAttribute& attribute : list_) {
      if (attribute.name == name) return &attribute;
    }
    return nullptr;
  }
  std::vector<MarkupAttribute> list_;
};

/// Takes the elements of a document in order. Names are in lower case, without a namespace's
/// prefix; attributes have theirs, of which "epub:type", "xml:lang" and "xlink:href" are always
/// spelt so. Each Open has its Close.
class MarkupSink {
 public:
  virtual ~MarkupSink() = default;
  virtual void Open(std::string_view name, const MarkupAttributes& attributes) = 0;
  virtual void Text(std::string_view utf8) = 0;
  virtual void Close() = 0;
  /// "&name;" of a name that nobody knows; it comes as text too.
  virtual void UnknownEntity(std::string_view name) = 0;
  /// What is wrong with names in an XML file, in words: the first such fault of it.
  virtual void Fault(std::string_view what) = 0;
};

/// What an element is to a reader by touch.
enum class ElementRole : std::uint8_t {
  kInline,  ///< also every element that is not known
  kBlock,
  kSilent,  ///< nothing in it is text: scripts, styles, templates
  kHead,
  kTitle,
  kMeta,
  kHeading,
  kParagraph,
  kBreak,
  kRule,
  kPreformatted,
  kQuotation,
  kQuote,
  kList,
  kOrderedList,
  kItem,
  kTerm,
  kDefinition,
  kTable,
  kCaption,
  kTableHead,
  kRow,
  kCell,
  kHeaderCell,
  kLink,
  kImage,
  kDrawing,
  kMath,
  kMedia,
  kReading,  ///< of ruby
  kRaised,   ///< superscript
  kLowered,
  kInput,
  kSwitch  ///< of its children one is read
};

/// By name, and by `role` where that says more.
ElementRole RoleOf(std::string_view name, const MarkupAttributes& attributes);

/// Whether a child of a switch can be read: a case of `epub:switch` in elements of XHTML or MathML,
/// its default, what a drawing has for readers of `language`, or for all.
bool FitsInSwitch(std::string_view name, const MarkupAttributes& attributes,
                  std::string_view language);

/// Whether its author made it invisible to everybody, or to readers who do not see.
bool IsHiddenElement(std::string_view name, const MarkupAttributes& attributes);

/// What a printed page is called, of what an author says of it: "12" of "[Pg 12]", "Page 12" and
/// "12."; empty: that is no name of a page.
std::string PageName(std::string_view said);

/// Of nothing but blanks, or empty.
bool IsOnlyBlanks(std::string_view text);

/// A word among others, apart by blanks, without regard to capitals.
bool HasWord(std::string_view words, std::string_view word);

/// A whole number at the beginning, at most nine digits; else `otherwise`.
int WholeNumber(std::string_view text, int otherwise);

}  // namespace moontrace
