#include "sim/picture/cairo_writer.h"

#include <utility>

#include "textures/base/error.h"

#ifdef MOONTRACE_HAVE_CAIRO

#include <cairo-pdf.h>
#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>

#include "textures/base/overload.h"
#include "textures/base/units.h"

namespace moontrace {

namespace {

struct SurfaceDeleter {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using CairoSurface = std::unique_ptr<cairo_surface_t, SurfaceDeleter>;

struct ContextDeleter {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Context = std::unique_ptr<cairo_t, ContextDeleter>;

cairo_status_t Append(void* text, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

/// Paints marks; the context's unit is 1 mm, y up (text is turned back where it stands).
class Painter {
 public:
  explicit Painter(cairo_t* cr) : cr_(cr) {}

  void operator()(const PathMark& mark) {
    cairo_new_path(cr_);
    for (const auto& subpath : mark.subpaths) {
      cairo_new_sub_path(cr_);
      for (const Piece& piece : subpath) Add(piece);
      if (mark.fill) cairo_close_path(cr_);
    }
    Paint(mark.fill, mark.stroke, mark.width, mark.dashed);
  }

  void operator()(const TrackMark& mark) {
    cairo_new_path(cr_);
    for (const glm::dvec2 p : mark.points) cairo_line_to(cr_, p.x, p.y);
    Paint(std::nullopt, mark.stroke, mark.width, mark.dashed);
  }

  void operator()(const CircleMark& mark) {
    cairo_new_path(cr_);
    cairo_arc(cr_, mark.center.x, mark.center.y, mark.radius, 0, kTurn);
    Paint(mark.fill, mark.stroke, mark.width, false);
  }

  void operator()(const TextMark& mark) {
    cairo_save(cr_);
    cairo_translate(cr_, mark.at.x, mark.at.y);
    cairo_scale(cr_, 1, -1);
    cairo_select_font_face(cr_, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cr_, mark.height / 0.72);
    Use(mark.color);
    cairo_move_to(cr_, 0, 0);
    cairo_show_text(cr_, mark.text.c_str());
    cairo_restore(cr_);
  }

 private:
  void Add(const Piece& piece) {
    const auto add_line = [this](const Line& line) {
      cairo_line_to(cr_, line.from.x, line.from.y);
      cairo_line_to(cr_, line.to.x, line.to.y);
    };
    const auto add_arc = [this](const Arc& arc) {
      const double end = arc.start + arc.sweep;
      const auto add = arc.sweep > 0 ? cairo_arc : cairo_arc_negative;
      add(cr_, arc.center.x, arc.center.y, arc.radius, arc.start, end);
    };
    std::visit(Overload{add_line, add_arc}, piece);
  }

  void Use(Color color) { cairo_set_source_rgb(cr_, color.red, color.green, color.blue); }

  void Paint(const std::optional<Color>& fill, const std::optional<Color>& stroke, double width,
             bool dashed) {
    if (fill) {
      Use(*fill);
      cairo_fill_preserve(cr_);
    }
    if (stroke) {
      Use(*stroke);
      cairo_set_line_width(cr_, width);
      cairo_set_line_cap(cr_, CAIRO_LINE_CAP_ROUND);
      cairo_set_line_join(cr_, CAIRO_LINE_JOIN_ROUND);
      const double dash = 3 * width;
      cairo_set_dash(cr_, &dash, dashed ? 1 : 0, 0);
      cairo_stroke_preserve(cr_);
    }
    cairo_new_path(cr_);
  }

  cairo_t* cr_;
};

/// Paints on white with `scale` surface units a millimetre.
void Draw(cairo_surface_t* surface, const Drawing& drawing, double scale) {
  const Context context(cairo_create(surface));
  cairo_t* cr = context.get();
  cairo_set_source_rgb(cr, 1, 1, 1);
  cairo_paint(cr);
  cairo_scale(cr, scale, -scale);
  cairo_translate(cr, 0, -drawing.height);
  Painter painter(cr);
  for (const Mark& mark : drawing.marks) std::visit(painter, mark);
  if (cairo_status(cr) != CAIRO_STATUS_SUCCESS) {
    throw LackError(std::string("the picture cannot be drawn (") +
                    cairo_status_to_string(cairo_status(cr)) + "); write an .svg picture instead");
  }
}

std::string BigEndian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xFFU);
  return bytes;
}

/// The check of a PNG's chunk (ISO/IEC 15948, annex D), bit by bit: it is short.
std::uint32_t Crc(std::string_view bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1U ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

/// A PNG with its true size, in points a metre: cairo has no call for it.
std::string WithSize(std::string png, double points_per_metre) {
  constexpr std::size_t kHead = 8 + 25;  // signature and the chunk IHDR, which comes first
  if (png.size() < kHead) return png;
  const std::string density = BigEndian(static_cast<std::uint32_t>(std::lround(points_per_metre)));
  const std::string chunk = "pHYs" + density + density + '\x01';  // 1: of a metre
  return png.insert(kHead, BigEndian(9) + chunk + BigEndian(Crc(chunk)));
}

}  // namespace

bool HaveCairo() noexcept { return true; }

std::string ToPng(const Drawing& drawing) {
  const double scale =
      std::min(300.0 / 25.4, 4000.0 / std::max({drawing.width, drawing.height, 1.0}));
  const int width = std::max(1, static_cast<int>(std::lround(drawing.width * scale)));
  const int height = std::max(1, static_cast<int>(std::lround(drawing.height * scale)));
  const CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
  Draw(surface.get(), drawing, scale);
  std::string bytes;
  cairo_surface_write_to_png_stream(surface.get(), &Append, &bytes);
  return WithSize(std::move(bytes), 1000 * scale);
}

std::string ToPng(const Raster& raster) {
  const CairoSurface surface(cairo_image_surface_create(
      CAIRO_FORMAT_RGB24, static_cast<int>(raster.width), static_cast<int>(raster.height)));
  cairo_surface_flush(surface.get());
  unsigned char* bytes = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (std::size_t row = 0; row < raster.height; ++row) {
    unsigned char* line = bytes + static_cast<std::ptrdiff_t>(row) * stride;
    for (std::size_t i = 0; i < raster.width; ++i) {
      const std::uint8_t* rgb = &raster.rgb[3 * (row * raster.width + i)];
      // cairo's points are numbers of 32 bits: blue lowest
      const std::uint32_t point =
          (std::uint32_t{rgb[0]} << 16) | (std::uint32_t{rgb[1]} << 8) | std::uint32_t{rgb[2]};
      std::memcpy(line + 4 * i, &point, 4);
    }
  }
  cairo_surface_mark_dirty(surface.get());
  std::string png;
  cairo_surface_write_to_png_stream(surface.get(), &Append, &png);
  return png;
}

struct PdfWriter::State {
  std::string bytes;
  CairoSurface surface;
};

PdfWriter::PdfWriter() : state_(std::make_unique<State>()) {}

// the surface's last bytes go into the state
PdfWriter::~PdfWriter() { state_->surface.reset(); }

void PdfWriter::Add(const Drawing& page) {
  constexpr double kPointsPerMillimetre = 72.0 / 25.4;
  const double width = page.width * kPointsPerMillimetre;
  const double height = page.height * kPointsPerMillimetre;
  CairoSurface& surface = state_->surface;
  if (surface == nullptr) {
    surface.reset(cairo_pdf_surface_create_for_stream(&Append, &state_->bytes, width, height));
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, page.title.c_str());
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_SUBJECT,
                                   page.description.c_str());
  }
  cairo_pdf_surface_set_size(surface.get(), width, height);
  Draw(surface.get(), page, kPointsPerMillimetre);
  cairo_surface_show_page(surface.get());
}

std::string PdfWriter::Take() { return std::exchange(state_->bytes, {}); }

void PdfWriter::Finish() {
  if (state_->surface != nullptr) cairo_surface_finish(state_->surface.get());
}

}  // namespace moontrace

#else

namespace moontrace {

namespace {

[[noreturn]] void Lack() {
  throw LackError("this build cannot write PNG or PDF: name an .svg, or build with libcairo2-dev");
}

}  // namespace

bool HaveCairo() noexcept { return false; }
std::string ToPng(const Drawing&) { Lack(); }
std::string ToPng(const Raster&) { Lack(); }
struct PdfWriter::State {};
PdfWriter::PdfWriter() { Lack(); }
PdfWriter::~PdfWriter() = default;
void PdfWriter::Add(const Drawing&) { Lack(); }
std::string PdfWriter::Take() { Lack(); }
void PdfWriter::Finish() { Lack(); }

}  // namespace moontrace

#endif
