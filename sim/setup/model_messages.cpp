#include "sim/setup/model_messages.h"

#include <fmt/core.h>

#include "sim/console/wording.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

std::string PageMoves(std::string_view geom) {
  return fmt::format("The geom '{}' can move: no force bound holds for it.", OneLine(geom));
}

std::string PagesOnGeom(std::size_t pages, std::string_view geom, bool from_middle) {
  return fmt::format(
      "{} pages: the text does not fit on the geom '{}', one lies on it at a time.{}", pages,
      OneLine(geom),
      from_middle ? " Its corner lies in the middle of the face: middle_mm=[0,0] in "
                    "the label gives it all of that."
                  : "");
}

std::string GeomIsSmaller(std::string_view geom, const PageSpec& sheet) {
  return fmt::format("--page is larger than the geom '{}': the text is set on its {} by {} mm.",
                     OneLine(geom), Short(kMillimetres * sheet.width, 1),
                     Short(kMillimetres * sheet.height, 1));
}

std::string LabelLacksText(std::string_view model, std::string_view geom) {
  return fmt::format("{}: label on '{}' has no text: write text='...' in it, or give a text", model,
                     OneLine(geom));
}

std::string NoSuchLabel(std::string_view model, std::string_view label, std::string_view labels,
                        std::string_view nearest) {
  const std::string mend = nearest.empty() ? fmt::format("it has {}", OneLine(labels))
                                           : fmt::format("did you mean '{}'?", OneLine(nearest));
  return fmt::format("{}: no label '{}': {}", model, OneLine(label), mend);
}

std::string LabelNeedsModel() { return "--label needs --model: name the model whose label it is."; }

std::string OneLabelOnly() { return "--label all is for trace: name one label here."; }

std::string NoLabelHasText(std::string_view model) {
  return fmt::format("{}: no label has a text: write text='...' in one", model);
}

std::string LabelHasNoRoom(std::string_view model, std::string_view label, double size,
                           glm::dvec2 text, std::size_t pages) {
  const std::string extent =
      fmt::format("{} by {} mm", Short(kMillimetres * text.x, 0), Short(kMillimetres * text.y, 0));
  return fmt::format(
      "{}: label on '{}': its text has no room there: with size_mm {} it takes {}; make size_mm "
      "smaller or move it",
      model, OneLine(label), Short(kMillimetres * size, 1),
      pages > 1 ? fmt::format("{} pages, the first of {}", pages, extent) : extent);
}

std::string LabelsLieTogether(std::string_view model, std::string_view a, std::string_view b) {
  return fmt::format("{}: labels '{}' and '{}' lie on one place: move one of them", model,
                     OneLine(a), OneLine(b));
}

std::string LengthsErr(std::string_view label, double error) {
  return fmt::format("Lengths on '{}' err by up to {} percent: the geom is round.", OneLine(label),
                     Short(100 * error, 1));
}

std::string OfLabel(std::string_view label, std::string_view text) {
  return fmt::format("Label {}: {}", OneLine(label), OneLine(text));
}

std::string InLabel(std::string_view model, std::string_view geom, std::string_view error) {
  return fmt::format("{}: label on '{}': {}", model, OneLine(geom), error);
}

}  // namespace moontrace::say
