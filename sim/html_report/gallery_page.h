#pragma once

#include <string>
#include <vector>

namespace moontrace {

/// What one command of the gallery printed and drew.
struct GalleryPicture {
  std::string title;
  std::string command;  ///< as typed
  std::string picture;  ///< file beside the page; empty where there is none
  std::string words;    ///< the command's lines
};

/// The gallery as HTML: headings to jump by, every picture with its words as its description.
std::string GalleryPage(const std::vector<GalleryPicture>& pictures);

}  // namespace moontrace
