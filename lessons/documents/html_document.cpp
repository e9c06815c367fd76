#include "lessons/documents/html_document.h"

#include "lessons/documents/block_writer.h"
#include "lessons/documents/html_source.h"
#include "lessons/documents/html_tree.h"
#include "lessons/documents/markup_reader.h"
#include "lessons/documents/xml_markup.h"

namespace moontrace {
namespace {

std::string OneSpaced(std::string_view text) {
  std::string line;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '\f';
    if (!blank) {
      line += c;
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
  }
  if (!line.empty() && line.back() == ' ') line.pop_back();
  return line;
}

}  // namespace

Document ReadHtml(const std::string& html, const std::string& name) {
  Document document;
  document.format = DocumentFormat::kHtml;
  BlockWriter writer(document, name);
  MarkupReader reader(writer);
  reader.BeginPart("");
  const bool xhtml = html.rfind("<?xml", 0) == 0;
  if (!xhtml || !ReadXmlMarkup(html, name, reader)) {
    const TamedHtml tamed = TameHtml(html, name, xhtml);
    NoteLeftOut(document, LeftOut::kDeepElement, "", tamed.flattened);
    ReadHtmlMarkup(tamed.html, reader);
  }
  reader.EndPart();
  reader.LeadLinks();
  document.title = OneSpaced(reader.title());
  document.language = reader.language();
  return document;
}

}  // namespace moontrace
