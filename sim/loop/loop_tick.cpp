#include "sim/loop/loop_tick.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <utility>

#include "textures/base/finite.h"

namespace moontrace {

namespace {

/// The force goes to zero over this time before a page change, so that a page lies there within
/// 20 ms of being asked for; a fall is safe however steep, and so it is smooth to a hand (ours).
/// With the ramp-in of 0.25 s that follows, the whole change is felt for less than 0.3 s.
constexpr double kFadeTime = 0.012;
/// A tip lifted this high for this long does not feel the page go back.
constexpr double kLiftedHeight = 0.003;  ///< [m]
constexpr double kLiftedTime = 0.2;      ///< [s]
/// After this time on plain paper a tip that cannot be lifted is between words, not between two
/// strokes [s].
constexpr double kPlainTime = 1;
/// Plain paper: less than the depth of any groove, no less than the grain of paper.
constexpr double kPlainHeight = 20e-6;  ///< [m]
constexpr double kPlainSlope = 0.1;
constexpr double kReportEvery = 1;  ///< least time between two reports of one safety event [s]

bool AllFinite(const DeviceState& state) noexcept {
  return IsFinite(state.p_D) && (!state.velocity_known || IsFinite(state.v_D));
}

}  // namespace

LoopTick::LoopTick(Scene scene, const TextureField& field, std::unique_ptr<Device> device,
                   const DevicePlace& place, const LoopOptions& options, LoopMail& mail)
    : scene_(std::move(scene)),
      device_(std::move(device)),
      limits_(device_->Limits()),
      options_(options),
      mail_(mail),
      home_(place),
      place_(place),
      R_WD_(place.R_WD),
      field_(&field),
      pressing_{options.press},
      safety_(limits_, scene_.options().tick),
      tick_(scene_.options().tick),
      tip_(limits_) {
  scene_.SetField(field_);
  mail_.pose.Fit(scene_);
  reported_at_.fill(-kReportEvery);
}

void LoopTick::Run(double time, bool late) noexcept {
  // in whole ticks: the device samples by its own clock, not when this thread happens to wake
  elapsed_ = tick_ * std::max(1.0, std::round((time - time_) / tick_));
  time_ = time;
  ++ticks_;
  TakeMail();
  SafetyInput input;
  if (posted_ != nullptr && fade_ <= 0) {
    TakePage();
    ramp_ = true;
  }
  input.status = Read();
  input.time = time;
  const bool usable = device_ != nullptr && begun_ && AllFinite(state_);
  const TickResult felt = usable ? Feel() : TickResult{};
  if (felt.through && !last_.through && !let_go_) Report(LoopEventKind::kThrough);
  last_ = felt;
  flowing_ = usable && !felt.fault;
  if (!usable) Restart();
  input.device = state_;
  input.physics_fault = felt.fault;
  if (posted_ != nullptr) fade_ = std::max(0.0, fade_ - tick_ / kFadeTime);
  input.ramp = ramp_ || late;
  ramp_ = false;
  HandleButtons(time, input);
  const Wanted wanted = Want(felt, !flowing_ || IsSilent(input));
  input.force = wanted.force;

  const SafetyResult safe = safety_.Advance(input);
  Write(safe.force);
  delivered_ = fade_ >= 1 && IsWhole(safe.force, wanted.force);
  if (flowing_) ReturnPage(felt);
  // a hand cannot jump: the proxy must not be dragged along
  if ((safe.events & (1U << static_cast<unsigned>(SafetyEvent::kJump))) != 0) Restart();
  ReportSafety(safe.events);
  if (was_stopped_ && !safe.stopped) GoOn();
  was_stopped_ = safe.stopped;
  Publish(felt, safe, PushFelt(wanted, safe));
}

/// Page and push together, on the axes that push.
LoopTick::Wanted LoopTick::Want(const TickResult& felt, bool silent) noexcept {
  const GuidanceResult push = push_.Advance(!silent, felt.tip_P, v_P_, tick_);
  target_P_ = push.target_P;
  Wanted wanted;
  wanted.push = fade_ * ForceToDevice(place_, TurnToWorld(Base(), push.force_P));
  const glm::dvec3 force = options_.on_page ? felt.force_W * moves_ : felt.force_W;
  wanted.force = fade_ * ForceToDevice(place_, force) + wanted.push;
  for (int axis = 0; axis < 3; ++axis) {
    if (!limits_.pushes[axis]) wanted.force[axis] = wanted.push[axis] = 0;
  }
  return wanted;
}

/// Whether a stop or a released button asks for no force.
bool LoopTick::IsSilent(const SafetyInput& input) const noexcept {
  return input.stop || input.hold || (was_stopped_ && !input.go_on);
}

/// The share of the push in what was commanded, frame P.
glm::dvec3 LoopTick::PushFelt(const Wanted& wanted, const SafetyResult& safe) const noexcept {
  glm::dvec3 push_D = wanted.push;
  for (int axis = 0; axis < 3; ++axis) {
    const double whole = wanted.force[axis];
    if (whole != 0) push_D[axis] *= std::clamp(safe.force[axis] / whole, 0.0, 1.0);
  }
  return TurnFromWorld(Base(), place_.R_WD * push_D);
}

/// The page in the frame that DevicePlace is in.
Pose LoopTick::Base() const noexcept { return options_.on_page ? Pose() : scene_.X_WP(); }

void LoopTick::Release() noexcept {
  if (device_ != nullptr) device_->Write({0, 0, 0});
}

void LoopTick::TakeMail() noexcept {
  if (posted_ == nullptr) posted_ = mail_.wanted_page.exchange(nullptr, std::memory_order_acquire);
  if (const PostedPush* push = mail_.wanted_push.exchange(nullptr, std::memory_order_acquire)) {
    push_.Take(push->plan);
    mail_.done_push.store(push, std::memory_order_release);
  }
  if (device_ != nullptr) return;
  Device* reopened = mail_.reopened.exchange(nullptr, std::memory_order_acquire);
  if (reopened == nullptr) return;
  device_.reset(reopened);
  begun_ = false;
  ramp_ = true;
  back_ = true;
  buttons_ = ButtonState{};
  Restart();
}

/// The page's far edge at another height: the device is turned against the page, about the middle
/// of its workspace.
void LoopTick::Tilt(double tilt) noexcept {
  if (!limits_.measures.z || options_.on_page || !std::isfinite(tilt)) return;
  const double angle = scene_.options().tilt - tilt;
  const double c = std::cos(angle), s = std::sin(angle);
  const glm::dmat3 about_x(1, 0, 0, 0, c, s, 0, -s, c);  // column by column
  const glm::dmat3 R_WP = scene_.X_WP().R;
  home_.R_WD = R_WP * about_x * glm::transpose(R_WP) * R_WD_;
}

/// The swap itself, at zero force: the last command was zero and this tick begins a ramp-in.
void LoopTick::TakePage() noexcept {
  PostedPage& posted = *posted_;
  const bool known = begun_ && AllFinite(state_);
  const DevicePlace before = place_;
  const glm::dvec3 tip_P = FromWorld(Base(), ToWorld(before, state_).p_D);  // on the page before
  if (posted.tilt) Tilt(*posted.tilt);
  field_ = posted.ready.laid.field;
  page_ = posted.page;
  scene_.Swap(posted.ready);
  if (posted.place_P) {
    TakeLabel(posted, known ? &tip_P : nullptr);
  } else {
    place_ = home_;
    if ((posted.anchor || posted.tilt) && known) Anchor(posted.anchor, tip_P);
  }
  push_.Take(nullptr);
  flowing_ = false;
  if (posted.device != nullptr) {
    if (device_ != nullptr) device_->Write({0, 0, 0});
    std::swap(device_, posted.device);
    begun_ = false;
    tip_.Restart();
  }
  fade_ = 1;
  felt_nothing_for_ = 0;
  posted_ = nullptr;
  Report(LoopEventKind::kPageChanged);
  mail_.done_page.store(&posted, std::memory_order_release);
}

/// Moves the device over the page, so that the tip comes to where the anchor wants it; without one
/// to `tip_P`'s height over where it is.
void LoopTick::Anchor(const std::optional<PageAnchor>& anchor, glm::dvec3 tip_P) noexcept {
  const Pose base = Base();
  const glm::dvec3 now = FromWorld(base, ToWorld(place_, state_).p_D);
  glm::dvec3 under(now.x, now.y, tip_P.z);
  if (anchor) {
    under =
        glm::dvec3(anchor->to_P + anchor->ratio * (glm::dvec2(tip_P) - anchor->from_P), tip_P.z);
  }
  place_.origin_W += TurnToWorld(base, under - now);
}

/// Another label is the page. `tip_P`: the tip on the page before; null: not known.
void LoopTick::TakeLabel(const PostedPage& posted, const glm::dvec3* tip_P) noexcept {
  if (options_.on_page) {
    place_ = home_ = *posted.place_P;
    if (posted.anchor && tip_P != nullptr) Anchor(posted.anchor, *tip_P);
    return;
  }
  if (!posted.anchor) return;
  const PagePoint to = scene_.PointOn({posted.anchor->to_P, 0});
  const glm::dvec3 to_D = (to.p_W - place_.origin_W) * place_.R_WD / place_.scale;
  bool reached = true;
  for (int i = 0; i < 3; ++i) reached &= std::abs(to_D[i]) <= limits_.workspace_D[i];
  if (reached) return;
  place_ = home_;
  place_.origin_W = home_.origin_W = scene_.PointOn(posted.place_P->origin_W).p_W;
  Report(LoopEventKind::kModelMoved);
  if (tip_P == nullptr) return;
  // until it is lifted, the hand is over the label's plane: in nothing
  constexpr double kOver = 0.005;  // [m]
  const glm::dvec3 up = glm::normalize(to.moves[2]);
  const double height = glm::dot(ToWorld(place_, state_).p_D - to.p_W, up);
  place_.origin_W += std::max(0.0, kOver - height) * up;
}

DeviceStatus LoopTick::Read() noexcept {
  if (device_ == nullptr) return DeviceStatus::kLost;
  const DeviceStatus status = device_->Read(state_);
  if (status == DeviceStatus::kOk) begun_ = true;
  if (status == DeviceStatus::kOk && back_) {
    back_ = false;
    Report(LoopEventKind::kDeviceBack);
  }
  tip_.Advance(elapsed_, status == DeviceStatus::kOk, state_.p_D);
  if (status == DeviceStatus::kLost) Lose();
  if (status != DeviceStatus::kLost && written_ == DeviceStatus::kNotReady) return written_;
  return status;
}

TickResult LoopTick::Feel() noexcept {
  DeviceState read = state_;
  if (!read.velocity_known) read.v_D = tip_.v();
  read.p_D = tip_.p();
  read.velocity_known = true;
  DeviceState tip = ToWorld(place_, read);
  const Pose base = Base();
  v_P_ = TurnFromWorld(base, tip.v_D);
  if (!limits_.measures.z) {
    tip = Pressed(tip, base, flowing_ ? &last_ : nullptr,
                  pressing_.PressOf(state_.p_D.z, limits_.stiffness), scene_.options(), *field_);
  }
  if (options_.on_page) GoAlong(tip);
  return scene_.Tick(tip, delivered_);
}

/// From the page's coordinates to the world, wherever the page has gone. From one that flees the
/// hand lets go, and rests where it was: pressing on would carry both off ever faster.
void LoopTick::GoAlong(DeviceState& tip) noexcept {
  if (!let_go_ && flowing_ && scene_.page_goes()) {
    const glm::dvec3 gone_to_W = scene_.PointOn(along_P_).p_W;
    let_go_ = glm::distance(gone_to_W, along_W_) > kFastestPage * tick_;
    if (let_go_) Report(LoopEventKind::kPageGone);
  }
  if (let_go_) {
    moves_ = glm::dmat3(0.0);
    tip.p_D = along_W_;
    tip.v_D = {0, 0, 0};
    return;
  }
  along_P_ = tip.p_D;
  const PagePoint point = scene_.PointOn(along_P_);
  moves_ = point.moves;
  tip.p_D = along_W_ = point.p_W;
  tip.v_D = moves_ * tip.v_D;
}

void LoopTick::HandleButtons(double time, SafetyInput& input) noexcept {
  input.stop = mail_.stop.exchange(false, std::memory_order_relaxed) || (let_go_ && !was_stopped_);
  input.go_on = mail_.go_on.exchange(false, std::memory_order_relaxed);
  const std::uint32_t held = begun_ && device_ != nullptr ? state_.buttons : 0;
  input.hold = options_.hold_to_feel && (held & 1U) == 0;
  switch (AdvanceButtons(buttons_, held, time, options_.hold_to_feel)) {
    case ButtonAction::kNone:
      break;
    case ButtonAction::kSay:
      Report(LoopEventKind::kSay);
      break;
    case ButtonAction::kBookmark:
      Report(LoopEventKind::kBookmark);
      break;
    case ButtonAction::kStop:
      input.stop = true;
      break;
  }
}

void LoopTick::Write(glm::dvec3 f_D) noexcept {
  if (device_ == nullptr) return;
  written_ = device_->Write(f_D);
  if (written_ == DeviceStatus::kLost) Lose();
}

/// A lost device is given zero once more, in case it still listens, and passed to the supervising
/// thread, which destroys it.
void LoopTick::Lose() noexcept {
  device_->Write({0, 0, 0});
  written_ = DeviceStatus::kOk;
  begun_ = false;
  mail_.detached.store(device_.release(), std::memory_order_release);
}

/// The next tick of the scene begins at the tip, whatever was before.
void LoopTick::Restart() noexcept {
  scene_.Restart();
  tip_.Restart();
  push_.Pause();
  flowing_ = false;
}

/// After a stop. A hand that let go of its page comes back to it, wherever that is.
void LoopTick::GoOn() noexcept {
  if (std::exchange(let_go_, false)) Restart();
  Report(LoopEventKind::kWentOn);
}

/// Whether the tip feels neither the page as it lies nor the page back in its place: it is in the
/// air, or it cannot be lifted (a stick without an axis for that) and is on plain paper of both.
bool LoopTick::FeelsNothing(const TickResult& felt) const noexcept {
  const glm::dvec3 home_P = FromWorld(Base(), ToWorld(home_, state_).p_D);
  if (limits_.measures.z) return std::min(felt.tip_P.z, home_P.z) > kLiftedHeight;
  if (state_.p_D.z > 0) return true;
  const glm::dvec2 back_P(home_P);
  const auto is_plain = [this](glm::dvec2 p_P) {
    const Sample sample = field_->SampleAt(p_P);
    return std::abs(sample.displacement) <= kPlainHeight &&
           glm::length(sample.gradient) <= kPlainSlope;
  };
  return is_plain(glm::dvec2(felt.tip_P)) && is_plain(back_P);
}

/// After a change under a resting hand the page may lie partly beyond the device's reach. It goes
/// back to its place while the tip feels neither.
void LoopTick::ReturnPage(const TickResult& felt) noexcept {
  if (place_.origin_W == home_.origin_W) return;
  felt_nothing_for_ = FeelsNothing(felt) ? felt_nothing_for_ + tick_ : 0;
  const bool can_lift = limits_.measures.z || state_.p_D.z > 0;
  if (felt_nothing_for_ < (can_lift ? kLiftedTime : kPlainTime)) return;
  place_ = home_;
  ramp_ = true;
  Restart();
  Report(LoopEventKind::kPageBack);
}

void LoopTick::Report(LoopEventKind kind) noexcept {
  LoopEvent event;
  event.kind = kind;
  event.time = time_;
  event.page = page_;
  event.tip_P = last_.tip_P;
  mail_.events.Push(event);
}

void LoopTick::ReportSafety(std::uint32_t events) noexcept {
  const std::uint32_t begun = events & ~reported_;
  reported_ = events;
  for (std::size_t i = 0; i < kSafetyEvents; ++i) {
    const auto kind = static_cast<SafetyEvent>(i);
    const bool by_hand = kind == SafetyEvent::kStopped;  // asked for: each one is reported
    if ((begun & (1U << i)) == 0) continue;
    if (!by_hand && time_ - reported_at_[i] < kReportEvery) continue;
    reported_at_[i] = time_;
    LoopEvent event;
    event.safety = kind;
    event.time = time_;
    event.page = page_;
    event.tip_P = last_.tip_P;
    mail_.events.Push(event);
  }
}

void LoopTick::Publish(const TickResult& felt, const SafetyResult& safe,
                       glm::dvec3 push_P) noexcept {
  LoopSnapshot snapshot;
  snapshot.tick = ticks_;
  snapshot.time = time_;
  snapshot.page = page_;
  snapshot.device = state_;
  snapshot.present = device_ != nullptr;
  snapshot.stopped = safe.stopped;
  snapshot.tip_P = felt.tip_P;
  snapshot.proxy_P = felt.proxy_P;
  snapshot.force_D = safe.force;
  // of a device without motors: what the page would do
  snapshot.force_P =
      glm::any(limits_.pushes) ? TurnFromWorld(Base(), place_.R_WD * safe.force) : felt.force_P;
  snapshot.guidance_P = push_P;
  snapshot.target_P = target_P_;
  snapshot.guided = push_.guided();
  snapshot.guidance_done = push_.done();
  snapshot.depth = felt.depth;
  snapshot.geom = felt.geom;
  snapshot.gives = scene_.gives(felt.geom);
  snapshot.heat = safe.heat;
  snapshot.safety_counts = safety_.counts();
  mail_.snapshot.Put(snapshot);
  mail_.pose.Put(scene_);
  if (device_ == nullptr || !begun_) return;
  LoopSample sample;
  sample.time = time_;
  sample.page = page_;
  sample.tip_P = felt.tip_P;
  sample.force_P = snapshot.force_P;
  sample.guidance_P = push_P;
  sample.energy_out = felt.energy_out;
  sample.in_contact = felt.depth > 0;
  sample.through = felt.through;
  sample.fault = felt.fault;
  mail_.samples.Push(sample);
}

}  // namespace moontrace
