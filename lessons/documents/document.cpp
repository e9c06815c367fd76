#include "lessons/documents/document.h"

#include <algorithm>

#include "textures/base/text_file.h"

namespace moontrace {

void NoteLeftOut(Document& document, LeftOut what, std::string_view example, std::size_t count) {
  if (count == 0) return;
  auto at =
      std::lower_bound(document.left_out.begin(), document.left_out.end(), what,
                       [](const LeftOutCount& entry, LeftOut other) { return entry.what < other; });
  if (at == document.left_out.end() || at->what != what) {
    at = document.left_out.insert(at, {what, 0, OneLine(example)});
  }
  at->count += count;
}

std::vector<ContentsEntry> ContentsOf(const Document& document) {
  if (!document.contents.empty()) return document.contents;
  std::vector<ContentsEntry> contents;
  for (std::size_t i = 0; i < document.blocks.size(); ++i) {
    const Block& block = document.blocks[i];
    if (block.kind != BlockKind::kHeading) continue;
    std::string title = block.text;
    std::replace(title.begin(), title.end(), '\n', ' ');
    contents.push_back({title, block.level, i});
  }
  return contents;
}

}  // namespace moontrace
