#pragma once

#include <cstdlib>
#include <string>

#include "lessons/documents/open_document.h"
#include "lessons/documents/transcribe.h"
#include "tests/fuzz/one_line.h"
#include "textures/base/error.h"
#include "textures/base/utf8.h"

namespace moontrace {

inline void Require(bool sound) {
  if (!sound) std::abort();
}

/// Reads bytes as a document: its texts are UTF-8, its marks lie within them in order, its contents
/// lead to blocks, and each block begins within the transcription; or it is refused in one line.
inline void RequireSoundDocument(const std::string& bytes, const std::string& name,
                                 bool marks = false) {
  OpenOptions options;
  options.limits.most_bytes = std::size_t{1} << 20U;
  options.marks = marks;
  try {
    const Document document = ReadDocument(bytes, name, options);
    Require(!document.blocks.empty());
    for (const Block& block : document.blocks) {
      Require(!FirstBadUtf8(block.text));
      std::size_t begin = 0;
      for (const DocumentMark& mark : block.marks) {
        Require(begin <= mark.begin && mark.begin <= mark.end && mark.end <= block.text.size());
        begin = mark.begin;
      }
    }
    for (const ContentsEntry& entry : document.contents) {
      Require(entry.block == kNoBlock || entry.block < document.blocks.size());
    }
    const Transcription written = Transcribe(document);
    Require(!FirstBadUtf8(written.text));
    Require(written.begins.size() == document.blocks.size());
    for (const std::size_t at : written.begins) Require(at <= written.text.size());
  } catch (const InputError& error) {
    MustBeOneLine(error.what());
  } catch (const LackError& error) {
    MustBeOneLine(error.what());
  }
}

}  // namespace moontrace
