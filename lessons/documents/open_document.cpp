#include "lessons/documents/open_document.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "lessons/documents/brf_document.h"
#include "lessons/documents/encoding.h"
#include "lessons/documents/epub_document.h"
#include "lessons/documents/html_document.h"
#include "lessons/documents/html_source.h"
#include "lessons/documents/text_document.h"
#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

bool BeginsWith(std::string_view bytes, std::string_view begin) {
  return bytes.substr(0, begin.size()) == begin;
}

bool IsZip(std::string_view bytes) {
  return BeginsWith(bytes, "PK\x03\x04") || BeginsWith(bytes, std::string_view("PK\x05\x06", 4));
}

bool IsHtml(std::string_view text, const std::string& path) {
  const std::string head = LowerCase(text.substr(0, 4096));
  const std::size_t begin = head.find_first_not_of(" \t\r\n");
  if (begin != std::string::npos && head[begin] == '<') {
    for (const char* word : {"<!doctype html", "<html", "<head", "<body", "<title"}) {
      if (head.find(word) != std::string::npos) return true;
    }
  }
  const std::string ending = LowerCase(std::filesystem::path(path).extension().string());
  return ending == ".html" || ending == ".htm" || ending == ".xhtml" || ending == ".xht";
}

/// Cells look like any text: the name tells.
bool IsBrfName(const std::string& path) {
  const std::string ending = LowerCase(std::filesystem::path(path).extension().string());
  return ending == ".brf" || ending == ".brl";
}

/// Packed files, by how they begin.
void RefusePacked(std::string_view bytes, const std::string& name) {
  const char* unpack = BeginsWith(bytes, "\x1F\x8B") ? "gunzip"
                       : BeginsWith(bytes, "BZh")    ? "bunzip2"
                       : BeginsWith(bytes,
                                    "\xFD"
                                    "7zXZ")
                           ? "unxz"
                           : nullptr;
  if (unpack == nullptr) return;
  throw InputError(name + ": is packed; unpack it first by " + unpack +
                   ", and read what that gives");
}

/// A page and its files as one message (RFC 2557): as browsers save it.
bool IsWebArchive(std::string_view bytes) {
  const std::string head = LowerCase(bytes.substr(0, 4096));
  const std::size_t part = head.find("content-type: multipart/related");
  const std::size_t version = head.rfind("mime-version:", part);
  return part != std::string::npos && version != std::string::npos && head.find("\n\n") > part &&
         head.find("\r\n\r\n") > part;
}

bool IsFictionBook(std::string_view bytes) {
  return bytes.substr(0, 4096).find("<FictionBook") != std::string_view::npos &&
         BeginsWith(bytes.substr(bytes.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0), "<?xml");
}

/// Kinds that people try, by how they begin.
void RefuseKnown(std::string_view bytes, const std::string& name) {
  const char* kind = BeginsWith(bytes, "%PDF-")              ? "a PDF"
                     : BeginsWith(bytes, "{\\rtf")           ? "a document in RTF"
                     : BeginsWith(bytes, "\xD0\xCF\x11\xE0") ? "a document of an older Word"
                     : BeginsWith(bytes, "ITSF")             ? "a CHM help file"
                     : IsWebArchive(bytes)                   ? "a web archive (MHTML)"
                     : IsFictionBook(bytes)                  ? "a FictionBook"
                     : BeginsWith(bytes, "PK\x07\x08")       ? "a piece of a split zip archive"
                     : bytes.size() > 68 && bytes.substr(60, 8) == "BOOKMOBI" ? "a Kindle book"
                     : IsBinary(bytes)                                        ? "no text"
                                                                              : nullptr;
  if (kind == nullptr) return;
  throw InputError(name + ": is " + kind + "; save it as EPUB, HTML or plain text");
}

[[noreturn]] void ThrowTooLarge(const std::string& name, const DocumentLimits& limits) {
  throw InputError(name + ": holds more than " + std::to_string(limits.most_bytes >> 20U) +
                   " MB; split it, or raise --most-mb");
}

Document ReadText(std::string bytes, const std::string& name, const OpenOptions& options) {
  RefusePacked(bytes, name);
  RefuseKnown(bytes, name);
  Document document;
  if (IsBrfName(name)) {
    document = ReadBrf(bytes, name);
  } else {
    DecodedText decoded = DecodeText(bytes, DeclaredEncoding(bytes));
    bytes = {};
    const bool html = IsHtml(decoded.text, name);
    document =
        html ? ReadHtml(decoded.text, name) : ReadPlainText(decoded.text, name, options.marks);
    document.encoding = decoded.encoding;
    if (decoded.guessed) NoteLeftOut(document, LeftOut::kGuessedCoding, decoded.encoding);
    NoteLeftOut(document, LeftOut::kBadByte, "", decoded.bad);
  }
  if (document.blocks.empty()) {
    throw InputError(name + ": holds no text; name another file");
  }
  return document;
}

}  // namespace

Document ReadDocument(std::string bytes, const std::string& name, const OpenOptions& options) {
  if (bytes.size() > options.limits.most_bytes) ThrowTooLarge(name, options.limits);
  if (!IsZip(bytes)) return ReadText(std::move(bytes), name, options);
  ZipArchive zip(std::move(bytes), name, options.limits.most_bytes);
  return ReadEpub(zip, name);
}

Document OpenDocument(const std::string& path, const OpenOptions& options) {
  RequireRegularFile(path);
  char head[4] = {};
  std::ifstream(path, std::ios::binary).read(head, sizeof head);
  if (IsZip(std::string_view(head, sizeof head))) {
    ZipArchive zip(path, options.limits.most_bytes);
    return ReadEpub(zip, path);
  }
  std::error_code ignored;
  const std::uintmax_t size = std::filesystem::file_size(path, ignored);
  if (!ignored && size > options.limits.most_bytes) ThrowTooLarge(path, options.limits);
  return ReadText(ReadTextFile(path, options.limits.most_bytes), path, options);
}

}  // namespace moontrace
