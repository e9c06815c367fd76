#include "sim/picture/svg_writer.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "textures/base/overload.h"
#include "textures/base/xml_text.h"

namespace moontrace {

namespace {

/// Three decimals, no needless zeros, never "-0".
std::string Number(double value) {
  std::string text = fmt::format("{:.3f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string Escaped(std::string text) {
  // XML 1.0 has no place for the other control characters.
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20U; };
  std::replace_if(text.begin(), text.end(), is_control, ' ');
  return EscapedXml(text);
}

std::string Hex(Color color) {
  const auto byte = [](double part) { return static_cast<int>(std::lround(255.0 * part)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(color.red), byte(color.green), byte(color.blue));
}

class Writer {
 public:
  explicit Writer(double height) : height_(height) {}

  void operator()(const PathMark& mark) {
    Put("<path d=\"");
    for (const auto& subpath : mark.subpaths) Subpath(subpath, mark.fill.has_value());
    Put("\"");
    Paint(mark.fill, mark.stroke, mark.width, mark.dashed);
  }

  void operator()(const TrackMark& mark) {
    Put("<polyline points=\"");
    for (const glm::dvec2 p : mark.points) Put("{},{} ", Number(p.x), Number(height_ - p.y));
    if (!mark.points.empty()) text_.pop_back();
    Put("\"");
    Paint(std::nullopt, mark.stroke, mark.width, mark.dashed);
  }

  void operator()(const CircleMark& mark) {
    Put("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"", Number(mark.center.x),
        Number(height_ - mark.center.y), Number(mark.radius));
    Paint(mark.fill, mark.stroke, mark.width, false);
  }

  void operator()(const TextMark& mark) {
    // A capital is about 0.72 of the font size high in common sans-serif fonts.
    Put("<text x=\"{}\" y=\"{}\" font-family=\"sans-serif\" font-size=\"{}\" "
        "fill=\"{}\">{}</text>\n",
        Number(mark.at.x), Number(height_ - mark.at.y), Number(mark.height / 0.72), Hex(mark.color),
        Escaped(mark.text));
  }

  std::string Take() { return std::move(text_); }

 private:
  template <typename... Args>
  void Put(fmt::format_string<Args...> format, Args&&... args) {
    text_ += fmt::format(format, std::forward<Args>(args)...);
  }

  void Subpath(const std::vector<Piece>& pieces, bool close) {
    if (pieces.empty()) return;
    const glm::dvec2 start = StartOf(pieces.front());
    Put("M{} {}", Number(start.x), Number(height_ - start.y));
    for (const Piece& piece : pieces) {
      std::visit(Overload{[this](const Line& line) { LineTo(line); },
                          [this](const Arc& arc) { ArcTo(arc); }},
                 piece);
    }
    if (close) Put("Z");
  }

  void LineTo(const Line& line) { Put("L{} {}", Number(line.to.x), Number(height_ - line.to.y)); }

  /// SVG draws nothing for an arc that ends where it starts: a long one is written as two halves.
  void ArcTo(const Arc& arc) {
    const int parts = std::abs(arc.sweep) > std::numbers::pi ? 2 : 1;
    for (int i = 1; i <= parts; ++i) {
      const double angle = arc.start + arc.sweep * i / parts;
      const glm::dvec2 end = arc.center + arc.radius * DirectionOf(angle);
      const std::string radius = Number(arc.radius);
      // y is turned over, so counter-clockwise on paper is SVG's sweep 0.
      Put("A{} {} 0 0 {} {} {}", radius, radius, arc.sweep > 0 ? 0 : 1, Number(end.x),
          Number(height_ - end.y));
    }
  }

  void Paint(const std::optional<Color>& fill, const std::optional<Color>& stroke, double width,
             bool dashed) {
    Put(" fill=\"{}\"", fill ? Hex(*fill) : "none");
    if (stroke) {
      Put(" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\" stroke-linejoin=\"round\"",
          Hex(*stroke), Number(width));
      if (dashed) Put(" stroke-dasharray=\"{}\"", Number(3 * width));
    }
    Put("/>\n");
  }

  double height_;
  std::string text_;
};

}  // namespace

std::string ToSvg(const Drawing& drawing) {
  Writer writer(drawing.height);
  for (const Mark& mark : drawing.marks) std::visit(writer, mark);
  const std::string width = Number(drawing.width);
  const std::string height = Number(drawing.height);
  return fmt::format(
             "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
             "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" role=\"img\" "
             "width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\">\n"
             "<title>{2}</title>\n<desc>{3}</desc>\n"
             "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
             width, height, Escaped(drawing.title), Escaped(drawing.description)) +
         writer.Take() + "</svg>\n";
}

}  // namespace moontrace
