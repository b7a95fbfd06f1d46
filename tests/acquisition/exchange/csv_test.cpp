#include "acquisition/exchange/csv.h"

#include <gtest/gtest.h>

#include "acquisition/recording/csv.h"
#include "tests/acquisition/exchange/a_recording.h"
#include "tests/temporary_folder.h"

namespace searig::acquisition::exchange {
namespace {

/// A module at 100 Hz whose deflection is its time, silent from 1 to 2 s; a load cell at 50 Hz; an
/// encoder at 40 Hz on the module's clock whose angle is twice its time.
Recording small_recording() {
  Recording recording;
  recording.name = "small";
  recording.one_clock = true;
  recording.module.name = "module";
  recording.loadcell.name = "loadcell";
  recording.lever_arm_m = 0.5;
  for (int i = 1; i < 300; ++i)
    if (i < 100 || i > 200) recording.module.t_s.push_back(0.01 * i);
  recording.module.channels = {{"deflection_rad", recording.module.t_s},
                               {"seq", recording.module.t_s}};
  for (int i = 0; i < 160; ++i) recording.loadcell.t_s.push_back(0.02 * i + 0.003);
  recording.loadcell.channels = {{"force_n", std::vector<double>(160, 1.0 / 3.0)},
                                 {"seq", recording.loadcell.t_s}};
  Device encoder;
  encoder.stream.name = "device.encoder";
  encoder.aligned_by = AlignedBy::clock;
  for (int i = 0; i < 120; ++i) encoder.stream.t_s.push_back(0.025 * i);
  encoder.stream.channels = {{"motor_angle_rad", encoder.stream.t_s}};
  for (double& angle : encoder.stream.channels[0].values) angle *= 2.0;
  recording.devices.push_back(std::move(encoder));
  return recording;
}

std::string text_of(void (*write)(const Contents&, const Sink&), const Recording& recording) {
  std::string text;
  write(contents_of(recording), [&](std::string_view piece) { text += piece; });
  return text;
}

/// Only the rows that have the column.
std::vector<double> column(const CsvFile& file, const char* name) {
  const std::vector<std::size_t> number{file.find(name)};
  return file.read(number, Faults::count).columns[0];
}

TEST(CsvTable, BringsEveryStreamToEveryLoadcellSample) {
  const TemporaryFolder folder;
  const Recording recording = small_recording();
  const CsvFile file(folder.write("e.csv", text_of(write_csv_table, recording)), true);
  const std::vector<double> t_s = column(file, "t_s"), valid = column(file, "module_valid");
  EXPECT_EQ(t_s, recording.loadcell.t_s);
  EXPECT_EQ(column(file, "loadcell_seq"), recording.loadcell.t_s);
  EXPECT_EQ(column(file, "torque_nm"), std::vector<double>(160, 0.5 * (1.0 / 3.0)));
  EXPECT_EQ(column(file, "module_age_s").size(), 159u);  // nothing came before the first sample
  const std::vector<double> deflection = column(file, "deflection_rad"),
                            angle = column(file, "motor_angle_rad"),
                            encoder_valid = column(file, "encoder_valid");
  std::size_t next = 0, next_angle = 0;
  for (std::size_t i = 0; i < t_s.size(); ++i) {
    const bool silent = t_s[i] < 0.01 || (t_s[i] > 0.99 && t_s[i] < 2.01) || t_s[i] > 2.99;
    EXPECT_EQ(valid[i], silent ? 0.0 : 1.0) << t_s[i];
    EXPECT_EQ(encoder_valid[i], t_s[i] < 2.975 ? 1.0 : 0.0) << t_s[i];
    if (!silent) {
      EXPECT_NEAR(deflection.at(next++), t_s[i], 1e-12);
    }
    if (t_s[i] < 2.975) {
      EXPECT_NEAR(angle.at(next_angle++), 2.0 * t_s[i], 1e-12);
    }
  }
  EXPECT_EQ(next, deflection.size());
  EXPECT_EQ(next_angle, angle.size());
}

TEST(CsvTable, FrameNumbersAreNotInterpolated) {
  const TemporaryFolder folder;
  const Recording recording = small_recording();
  const CsvFile file(folder.write("e.csv", text_of(write_csv_table, recording)), true);
  EXPECT_EQ(column(file, "module_seq"), column(file, "module_t_s"));
}

TEST(CsvTable, SaysHowEachColumnCameThere) {
  const std::string text = text_of(write_csv_table, small_recording());
  for (const char* part :
       {"# t_s: s, on the module's clock", "# torque_nm: N*m, force_n times the lever arm of 0.5 m",
        "# deflection_rad: rad, linear between", "# module_valid: 1 where", "95 % interval"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST(CsvLong, HasEveryValueAsReceived) {
  const Recording recording = small_recording();
  const std::string text = text_of(write_csv_long, recording);
  const auto rows = 2 * recording.module.t_s.size() + 2 * recording.loadcell.t_s.size() + 120;
  const std::string body = text.substr(text.find("\nt_s,") + 1);
  EXPECT_EQ(std::size_t(std::count(body.begin(), body.end(), '\n')), rows + 1);
  EXPECT_NE(body.find("\n0.003,0.003,loadcell,force_n,0.3333333333333333\n"), std::string::npos);
  EXPECT_NE(body.find("\n0.025,0.025,device.encoder,motor_angle_rad,0.05\n"), std::string::npos);
}

TEST(CsvLong, RowsThatCannotBePlacedAreThereWithoutATime) {
  Recording recording = small_recording();
  recording.loadcell.restarts = {10};  // without host stamps nobody knows how long it was away
  const std::string text = text_of(write_csv_long, recording);
  EXPECT_NE(text.find("\n,0.003,loadcell,force_n,"), std::string::npos);
}

}  // namespace
}  // namespace searig::acquisition::exchange
