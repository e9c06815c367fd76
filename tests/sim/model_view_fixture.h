#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/model_view/view_model.h"
#include "sim/page_view/view_page.h"
#include "sim/physics/page_field.h"
#include "sim/physics/scene.h"
#include "sim/setup/text_setup.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// A can of 40 mm radius that turns on its axis, an inner wall that can be slid before it, and a
/// plate that lies behind it to the right. The can's label is the page.
inline std::string CanXml() {
  return R"(<mujoco>
  <visual><quality shadowsize="0" offsamples="0"/><headlight ambient=".4 .4 .4" diffuse=".5 .5 .5" specular="0 0 0"/></visual>
  <custom>
    <text name="moontrace:can" data="{text='moon'}"/>
    <text name="moontrace:plate" data="{text='sea', middle_mm=[0,0]}"/>
  </custom>
  <worldbody>
    <camera name="reader" pos="0 -0.3 0.05" xyaxes="1 0 0 0 0 1" fovy="45"/>
    <body name="turntable" pos="0 0 0.05">
      <joint name="turn" type="hinge" axis="0 0 1"/>
      <geom name="can" type="cylinder" size="0.04 0.05" mass="1" rgba="0.9 0.9 0.9 1" contype="0" conaffinity="0"/>
    </body>
    <body name="wall" pos="0.3 -0.1 0.05">
      <joint name="slide" type="slide" axis="1 0 0"/>
      <geom name="wall" type="box" size="0.06 0.002 0.06" mass="1" rgba="0.2 0.4 0.8 1" contype="0" conaffinity="0"/>
    </body>
    <geom name="plate" type="box" size="0.05 0.03 0.002" pos="0.12 0.1 0.002" rgba="0.8 0.8 0.7 1" contype="0" conaffinity="0"/>
  </worldbody>
</mujoco>)";
}

/// A model whose labels carry text in Moon of 12 mm.
struct LabelledModel {
  std::shared_ptr<const ViewModel> model;
  std::shared_ptr<const TextureField> page;  ///< of its first label
  std::shared_ptr<const ViewPage> view_page;
};
inline LabelledModel LabelledFrom(const std::string& xml, const std::string& text = "moon") {
  const Script script = FindScript("moon");
  const auto set = [&](const std::string& words) {
    return SetText(words, script, DefaultStyle(0.012, Relief::kEngraved, script),
                   {"custom", 0.12, 0.03, 0.003});
  };
  const auto field = [&](const Typeset& typeset) {
    return std::make_shared<const TextureField>(
        PageField(typeset.pages.at(0), script, typeset.style, false));
  };
  const Typeset page = set(text);
  SceneOptions options;
  options.text_P = TextBox(page.pages.at(0), script, page.style);
  LabelledModel labelled;
  labelled.page = field(page);
  Scene scene = Scene::FromXml(xml, "test.xml", options);
  scene.SetField(labelled.page.get());
  std::vector<LaidLabel> others;
  for (std::size_t i = 1; i < scene.labels().size(); ++i) {
    const Typeset other = set(scene.labels()[i].text);
    others.push_back({i, field(other), TextBox(other.pages.at(0), script, other.style)});
    scene.SetLabel(others.back());
  }
  labelled.view_page = MakeViewPage(page, 0, script, text, labelled.page, false, 1);
  labelled.model = MakeViewModel(scene, others, text);
  return labelled;
}

}  // namespace moontrace
