#include "sim/view/model_part.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "sim/model_view/model_words.h"
#include "sim/model_view/visibility.h"
#include "sim/physics/felt_object.h"

namespace moontrace {

namespace {

constexpr double kUnitsPerNewton = 8;  // of a drawn arrow, in hundredths of the picture
constexpr double kLeastArrow = 0.02;   // forces below are not drawn [N]
constexpr double kPaper = 0.6;         // how little is seen through what print stands on
constexpr double kPaperEdge = 1;       // of that, over and under the letters [points]
constexpr double kLift = 0.2;          // of lines over the surface [hundredths of the picture]

const ViewModel::Label& PageOf(const ViewModel& model) { return model.labels[model.page]; }

/// Where there may be something of a page: on a flat face all of its sheet, round ones as far as
/// the text goes.
Box AreaOf(const ViewPage& page, const ViewModel::Label& label) {
  Box text;
  for (const ViewPage::Letter& letter : page.letters) Include(text, letter.box_P);
  if (label.text_P.min.x <= label.text_P.max.x) Include(text, label.text_P);
  if (page.letters.empty()) return label.text_P;
  Box area = Grown(text, 3 * page.width);
  if (label.chart.place().face == Face::kRound) return area;
  Include(area, page.sheet_P);
  const Box room = RoomOn(label.solid, label.chart.place().face);
  const bool straight = label.chart.place().turn == 0;
  if (!straight || !std::isfinite(room.max.x) || !std::isfinite(room.max.y)) return area;
  const glm::dvec2 shift = label.chart.place().on_page - label.chart.place().on_face;
  return {glm::max(area.min, room.min + shift), glm::min(area.max, room.max + shift)};
}

}  // namespace

ModelPart::ModelPart(std::shared_ptr<const ViewModel> model, int width, int height)
    : model_(std::move(model)), width_(width), height_(height), scene_(model_, width, height) {
  X_WP_ = model_->start.X_WP;
}

void ModelPart::Continue(const ModelPart& before) {
  scene_.camera = before.scene_.camera;
  looks_ = before.looks_;
  follow_ = before.follow_;
  target_ = before.target_;
  if (before.now_) Add(*before.now_);
}

void ModelPart::ShowPage(const ViewPage& page) {
  scene_.SetPage(page.field, AreaOf(page, PageOf(*model_)));
}

void ModelPart::Add(const ViewMoment& moment) {
  std::shared_ptr<const ScenePose> pose = moment.pose;
  if (pose == nullptr && now_) pose = now_->pose;
  now_ = moment;
  now_->pose = pose;
  if (moment.pose == nullptr) return;
  scene_.SetPose(*moment.pose);
  X_WP_ = moment.pose->X_WP;
}

void ModelPart::LookAt(const ViewTarget& target, double aspect) {
  const glm::dvec3 tip_W = now_ && now_->present ? ToWorld(X_WP_, now_->tip_P) : X_WP_.p;
  follow_ = target.kind == ViewTarget::Kind::kTip;
  scene_.camera = CameraOn(*model_, scene_.data(), target, scene_.camera, tip_W, aspect);
  looks_ = true;
  target_ = target;
}

/// A camera of the model stands where it stands: from here on it is ours.
void ModelPart::Free(double aspect) {
  target_ = {};
  if (scene_.camera.type == mjCAMERA_FREE) return;
  const Sight sight = scene_.Look(aspect);
  const double distance = std::max(sight.DepthOf(X_WP_.p), 0.05);
  scene_.camera = Freed(scene_.camera, sight, distance);
}

void ModelPart::Turn(glm::dvec2 by, double aspect) {
  Free(aspect);
  moontrace::Turn(scene_.camera, by);
}

void ModelPart::Shift(glm::dvec2 by, double aspect) {
  Free(aspect);
  moontrace::Shift(scene_.camera, scene_.Look(aspect), by);
}

void ModelPart::Zoom(glm::dvec2 share, double factor, double aspect) {
  Free(aspect);
  moontrace::Zoom(scene_.camera, scene_.Look(aspect), share, factor);
}

std::optional<glm::dvec2> ModelPart::PointUnder(glm::dvec2 share, double aspect) {
  const ViewModel::Label& label = PageOf(*model_);
  const Sight::Ray ray = scene_.Look(aspect).RayUnder(share);
  const double from[3] = {ray.from_W.x, ray.from_W.y, ray.from_W.z};
  const double along[3] = {ray.along_W.x, ray.along_W.y, ray.along_W.z};
  const double far = DistanceOnRay(*model_->m, scene_.data(), label.geom, from, along);
  if (far < 0) return std::nullopt;
  const Pose X_WG = PoseOfGeom(scene_.data(), label.geom);
  return label.chart.At(FromWorld(X_WG, ray.from_W + far * ray.along_W)).p_P;
}

/// The tip stays within the middle of the picture.
void ModelPart::Follow(double aspect) {
  if (!follow_ || !now_ || !now_->present) return;
  const glm::dvec3 tip_W = ToWorld(X_WP_, now_->tip_P);
  const std::optional<glm::dvec2> share = scene_.Look(aspect).ShareOf(tip_W);
  const bool near = share && std::abs(share->x - 0.5) < 0.25 && std::abs(share->y - 0.5) < 0.25;
  if (near) return;
  if (scene_.camera.type != mjCAMERA_FREE) Free(aspect);
  moontrace::LookAt(scene_.camera, tip_W);
}

glm::dvec3 ModelPart::OnLabel(glm::dvec3 p_P) const {
  const ViewModel::Label& label = PageOf(*model_);
  return ToWorld(PoseOfGeom(scene_.data(), label.geom), label.chart.ToObject(p_P));
}

SceneMarks ModelPart::MarksInWorld(const ViewMarks& marks, const Sight& sight) const {
  SceneMarks world;
  const double unit = 0.01 * sight.HeightAt(X_WP_.p);
  const auto over = [&](glm::dvec3 p_P) {
    return OnLabel({p_P.x, p_P.y, std::max(p_P.z, 0.0) + kLift * unit});
  };
  for (std::size_t i = 1; i < marks.path.size(); ++i) {
    if (marks.path[i].begins) continue;
    world.lines.push_back(
        {over(marks.path[i - 1].p_P), over(marks.path[i].p_P), 3.5,
         Mixed(view_color::kOnStroke, view_color::kOffStroke, std::min(marks.path[i].off, 1.0))});
  }
  for (const std::vector<Piece>& pieces : marks.stroke_P) {
    for (const Piece& piece : pieces) {
      const double length = Length(piece);
      const int count = std::clamp(static_cast<int>(length / unit), 1, 100);
      for (int i = 0; i < count; ++i) {
        world.lines.push_back({over({PointAt(piece, length * i / count), 0}),
                               over({PointAt(piece, length * (i + 1) / count), 0}), 3,
                               view_color::kLetter});
      }
    }
  }
  if (marks.bead_P) {
    world.balls.push_back({OnLabel({*marks.bead_P, 0}), 0.9 * unit, view_color::kGuidance, 0.8});
  }
  if (!marks.tip_P) return world;
  if (marks.proxy_P) {
    world.balls.push_back({ToWorld(X_WP_, *marks.proxy_P), 0.6 * unit, view_color::kForce, 1});
  }
  const glm::dvec3 tip_W = ToWorld(X_WP_, *marks.tip_P);
  const auto arrow = [&](glm::dvec3 force_P, const Color& color) {
    if (glm::length(force_P) < kLeastArrow) return;
    const glm::dvec3 to_W = tip_W + kUnitsPerNewton * unit * TurnToWorld(X_WP_, force_P);
    world.arrows.push_back({tip_W, to_W, 0.4 * unit, color});
  };
  arrow(marks.force_P, view_color::kForce);
  arrow(marks.guidance_P, view_color::kGuidance);
  return world;
}

void ModelPart::Draw(const ViewPage* page, const ViewHistory& history, const ViewLook& look,
                     const PixelBox& box, const Letters& letters) {
  const double aspect = static_cast<double>(box.width) / box.height;
  if (!looks_) {
    LookAt({ViewTarget::Kind::kLabel, static_cast<int>(model_->page)}, aspect);
  }
  Follow(aspect);
  scene_.ShowTip(now_ && now_->present);
  scene_.SetHighContrast(look.high_contrast);
  const Sight sight = scene_.Look(aspect);
  ViewMarks marks;
  print_.clear();
  if (page != nullptr) {
    // letters as large as they would be on a page that far away
    Box text;
    for (const ViewPage::Letter& letter : page->letters) Include(text, letter.box_P);
    PageCamera flat;
    if (!page->letters.empty()) flat.at_P = 0.5 * (text.min + text.max);
    flat.height = sight.HeightAt(OnLabel({flat.at_P, 0}));
    marks =
        MarksOf(*page, history, flat, aspect, look.print, box.height, letters.small, letters.big);
    for (ViewMarks::Print& print : marks.print) {
      const glm::dvec3 p_W = OnLabel({print.at_P, 0});
      const glm::dvec3 above_W = OnLabel({print.at_P, 1e-3}) - p_W;
      constexpr double kSlant = 0.3;  // of what is turned farther away nothing is read
      if (glm::dot(glm::normalize(above_W), sight.ToEye(p_W)) < kSlant) continue;
      if (HiddenBy(*model_, scene_.data(), PageOf(*model_), sight.eye_W, p_W) >= 0) continue;
      const double half = 0.5 * (print.big ? letters.big : letters.small);
      const glm::dvec2 edge_P = print.at_P + glm::dvec2(0, half * flat.height / box.height);
      const auto share = sight.ShareOf(p_W), edge = sight.ShareOf(OnLabel({edge_P, 0}));
      if (!share || !edge) continue;
      const glm::dvec2 picture(box.width, box.height);
      const glm::dvec2 at = UprightPrint(*share * picture, *edge * picture, half + kPaperEdge);
      print_.push_back({at / picture, std::move(print.text), print.big});
    }
  }
  scene_.Draw(MarksInWorld(marks, sight), box.x, box.y, box.width, box.height);
}

void ModelPart::DrawPrint(const PixelBox& box, Canvas& canvas) const {
  for (const Print& print : print_) {
    const int width = canvas.TextWidth(print.text, print.big);
    const int height = canvas.TextHeight(print.big);
    const int x = box.x + static_cast<int>(print.share.x * box.width) - width / 2;
    const int y = box.y + static_cast<int>(print.share.y * box.height) - height / 2;
    const bool inside = x >= box.x && y >= box.y && x + width <= box.x + box.width &&
                        y + height <= box.y + box.height;
    if (!inside) continue;
    // whatever the colour of the geom
    const glm::dvec2 low(x - 2, y - kPaperEdge), high(x + width + 2, y + height + kPaperEdge);
    canvas.Shape({low, {high.x, low.y}, high, {low.x, high.y}}, {1, 1, 1}, kPaper);
    canvas.Text(print.text, x, y, print.big, view_color::kPrint);
  }
}

std::vector<std::string> ModelPart::Seen(double aspect) {
  std::optional<SeenTip> tip;
  if (now_ && now_->present) {
    tip = SeenTip{ToWorld(X_WP_, now_->tip_P), now_->tip_P.z, now_->in_contact};
  }
  return WordsOfView(*model_, scene_.data(), scene_.Look(aspect), target_, tip);
}

}  // namespace moontrace
