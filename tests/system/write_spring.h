// A recording whose truth is known: a linear spring, and a current that says the same torque.
#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>

namespace searig {

/// Makes `folder` of it: 20 s at 250 Hz, the load cell at 50 Hz on the same clock, and the model.
inline void write_spring(const std::filesystem::path& folder, double k_nm_per_rad) {
  constexpr double torque_constant_nm_per_a = 2.0;
  std::filesystem::create_directories(folder);
  std::ofstream module(folder / "module.csv"), loadcell(folder / "loadcell.csv");
  module << "t_s,deflection_rad,current_a\n";
  loadcell << "t_s,torque_nm\n";
  for (int i = 0; i < 5000; ++i) {
    const double t_s = i * 0.004, torque_nm = k_nm_per_rad * 0.1 * std::sin(3 * t_s);
    module << t_s << ',' << torque_nm / k_nm_per_rad << ',' << torque_nm / torque_constant_nm_per_a
           << '\n';
    if (i % 5 == 0) loadcell << t_s << ',' << torque_nm << '\n';
  }
  std::ofstream(folder / "recording.toml")
      << "format = \"searig-recording/1\"\n[module]\nfile = \"module.csv\"\n[loadcell]\nfile = "
         "\"loadcell.csv\"\n";
  std::ofstream(folder / "model.toml")
      << "format = \"searig-model/1\"\n[spring.linear]\nk_nm_per_rad = " << k_nm_per_rad
      << "\n[drive.motor]\ntorque_constant_nm_per_a = " << torque_constant_nm_per_a
      << "\nefficiency = 1.0\n";
}

}  // namespace searig
