#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/proving/plan/generate.h"
#include "tests/proving/plan/make_case.h"
#include "tests/proving/score/judge.h"
#include "tests/proving/truth/write.h"

namespace searig::proving {
namespace {

namespace fs = std::filesystem;

Rig plain_rig(double duration_s = 20.0) {
  Rig rig;
  rig.duration_s = duration_s;
  rig.base.bristle_rad = 4e-5;
  rig.plan.segments = {"multisine", "triangles"};
  rig.plan.shares = {0.5, 0.5};
  rig.motion = plan_motion(rig.plan, duration_s + rig.preroll_s, Random(7));
  return rig;
}

Rig with(const Effect& e, double duration_s = 20.0) {
  Rig rig = plain_rig(duration_s);
  give(rig, e);
  return rig;
}

template <typename Of>
double largest(const Trace& t, Of of) {
  double most = 0.0;
  for (std::size_t i = 0; i < t.current_a.size(); ++i) most = std::max(most, std::abs(of(i)));
  return most;
}

double drive_balance(const Rig& rig, const Trace& t, std::size_t i) {
  const Baseline& b = rig.base;
  return b.efficiency * (b.torque_constant_nm_per_a * t.current_a[i] -
                         b.inertia_kg_m2 * t.input_acceleration_rad_s2[i]) +
         t.coulomb_nm[i] - b.viscous_nm_s_per_rad * t.input_velocity_rad_s[i] -
         t.spring_torque_nm[i];
}

TEST(Simulation, WithEverythingOffTheLoadCellReadsKTimesTheta) {
  const Trace t = simulate(plain_rig());
  EXPECT_GT(largest(t, [&](auto i) { return t.linear_torque_nm[i]; }), 0.5);
  EXPECT_LT(largest(t, [&](auto i) { return t.loadcell_torque_nm[i] - t.linear_torque_nm[i]; }),
            1e-12);
}

TEST(Simulation, TheDriveEquationBalances) {
  const Rig rig = plain_rig();
  const Trace t = simulate(rig);
  // Velocities are predicted before a step and known after it: that much, at most, is open.
  EXPECT_LT(largest(t, [&](auto i) { return drive_balance(rig, t, i); }), 2e-3);
}

TEST(Simulation, VelocityIsTheAnglesDerivativeAndAccelerationTheVelocitys) {
  const Trace t = simulate(plain_rig());
  const double h = 2.0 / Trace::rate_hz;
  double velocity = 0.0, wrong = 0.0;
  for (std::size_t i = 1; i + 1 < t.current_a.size(); ++i) {
    const double w = (t.input_angle_rad[i + 1] - t.input_angle_rad[i - 1]) / h;
    velocity += w * w;
    wrong += std::pow(w - t.input_velocity_rad_s[i], 2);
  }
  EXPECT_LT(std::sqrt(wrong / velocity), 1e-3);
}

TEST(Simulation, FrictionTakesEnergyAway) {
  const Trace t = simulate(plain_rig());
  double work = 0.0;
  for (std::size_t i = 0; i < t.current_a.size(); ++i)
    work += t.coulomb_nm[i] * t.input_velocity_rad_s[i];
  EXPECT_LT(work, 0.0);
}

double loop_energy(const Trace& t) {
  double work = 0.0;
  for (std::size_t i = 0; i < t.current_a.size(); ++i)
    work += t.spring_torque_nm[i] * (t.input_velocity_rad_s[i] - t.output_velocity_rad_s[i]);
  return work / Trace::rate_hz;
}

TEST(Simulation, LossySpringsTakeEnergyAndElasticOnesGiveItBack) {
  const double elastic = std::abs(loop_energy(simulate(plain_rig())));
  const Effect lossy[] = {
      {"spring.viscous", "newton", {{"c_nm_s_per_rad", 0.5}}, {}, {}},
      {"spring.relaxation", "prony", {{"k1_nm_per_rad", 8.0}, {"tau_s", 0.5}}, {}, {}},
      {"spring.relaxation", "springpot", {{"k1_nm_per_rad", 3.0}, {"exponent", 0.2}}, {}, {}},
      {"spring.hysteresis",
       "maxwell_slip",
       {{"torque_nm", 0.2}, {"yield_rad", 0.01}, {"spread", 0.6}},
       {},
       {}},
      {"spring.hysteresis",
       "bouc_wen",
       {{"torque_nm", 0.2}, {"yield_rad", 0.01}, {"beta", 0.5}, {"exponent", 1.2}},
       {},
       {}},
      {"spring.hysteresis",
       "preisach",
       {{"torque_nm", 0.2}, {"yield_rad", 0.01}, {"reach_rad", 0.15}},
       {},
       {}}};
  for (const auto& e : lossy)
    EXPECT_GT(loop_energy(simulate(with(e))), 10.0 * elastic + 0.01) << e.name << ' ' << e.form;
}

/// A spring's effect leaves the gear's equation alone and shows at the load cell; a drive's the
/// other way round; a rig's stands between spring and load cell.
TEST(Simulation, EachEffectChangesWhatTheContractSays) {
  const Statistics stats = statistics_of(simulate(plain_rig()), plain_rig());
  for (const char* name :
       {"spring.viscous", "spring.cubic", "spring.hysteresis", "spring.relaxation",
        "spring.mullins", "spring.temperature", "spring.asymmetry", "spring.deadzone",
        "drive.stribeck", "drive.load_friction", "drive.ripple",
        "drive.torque_constant_temperature", "rig.delay", "rig.lag", "rig.zero_drift",
        "rig.gravity", "rig.inertia"}) {
    const Rig rig = with(draw_effect(name, plain_rig(), stats, Random(3)));
    const Trace t = simulate(rig);
    const std::string path = std::string(name).substr(0, std::string(name).find('.'));
    const auto seen = [](double v) { return v > 5e-3; };
    EXPECT_EQ(
        seen(largest(t, [&](auto i) { return t.spring_torque_nm[i] - t.linear_torque_nm[i]; })),
        path == "spring")
        << name;
    EXPECT_EQ(seen(largest(t, [&](auto i) { return drive_balance(rig, t, i); })), path == "drive")
        << name;
    EXPECT_EQ(
        seen(largest(t, [&](auto i) { return t.loadcell_torque_nm[i] - t.spring_torque_nm[i]; })),
        path == "rig")
        << name;
  }
}

TEST(Sensing, CurrentOffsetIsOnTheMeasuredCurrentOnly) {
  const Rig plain = plain_rig();
  const Rig offset = with({"drive.current_offset", "constant", {{"offset_a", 0.1}}, {}, {}});
  Sensing s;
  s.current_step_a = 0.0;
  const Recording without = observe(simulate(plain), plain, s);
  const Recording with_it = observe(simulate(offset), offset, s);
  for (std::size_t i = 0; i < without.module.size(); i += 50)
    EXPECT_NEAR(with_it.module[i].current_a - without.module[i].current_a, 0.1, 1e-12);
}

TEST(Sensing, ClocksAreRecoveredFromTheAnswer) {
  const Rig rig = plain_rig();
  Sensing s;
  s.module_clock = {40.0, 123.0, 1e-6};
  s.loadcell_clock = {-1800.0, 456.0, 1e-6};
  const Recording r = observe(simulate(rig), rig, s);
  for (const auto& m : r.module) EXPECT_NEAR(s.module_clock.true_time(m.t_s), m.true_s, 1e-6);
  for (const auto& l : r.loadcell) EXPECT_NEAR(s.loadcell_clock.true_time(l.t_s), l.true_s, 1e-6);
}

TEST(Sensing, NothingArrivesBeforeItIsSentNorOvertakes) {
  const Rig rig = plain_rig();
  Sensing s;
  s.loadcell_link = {2e-3, 3e-3, 16e-3, 0.01, 0.1, 0.01};
  const Recording r = observe(simulate(rig), rig, s);
  for (std::size_t i = 0; i < r.loadcell.size(); ++i) {
    EXPECT_GE(r.loadcell[i].host_s, r.loadcell[i].true_s + 2e-3);
    if (i > 0) {
      EXPECT_GE(r.loadcell[i].host_s, r.loadcell[i - 1].host_s);
      EXPECT_GT(r.loadcell[i].seq, r.loadcell[i - 1].seq);
    }
  }
  EXPECT_LT(r.loadcell.size(), static_cast<std::size_t>(r.loadcell.back().seq) + 1);
}

Item item(const char* stratum, const char* level, std::vector<std::string> effects, Strength s) {
  return {"p9999", stratum, level, "", std::move(effects), s, 42};
}

TEST(Cases, ANullHasNothingToFind) {
  const Case c = make_case(item("null exact", "exact", {}, Strength::none));
  EXPECT_LT(c.visible, 0.08);
  EXPECT_LT(c.reachable.rho(), 0.02);
  EXPECT_EQ(c.believed.stiffness_nm_per_rad, c.rig.base.stiffness_nm_per_rad);
}

TEST(Cases, StrengthIsWhatTheStratumSays) {
  const Case weak = make_case(item("single weak", "single", {"spring.cubic"}, Strength::weak));
  EXPECT_GT(weak.visible, 0.29);
  EXPECT_LT(weak.visible, 1.04);
  const Case strong =
      make_case(item("single strong", "single", {"drive.coulomb"}, Strength::strong));
  EXPECT_GT(strong.reachable.rho(), 2.8);
}

std::string bytes(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream all;
  all << file.rdbuf();
  return all.str();
}

TEST(Cases, TheSameSeedGivesTheSameBytesHoweverManyThreads) {
  const fs::path folder = fs::path(testing::TempDir()) / "proving";
  const auto items = plan_set("null exact", 5, 2);
  generate(items, folder / "a", 1);
  generate(items, folder / "b", 2);
  EXPECT_EQ(bytes(folder / "a/answers.json"), bytes(folder / "b/answers.json"));
  for (const auto& i : items)
    for (const char* file : {"recording.toml", "model.toml", "module.csv", "loadcell.csv"}) {
      const fs::path name = fs::path("recordings") / i.name / file;
      EXPECT_GT(bytes(folder / "a" / name).size(), 20u);
      EXPECT_EQ(bytes(folder / "a" / name), bytes(folder / "b" / name)) << name;
    }
  EXPECT_FALSE(fs::exists(folder / "a/recordings/answers.json"));
  fs::remove_all(folder);
}

TEST(Cases, TheOwnersModelLacksWhatIsConcealed) {
  const Case c = make_case(item("single strong", "single", {"drive.viscous"}, Strength::strong));
  const fs::path folder = fs::path(testing::TempDir()) / "concealed";
  write_recording(c, folder);
  const std::string model = bytes(folder / "model.toml");
  EXPECT_EQ(model.find("drive.viscous"), std::string::npos);
  EXPECT_NE(model.find("drive.coulomb"), std::string::npos);
  fs::remove_all(folder);
}

TEST(Plan, HoldsAtLeast320AndTheSmallSetIsAShareOfEach) {
  const auto full = plan_full(1), small = plan_set("small", 1, 0);
  EXPECT_GE(full.size(), 320u);
  EXPECT_GE(small.size(), 50u);
  EXPECT_LE(small.size(), 80u);
}

Truth truth_about(const char* effects, const char* level) {
  Truth t;
  t.level = level, t.stratum = level;
  t.sealed = nlohmann::json::parse(R"({"truth":{"spring.viscous.c_nm_s_per_rad":0.5},
      "reachable_rmse_nm":{"spring":{"before":2,"after":1},"drive":{"before":1,"after":1}}})");
  std::istringstream words(effects);
  for (std::string e; words >> e;) t.families.insert(family(e));
  return t;
}

Run says(const char* json) {
  return {nlohmann::json::parse(json), "", 1.0};
}

TEST(Score, DelayAndLagAreOneName) {
  const Judgement j = judge(truth_about("rig.delay", "single"),
                            says(R"({"findings":[{"effect":"rig.lag","probability":0.9}]})"), "");
  EXPECT_TRUE(j.named);
  EXPECT_FALSE(j.wrong);
}

TEST(Score, AConfidentOtherNameIsWrongAndADoubtfulOneIsNot) {
  const Truth t = truth_about("spring.cubic", "single");
  EXPECT_TRUE(judge(t, says(R"({"findings":[{"effect":"rig.lag","probability":0.9}]})"), "").wrong);
  EXPECT_FALSE(
      judge(t, says(R"({"findings":[{"effect":"rig.lag","probability":0.5}]})"), "").wrong);
}

TEST(Score, ANullThatIsNotLeftAloneIsAnAlarm) {
  const Truth t = truth_about("", "exact");
  EXPECT_FALSE(judge(t, says(R"({"verdict":"recalibrate","findings":[]})"), "").alarm);
  EXPECT_TRUE(judge(t, says(R"({"verdict":"unexplained","findings":[]})"), "").alarm);
}

TEST(Score, ParametersAndIntervalsAreHeldAgainstTheTruth) {
  const Judgement j = judge(truth_about("spring.viscous", "single"), says(R"({"findings":[
      {"effect":"spring.viscous","probability":0.99,"parameters":
       [{"name":"c_nm_s_per_rad","value":0.45,"ci95":[0.44,0.46]}]}]})"),
                            "");
  ASSERT_EQ(j.parameters.size(), 1u);
  EXPECT_NEAR(j.parameters[0].relative_error, 0.1, 1e-9);
  EXPECT_FALSE(*j.parameters[0].covered);
}

TEST(Score, AnotherReferenceTemperatureIsTheSamePhysics) {
  Truth t = truth_about("spring.temperature", "single");
  t.sealed["truth"] = {{"spring.temperature.per_c", -0.01}, {"spring.temperature.reference_c", 25}};
  // k*(1 - 0.01*(T - 25)) = 0.9*k*(1 - (0.01/0.9)*(T - 35))
  const Judgement j = judge(t, says(R"({"findings":[{"effect":"spring.temperature","parameters":[
      {"name":"per_c","value":-0.0111111,"ci95":[-0.012,-0.010]},
      {"name":"reference_c","value":35}]}]})"),
                            "");
  ASSERT_EQ(j.parameters.size(), 1u);
  EXPECT_LT(j.parameters[0].relative_error, 1e-4);
  EXPECT_TRUE(*j.parameters[0].covered);
}

}  // namespace
}  // namespace searig::proving
