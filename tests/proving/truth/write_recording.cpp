#include <cstdio>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "tests/proving/truth/write.h"

namespace searig::proving {
namespace {

namespace fs = std::filesystem;

struct Closer {
  void operator()(std::FILE* f) const { std::fclose(f); }
};
using File = std::unique_ptr<std::FILE, Closer>;

File open(const fs::path& path) {
  File file(std::fopen(path.c_str(), "w"));
  if (!file) throw std::runtime_error("cannot write " + path.string());
  return file;
}

void write_module(const Case& c, const fs::path& path) {
  const File file = open(path);
  const bool warm = c.sensing.temperatures;
  std::fprintf(file.get(), "t_s,host_s,input_angle_rad,output_angle_rad,current_a%s\n",
               warm ? ",winding_temperature_c,spring_temperature_c" : "");
  for (const auto& r : c.recording.module) {
    std::fprintf(file.get(), "%.6f,%.6f,%.7f,%.7f,%.6f", r.t_s, r.host_s, r.input_angle_rad,
                 r.output_angle_rad, r.current_a);
    if (warm) std::fprintf(file.get(), ",%.2f,%.2f", r.winding_c, r.spring_c);
    std::fputc('\n', file.get());
  }
}

void write_loadcell(const Case& c, const fs::path& path) {
  const File file = open(path);
  std::fprintf(file.get(), "t_s,host_s,seq,force_n\n");
  for (const auto& r : c.recording.loadcell)
    std::fprintf(file.get(), "%.6f,%.6f,%d,%.6f\n", r.t_s, r.host_s, r.seq, r.force_n);
}

void write_model(const Case& c, const fs::path& path) {
  const File file = open(path);
  const Baseline& b = c.believed;
  const Concealed hidden = Concealed::from(c.concealed);
  std::FILE* f = file.get();
  std::fprintf(f, "format = \"searig-model/1\"\n\n[spring.linear]\nk_nm_per_rad = %.6g\n",
               b.stiffness_nm_per_rad);
  std::fprintf(f, "\n[drive.motor]\ntorque_constant_nm_per_a = %.6g\nefficiency = %.17g\n",
               b.torque_constant_nm_per_a, b.efficiency);
  if (!hidden.inertia) std::fprintf(f, "\n[drive.inertia]\nj_kg_m2 = %.6g\n", b.inertia_kg_m2);
  if (!hidden.coulomb)
    std::fprintf(f, "\n[drive.coulomb]\ntorque_nm = %.6g\nsmoothing_rad_s = 0.01\n", b.coulomb_nm);
  if (!hidden.viscous)
    std::fprintf(f, "\n[drive.viscous]\nb_nm_s_per_rad = %.6g\n", b.viscous_nm_s_per_rad);
}

}  // namespace

void write_recording(const Case& c, const fs::path& folder) {
  fs::create_directories(folder);
  {
    const File file = open(folder / "recording.toml");
    std::fprintf(
        file.get(),
        "format = \"searig-recording/1\"\n\n[module]\nfile = \"module.csv\"\ngear_ratio = %.1f\n\n"
        "[loadcell]\nfile = \"loadcell.csv\"\nlever_arm_m = %.2f\n",
        c.rig.base.gear_ratio, c.rig.base.lever_arm_m);
  }
  write_module(c, folder / "module.csv");
  write_loadcell(c, folder / "loadcell.csv");
  write_model(c, folder / "model.toml");
}

}  // namespace searig::proving
