// Any bytes as a model, as far as this program reads it before MuJoCo does: made self-contained and
// measured, or refused with an InputError of one line; so are the labels of all its texts.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "sim/physics/label.h"
#include "sim/physics/mjcf.h"
#include "tests/fuzz/one_line.h"
#include "textures/base/error.h"

namespace {

using namespace moontrace;

constexpr char kProxy[] =
    "<mujoco><worldbody><body name=\"moontrace_proxy\"/></worldbody></mujoco>";

void ReadLabel(const pugi::xml_node& text) {
  try {
    const Label label =
        ParseLabel(text.attribute("name").value(), text.attribute("data").value(), "m.xml");
    if (label.geom.empty() || label.number < 0) std::abort();
    if (!(std::abs(label.at.x) <= 100.001 && std::abs(label.at.y) <= 100.001)) std::abort();
    if (label.size && !(*label.size > 0)) std::abort();
  } catch (const InputError& error) {
    MustBeOneLine(error.what());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string xml(reinterpret_cast<const char*>(data), size);
  try {
    const Mjcf mjcf = PrepareMjcf(xml, "", "m.xml", kProxy);
    pugi::xml_document document;
    // what is given to MuJoCo is whole
    if (!document.load_buffer(mjcf.xml.data(), mjcf.xml.size())) std::abort();
    for (const pugi::xml_node& custom : document.document_element().children("custom")) {
      for (const pugi::xml_node& text : custom.children("text")) ReadLabel(text);
    }
  } catch (const InputError& error) {
    MustBeOneLine(error.what());
  }
  return 0;
}
