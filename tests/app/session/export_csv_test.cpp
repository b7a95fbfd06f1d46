#include "app/session/export_csv.h"

#include <gtest/gtest.h>

#include <cmath>

#include "acquisition/recording/csv.h"
#include "acquisition/recording/write_recording.h"
#include "tests/acquisition/recording/temporary_folder.h"

namespace searig::app {
namespace {

using acquisition::CsvFile;
using acquisition::TemporaryFolder;

/// A module at 100 Hz whose deflection is its time, silent from 1 to 2 s; a load cell at 50 Hz.
Session small_session() {
  acquisition::Recording recording;
  recording.module.name = "module";
  recording.loadcell.name = "loadcell";
  recording.lever_arm_m = 0.5;
  for (int i = 1; i < 300; ++i)
    if (i < 100 || i > 200) recording.module.t_s.push_back(0.01 * i);
  recording.module.channels = {{"deflection_rad", recording.module.t_s}};
  for (int i = 0; i < 160; ++i) recording.loadcell.t_s.push_back(0.02 * i + 0.003);
  recording.loadcell.channels = {{"force_n", std::vector<double>(160, 1.0 / 3.0)}};
  const TemporaryFolder folder;
  acquisition::write_recording(recording, folder.path());
  return open_session(folder.path());
}

std::vector<double> column(const CsvFile& file, const char* name) {
  const std::vector<std::size_t> number{file.find(name)};
  return file.read(number, acquisition::Faults::count).columns[0];
}

TEST(ExportCsv, InterpolatesTheModuleAtEveryLoadcellSample) {
  const TemporaryFolder folder;
  const Session session = small_session();
  const CsvFile file(folder.write("e.csv", to_csv_table(session)), true);
  const std::vector<double> t_s = column(file, "t_s"), valid = column(file, "module_valid");
  ASSERT_EQ(t_s.size(), 160u);
  EXPECT_EQ(t_s, session.signals.loadcell.t_s);
  EXPECT_EQ(column(file, "torque_nm"), std::vector<double>(160, 0.5 * (1.0 / 3.0)));
  EXPECT_EQ(column(file, "loadcell_t_s"), session.recording.loadcell.t_s);
  const std::vector<double> age = column(file, "module_age_s");
  EXPECT_EQ(age.size(), 159u);  // nothing came before the first sample
  for (std::size_t i = 0; i < t_s.size(); ++i) {
    const bool silent = t_s[i] < 0.01 || (t_s[i] > 0.99 && t_s[i] < 2.01) || t_s[i] > 2.99;
    EXPECT_EQ(valid[i], silent ? 0.0 : 1.0) << t_s[i];
  }
  const std::vector<double> deflection = column(file, "deflection_rad");
  std::size_t next = 0;
  for (std::size_t i = 0; i < t_s.size(); ++i)
    if (valid[i] == 1.0) {
      EXPECT_NEAR(deflection.at(next++), t_s[i], 1e-12);
    }
  EXPECT_EQ(next, deflection.size());
}

TEST(ExportCsv, SaysHowEachColumnCameThere) {
  const std::string text = to_csv_table(small_session());
  for (const char* part :
       {"# t_s: s on the module's clock", "# torque_nm: force_n times the lever arm of 0.5 m",
        "# deflection_rad: linear between", "# module_valid: 1 where"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST(ExportCsv, LongFormHasEveryValueAsReceived) {
  const Session session = small_session();
  const std::string text = to_csv_long(session);
  const auto rows = session.recording.module.t_s.size() + session.recording.loadcell.t_s.size();
  std::size_t lines = 0;
  for (std::size_t at = text.find("\nt_s,"); (at = text.find('\n', at + 1)) != std::string::npos;)
    ++lines;
  EXPECT_EQ(lines, rows + 1);
  EXPECT_NE(text.find("\n0.003,0.003,loadcell,force_n,0.3333333333333333\n"), std::string::npos);
}

}  // namespace
}  // namespace searig::app
