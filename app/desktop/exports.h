// What the window shows, and the recording behind it, as files for other programs.
#pragma once

#include <QWidget>
#include <filesystem>
#include <string>

namespace searig::app::desktop {

/// Kinds of file, by what their names end with.
enum class ExportKind { picture, drawing, csv, mat, hdf5, report, none };
ExportKind export_kind(const std::filesystem::path& file);

/// PNG, twice as fine as the screen. Throws std::runtime_error with one sentence, as the next ones.
void save_picture(QWidget& view, const std::filesystem::path& file);

/// SVG of the plots that are visible in a view, from top to bottom, over what they show.
void save_drawing(const QWidget& view, const std::filesystem::path& file);

/// The whole recording, on one clock; may take long.
void save_recording(const std::filesystem::path& recording, ExportKind kind,
                    const std::filesystem::path& file);

}  // namespace searig::app::desktop
