#include "sim/view/viewer.h"
#include "sim/view/view_words.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/vec2.hpp>
#include <iterator>
#include <thread>

#include "sim/page_view/canvas.h"
#include "sim/page_view/gl_headless.h"
#include "sim/view/view_painter.h"
#include "sim/view/view_thread.h"
#include "tests/sim/display_fixture.h"
#include "tests/sim/model_view_fixture.h"
#include "tests/sim/scene_fixture.h"
#include "tests/sim/view_fixture.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;

// Kept as it was measured: a median that was rounded upwards would exceed the slowest frame.
TEST(TimeLog, MedianOfOneFrameIsThatFrame) {
  TimeLog frames;
  frames.Add(557.567728);
  EXPECT_DOUBLE_EQ(frames.Median(), 557.567728);
  EXPECT_LE(frames.Median(), frames.slowest());
}

class ViewerTest : public testing::Test {
 protected:
  void SetUp() override {
    try {
      const HeadlessGl gl;
      const Canvas canvas(16);
    } catch (const LackError& lack) {
      GTEST_SKIP() << lack.what();
    }
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) /
              (std::string("moontrace-") + test->name() + "-" + std::to_string(getpid()));
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string BytesOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  ViewerOptions SmallFrames() const {
    ViewerOptions options;
    options.frames = folder_.string();
    options.width = 160;
    options.height = 120;
    return options;
  }

  fs::path folder_;
};

TEST_F(ViewerTest, WritesAPictureOfThePage) {
  fs::create_directories(folder_);
  ViewerOptions options;
  options.width = 320;
  options.height = 200;
  const std::string plain = (folder_ / "plain.png").string();
  const std::string marked = (folder_ / "marked.png").string();
  WriteViewPicture(plain, options, PageOf("moon"), {}, {}, {});
  ViewMoment moment;
  moment.page = 1;
  moment.present = true;
  moment.tip_P = {0.02, 0.04, 0};
  WriteViewPicture(marked, options, PageOf("moon"), {moment}, {}, {});
  EXPECT_EQ(BytesOf(plain).substr(1, 3), "PNG");
  EXPECT_NE(BytesOf(plain), BytesOf(marked));
}

TEST_F(ViewerTest, WritesFramesInOrderWithoutADisplay) {
  ViewerOptions options;
  options.frames = folder_.string();
  options.width = 320;
  options.height = 200;
  options.most_frames = 5;
  {
    Viewer viewer(options);
    viewer.Show(PageOf("moon"));
    EXPECT_TRUE(Eventually([&] { return fs::exists(folder_ / "frame-00005.png"); }));
    EXPECT_EQ(viewer.failure(), "");
    EXPECT_GE(viewer.report().frames, 1U);
    EXPECT_GT(viewer.report().median_frame_ms, 0);
  }
  EXPECT_FALSE(fs::exists(folder_ / "frame-00006.png"));
  // those of a run before are not written over
  EXPECT_THROW(Viewer{options}, InputError);
}

TEST_F(ViewerTest, TheFirstFrameIsOfAPage) {
  ViewerOptions options;
  options.width = 320;
  options.height = 200;
  const std::string picture = folder_.string() + ".png";
  WriteViewPicture(picture, options, PageOf("moon"), {}, {}, {});
  const std::string page = BytesOf(picture);
  fs::remove(picture);
  options.frames = folder_.string();
  options.frames_per_second = 200;
  Viewer viewer(options);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_TRUE(fs::is_empty(folder_));
  viewer.Show(PageOf("moon"));
  ASSERT_TRUE(Eventually([&] { return fs::exists(folder_ / "frame-00001.png"); }));
  EXPECT_EQ(BytesOf(folder_ / "frame-00001.png"), page);
}

// However long the machine takes between them: as many as were asked for, each of its moment.
TEST_F(ViewerTest, OfflineAFrameIsDrawnWheneverItIsAskedFor) {
  ViewerOptions options = SmallFrames();
  options.offline = true;
  options.frames_per_second = 1000;
  options.most_frames = 3;
  Viewer viewer(options);
  viewer.Show(PageOf("moon"));
  ViewMoment moment;
  moment.page = 1;
  moment.present = true;
  for (int i = 0; i < 2; ++i) {
    moment.tip_P = {0.02 + 0.02 * i, 0.04, 0};
    viewer.Add(moment);
    viewer.DrawFrame();
    const std::string number = std::to_string(i + 1);
    EXPECT_TRUE(fs::exists(folder_ / ("frame-0000" + number + ".png"))) << number;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_FALSE(fs::exists(folder_ / "frame-00003.png"));
  viewer.DrawFrame();  // nothing has changed: that picture again
  EXPECT_NE(BytesOf(folder_ / "frame-00001.png"), BytesOf(folder_ / "frame-00002.png"));
  EXPECT_EQ(BytesOf(folder_ / "frame-00002.png"), BytesOf(folder_ / "frame-00003.png"));
  viewer.DrawFrame();  // behind the last
  viewer.Finish();
  EXPECT_FALSE(fs::exists(folder_ / "frame-00004.png"));
}

TEST_F(ViewerTest, AShortRunHasAFrame) {
  Viewer viewer(SmallFrames());
  viewer.Show(PageOf("moon"));
  viewer.Finish();
  EXPECT_GE(viewer.report().frames, 1U);  // more if this thread was held up
  EXPECT_TRUE(fs::exists(folder_ / "frame-00001.png"));
  viewer.Finish();  // twice is once
}

TEST_F(ViewerTest, RefusesAFolderThatCannotBeMade) {
  fs::create_directories(folder_);
  const fs::path file = folder_ / "file";
  std::ofstream(file) << "x";
  ViewerOptions options;
  options.frames = (file / "frames").string();
  EXPECT_THROW(Viewer{options}, LackError);
}

TEST_F(ViewerTest, ObeysItsOwnWordsOnly) {
  Viewer viewer(SmallFrames());
  viewer.Show(PageOf("moon"));
  for (const std::string& word : ViewWords()) {
    const std::optional<std::string> answer = viewer.Obey(word);
    ASSERT_TRUE(answer) << word;
    EXPECT_LE(answer->size(), 80U);
    EXPECT_EQ(answer->find('\n'), std::string::npos);
  }
  EXPECT_FALSE(viewer.Obey("size 20 mm"));
  EXPECT_FALSE(viewer.Obey(""));
  EXPECT_FALSE(viewer.NextLine());
  EXPECT_FALSE(viewer.closed());
}

class ViewPainterTest : public ViewerTest {
 protected:
  void SetUp() override {
    ViewerTest::SetUp();
    if (IsSkipped()) return;
    gl_ = std::make_unique<HeadlessGl>();
    ViewLook look;
    look.print = look.plots = look.panel = false;
    painter_ = std::make_unique<ViewPainter>(false, kWidth, kHeight, look);
  }
  void TearDown() override {
    painter_.reset();
    gl_.reset();
    ViewerTest::TearDown();
  }
  Raster Drawn() {
    painter_->Await();
    painter_->Draw();
    return painter_->Picture();
  }
  static double BrightnessAt(const Raster& raster, glm::dvec2 share) {
    const auto x = static_cast<std::size_t>(share.x * static_cast<double>(raster.width));
    const auto y = static_cast<std::size_t>((1 - share.y) * static_cast<double>(raster.height));
    return raster.rgb.at(3 * (y * raster.width + x)) / 255.0;
  }

  static constexpr int kWidth = 640, kHeight = 360;
  std::unique_ptr<HeadlessGl> gl_;
  std::unique_ptr<ViewPainter> painter_;
};

// Half way along each stroke of each letter there is a groove in the picture: the floor is darker
// than paper by the tint of full depth, from 0.96 to 0.24 red; more than half of that is left
// wherever the picture's point lies within a quarter of the groove's width.
TEST_F(ViewPainterTest, EachLettersStrokesAreSeenWhereTheFieldSays) {
  for (char c = 'a'; c <= 'z'; ++c) {
    const auto page = PageOf(std::string(1, c));
    painter_->Show(page);
    const Raster raster = Drawn();
    for (const IntendedStroke& stroke : page->strokes) {
      for (const Piece& piece : stroke.spine_P) {
        const glm::dvec2 p_P = PointAt(piece, 0.5 * Length(piece));
        const auto share = ShareOf(painter_->camera(), painter_->aspect(), p_P);
        ASSERT_TRUE(share);
        EXPECT_LT(BrightnessAt(raster, *share), 0.63) << c;
        // beside the letter's box is bare paper
        const Box& box = page->letters[0].box_P;
        const glm::dvec2 beside(box.min.x - page->width, 0.5 * (box.min.y + box.max.y));
        const auto bare = ShareOf(painter_->camera(), painter_->aspect(), beside);
        EXPECT_NEAR(BrightnessAt(raster, *bare), 0.96, 0.02) << c;
      }
    }
  }
}

// Zoomed to one groove: across an upright straight stroke the picture is as bright as the field's
// gradient makes it: ambient + (1 - ambient) n.l / l_z times the paper's red mixed with the
// groove's by depth (field_shading.h), n from the profile's slope (design section 4).
TEST_F(ViewPainterTest, AGrooveIsAsBrightAsItsGradient) {
  const auto page = PageOf("l");  // begins with an upright line
  const Piece& upright = page->strokes.at(0).spine_P.at(0);
  const glm::dvec2 middle = PointAt(upright, 0.5 * Length(upright));
  ASSERT_NEAR(std::abs(TangentAt(upright, 0).y), 1, 1e-9);
  painter_->Show(page);
  PageCamera camera;
  camera.at_P = middle;
  camera.height = page->width;
  painter_->SetCamera(camera);
  const Raster raster = Drawn();
  const double w = page->width, depth = w / 2, r = 0.2 * w, s = depth / (w / 2 - r);
  for (const double d : {-0.25 * w, 0.25 * w}) {  // within r .. w/2 - r: a straight flank
    const double slope = d > 0 ? s : -s;
    const double h = -depth + s * r / 2 + s * (std::abs(d) - r);
    const double lit = (0.48 * slope + 0.60) / std::sqrt(1 + s * s) / 0.60;
    const double bright = 0.72 + 0.28 * std::max(lit, 0.0);
    const double t = (-h / depth - 0.15) / 0.80;
    const double tint = 0.96 + (0.24 - 0.96) * t * t * (3 - 2 * t);
    const auto share = ShareOf(painter_->camera(), painter_->aspect(), middle + glm::dvec2(d, 0));
    // a point of the picture is w / 360, which changes the depth's share by at most 2 s / 360 and
    // the tint by 0.72 * 1.5 / 0.80 of that; and 1/255 of steps
    EXPECT_NEAR(BrightnessAt(raster, *share), std::min(1.0, bright * tint), 0.018) << d;
  }
}

TEST_F(ViewPainterTest, DrawsAgainOnlyWhatChanged) {
  painter_->Show(PageOf("moon"));
  Drawn();
  EXPECT_FALSE(painter_->changed());
  painter_->ShowLines({"Well done."});
  EXPECT_TRUE(painter_->changed());
  Drawn();
  EXPECT_FALSE(painter_->changed());
  painter_->SetTyped("");
  EXPECT_FALSE(painter_->changed());
  painter_->ZoomBy(0.5, {0.5, 0.5});
  EXPECT_TRUE(painter_->changed());
}

TEST_F(ViewPainterTest, ANewPageKeepsTheViewThatSomeoneChose) {
  painter_->Show(PageOf("moon", 1));
  const double whole = painter_->camera().height;
  painter_->Show(PageOf("m", 2));
  EXPECT_LT(painter_->camera().height, whole);  // one letter: nearer
  const double one = painter_->camera().height;
  painter_->Show(PageOf("n", 3));
  EXPECT_EQ(painter_->camera().height, one);  // another as large: as it was
  painter_->ZoomBy(0.5, {0.5, 0.5});
  const double chosen = painter_->camera().height;
  painter_->Show(PageOf("moon", 4));
  EXPECT_EQ(painter_->camera().height, chosen);
  painter_->ShowWholePage();
  EXPECT_NEAR(painter_->camera().height, 0.12 / painter_->aspect(), 1e-12);
}

TEST_F(ViewPainterTest, LongTalkStandsInRowsAboveTheEdge) {
  painter_->Show(PageOf("moon"));
  painter_->ShowLines({"Well done."});
  const Raster short_line = Drawn();
  std::string talk;
  for (int i = 0; i < 40; ++i) talk += "several words ";
  painter_->ShowLines({"The first.", talk});
  const Raster rows = Drawn();
  const PixelBox& text = painter_->layout().text;
  const auto column = static_cast<std::size_t>(text.x) + 2;
  const auto above = rows.height - static_cast<std::size_t>(text.y + text.height) - 5;
  const auto differs = [&](std::size_t row) {
    const std::size_t at = 3 * (row * rows.width + column);
    return rows.rgb.at(at) != short_line.rgb.at(at);
  };
  EXPECT_TRUE(differs(above));
  EXPECT_FALSE(differs(rows.height / 4));  // the page is not covered
}

TEST_F(ViewPainterTest, TellsThatItIsTooSmallForItsPanel) {
  painter_->Show(PageOf("moon"));
  EXPECT_FALSE(painter_->cramped());
  ViewLook look;
  painter_->SetLook(look);
  painter_->SetControls(SmallPanel());
  EXPECT_FALSE(painter_->cramped());
  painter_->Resize(300, 300);
  EXPECT_TRUE(painter_->cramped());
  look.panel = false;
  painter_->SetLook(look);  // it is not wished for
  EXPECT_FALSE(painter_->cramped());
}

TEST_F(ViewPainterTest, SmallestPicturesAreDrawn) {
  painter_->Show(PageOf("moon"));
  painter_->SetControls(SmallPanel());
  ViewLook all;
  painter_->SetLook(all);
  for (const int size : {1, 2, 17, 130}) {
    ViewPainter small(false, size, size, all);
    small.Show(PageOf("moon"));
    small.Await();
    small.Draw();
    EXPECT_EQ(small.Picture().width, static_cast<std::size_t>(size));
  }
}

TEST_F(ViewerTest, AModelIsLookedAtByItsNames) {
  const LabelledModel labelled = LabelledFrom(CanXml());
  ViewerOptions options = SmallFrames();
  options.offline = true;
  Viewer viewer(options);
  EXPECT_EQ(viewer.Obey("view can"), std::nullopt);  // of a page that is no word
  viewer.ShowModel(labelled.model);
  viewer.Show(PageOf("moon"));
  viewer.DrawFrame();
  EXPECT_EQ(viewer.Obey(" view wall "), "The view looks at wall.");
  viewer.DrawFrame();
  EXPECT_EQ(viewer.Obey("view wal"),
            "The model has nothing named 'wal' to look at: did you mean wall?");
  EXPECT_EQ(viewer.Obey("view"),
            "view NAME looks at: can, plate, wall, world, turntable, reader, whole, tip.");
  EXPECT_EQ(viewer.Obey("whole page"), "The view shows the whole model.");
  viewer.DrawFrame();
  const std::string label = BytesOf(folder_ / "frame-00001.png");
  const std::string wall = BytesOf(folder_ / "frame-00002.png");
  EXPECT_NE(label, wall);
  EXPECT_NE(wall, BytesOf(folder_ / "frame-00003.png"));
  viewer.Finish();
  ASSERT_FALSE(viewer.report().seen.empty());
  EXPECT_EQ(viewer.report().seen[0].substr(0, 4), "Seen");
}

TEST_F(ViewerTest, AModelIsShownAsItStandsAtEachMoment) {
  const LabelledModel labelled = LabelledFrom(CanXml());
  ViewerOptions options = SmallFrames();
  options.offline = true;
  Viewer viewer(options);
  viewer.ShowModel(labelled.model);
  viewer.Show(PageOf("moon"));
  const auto draw_at = [&](double turn, double time) {
    auto pose = std::make_shared<ScenePose>(labelled.model->start);
    pose->qpos[kInserted] = turn;
    ViewMoment moment;
    moment.time = time;
    moment.pose = pose;
    viewer.Add(moment);
    viewer.DrawFrame();
  };
  draw_at(0, 0);
  draw_at(0.5, 1);
  draw_at(0, 2);
  viewer.Finish();
  EXPECT_NE(BytesOf(folder_ / "frame-00001.png"), BytesOf(folder_ / "frame-00002.png"));
  EXPECT_FALSE(BytesOf(folder_ / "frame-00003.png").empty());
}

// Kept as it was: where MuJoCo drew shadows their texture stayed in use, and no letter was seen.
TEST_F(ViewerTest, PrintStandsOnAModelWithShadows) {
  std::string xml = CanXml();
  const std::string none = R"(shadowsize="0")";
  xml.replace(xml.find(none), none.size(), R"(shadowsize="256")");
  xml.insert(xml.find("<camera"), R"(<light pos="0 -1 1" dir="0 1 -1"/>)");
  const LabelledModel labelled = LabelledFrom(xml);
  ViewerOptions options = SmallFrames();
  options.width = 640;
  options.height = 480;
  options.offline = true;
  Viewer viewer(options);
  viewer.ShowModel(labelled.model);
  viewer.Show(labelled.view_page);
  viewer.DrawFrame();
  viewer.Obey("print off");
  viewer.DrawFrame();
  viewer.Finish();
  EXPECT_TRUE(BytesOf(folder_ / "frame-00001.png") != BytesOf(folder_ / "frame-00002.png"));
}

TEST_F(ViewerTest, AnUnknownCameraIsRefusedBeforeAnythingIsDrawn) {
  const LabelledModel labelled = LabelledFrom(CanXml());
  ViewerOptions options = SmallFrames();
  options.camera = "reade";
  const std::string path = folder_.string() + ".png";
  EXPECT_THROW(WriteViewPicture(path, options, PageOf("moon"), {}, {}, {}, labelled.model),
               InputError);
  EXPECT_FALSE(fs::exists(path));
  Viewer viewer(options);
  EXPECT_THROW(viewer.ShowModel(labelled.model), InputError);
}

}  // namespace
}  // namespace moontrace
