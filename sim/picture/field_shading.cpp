#include "sim/picture/field_shading.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <thread>
#include <vector>

namespace moontrace {

namespace {

std::uint8_t Byte(double part) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(part, 0.0, 1.0)));
}

/// From 0 to 1: roughness of paper stays paper, and a line is darkest along its middle.
double TintOf(double share) {
  constexpr double kNone = 0.15, kFull = 0.95;
  const double t = std::clamp((share - kNone) / (kFull - kNone), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// One picture's constants.
struct Shader {
  const TextureField& field;
  const PageShade& shade;
  Box view_P, sheet_P;
  std::size_t width, height;
  double greatest;  ///< [m]

  Color At(glm::dvec2 p_P, const Sample& sample) const {
    const bool on_sheet = p_P.x >= sheet_P.min.x && p_P.x <= sheet_P.max.x &&
                          p_P.y >= sheet_P.min.y && p_P.y <= sheet_P.max.y;
    const double h = sample.displacement;
    Color color = on_sheet ? shade.paper : shade.desk;
    if (h != 0 && greatest > 0) {
      color = Mixed(color, h < 0 ? shade.groove : shade.ridge, TintOf(std::abs(h) / greatest));
    }
    const glm::dvec2 g = sample.gradient;
    const glm::dvec3 normal = glm::normalize(glm::dvec3(-g.x, -g.y, 1));
    const double lit = std::max(0.0, glm::dot(normal, shade.light_P)) / shade.light_P.z;
    const double brightness = shade.ambient + (1 - shade.ambient) * lit;
    return {brightness * color.red, brightness * color.green, brightness * color.blue};
  }

  void Row(std::size_t row, std::uint8_t* out) const {
    const glm::dvec2 step = (view_P.max - view_P.min) /
                            glm::dvec2(static_cast<double>(width), static_cast<double>(height));
    const double y = view_P.max.y - step.y * (static_cast<double>(row) + 0.5);
    std::vector<glm::dvec2> points(width);
    for (std::size_t i = 0; i < width; ++i) {
      points[i] = {view_P.min.x + step.x * (static_cast<double>(i) + 0.5), y};
    }
    std::vector<Sample> samples(width);
    field.SamplesAt(points, samples);
    for (std::size_t i = 0; i < width; ++i) {
      const Color color = At(points[i], samples[i]);
      *out++ = Byte(color.red);
      *out++ = Byte(color.green);
      *out++ = Byte(color.blue);
    }
  }
};

}  // namespace

PageShade HighContrastShade() {
  PageShade shade;
  shade.paper = {1, 1, 1};
  shade.groove = {0, 0, 0};
  shade.ridge = {0.45, 0.20, 0};
  shade.desk = {0.1, 0.1, 0.1};
  return shade;
}

Raster ShadeField(const TextureField& field, const Box& view_P, const Box& sheet_P,
                  std::size_t width, std::size_t height, const PageShade& shade,
                  std::size_t threads) {
  Raster raster{width, height, std::vector<std::uint8_t>(3 * width * height)};
  const Shader shader{field, shade, view_P, sheet_P, width, height, field.greatest_displacement()};
  const auto work = [&](std::size_t first) {
    for (std::size_t row = first; row < height; row += threads) {
      shader.Row(row, &raster.rgb[3 * width * row]);
    }
  };
  std::vector<std::thread> others;
  for (std::size_t i = 1; i < threads; ++i) others.emplace_back(work, i);
  work(0);
  for (std::thread& other : others) other.join();
  return raster;
}

}  // namespace moontrace
