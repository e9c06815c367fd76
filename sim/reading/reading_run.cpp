#include "sim/reading/reading_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <string>

#include "sim/console/console.h"
#include "sim/reader/hatch_reader.h"
#include "sim/reader/reader.h"
#include "sim/trial/hand_on_device.h"
#include "textures/base/resources.h"

namespace moontrace {
namespace {

/// The sheet lies turned under the hand, whose frame begins where the hand was put.
class Sheet {
 public:
  Sheet(const Pose& X_WP, glm::dvec2 start_P, double turn)
      : X_WP_(X_WP), start_P_(start_P), c_(std::cos(turn)), s_(std::sin(turn)) {}
  glm::dvec2 ToPage(glm::dvec2 p) const noexcept {
    return start_P_ + glm::dvec2(c_ * p.x + s_ * p.y, c_ * p.y - s_ * p.x);
  }
  /// The page is round or moves, and the hand goes along: its coordinates are the page's, wherever
  /// that is. `scene` outlives this.
  void GoAlong(const Scene* scene) noexcept { scene_ = scene; }
  glm::dvec3 ToWorldFrame(glm::dvec3 p) const noexcept {
    const glm::dvec3 p_P(ToPage(glm::dvec2(p)), p.z);
    return scene_ != nullptr ? scene_->PointOn(p_P).p_W : ToWorld(X_WP_, p_P);
  }
  /// The force on a hand at `p`: its work is the same in both coordinates.
  glm::dvec3 ToPageFrame(glm::dvec3 f_W, glm::dvec3 p) const noexcept {
    if (scene_ == nullptr) return TurnFromWorld(X_WP_, f_W);
    return f_W * scene_->PointOn({ToPage(glm::dvec2(p)), p.z}).moves;
  }
  /// A place in the world, as the hand has it.
  glm::dvec3 FromWorldFrame(glm::dvec3 p_W) const noexcept {
    const glm::dvec3 p_P = FromWorld(scene_ != nullptr ? scene_->X_WP() : X_WP_, p_W);
    return ToHandFrame({p_P.x - start_P_.x, p_P.y - start_P_.y, p_P.z});
  }
  glm::dvec3 ToHandFrame(glm::dvec3 f_P) const noexcept {
    return {c_ * f_P.x - s_ * f_P.y, s_ * f_P.x + c_ * f_P.y, f_P.z};
  }

 private:
  Pose X_WP_;
  const Scene* scene_ = nullptr;
  glm::dvec2 start_P_;
  double c_, s_;
};

/// The led stylus as the scene's frame sees it.
class StylusOnSheet final : public Device {
 public:
  StylusOnSheet(const LedStylus& stylus, const Sheet& sheet) : stylus_(stylus), sheet_(sheet) {}
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
  Sheet sheet_;
};

/// What was felt some time ago.
class LateSenses {
 public:
  LateSenses(double delay, double tick, const ReaderInput& before)
      : kept_(static_cast<std::size_t>(std::lround(delay / tick)) + 1, before) {}
  ReaderInput Pass(const ReaderInput& now) noexcept {
    kept_[slot_] = now;
    slot_ = slot_ + 1 == kept_.size() ? 0 : slot_ + 1;
    ReaderInput late = kept_[slot_];
    late.time = now.time;
    return late;
  }

 private:
  std::vector<ReaderInput> kept_;
  std::size_t slot_ = 0;
};

/// How a path is drawn where the reader was at this.
TracePhase PhaseOf(ReaderActivity activity) {
  switch (activity) {
    case ReaderActivity::kSearching:
    case ReaderActivity::kCrossing:
    case ReaderActivity::kHatching:
      return TracePhase::kTravel;
    case ReaderActivity::kFollowing:
    case ReaderActivity::kTurning:
      return TracePhase::kStroke;
    default:
      return TracePhase::kAir;
  }
}

void Keep(std::vector<PathPoint>& path, const TickResult& felt, ReaderActivity activity,
          double spacing) {
  if (spacing <= 0) return;
  PathPoint point;
  point.tip_P = felt.proxy_P;
  point.in_contact = felt.depth > 0;
  point.phase = PhaseOf(activity);
  if (!path.empty() && path.back().in_contact == point.in_contact &&
      path.back().phase == point.phase && glm::distance(path.back().tip_P, point.tip_P) < spacing) {
    return;
  }
  path.push_back(point);
}

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

}  // namespace

/// The hand on its device, of which the caller keeps the stylus in sight.
HandOnDevice OnDevice(std::unique_ptr<StylusOnSheet> stylus, const ReadingSetup& setup,
                      double press, const Pose& X_WP) {
  HandOnDevice::Setup on_device;
  on_device.hand = setup.hand;
  on_device.tick = setup.scene.tick;
  on_device.profile = setup.device ? &*setup.device : nullptr;
  on_device.press = press;
  return {std::move(stylus), on_device, X_WP};
}

namespace {

std::unique_ptr<PageReader> ReaderFor(const ReaderKnowledge& knowledge, double tick,
                                      std::uint64_t seed) {
  if (knowledge.followed) return std::make_unique<Reader>(knowledge, tick, seed);
  return std::make_unique<HatchReader>(knowledge, tick);
}

}  // namespace

ReadingResult RunReading(const ReadingSetup& setup) {
  Scene scene = Scene::Load(setup.model_path, setup.scene);
  if (setup.device) scene.SetOptions(HeldOn(*setup.device, setup.scene, scene.proxy_mass()));
  scene.SetField(setup.field);
  for (const LaidLabel& other : setup.others) scene.SetLabel(other);
  const bool on_page = !scene.page_is_flat() || (scene.page_goes() && !scene.page_falls());
  std::optional<ReaderFace> face;
  if (!setup.model_path.empty()) face = FaceOf(scene);
  const glm::dvec2 start_P = face ? face->Held(setup.start_P, kFromEdge) : setup.start_P;
  Sheet sheet(scene.X_WP(), start_P, setup.page_turn);
  if (on_page) sheet.GoAlong(&scene);
  const double tick = setup.scene.tick;
  const glm::dvec3 start{0, 0, kApproach};
  HandModel hand = setup.hand;
  // of a small round object the grooves are felt at a lighter press only, which a hand finds
  if (face && !setup.press_given) hand.press = std::min(hand.press, scene.groove_press());
  if (setup.device) hand.late_ticks = 0;  // the delay is the device's
  auto made = std::make_unique<StylusOnSheet>(
      LedStylus(hand, setup.muscle, start, tick, setup.hand_seed), sheet);
  StylusOnSheet& stylus = *made;
  HandOnDevice device = OnDevice(std::move(made), setup, hand.press, scene.X_WP());
  scene.Reset({start_P.x, start_P.y, kApproach});
  ReaderKnowledge knowledge = setup.knowledge;
  knowledge.press = hand.press;
  if (setup.device) knowledge.device_stiffness = scene.options().coupling_stiffness;
  if (setup.device) knowledge.feels_height = setup.device->limits.measures.z;
  if (face) {
    // a hand knows it to within a millimetre or so
    Random random(setup.hand_seed ^ setup.reader_seed);
    const auto about = [&random] { return kRoughly * (2 * random.Uniform() - 1); };
    const double up = about(), right = about(), higher = about(), wider = about();
    const glm::dvec2 off_P = face->middle - start_P + glm::dvec2(right, up);
    const glm::dvec3 middle = sheet.ToHandFrame({off_P, 0});
    knowledge.face = ReaderFace{glm::dvec2(middle), face->half + glm::dvec2(wider, higher),
                                face->turn + setup.page_turn};
  }
  const std::unique_ptr<PageReader> made_reader = ReaderFor(knowledge, tick, setup.reader_seed);
  PageReader& reader = *made_reader;
  LateSenses senses(setup.senses.delay, tick, {0, start, {0, 0, 0}});
  UnsurePlace unsure(setup.senses.unsure, tick, ~setup.hand_seed);

  ReadingResult result;
  const auto begin = std::chrono::steady_clock::now();
  const auto most = static_cast<std::size_t>(setup.longest / tick);
  TickResult felt;
  bool through = false;
  std::size_t n = 0;
  for (; n < most && !reader.done(); ++n) {
    if (setup.stop != nullptr && setup.stop->load(std::memory_order_relaxed)) throw Interrupted();
    if (setup.alive && n % 1000 == 0) setup.alive();
    const DeviceState input = device.Read(scene, n > 0 ? &felt : nullptr, *setup.field);
    felt = scene.Tick(input);
    device.Write(felt.force_W, felt.stored);
    const glm::dvec3 force_P = sheet.ToPageFrame(device.Given(felt.force_W), stylus.p());
    ReaderInput now{input.time, sheet.FromWorldFrame(device.reported_W()),
                    sheet.ToHandFrame(force_P)};
    now.tip += glm::dvec3(unsure.Next(), 0);
    if (felt.through && !through) ++result.through;
    through = felt.through;
    const ReaderInput late = senses.Pass(now);
    const ReaderAction action = reader.Step(late);
    result.seconds[static_cast<std::size_t>(reader.activity())] += tick;
    if (setup.watch) setup.watch({static_cast<double>(n) * tick, late, reader, felt, scene});
    stylus.Lead({action.aim, action.press});
    Keep(result.path, felt, reader.activity(), setup.path_spacing);
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  result.tokens = reader.tokens();
  for (ReadToken& token : result.tokens) {
    token.place.origin = sheet.ToPage(token.place.origin);
    token.place.turn -= setup.page_turn;
  }
  result.ended = reader.done();
  result.duration = static_cast<double>(n) * tick;
  result.real_time_factor = result.duration / std::max(elapsed.count(), 1e-9);
  return result;
}

namespace {

/// Forms of a sign count as that sign: of each glyph its own number or that of its plain form.
std::vector<int> PlainForms(const Script& script) {
  std::vector<int> plain(script.glyphs.size());
  for (std::size_t i = 0; i < plain.size(); ++i) plain[i] = static_cast<int>(i);
  for (const auto& [name, forms] : script.forms) {
    const std::size_t whole = script.Find(name);
    if (whole == Script::npos) continue;
    for (const auto& [form, glyph] : forms) {
      const std::size_t index = script.Find(glyph);
      if (index != Script::npos) plain[index] = static_cast<int>(whole);
    }
  }
  return plain;
}

}  // namespace

std::vector<int> MarksOf(const TextPage& page, const Script& script) {
  const std::vector<int> plain = PlainForms(script);
  std::vector<int> marks;
  for (std::size_t i = 0; i < page.glyphs.size(); ++i) {
    const PlacedGlyph& glyph = page.glyphs[i];
    if (i > 0) {
      if (glyph.line != page.glyphs[i - 1].line) {
        marks.push_back(kLineEndMark);
      } else if (glyph.word != page.glyphs[i - 1].word) {
        marks.push_back(kSpaceMark);
      }
    }
    marks.push_back(plain[glyph.glyph]);
  }
  if (!marks.empty()) marks.push_back(kLineEndMark);
  return marks;
}

std::vector<int> MarksOf(const std::vector<ReadToken>& tokens, const Script& script) {
  const std::vector<int> plain = PlainForms(script);
  std::vector<int> marks;
  for (const ReadToken& token : tokens) {
    switch (token.kind) {
      case ReadToken::Kind::kSign:
        marks.push_back(plain[token.glyph]);
        break;
      case ReadToken::Kind::kUnknown:
        marks.push_back(kUnknownMark);
        break;
      case ReadToken::Kind::kSpace:
        marks.push_back(kSpaceMark);
        break;
      case ReadToken::Kind::kLineEnd:
        marks.push_back(kLineEndMark);
        break;
    }
  }
  return marks;
}

// With s = tick / lag the inner lag's variance is kick^2 / (2 s) and the outer one's half of that,
// both to first order in s. Even noise within +-1 has a variance of a third.
UnsurePlace::UnsurePlace(double rms, double tick, std::uint64_t seed)
    : share_(tick / kLag), kick_(rms * std::sqrt(12 * tick / kLag)), random_(seed) {
  // as if it had wandered for ever
  const auto settled = static_cast<int>(10 / share_);
  for (int i = 0; rms > 0 && i < settled; ++i) Next();
}

glm::dvec2 UnsurePlace::Next() noexcept {
  if (kick_ <= 0) return error_;
  const double x = 2 * random_.Uniform() - 1;
  const double y = 2 * random_.Uniform() - 1;
  inner_ += kick_ * glm::dvec2(x, y) - share_ * inner_;
  error_ += share_ * (inner_ - error_);
  return error_;
}

}  // namespace moontrace
