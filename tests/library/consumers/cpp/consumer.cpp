// A tip goes along the groove of an I: how deep it is, and what it feels there.
//   consumer PICTURE
#include <cmath>
#include <cstdio>
#include <moontrace.hpp>
#include <vector>

namespace {

/// Deepest of a row of samples [m].
double DeepestOf(const std::vector<moontrace::Sample>& samples) {
  double deepest = 0;
  for (const moontrace::Sample& sample : samples) deepest = std::fmin(deepest, sample.displacement);
  return deepest;
}

int Run(const char* picture) {
  const moontrace::Script script("moon");
  moontrace::Style style;
  style.sheet = "60x50";
  style.letter_size = 0.020;
  const moontrace::Text text(script, "i", style);
  const moontrace::Page page(text);
  const moontrace::Letter letter = page.letters().at(0);
  std::vector<moontrace::Point> across;
  std::vector<moontrace::Tip> tips;
  for (int i = 0; i < 200; ++i) {
    across.push_back({letter.at.x + 0.0001 * i, letter.at.y + 0.010});
    tips.push_back({across.back().x, across.back().y, -0.0001});
  }
  const std::vector<moontrace::Sample> samples = page.SamplesAt(across);
  const std::vector<moontrace::Force> forces = page.ForcesOn(tips);
  const double deepest = DeepestOf(samples), depth = text.facts().depth;
  // within the 0.05 mm between two points, at a slope of about 1
  if (!(std::fabs(deepest + depth) < 0.0001)) return 1;
  bool free = false, pressed = false;
  for (std::size_t i = 0; i < tips.size(); ++i) {
    free = free || forces[i].z == 0;       // in the groove, above its floor
    pressed = pressed || forces[i].z > 0;  // on the paper beside it
    if (forces[i].z != page.ForceOn(tips[i]).z) return 2;
    if (samples[i].displacement != page.SampleAt(across[i]).displacement) return 3;
  }
  if (!free || !pressed) return 4;
  page.Draw(picture, true);
  try {
    page.SampleAt({std::nan(""), 0});
    return 5;
  } catch (const moontrace::Error& error) {
    if (error.code() != MOONTRACE_BAD_CALL) return 6;
  }
  std::printf("%s: %s, %.2f mm deep\n", script.facts().title, letter.sign.c_str(), -1000 * deepest);
  return 0;
}

}  // namespace

int main(int count, char** words) {
  try {
    return count == 2 ? Run(words[1]) : 7;
  } catch (const moontrace::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 8;
  }
}
