#include "app/desktop/diagnose/finding_text.h"

#include "app/report/diagnosis_sentences.h"
#include "app/report/quantity.h"

namespace searig::app::desktop {
namespace {

QString said(const std::string& words) {
  return QString::fromStdString(words).toHtmlEscaped();
}

QString row(const char* name, const std::optional<estimator::PathErrors>& path) {
  if (!path) return {};
  QString cells = QStringLiteral("<td>%1&nbsp;&nbsp;</td>").arg(QLatin1String(name));
  const std::string values[] = {path->as_given ? figures(*path->as_given, 2) : "–",
                                figures(path->before, 2), figures(path->after, 2),
                                figures(path->noise_floor, 2)};
  for (const auto& value : values)
    cells += QStringLiteral("<td align='right'>&nbsp;&nbsp;%1</td>").arg(said(value));
  return QStringLiteral("<tr>%1</tr>").arg(cells);
}

QString errors_table(const estimator::Diagnosis& d) {
  return QStringLiteral(
             "<table cellspacing='2'><tr><td><b>error (N·m)</b></td><td>&nbsp;&nbsp;as given</td>"
             "<td>&nbsp;&nbsp;refitted</td><td>&nbsp;&nbsp;explained</td><td>&nbsp;&nbsp;noise</td>"
             "</tr>%1%2</table>")
      .arg(row("spring", d.spring), row("current", d.drive));
}

}  // namespace

QString finding_text(const Examined& examined) {
  const auto& d = examined.diagnosis;
  QString out = errors_table(d);
  auto lines = sentences(d, examined.given);
  lines.erase(lines.begin());  // the headline stands above
  for (const auto& note : d.notes) lines.push_back("Note: " + note + ".");
  for (const std::string& line : lines) {
    if (line.starts_with("Load cell against")) continue;  // in the table
    const auto colon = line.find(": ");
    const bool detail = line.starts_with("  ");
    if (detail || colon == std::string::npos)
      out += QStringLiteral("<p style='margin:2px 0 2px 14px'>%1</p>").arg(said(line));
    else
      out += QStringLiteral("<p style='margin:10px 0 2px 0'><b>%1:</b> %2</p>")
                 .arg(said(line.substr(0, colon)), said(line.substr(colon + 2)));
  }
  return out;
}

}  // namespace searig::app::desktop
