// The window, drawn offscreen: the tests look at its pixels.
#ifdef SEARIG_HAS_DESKTOP
#include <gtest/gtest.h>

#include <QImage>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/report/palette.h"
#include "app/session/session.h"
#include "estimator/evaluation/evaluation.h"
#include "tests/system/run_program.h"

namespace searig {
namespace {

struct Picture {
  QImage image;
  nlohmann::json layout;
};

Picture picture_of(const std::string& arguments) {
  const TemporaryFolder folder;
  const std::string png = (folder.path() / "window.png").string();
  const std::string json = (folder.path() / "layout.json").string();
  const Ran ran = run_program("searig desktop " + arguments + " --theme light --offscreen" +
                              " --screenshot " + png + " --layout " + json);
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(ran.err.empty()) << ran.err;
  return {QImage(QString::fromStdString(png)), nlohmann::json::parse(text_of(json))};
}

bool is(const QColor& seen, app::Hue hue) {
  const QColor wanted(app::shades(hue).light);
  return std::abs(seen.red() - wanted.red()) + std::abs(seen.green() - wanted.green()) +
             std::abs(seen.blue() - wanted.blue()) <
         24;
}

int count(const Picture& picture, const std::string& plot, app::Hue hue) {
  const auto& at = picture.layout["plots"][plot];
  int found = 0;
  for (int x = at["left"]; x < int(at["left"]) + int(at["width"]); ++x)
    for (int y = at["top"]; y < int(at["top"]) + int(at["height"]); ++y)
      found += is(picture.image.pixelColor(x, y), hue) ? 1 : 0;
  return found;
}

/// Whether a pixel of that hue is within two pixels of where the plot shows (t, value).
bool drawn_at(const Picture& picture, const std::string& plot, double t, double value,
              app::Hue hue) {
  const auto& at = picture.layout["plots"][plot];
  const auto share = [](const nlohmann::json& range, double v) {
    return (v - double(range[0])) / (double(range[1]) - double(range[0]));
  };
  const int x = int(std::lround(int(at["left"]) + share(at["x"], t) * (int(at["width"]) - 1)));
  const int y =
      int(std::lround(int(at["top"]) + (1.0 - share(at["y"], value)) * (int(at["height"]) - 1)));
  for (int dx = -2; dx <= 2; ++dx)
    for (int dy = -2; dy <= 2; ++dy)
      if (picture.image.valid(x + dx, y + dy) && is(picture.image.pixelColor(x + dx, y + dy), hue))
        return true;
  return false;
}

TEST(Desktop, ShowsTheSimulatedRigLive) {
  const Picture picture = picture_of("--live --seconds 6");
  EXPECT_EQ(picture.image.width(), 1280);
  EXPECT_EQ(picture.image.height(), 800);
  EXPECT_GT(count(picture, "torque", app::Hue::blue), 250);
  EXPECT_GT(count(picture, "weight", app::Hue::purple), 250);
  EXPECT_GT(count(picture, "stiffness", app::Hue::green), 150);
}

TEST(Desktop, CurvesOfARecordingAreWhereTheDataAre) {
  const TemporaryFolder folder;
  const std::string out = folder.path().string();
  ASSERT_EQ(run_program("searig demo --seconds 10 --headless --out " + out).exit_code, 0);
  const Picture picture = picture_of(out + "/recording.mcap");

  const auto session = app::open_session(out + "/recording.mcap");
  const auto model = app::find_model(out + "/recording.mcap", std::nullopt);
  const auto evaluation = estimator::evaluate(session.signals, &*model);
  const auto& track = evaluation.online->track;
  const double start_s = session.signals.module.t_s.front();
  int looked_at = 0;
  for (std::size_t i = track.size() / 4; i < track.size(); i += 100, ++looked_at) {
    const double t = track[i].t_s - start_s;
    EXPECT_TRUE(drawn_at(picture, "torque", t, track[i].torque_nm, app::Hue::blue)) << t;
    EXPECT_TRUE(drawn_at(picture, "stiffness", t, track[i].k_nm_per_rad, app::Hue::green)) << t;
    EXPECT_TRUE(drawn_at(picture, "weight", t, track[i].weight, app::Hue::purple)) << t;
  }
  EXPECT_GT(looked_at, 30);
  // And the mirror image of the torque is not there: the test can fail.
  int mirrored = 0;
  for (std::size_t i = track.size() / 4; i < track.size(); i += 100) {
    if (std::abs(track[i].torque_nm) < 1.0) continue;
    mirrored +=
        drawn_at(picture, "torque", track[i].t_s - start_s, -track[i].torque_nm, app::Hue::blue)
            ? 1
            : 0;
  }
  EXPECT_LE(mirrored, 2);
}

/// Whatever the scale and the theme, nothing is cut and the curve is where the data are.
TEST(Desktop, IsReadableAtTwiceTheScaleInBothThemes) {
  const TemporaryFolder folder;
  const std::string out = folder.path().string();
  ASSERT_EQ(run_program("searig demo --seconds 10 --headless --out " + out).exit_code, 0);
  for (const char* theme : {"light", "dark"})
    for (const int scale : {1, 2}) {
      const std::string png = out + "/window.png", json = out + "/layout.json";
      const Ran ran =
          run_program("searig desktop --as-live " + out + "/recording.mcap --theme " + theme +
                          " --offscreen --screenshot " + png + " --layout " + json,
                      "env QT_SCALE_FACTOR=" + std::to_string(scale) + " ");
      ASSERT_EQ(ran.exit_code, 0) << ran.err;
      EXPECT_EQ(QImage(QString::fromStdString(png)).width(), 1280 * scale);
      const auto layout = nlohmann::json::parse(text_of(json));
      EXPECT_TRUE(layout["cut"].empty()) << layout["cut"];
      EXPECT_EQ(layout["plots"].size(), 4u);
    }
}

TEST(Desktop, EmptyWindowHasNoCurve) {
  const Picture picture = picture_of("");
  EXPECT_EQ(count(picture, "torque", app::Hue::blue), 0);
}

TEST(Desktop, ShowsThePageThatIsAskedFor) {
  EXPECT_TRUE(picture_of("--page replay").layout["plots"].contains("torque"));
  const Picture diagnose = picture_of("--page diagnose");
  EXPECT_TRUE(diagnose.layout["plots"].contains("residual"));
  EXPECT_TRUE(diagnose.layout["words"].contains("hint"));
}

TEST(Desktop, ARecordingThatIsNotThereIsSaidAndExits1) {
  const Ran ran = run_program("searig desktop /nowhere --offscreen --screenshot /tmp/never.png");
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_NE(ran.err.find("/nowhere"), std::string::npos) << ran.err;
  EXPECT_FALSE(std::filesystem::exists("/tmp/never.png"));
}

TEST(Desktop, WithoutADisplayItSaysWhatToDo) {
  const Ran ran = run_program("searig-desktop --live");
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_NE(ran.err.find("--offscreen"), std::string::npos) << ran.err;
}

TEST(Desktop, WrongUseExits2) {
  EXPECT_EQ(run_program("searig desktop --nonsense").exit_code, 2);
  EXPECT_EQ(run_program("searig desktop --theme pink").exit_code, 2);
  // A window that nobody sees would stay open for ever.
  EXPECT_EQ(run_program("searig desktop --live --offscreen").exit_code, 2);
}

}  // namespace
}  // namespace searig
#endif
