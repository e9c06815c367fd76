// Pictures, drawings, formulas and controls of a document, as MarkupReader meets them.
#include <string>
#include <utility>

#include "lessons/documents/markup_reader.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

/// Whether a part of a drawing's text begins a line of its own.
bool BeginsLine(std::string_view name, const MarkupAttributes& attributes) {
  return name == "tspan" && (attributes.Has("y") ||
                             attributes["dy"].find_first_of("123456789") != std::string_view::npos);
}

/// "a/b/cover.jpg?x" is "cover.jpg".
std::string_view FileName(std::string_view address) {
  if (address.substr(0, 5) == "data:") return "";
  address = address.substr(0, address.find_first_of("?#"));
  const std::size_t slash = address.find_last_of('/');
  return slash == std::string_view::npos ? address : address.substr(slash + 1);
}

}  // namespace

void MarkupReader::OpenImage(const Frame& frame, const MarkupAttributes& attributes) {
  const std::string_view role = attributes["role"];
  if (role == "presentation" || role == "none") return;
  std::string_view words = attributes["aria-label"];
  if (words.empty()) words = attributes["alt"];
  if (words.empty()) words = attributes["title"];
  const std::string_view file = FileName(attributes["src"]);
  const bool again = frame.stand_in && picture_end_ == writer_.written() && picture_ == words;
  if (again) return;
  const auto note = [&] {
    picture_ = words;
    picture_end_ = writer_.written();
  };
  if (!IsOnlyBlanks(words)) {
    WritingState state = frame.state;
    ValueOf(state, MarkKind::kPicture) = writer_.Value(file);
    state.verbatim = false;
    Say(words, state);
    note();
    const bool drawing = LowerCase(file).ends_with(".svg");
    if (drawing) NoteLeftOut(writer_.document(), LeftOut::kDrawing, words);
  } else if (!attributes.Has("alt")) {  // an empty one says that it only decorates
    writer_.Point(MarkKind::kPicture, file, frame.state);
    note();
    NoteLeftOut(writer_.document(), LeftOut::kPicture, file);
  }
}

void MarkupReader::OpenDrawing(Frame& frame, const MarkupAttributes& attributes) {
  const bool inner = frame.drawing;
  frame.drawing = true;
  if (!inner) {
    ValueOf(frame.state, MarkKind::kPicture) = writer_.Value("");
    drawing_title_.clear();
  }
  OpenDrawn(frame, "svg", attributes);
}

/// An element in a drawing: its words stand apart from those of others, as they do on paper.
void MarkupReader::OpenDrawn(Frame& frame, std::string_view name,
                             const MarkupAttributes& attributes) {
  const std::string_view label = attributes["aria-label"];
  frame.labelled = !IsOnlyBlanks(label);
  frame.apart = frame.labelled || name == "title" || name == "desc" || name == "text" ||
                BeginsLine(name, attributes);
  if (frame.apart) Say(" ", frame.state);
  if (!frame.labelled) return;
  if (drawing_title_.empty()) drawing_title_ = label;
  Say(label, frame.state);
  Say(" ", frame.state);
}

void MarkupReader::OpenMath(Frame& frame, const MarkupAttributes& attributes) {
  ValueOf(frame.state, MarkKind::kMath) = writer_.Value("");
  const std::string_view words = attributes["alttext"];
  const bool tex = words.find('\\') != std::string_view::npos;  // for programs, not to be said
  if (!IsOnlyBlanks(words) && !tex) {
    Say(words, frame.state);
    frame.silent = true;
    return;
  }
  math_words_ = words;
  math_.emplace();
  math_depth_ = 0;
}

void MarkupReader::OpenInput(const Frame& frame, const MarkupAttributes& attributes) {
  const std::string type = LowerCase(attributes["type"]);
  if (type == "checkbox" || type == "radio" || type == "password") return;
  for (const char* name : {"value", "alt", "placeholder", "aria-label"}) {
    if (IsOnlyBlanks(attributes[name])) continue;
    Say(" ", frame.state);
    Say(attributes[name], frame.state);
    Say(" ", frame.state);
    return;
  }
}

void MarkupReader::CloseDrawing(const Frame& frame) {
  if (!frames_.empty() && frames_.back().drawing) return;  // within another
  if (writer_.written() != frame.written) {
    return NoteLeftOut(writer_.document(), LeftOut::kDrawing, drawing_title_);
  }
  writer_.Point(MarkKind::kPicture, "", frame.state);
  NoteLeftOut(writer_.document(), LeftOut::kPicture, "svg");
}

}  // namespace moontrace
