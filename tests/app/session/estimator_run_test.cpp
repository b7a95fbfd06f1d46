#include "app/session/estimator_run.h"

#include <gtest/gtest.h>

#include <cmath>

#include "acquisition/recording/text_file.h"
#include "tests/app/session/sample_recording.h"
#include "tests/temporary_folder.h"

namespace searig::app {
namespace {

class EstimatorRunTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    make_sample_recording(folder_->path() / "sample");
    session_ = std::make_unique<Session>(open_session(folder_->path() / "sample"));
  }
  static void TearDownTestSuite() {
    session_.reset();
    folder_.reset();
  }
  static inline std::unique_ptr<TemporaryFolder> folder_;
  static inline std::unique_ptr<Session> session_;
};

TEST_F(EstimatorRunTest, FollowsTheStiffnessFromWhereItIsTold) {
  const auto run = run_estimator(*session_, {.initial_k_nm_per_rad = 100.0});
  EXPECT_NEAR(run.history.stiffness_nm_per_rad.front(), 100.0, 5.0);
  EXPECT_NEAR(run.history.stiffness_nm_per_rad.back(), sample_k, 2.0);
}

TEST_F(EstimatorRunTest, GivesAWatchedRunAwayAsItComes) {
  const auto whole = run_estimator(*session_, {});
  History seen;
  const auto run = run_estimator(*session_, {}, [&](History more) { seen.append(more); });
  EXPECT_EQ(seen.estimated_nm, whole.history.estimated_nm);
  EXPECT_EQ(seen.stiffness_sd_nm_per_rad, whole.history.stiffness_sd_nm_per_rad);
  EXPECT_TRUE(run.history.t_s.empty());
  EXPECT_EQ(run.remark, whole.remark);
  for (const RunKind kind : {RunKind::online, RunKind::linear}) {
    const auto stop = [](History) { throw std::runtime_error("Stopped."); };
    EXPECT_THROW(run_estimator(*session_, {.kind = kind}, stop), std::runtime_error);
  }
  const RunSettings several{.kind = RunKind::linear};
  EXPECT_EQ(run_estimator(*session_, several, [](History) {}).history.estimated_nm,
            run_estimator(*session_, several).history.estimated_nm);
}

TEST_F(EstimatorRunTest, EstimatesDampingBesideTheStiffness) {
  const RunSettings plain{.kind = RunKind::linear};
  const RunSettings damped{.kind = RunKind::linear, .states = {"spring.linear", "spring.viscous"}};
  const auto without = error_percent(run_estimator(*session_, plain).history, 10.0);
  const auto with = error_percent(run_estimator(*session_, damped).history, 10.0);
  ASSERT_TRUE(without && with);
  EXPECT_LT(*with, 0.3 * *without);
}

TEST_F(EstimatorRunTest, HasAResidualForEachReadingThatItCovers) {
  for (const RunKind kind : {RunKind::online, RunKind::linear, RunKind::simulation}) {
    const auto run = run_estimator(*session_, {.kind = kind});
    std::size_t found = 0;
    for (const auto& regime : run.residuals) {
      found += regime.t_s.size();
      for (std::size_t i = 0; i < regime.t_s.size(); ++i) {
        const auto at = values_at(run.history, regime.t_s[i]);
        ASSERT_TRUE(at.measured_nm && at.estimated_nm);
        ASSERT_NEAR(regime.nm[i], *at.measured_nm - *at.estimated_nm, 1e-9);
      }
    }
    EXPECT_GT(found, session_->signals.loadcell.t_s.size() - 10);
    EXPECT_GT(run.residuals[std::size_t(estimator::Regime::driving)].t_s.size(), 50u);
  }
}

TEST_F(EstimatorRunTest, SimulatesTheModelThatIsGiven) {
  estimator::Model truth = *find_model(session_->recording.path, std::nullopt);
  truth.set("spring.viscous", "c_nm_s_per_rad", sample_c);
  const auto file = folder_->path() / "truth.toml";
  acquisition::write_text_file(file, estimator::to_toml(truth));
  RunSettings settings{.kind = RunKind::simulation};
  const auto own = error_percent(run_estimator(*session_, settings).history);
  settings.model_file = file;
  const auto run = run_estimator(*session_, settings);
  EXPECT_LT(*error_percent(run.history), 0.3 * *own);
  EXPECT_EQ(run.history.estimated_from, "simulation, truth.toml");
  EXPECT_TRUE(run.history.stiffness_nm_per_rad.empty());
}

TEST_F(EstimatorRunTest, TellsValuesBetweenSamplesAndNoneOutside) {
  History history;
  history.t_s = {0.0, 1.0, 3.0};
  history.estimated_nm = {0.0, 2.0, 4.0};
  EXPECT_DOUBLE_EQ(*values_at(history, 0.5).estimated_nm, 1.0);
  EXPECT_DOUBLE_EQ(*values_at(history, 2.0).estimated_nm, 3.0);
  EXPECT_DOUBLE_EQ(*values_at(history, 0.0).estimated_nm, 0.0);
  EXPECT_FALSE(values_at(history, 3.1).estimated_nm);
  EXPECT_FALSE(values_at(history, -0.1).estimated_nm);
  EXPECT_FALSE(values_at(history, 1.0).weight);
}

TEST_F(EstimatorRunTest, NamesWhatSetsARunApart) {
  EXPECT_EQ(words_for({}), "online");
  EXPECT_EQ(words_for({.kind = RunKind::rls,
                       .states = {"spring.linear", "spring.viscous"},
                       .initial_k_nm_per_rad = 500.0,
                       .model_file = "a/b.toml"}),
            "rls with spring.viscous from k = 500, b.toml");
}

}  // namespace
}  // namespace searig::app
