// Recordings of any length for the benchmark, written as they are made: none is in memory.
#pragma once

#include <filesystem>

/// A spring of 40 N*m/rad with a geared motor, as a folder: a module at `hz` and a load cell at 80
/// Hz on one clock, with noise as it is measured. `seed` makes another motion.
void write_folder(const std::filesystem::path& folder, double seconds, double hz, unsigned seed);
