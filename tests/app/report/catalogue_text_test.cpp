#include "app/report/catalogue_text.h"

#include <gtest/gtest.h>

#include "acquisition/recording/text_file.h"
#include "estimator/physics/catalogue.h"

namespace searig::app {
namespace {

TEST(CatalogueText, DocumentIsUpToDate) {
  EXPECT_EQ(acquisition::read_text_file(SEARIG_SOURCE_DIR "/docs/catalogue.md"),
            catalogue_markdown())
      << "write it anew: searig effects --markdown > docs/catalogue.md";
}

TEST(CatalogueText, TellsOfEveryEffect) {
  const std::string markdown = catalogue_markdown(), lines = catalogue_lines();
  for (const auto* effect : estimator::catalogue()) {
    EXPECT_NE(markdown.find("### " + effect->name() + "\n"), std::string::npos);
    EXPECT_NE(lines.find(effect->name() + " "), std::string::npos);
    EXPECT_NE(markdown.find(effect->about().equation), std::string::npos);
    EXPECT_NE(markdown.find(effect->about().source), std::string::npos);
  }
}

}  // namespace
}  // namespace searig::app
