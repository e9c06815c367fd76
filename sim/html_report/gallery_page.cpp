#include "sim/html_report/gallery_page.h"

#include <fmt/core.h>

#include <string_view>

#include "textures/base/xml_text.h"

namespace moontrace {

namespace {

constexpr std::string_view kHead =
    "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
    "<meta name=\"viewport\" content=\"width=device-width\">\n<title>Moontrace gallery</title>\n"
    "<style>\n"
    "body { max-width: 60em; margin: 2em auto; padding: 0 1em; font: 1.1em/1.5 sans-serif; }\n"
    "img { max-width: 100%; border: 1px solid #888; }\n"
    "code, pre { white-space: pre-wrap; overflow-wrap: anywhere; }\n"
    "</style>\n</head>\n<body>\n<h1>Moontrace gallery</h1>\n";

std::string Section(const GalleryPicture& shown, std::size_t number) {
  std::string html = fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n<p><code>{}</code></p>\n",
                                 number, EscapedXml(shown.title), EscapedXml(shown.command));
  if (!shown.picture.empty()) {
    html += fmt::format("<p><img src=\"{}\" alt=\"{}, as the words below say.\"></p>\n",
                        EscapedXml(shown.picture), EscapedXml(shown.title));
  }
  html += fmt::format("<pre>{}</pre>\n</section>\n", EscapedXml(shown.words));
  return html;
}

}  // namespace

std::string GalleryPage(const std::vector<GalleryPicture>& pictures) {
  std::string html(kHead);
  html +=
      "<p>Pages of tactile text. Each picture shows what the finger would meet; below it stands "
      "what the command says about it.</p>\n<ol>\n";
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    html += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", i + 1, EscapedXml(pictures[i].title));
  }
  html += "</ol>\n";
  for (std::size_t i = 0; i < pictures.size(); ++i) html += Section(pictures[i], i + 1);
  return html + "</body>\n</html>\n";
}

}  // namespace moontrace
