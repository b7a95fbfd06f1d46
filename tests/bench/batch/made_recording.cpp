#include "tests/bench/batch/made_recording.h"

#include <charconv>
#include <cmath>
#include <fstream>
#include <random>
#include <string>

namespace {

namespace fs = std::filesystem;

class Csv {
 public:
  Csv(const fs::path& file, const char* header) : file_(file, std::ios::binary) {
    text_ = header;
    text_ += '\n';
  }
  ~Csv() { file_ << text_; }

  Csv& add(double value, int digits, char end) {
    char number[40];
    const auto stop =
        std::to_chars(number, number + sizeof number, value, std::chars_format::fixed, digits).ptr;
    text_.append(number, stop).push_back(end);
    if (text_.size() > 1 << 20) {
      file_ << text_;
      text_.clear();
    }
    return *this;
  }

 private:
  std::ofstream file_;
  std::string text_;
};

}  // namespace

void write_folder(const fs::path& folder, double seconds, double hz, unsigned seed) {
  fs::create_directories(folder);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise;
  const double fast = 10.0 + 0.001 * seed;
  const auto deflection = [&](double t) {
    return 0.1 * std::sin(3 * t) + 0.03 * std::sin(fast * t);
  };
  {
    Csv module(folder / "module.csv",
               "t_s,input_angle_rad,output_angle_rad,deflection_rad,current_a");
    for (double row = 0; row < seconds * hz; ++row) {
      const double t = row / hz, theta = deflection(t), out = 0.01 * std::sin(0.7 * t);
      module.add(t, 6, ',').add(theta + out + 2e-5 * noise(random), 7, ',');
      module.add(out + 2e-5 * noise(random), 7, ',').add(theta + 2e-5 * noise(random), 7, ',');
      module.add(20 * theta + 0.02 * noise(random), 5, '\n');
    }
    Csv loadcell(folder / "loadcell.csv", "t_s,torque_nm");
    for (double row = 0; row < seconds * 80; ++row) {
      const double t = row / 80 + 0.0003;
      loadcell.add(t, 6, ',').add(40 * deflection(t) + 0.02 * noise(random), 5, '\n');
    }
  }
  std::ofstream(folder / "recording.toml")
      << "format = \"searig-recording/1\"\n[module]\nfile = \"module.csv\"\n[loadcell]\nfile = "
         "\"loadcell.csv\"\n";
}
