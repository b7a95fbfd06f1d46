#include "acquisition/exchange/new_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "acquisition/exchange/hdf5.h"
#include "acquisition/exchange/mat.h"
#include "acquisition/exchange/sha256.h"
#include "tests/acquisition/exchange/a_recording.h"
#include "tests/temporary_folder.h"

namespace searig::acquisition::exchange {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::size_t files_in(const fs::path& folder) {
  return std::size_t(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(NewFile, IsThereWholeOrNotAtAll) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.csv";
  {
    const NewFile dropped(path, false);
    std::ofstream(dropped.temporary()) << "half";
  }
  EXPECT_EQ(files_in(folder.path()), 0u);
  NewFile file(path, false);
  std::ofstream(file.temporary()) << "whole";
  EXPECT_FALSE(fs::exists(path));
  file.keep();
  EXPECT_EQ(text_of(path), "whole");
  EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(NewFile, ReplacesOnlyWhatItIsToldTo) {
  const TemporaryFolder folder;
  const fs::path path = folder.write("a.csv", "before");
  EXPECT_THROW(NewFile(path, false), std::runtime_error);
  NewFile meanwhile(folder.path() / "b.csv", false);
  std::ofstream(meanwhile.temporary()) << "mine";
  folder.write("b.csv", "another's");
  EXPECT_THROW(meanwhile.keep(), std::runtime_error);
  EXPECT_EQ(text_of(folder.path() / "b.csv"), "another's");
  NewFile file(path, true);
  std::ofstream(file.temporary()) << "after";
  file.keep();
  EXPECT_EQ(text_of(path), "after");
}

/// Whether `write` says that the disk is full, in a process whose files may be `bytes` long.
bool says_full(std::size_t bytes, const std::function<void()>& write) {
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
    try {
      write();
    } catch (const std::runtime_error&) {
      _exit(3);
    }
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 3;
}

TEST(NewFile, AFullDiskIsToldByEveryFormat) {
  const TemporaryFolder folder;
  const Recording recording = a_recording(10.0);
  const Contents contents = contents_of(recording);
  const fs::path whole = folder.path() / "whole", part = folder.path() / "part";
  const auto each = [&](auto write) {
    write(contents, "searig test", whole);
    const std::size_t size = fs::file_size(whole);
    for (const std::size_t bytes : {std::size_t{100}, size / 10, size / 2, size - 1})
      EXPECT_TRUE(says_full(bytes, [&] { write(contents, "searig test", part); }))
          << bytes << " of " << size << ", left " << fs::file_size(part);
    EXPECT_FALSE(says_full(size, [&] { write(contents, "searig test", part); }));
  };
  each(write_mat);
  each(write_hdf5);
}

TEST(Sha256, IsTheStandards) {  // FIPS 180-2, appendix B
  const TemporaryFolder folder;
  EXPECT_EQ(sha256_of(folder.write("a", "abc")),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of(folder.write("b", "")),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

}  // namespace
}  // namespace searig::acquisition::exchange
