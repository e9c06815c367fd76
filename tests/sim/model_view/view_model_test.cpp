#include "sim/model_view/view_model.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/sim/model_view_fixture.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

using Kind = ViewTarget::Kind;

std::string Refusal(const ViewModel& model, const char* name) {
  try {
    FindTarget(model, name);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ViewModel, NamesAreLabelsGeomsBodiesAndCameras) {
  const LabelledModel labelled = LabelledFrom(CanXml());
  const ViewModel& model = *labelled.model;
  EXPECT_EQ(FindTarget(model, "can").kind, Kind::kLabel);
  EXPECT_EQ(FindTarget(model, "plate").number, 1);
  EXPECT_EQ(FindTarget(model, "wall").kind, Kind::kGeom);
  EXPECT_EQ(FindTarget(model, "turntable").kind, Kind::kBody);
  EXPECT_EQ(FindTarget(model, "reader").kind, Kind::kCamera);
  EXPECT_EQ(FindTarget(model, "tip").kind, Kind::kTip);
  EXPECT_EQ(FindTarget(model, "whole").kind, Kind::kWhole);
}

TEST(ViewModel, AnUnknownNameIsAnsweredByTheNearest) {
  const LabelledModel labelled = LabelledFrom(CanXml());
  EXPECT_EQ(Refusal(*labelled.model, "raeder"),
            "the model has nothing named 'raeder' to look at: did you mean reader?");
  EXPECT_EQ(Refusal(*labelled.model, "xyzzy"),
            "the model has nothing named 'xyzzy' to look at: name a label, geom, body or camera");
}

TEST(ViewModel, MoontracesOwnPartsAreNotProposed) {
  const LabelledModel labelled = LabelledFrom(CanXml());
  const std::vector<std::string> names = TargetNames(*labelled.model);
  EXPECT_EQ(std::count(names.begin(), names.end(), "can"), 1);
  EXPECT_TRUE(std::none_of(names.begin(), names.end(),
                           [](const std::string& name) { return name.starts_with("moontrace_"); }));
}

}  // namespace
}  // namespace moontrace
