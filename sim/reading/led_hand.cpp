#include "sim/reading/led_hand.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "textures/base/random.h"

namespace moontrace {
namespace {

constexpr double kApproach = 0.005;  ///< the hand is put so far above the paper [m]
constexpr double kFromEdge =
    0.003;  ///< and so far within an object's face, where there is room [m]

constexpr double kRoughly = 0.001;  ///< a hand that is put on a face errs about its sides [m]

/// The face that carries the page, in frame P; none: a plane, which goes on.
std::optional<ReaderFace> FaceOf(const Scene& scene) {
  const std::size_t label = scene.options().label;
  const Solid solid = scene.solids()[label];
  if (solid.kind == SolidKind::kPlane) return std::nullopt;
  const LabelPlace& place = scene.laid(label).chart.place();
  const Box room = RoomOn(solid, place.face);
  ReaderFace face;
  face.half = 0.5 * (room.max - room.min);
  face.turn = -place.turn;
  const ReaderFace about_page{place.on_page, {0, 0}, -place.turn};
  face.middle = about_page.FromOwn(0.5 * (room.min + room.max) - place.on_face);
  return face;
}

Scene SceneFor(const LedHandSetup& setup) {
  Scene scene = Scene::Load(setup.model_path, setup.scene);
  if (setup.device) scene.SetOptions(HeldOn(*setup.device, setup.scene, scene.proxy_mass()));
  scene.SetField(setup.field);
  for (const LaidLabel& other : setup.others) scene.SetLabel(other);
  return scene;
}

}  // namespace

/// The led stylus as the scene's frame sees it.
class LedHand::Stylus final : public Device {
 public:
  Stylus(const LedStylus& stylus, const SheetUnderHand& sheet) : stylus_(stylus), sheet_(sheet) {}
  void Lead(const LedAim& aim) noexcept { stylus_.Lead(aim); }
  DeviceLimits Limits() const noexcept override { return stylus_.Limits(); }
  DeviceStatus Read(DeviceState& state) noexcept override {
    const DeviceStatus status = stylus_.Read(state);
    p_ = state.p_D;
    state.p_D = sheet_.ToWorldFrame(p_);
    return status;
  }
  DeviceStatus Write(glm::dvec3 f_W) noexcept override {
    return stylus_.Write(sheet_.ToHandFrame(sheet_.ToPageFrame(f_W, p_)));
  }
  glm::dvec3 p() const noexcept { return p_; }  ///< where it was read last, in its own frame [m]

 private:
  glm::dvec3 p_{0, 0, 0};
  LedStylus stylus_;
  SheetUnderHand sheet_;
};

LedHand::LedHand(const LedHandSetup& setup)
    : tick_(setup.scene.tick),
      field_(setup.field),
      scene_(SceneFor(setup)),
      face_(setup.model_path.empty() ? std::nullopt : FaceOf(scene_)),
      start_P_(face_ ? face_->Held(setup.start_P, kFromEdge) : setup.start_P),
      sheet_(scene_.X_WP(), start_P_, setup.page_turn),
      knowledge_(setup.knowledge),
      senses_(setup.senses.delay, tick_, {0, {0, 0, kApproach}, {0, 0, 0}}),
      unsure_(setup.senses.unsure, tick_, ~setup.hand_seed) {
  const bool goes = scene_.page_goes() && !scene_.page_falls();
  if (!scene_.page_is_flat() || goes) sheet_.GoAlong(&scene_);
  HandModel hand = setup.hand;
  // of a small round object the grooves are felt at a lighter press only, which a hand finds
  if (face_ && !setup.press_given) hand.press = std::min(hand.press, scene_.groove_press());
  if (setup.device) hand.late_ticks = 0;  // the delay is the device's
  PutHand(setup, hand);
  Tell(setup, hand.press);
}

LedHand::~LedHand() = default;

void LedHand::PutHand(const LedHandSetup& setup, const HandModel& hand) {
  const glm::dvec3 start{0, 0, kApproach};
  auto stylus = std::make_unique<Stylus>(
      LedStylus(hand, setup.muscle, start, tick_, setup.hand_seed), sheet_);
  stylus_ = stylus.get();
  HandOnDevice::Setup on_device;
  on_device.hand = setup.hand;
  on_device.tick = tick_;
  on_device.profile = setup.device ? &*setup.device : nullptr;
  on_device.press = hand.press;
  device_.emplace(std::move(stylus), on_device, scene_.X_WP());
  scene_.Reset({start_P_.x, start_P_.y, kApproach});
}

/// What a hand finds of its device and of an object: of its sides to within a millimetre or so.
void LedHand::Tell(const LedHandSetup& setup, double press) {
  knowledge_.press = press;
  if (setup.device) knowledge_.device_stiffness = scene_.options().coupling_stiffness;
  if (setup.device) knowledge_.feels_height = setup.device->limits.measures.z;
  if (!face_) return;
  Random random(setup.hand_seed ^ setup.reader_seed);
  const auto about = [&random] { return kRoughly * (2 * random.Uniform() - 1); };
  const double up = about(), right = about(), higher = about(), wider = about();
  const glm::dvec2 off_P = face_->middle - start_P_ + glm::dvec2(right, up);
  const glm::dvec3 middle = sheet_.ToHandFrame({off_P, 0});
  knowledge_.face = ReaderFace{glm::dvec2(middle), face_->half + glm::dvec2(wider, higher),
                               face_->turn + setup.page_turn};
}

ReaderInput LedHand::Feel() {
  const DeviceState input = device_->Read(scene_, begun_ ? &felt_ : nullptr, *field_);
  begun_ = true;
  felt_ = scene_.Tick(input);
  device_->Write(felt_.force_W, felt_.stored);
  const glm::dvec3 force_P = sheet_.ToPageFrame(device_->Given(felt_.force_W), stylus_->p());
  ReaderInput now{input.time, sheet_.FromWorldFrame(device_->reported_W()),
                  sheet_.ToHandFrame(force_P)};
  now.tip += glm::dvec3(unsure_.Next(), 0);
  return senses_.Pass(now);
}

void LedHand::Lead(const ReaderAction& action) { stylus_->Lead({action.aim, action.press}); }

}  // namespace moontrace
