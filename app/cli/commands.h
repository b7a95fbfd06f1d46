// One function per command, one file per command; main.cpp is the table of contents.
#pragma once

#include <CLI/CLI.hpp>

namespace searig::app {

void add_calibrate(CLI::App& app);
void add_record(CLI::App& app);
void add_import(CLI::App& app);
void add_recover(CLI::App& app);
void add_info(CLI::App& app);
void add_sync(CLI::App& app);
void add_export(CLI::App& app);
void add_evaluate(CLI::App& app);
void add_diagnose(CLI::App& app);
void add_merge(CLI::App& app);
void add_simulate(CLI::App& app);
void add_effects(CLI::App& app);
void add_demo(CLI::App& app);
void add_reproduce(CLI::App& app);
void add_desktop(CLI::App& app);

}  // namespace searig::app
