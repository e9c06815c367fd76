#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lessons/measure/intended_strokes.h"
#include "sim/physics/scene_pose.h"
#include "textures/field/element.h"
#include "textures/field/field.h"
#include "textures/fonts/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// A page as the viewer shows it; never changed once it is shown, shared by threads.
struct ViewPage {
  std::uint32_t number = 0;                   ///< LoopSnapshot::page
  std::shared_ptr<const TextureField> field;  ///< never null
  Box sheet_P;                                ///< the paper [m]
  double width = 0;                           ///< of a groove [m]
  struct Letter {
    Box box_P;          ///< its em box [m]
    std::string print;  ///< the characters it stands for; empty: none
    /// Up the page [m], where its print keeps clear of its line's strokes, of rules and of a
    /// raised margin; without these only at its top.
    double print_top = 0, print_bottom = -HUGE_VAL;
  };
  std::vector<Letter> letters;  ///< one a glyph of the page, in its order
  /// In writing order; IntendedStroke::glyph is an index into `letters`. None on a blank page.
  std::vector<IntendedStroke> strokes;
};

/// The page `index` of a set, from 0. `source`: the text that was set. `field`: the page's own
/// (PageField), the one that is felt. `blank`: paper without grooves.
std::shared_ptr<const ViewPage> MakeViewPage(const Typeset& set, std::size_t index,
                                             const Script& script, std::string_view source,
                                             std::shared_ptr<const TextureField> field, bool blank,
                                             std::uint32_t number);

/// The same page, its letters standing for nothing: what lies there is asked.
std::shared_ptr<const ViewPage> WithoutPrint(const ViewPage& page);

/// The same page, its paper drawn on round the text, so that this can stand in the middle of a
/// view: for trials, which lie on a plane without edges.
std::shared_ptr<const ViewPage> WithPaperAround(const ViewPage& page);

/// What the viewer shows of one instant. Frame P of the page `page`.
struct ViewMoment {
  double time = 0;                              ///< since the loop or trial began [s]
  std::uint32_t page = 0;                       ///< ViewPage::number
  bool present = false;                         ///< there is a stylus
  bool in_contact = false;                      ///< it touches the page
  bool stopped = false;                         ///< force rests
  glm::dvec3 tip_P{0, 0, 0}, proxy_P{0, 0, 0};  ///< [m]
  glm::dvec3 force_P{0, 0, 0};                  ///< on the hand [N]
  glm::dvec3 guidance_P{0, 0, 0};               ///< the push within it [N]
  std::optional<glm::dvec2> bead_P;             ///< where the push leads [m]
  double lateness_us = 0;                       ///< of the tick, after its deadline [us]
  double heat = 0;                              ///< of the warmest motor, share of what it bears
  /// Where a model's bodies stand; null: as before, or a page is shown.
  std::shared_ptr<const ScenePose> pose;
};

}  // namespace moontrace
