#include "sim/picture/picture_file.h"

#include <filesystem>
#include <optional>

#include "sim/picture/cairo_writer.h"
#include "sim/picture/picture_messages.h"
#include "sim/picture/svg_writer.h"
#include "textures/base/error.h"
#include "textures/base/output_file.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 100;

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

/// Of page `page` (from 0) of `pages`.
std::string PathOf(const std::string& path, std::size_t page, std::size_t pages) {
  if (pages == 1) return path;
  const fs::path whole(path);
  const std::string name =
      whole.stem().string() + "-" + std::to_string(page + 1) + whole.extension().string();
  return (whole.parent_path() / name).string();
}

std::string ToPdf(const Drawing& drawing) {
  PdfWriter writer;
  writer.Add(drawing);
  writer.Finish();
  return writer.Take();
}

}  // namespace

bool HasPictureEnding(const std::string& path) { return EndingOf(path).has_value(); }

void CheckPicturePath(const std::string& path) {
  if (KindOf(path) != PictureKind::kSvg && !HaveCairo())
    ToPng(Drawing{});  // throws, saying what is missing
  RequireWritable(path);
}

void WritePicture(const std::string& path, const Drawing& drawing) {
  switch (KindOf(path)) {
    case PictureKind::kSvg:
      return WriteWhole(path, ToSvg(drawing));
    case PictureKind::kPng:
      return WriteWhole(path, ToPng(drawing));
    case PictureKind::kPdf:
      return WriteWhole(path, ToPdf(drawing));
  }
}

void WritePicture(const std::string& path, const Raster& raster, bool lasting) {
  if (KindOf(path) != PictureKind::kPng) throw InputError(path + ": this picture ends in .png");
  WriteWhole(path, ToPng(raster), lasting);
}

struct PagePictures::Pdf {
  explicit Pdf(const std::string& path) : file(path) {}
  OutputFile file;
  PdfWriter writer;
};

PagePictures::PagePictures(const std::string& path, std::size_t pages)
    : path_(path), pages_(pages) {
  if (KindOf(path) == PictureKind::kPdf) {
    pdf_ = std::make_unique<Pdf>(path);
  } else if (pages > kMostFiles) {
    throw InputError(say::TooManyPictures(pages, kMostFiles));
  }
}

PagePictures::~PagePictures() = default;

void PagePictures::Add(const Drawing& page) {
  if (pdf_ == nullptr) {
    files_.push_back(PathOf(path_, files_.size(), pages_));
    WritePicture(files_.back(), page);
    return;
  }
  pdf_->writer.Add(page);
  pdf_->file.Append(pdf_->writer.Take());
}

std::vector<std::string> PagePictures::Finish() {
  if (pdf_ != nullptr) {
    pdf_->writer.Finish();
    pdf_->file.Append(pdf_->writer.Take());
    pdf_->file.Finish();
    pdf_.reset();
    files_ = {path_};
  }
  return files_;
}

}  // namespace moontrace
