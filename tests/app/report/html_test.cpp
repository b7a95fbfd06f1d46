#include "app/report/html.h"

#include <gtest/gtest.h>

#include <regex>
#include <stdexcept>
#include <vector>

namespace searig::app {
namespace {

HtmlReport small_report() {
  HtmlReport report("Spring <1>");
  report.verdict("All is well & true.");
  report.facts({{"stiffness", "40 N·m/rad"}});
  report.heading("Errors");
  report.table({"model", "error"}, {{"best fit", "7 %"}}, "Table I");
  Plot plot{.title = "Torque"};
  plot.series = {{"measured", {0, 1}, {0, 1}}};
  report.figure(plot, "first");
  report.figure(plot, "second");
  report.code("k = 1 < 2\n");
  return report;
}

/// Every element that is opened is closed, in the right order.
bool balanced(const std::string& html) {
  std::vector<std::string> open;
  const std::regex tag("<(/?)([a-zA-Z0-9]+)[^>]*?(/?)>");
  for (std::sregex_iterator it(html.begin(), html.end(), tag), end; it != end; ++it) {
    const std::string name = (*it)[2];
    if ((*it)[3] == "/" || name == "meta") continue;
    if ((*it)[1] != "/") {
      open.push_back(name);
    } else {
      if (open.empty() || open.back() != name) return false;
      open.pop_back();
    }
  }
  return open.empty();
}

TEST(Html, IsWellFormed) {
  EXPECT_TRUE(balanced(small_report().text()));
}

TEST(Html, NeedsNothingBesideIt) {
  const std::string html = std::regex_replace(
      small_report().text(), std::regex("xmlns=\"http://www.w3.org/2000/svg\""), "");
  for (const char* outside : {"http:", "https:", "src=", "<link", "@import", "<script"}) {
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
  }
}

TEST(Html, EscapesWords) {
  const std::string html = small_report().text();
  EXPECT_NE(html.find("Spring &lt;1&gt;"), std::string::npos);
  EXPECT_NE(html.find("well &amp; true"), std::string::npos);
  EXPECT_NE(html.find("k = 1 &lt; 2"), std::string::npos);
}

TEST(Html, NumbersItsFigures) {
  const std::string html = small_report().text();
  EXPECT_NE(html.find("Figure 1. first"), std::string::npos);
  EXPECT_NE(html.find("Figure 2. second"), std::string::npos);
}

TEST(Html, SaysWhereItCannotBeWritten) {
  try {
    small_report().write("/nowhere/at/all.html");
    FAIL() << "wrote into a folder that is not there";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/at/all.html"), std::string::npos);
  }
}

}  // namespace
}  // namespace searig::app
