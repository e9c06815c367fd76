#include "sim/view/picture_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>

#include "sim/view/cairo_writer.h"
#include "sim/view/svg_writer.h"
#include "textures/error.h"
#include "textures/text_file.h"

namespace moontrace {

namespace {

namespace fs = std::filesystem;

enum class PictureKind { kSvg, kPng, kPdf };

std::optional<PictureKind> EndingOf(const std::string& path) {
  const std::string ending = LowerCase(fs::path(path).extension().string());
  if (ending == ".svg") return PictureKind::kSvg;
  if (ending == ".png") return PictureKind::kPng;
  if (ending == ".pdf") return PictureKind::kPdf;
  return std::nullopt;
}

PictureKind KindOf(const std::string& path) {
  if (const std::optional<PictureKind> kind = EndingOf(path)) return *kind;
  throw InputError(path + ": a picture ends in .svg, .png or .pdf");
}

[[noreturn]] void CannotWrite(const std::string& path) {
  throw LackError(path + ": cannot be written (" + std::strerror(errno) + "): name another place");
}

std::string PartialOf(const std::string& path) { return path + ".partial"; }

/// Writes all bytes or removes what there is and throws.
void WriteAll(const std::string& path, const std::string& bytes) {
  const std::string partial = PartialOf(path);
  std::FILE* file = std::fopen(partial.c_str(), "wb");
  if (file == nullptr) CannotWrite(path);
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  const bool closed = std::fclose(file) == 0;
  if (!written || !closed || std::rename(partial.c_str(), path.c_str()) != 0) {
    const int cause = errno;
    std::remove(partial.c_str());
    errno = cause;
    CannotWrite(path);
  }
}

}  // namespace

bool HasPictureEnding(const std::string& path) { return EndingOf(path).has_value(); }

void CheckPicturePath(const std::string& path) {
  if (KindOf(path) != PictureKind::kSvg && !HaveCairo())
    ToPng(Drawing{});  // throws, saying what lacks
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    errno = EISDIR;
    CannotWrite(path);
  }
  const std::string partial = PartialOf(path);
  std::FILE* file = std::fopen(partial.c_str(), "wb");
  if (file == nullptr) CannotWrite(path);
  std::fclose(file);
  std::remove(partial.c_str());
}

void WritePicture(const std::string& path, const Drawing& drawing) {
  switch (KindOf(path)) {
    case PictureKind::kSvg:
      return WriteAll(path, ToSvg(drawing));
    case PictureKind::kPng:
      return WriteAll(path, ToPng(drawing));
    case PictureKind::kPdf:
      return WriteAll(path, ToPdf(drawing));
  }
}

void WritePicture(const std::string& path, const Raster& raster) {
  if (KindOf(path) != PictureKind::kPng) throw InputError(path + ": this picture ends in .png");
  WriteAll(path, ToPng(raster));
}

std::string PicturePath(const std::string& path, std::size_t page, std::size_t pages) {
  if (pages == 1) return path;
  const fs::path whole(path);
  const std::string name =
      whole.stem().string() + "-" + std::to_string(page + 1) + whole.extension().string();
  return (whole.parent_path() / name).string();
}

}  // namespace moontrace
