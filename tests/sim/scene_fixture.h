#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/vec3.hpp>
#include <string>

#include "sim/physics/scene.h"
#include "textures/base/error.h"

namespace moontrace {

/// A reading without velocity, as encoders give it.
inline DeviceState TipAt(glm::dvec3 p_W) {
  DeviceState state;
  state.p_D = p_W;
  return state;
}

/// Joints that are inserted before those of a model which has some: the proxy's and the pad.
inline constexpr int kInserted = 4;

inline TickResult Hold(Scene& scene, glm::dvec3 p_W, int ticks) {
  TickResult result;
  for (int i = 0; i < ticks; ++i) result = scene.Tick(TipAt(p_W));
  return result;
}

/// The default groove at 12 mm letters: w = 1.4 mm, D = w/2, r = 0.2 w; slope 1.67.
inline constexpr Profile kGroove{0.0014, 0.0007, 0.00028};

inline TextureField FieldOf(std::vector<Element> elements) {
  Group group;
  group.elements = std::move(elements);
  Texture texture;
  texture.layers.push_back({Finish(std::move(group)), Relief::kEngraved});
  return TextureField(texture);
}

/// One groove through the origin, a metre long, along y.
inline TextureField GrooveAlongY(const Profile& profile = kGroove) {
  return FieldOf({{Line{{0.0, -0.5}, {0.0, 0.5}}, profile}});
}

/// A model with a page at the world's origin and `more` elements of the world, options first.
inline std::string ModelWith(const std::string& options, const std::string& more) {
  return "<mujoco>" + options +
         "<custom><text name=\"moontrace:page\" data=\"{}\"/></custom><worldbody>"
         "<geom name=\"page\" type=\"plane\" size=\"0.1 0.1 0.1\" contype=\"0\" "
         "conaffinity=\"0\"/>" +
         more + "</worldbody></mujoco>";
}

/// The text of the InputError that `act` throws; empty if it throws none.
inline std::string ErrorOf(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

inline bool Holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline bool IsOneLine(const std::string& text) {
  return !text.empty() && text.find('\n') == std::string::npos;
}

}  // namespace moontrace
