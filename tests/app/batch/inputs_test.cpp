// Which recordings are found in folders and lists, and in what order.
#include "app/batch/inputs.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/acquisition/recording/refusal.h"
#include "tests/temporary_folder.h"

namespace searig::app {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<std::string>;

class FindRecordings : public testing::Test {
 protected:
  FindRecordings() {
    for (const char* folder : {"all/b", "all/a/deep", "empty", "all/c"})
      fs::create_directories(folder_.path() / folder);
    for (const char* recording : {"all/b", "all/a/deep"})
      folder_.write(std::string(recording) + "/recording.toml", "");
    for (const char* file : {"all/a.mcap", "all/b/inside.mcap", "all/c/z.mcap", "all/notes.txt"})
      folder_.write(file, "");
  }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  TemporaryFolder folder_;
};

TEST_F(FindRecordings, FindsAllBelowAFolderSorted) {
  const Inputs found = find_recordings({path("all")});
  EXPECT_TRUE(found.searched);
  EXPECT_EQ(found.recordings,
            (Paths{path("all/a.mcap"), path("all/a/deep"), path("all/b"), path("all/c/z.mcap")}));
}

TEST_F(FindRecordings, LeavesWhatIsNamedAsItIs) {
  const Paths named{path("all/b"), path("nowhere"), path("all/a.mcap"), path("empty")};
  const Inputs found = find_recordings(named);
  EXPECT_FALSE(found.searched);
  EXPECT_EQ(found.recordings, named);
}

TEST_F(FindRecordings, TakesEachOnce) {
  const Inputs found = find_recordings({path("all/b"), path("all"), path("all/./b/")});
  EXPECT_EQ(found.recordings,
            (Paths{path("all/b"), path("all/a.mcap"), path("all/a/deep"), path("all/c/z.mcap")}));
}

TEST_F(FindRecordings, ReadsAList) {
  const fs::path list = folder_.write(
      "list", "# the good ones\r\n\n " + path("all/b") + " \r\n" + path("all/c") + "\n");
  const Inputs found = find_recordings({path("all/a.mcap")}, list.string());
  EXPECT_TRUE(found.searched);
  EXPECT_EQ(found.recordings, (Paths{path("all/a.mcap"), path("all/b"), path("all/c/z.mcap")}));
}

TEST_F(FindRecordings, RefusesAListThatNamesNothing) {
  const fs::path list = folder_.write("list", "# none\n");
  const std::string why = acquisition::refusal([&] { find_recordings({}, list.string()); });
  EXPECT_EQ(why, list.string() + ": names no recording.");
}

TEST_F(FindRecordings, DoesNotFollowLinksInACircle) {
  fs::create_directory_symlink(folder_.path() / "all", folder_.path() / "all/c/again");
  EXPECT_EQ(find_recordings({path("all")}).recordings.size(), 4u);
}

}  // namespace
}  // namespace searig::app
