// The desktop app is a program of its own, so that this one links no GUI library.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace searig::app {

/// searig-desktop beside this program. Throws std::runtime_error with one sentence where it is not
/// there.
std::filesystem::path find_desktop_program();

/// Becomes the program; comes back only by throwing std::runtime_error.
[[noreturn]] void become(const std::filesystem::path& program,
                         const std::vector<std::string>& arguments);

/// Runs the program to its end and returns its exit code.
int run_to_end(const std::filesystem::path& program, const std::vector<std::string>& arguments);

/// Whether there is a screen to open a window on.
bool has_display();

}  // namespace searig::app
