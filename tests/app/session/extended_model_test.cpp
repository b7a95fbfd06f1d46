#include "app/session/extended_model.h"

#include <gtest/gtest.h>

#include "app/session/session.h"
#include "tests/temporary_folder.h"

namespace searig::app {
namespace {

TEST(ExtendedModel, IsKeptBesideItsRecordingAndReplacesNothing) {
  const TemporaryFolder folder;
  const auto file = folder.write("run.mcap", "");
  estimator::Model model;
  model.set("spring.linear", "k_nm_per_rad", 41.5);
  EXPECT_EQ(keep_extended_model(file, model), folder.path() / "run.extended.toml");
  model.set("spring.linear", "k_nm_per_rad", 42.5);
  const auto second = keep_extended_model(file, model);
  EXPECT_EQ(second, folder.path() / "run.extended-2.toml");
  EXPECT_EQ(keep_extended_model(folder.path(), model), folder.path() / "extended.toml");
  EXPECT_DOUBLE_EQ(*find_model(file, second)->get("spring.linear", "k_nm_per_rad"), 42.5);
  EXPECT_DOUBLE_EQ(
      *find_model(file, folder.path() / "run.extended.toml")->get("spring.linear", "k_nm_per_rad"),
      41.5);
}

TEST(ExtendedModel, SaysWhereItCannotBeWritten) {
  EXPECT_THROW(keep_extended_model("/proc/run.mcap", {}), std::runtime_error);
}

}  // namespace
}  // namespace searig::app
