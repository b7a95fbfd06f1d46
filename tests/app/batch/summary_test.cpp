// A batch's table and page.
#include "app/batch/summary.h"

#include <gtest/gtest.h>

namespace searig::app {
namespace {

using nlohmann::json;

Summary evaluations() {
  return {"evaluate",
          {{{"name", "a"},
            {"path", "in, a folder/a"},
            {"seconds", 60.0},
            {"models",
             {{"best_fit", {{"k_nm_per_rad", 0.1}, {"error_percent", nullptr}}},
              {"online", {{"k_nm_per_rad", 41.0}, {"error_percent", 8.0}}}}},
            {"notes", {"12 samples are \"left out\""}}},
           {{"name", "b"}, {"path", "b"}, {"why", "b: there is no such recording."}}}};
}

TEST(Summary, HasARowForEachRecording) {
  const std::string csv = csv_of(evaluations());
  const std::string first = csv.substr(csv.find('\n') + 1);
  EXPECT_TRUE(csv.starts_with("path,name,seconds,best_fit_k_nm_per_rad,")) << csv;
  EXPECT_TRUE(first.starts_with("\"in, a folder/a\",a,60,0.1,,,,,41,8,")) << first;
  EXPECT_NE(first.find("\"12 samples are \"\"left out\"\"\","), std::string::npos) << first;
  EXPECT_NE(first.find("\nb,b,,,"), std::string::npos) << first;
  EXPECT_TRUE(csv.ends_with(",b: there is no such recording.\n")) << csv;
}

TEST(Summary, AnswersAsTheContractSays) {
  const json answer = answer_of(evaluations());
  EXPECT_EQ(answer.at("format"), "searig-evaluation/1");
  EXPECT_EQ(answer.at("recordings").size(), 1u);
  EXPECT_EQ(answer.at("failed").at(0).at("why"), "b: there is no such recording.");
  EXPECT_EQ(answer_of({"diagnose", {}}).at("format"), "searig-diagnoses/1");
}

TEST(Summary, HasAPageThatNeedsNothingBesideIt) {
  const std::string page = page_of(evaluations()).text();
  for (const char* part : {"1 of 2 were evaluated; 1 failed.", "Stiffness over the recordings",
                           "N samples are &quot;left out&quot;", "there is no such recording"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  EXPECT_EQ(page.find("src="), std::string::npos);
  EXPECT_EQ(page.find("href="), std::string::npos);
}

TEST(Summary, CountsARecordingWithTwoNotesOfAKindOnce) {
  Summary summary = evaluations();
  summary.answers[0]["notes"] = {"12 samples are lost", "3 samples are lost"};
  EXPECT_NE(page_of(summary).text().find("<td>N samples are lost</td><td>1</td>"),
            std::string::npos);
}

TEST(Summary, CountsFindingsByKind) {
  const json finding{{"effect", "spring.viscous"}, {"probability", 0.97}};
  const json undecided{{"effects", {"rig.delay"}}};
  const Summary summary{"diagnose",
                        {{{"name", "a"},
                          {"path", "a"},
                          {"verdict", "missing_physics"},
                          {"findings", {finding}},
                          {"undecidable", {undecided}},
                          {"model", {{"spring.linear", {{"k_nm_per_rad", 40.0}}}}},
                          {"notes", json::array()}},
                         {{"name", "b"},
                          {"path", "b"},
                          {"verdict", "consistent"},
                          {"findings", json::array()},
                          {"undecidable", json::array()}}}};
  EXPECT_NE(csv_of(summary).find("\na,a,missing_physics,spring.viscous,0.97,1,,40,"),
            std::string::npos)
      << csv_of(summary);
  const std::string page = page_of(summary).text();
  for (const char* part :
       {"All 2 were diagnosed.", "missing_physics", "spring.viscous", "0.97", "rig.delay"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
}

TEST(Summary, OfNothingIsStillOne) {
  for (const char* command : {"evaluate", "diagnose"})
    EXPECT_NE(page_of({command, {}}).text().find("All 0"), std::string::npos);
}

}  // namespace
}  // namespace searig::app
