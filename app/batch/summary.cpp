#include "app/batch/summary.h"

#include <stdexcept>

#include "acquisition/recording/text_file.h"
#include "app/batch/columns.h"

namespace searig::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

void write_whole(const fs::path& file, const std::string& text) {
  const fs::path part = file.string() + ".part";
  acquisition::write_text_file(part, text);
  std::error_code error;
  fs::rename(part, file, error);
  if (error)
    throw std::runtime_error(file.string() + ": cannot be written: " + error.message() + ".");
}

/// RFC 4180: quotes where the text would be taken for more than one field.
void append_field(std::string& row, const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) {
    row += text;
    return;
  }
  row += '"';
  for (const char c : text) row.append(c == '"' ? 2 : 1, c);
  row += '"';
}

}  // namespace

json answer_of(const Summary& summary) {
  json recordings = json::array(), failed = json::array();
  for (const json& answer : summary.answers)
    (answer.contains("why") ? failed : recordings).push_back(answer);
  const bool evaluated = summary.command == "evaluate";
  return {{"format", evaluated ? "searig-evaluation/1" : "searig-diagnoses/1"},
          {"recordings", recordings},
          {"failed", failed}};
}

std::string csv_of(const Summary& summary) {
  const std::vector<SummaryColumn>& columns = columns_of(summary.command);
  std::string text;
  for (const SummaryColumn& column : columns)
    text.append(text.empty() ? "" : ",").append(column.name);
  text += '\n';
  for (const json& answer : summary.answers) {
    for (const SummaryColumn& column : columns) {
      if (&column != &columns.front()) text += ',';
      append_field(text, column.text(answer));
    }
    text += '\n';
  }
  return text;
}

void write_summary(const Summary& summary, const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw std::runtime_error(folder.string() + ": cannot be made: " + error.message() + ".");
  write_whole(folder / (summary.command == "evaluate" ? "evaluation.json" : "diagnoses.json"),
              answer_of(summary).dump(2) + '\n');
  write_whole(folder / "summary.csv", csv_of(summary));
  write_whole(folder / "report.html", page_of(summary).text());
}

}  // namespace searig::app
