#include "apps/output/result_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "tests/apps/small_disk.h"
#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using testing::complaint;
using ::testing::HasSubstr;
using testing::read_text;
using testing::SmallDisk;
using testing::TempFolder;

TEST(ResultFolder, MakesTheFolderAndPublishesEveryFile) {
  const TempFolder temp;
  ResultFolder folder(temp.path() / "a/b");
  folder.write("one.txt", "1\n");
  folder.write("two.bin", std::string("\0\xff\n", 3));
  folder.publish();
  EXPECT_EQ(read_text(temp.path() / "a/b/one.txt"), "1\n");
  EXPECT_EQ(read_text(temp.path() / "a/b/two.bin"), std::string("\0\xff\n", 3));
  EXPECT_EQ(std::distance(fs::directory_iterator(temp.path() / "a/b"), {}), 2);
}

TEST(ResultFolder, ShowsNothingUnderItsNameBeforeItIsPublished) {
  const TempFolder temp;
  ResultFolder folder(temp.path());
  folder.write("one.txt", "1\n");
  EXPECT_FALSE(fs::exists(temp.path() / "one.txt"));
}

TEST(ResultFolder, WhatWasAbandonedLeavesNothing) {
  const TempFolder temp;
  {
    ResultFolder folder(temp.path());
    folder.write("one.txt", "1\n");
    folder.write("two.txt", "2\n");
  }
  EXPECT_EQ(temp.count(), 0u);
}

TEST(ResultFolder, WhatWasAbandonedLeavesEarlierResultsAsTheyWere) {
  const TempFolder temp;
  temp.write("one.txt", "before\n");
  {
    ResultFolder folder(temp.path());
    folder.write("one.txt", "after\n");
  }
  EXPECT_EQ(read_text(temp.path() / "one.txt"), "before\n");
}

TEST(ResultFolder, PublishingReplacesEarlierResults) {
  const TempFolder temp;
  temp.write("one.txt", "before, and longer\n");
  ResultFolder folder(temp.path());
  folder.write("one.txt", "after\n");
  folder.publish();
  EXPECT_EQ(read_text(temp.path() / "one.txt"), "after\n");
}

// /dev/stdout is one: what it leads to would stay as it was, and the link be gone.
TEST(ResultFolder, ALinkIsNotReplaced) {
  const TempFolder temp;
  const fs::path file = temp.write("one.txt", "mine\n");
  fs::create_symlink(file, temp.path() / "link.txt");
  fs::create_symlink(temp.path() / "nowhere", temp.path() / "dangling.txt");
  for (const char* name : {"link.txt", "dangling.txt"})
    EXPECT_THAT(complaint([&] { ResultFolder(temp.path(), {name}); }), HasSubstr("it is a link")) << name;
  EXPECT_EQ(read_text(file), "mine\n");
}

TEST(ResultFolder, NamesTheOptionThatNamedIt) {
  EXPECT_THAT(complaint([] { ResultFolder("", {}, "--record"); }), HasSubstr("--record : cannot be made"));
}

TEST(ResultFolder, AFileInThePlaceOfTheFolderIsRefused) {
  const TempFolder temp;
  const fs::path file = temp.write("f", "x");
  EXPECT_THAT(complaint([&] { ResultFolder{file}; }), HasSubstr("--out " + file.string()));
  EXPECT_THAT(complaint([&] { ResultFolder{file / "g"}; }), HasSubstr("--out " + (file / "g").string()));
  EXPECT_EQ(read_text(file), "x");
}

TEST(ResultFolder, AFolderThatCannotBeMadeIsRefused) {
  EXPECT_THAT(complaint([] { ResultFolder{"/proc/lineservo/out"}; }),
              AllOf(HasSubstr("--out /proc/lineservo/out"), HasSubstr("cannot be made")));
  EXPECT_THAT(complaint([] { ResultFolder{""}; }), HasSubstr("--out"));
}

TEST(ResultFolder, AFullDiskIsOneErrorAndLeavesNothing) {
  const TempFolder temp;
  std::string message;
  {
    const SmallDisk disk(4096);
    message = complaint([&] {
      ResultFolder folder(temp.path());
      folder.write("small.txt", "1\n");
      folder.write("large.txt", std::string(100000, 'x'));
      folder.publish();
    });
  }
  EXPECT_THAT(message, AllOf(HasSubstr("large.txt"), HasSubstr("cannot be written")));
  EXPECT_EQ(message.find('\n'), std::string::npos);
  EXPECT_EQ(temp.count(), 0u);
}

TEST(ResultFolder, AFolderInThePlaceOfAFilePublishesNothing) {
  const TempFolder temp;
  fs::create_directories(temp.path() / "two.txt/inside");
  const std::string message = complaint([&] {
    ResultFolder folder(temp.path());
    folder.write("one.txt", "1\n");
    folder.write("two.txt", "2\n");
    folder.publish();
  });
  EXPECT_THAT(message, AllOf(HasSubstr("two.txt"), HasSubstr("cannot be written")));
  EXPECT_EQ(temp.count(), 1u);
}

TEST(ResultFolder, ADeviceOrAPipeIsNotReplaced) {
  const TempFolder temp;
  ASSERT_EQ(::mkfifo((temp.path() / "pipe").c_str(), 0600), 0);
  ResultFolder folder(temp.path());
  EXPECT_THAT(complaint([&] { folder.write("pipe", "x"); }),
              AllOf(HasSubstr("pipe"), HasSubstr("not a file")));
  EXPECT_TRUE(fs::is_fifo(temp.path() / "pipe"));
  EXPECT_THAT(complaint([] { ResultFolder("/dev").check("null"); }), HasSubstr("/dev/null"));
}

TEST(ResultFolder, WhatASetLeavesOutGoesWithTheEarlierOne) {
  const TempFolder temp;
  temp.write("old.txt", "before\n");
  temp.write("notes.txt", "mine\n");
  ResultFolder folder(temp.path());
  folder.leave_out("old.txt");
  folder.leave_out("never.txt");
  folder.write("one.txt", "1\n");
  EXPECT_TRUE(fs::exists(temp.path() / "old.txt"));
  folder.publish();
  EXPECT_FALSE(fs::exists(temp.path() / "old.txt"));
  EXPECT_EQ(temp.count(), 2u);
}

TEST(ResultFolder, AFileThatSomeoneElseWritesIsPublishedWithTheOthers) {
  const TempFolder temp;
  ResultFolder folder(temp.path());
  const fs::path aside = folder.reserve("film.mp4");
  EXPECT_EQ(aside.extension(), ".mp4");
  std::ofstream(aside) << "film";
  folder.write("seal", "x");
  EXPECT_FALSE(fs::exists(temp.path() / "film.mp4"));
  folder.publish();
  EXPECT_EQ(read_text(temp.path() / "film.mp4"), "film");
  EXPECT_EQ(temp.count(), 2u);
}

TEST(ResultFolder, WhatIsGivenUpGoesAndAnEarlierFileStays) {
  const TempFolder temp;
  temp.write("film.mp4", "before");
  ResultFolder folder(temp.path());
  std::ofstream(folder.reserve("film.mp4")) << "half";
  folder.give_up("film.mp4");
  EXPECT_EQ(temp.count(), 1u);
  folder.write("seal", "x");
  folder.publish();
  EXPECT_EQ(read_text(temp.path() / "film.mp4"), "before");
}

TEST(ResultFolder, AnEarlierFileGoesOnlyBesideItsOwner) {
  const TempFolder temp;
  temp.write("film.mp4", "mine");
  const auto publish = [&temp] {
    ResultFolder folder(temp.path());
    folder.leave_out("film.mp4", "owner");
    folder.write("seal", "x");
    folder.publish();
  };
  publish();
  EXPECT_EQ(read_text(temp.path() / "film.mp4"), "mine");
  temp.write("owner", "x");
  publish();
  EXPECT_FALSE(fs::exists(temp.path() / "film.mp4"));
}

/// Whether the set in a folder is whole by its seal, the file written last; and if so, whether it is of one
/// run.
bool is_mixed(const fs::path& folder) {
  if (!fs::exists(folder / "c")) return false;
  const std::string run = read_text(folder / "c");
  return read_text(folder / "a") != run || read_text(folder / "b") != run;
}

void publish_run(const fs::path& path, const std::string& run) {
  ResultFolder folder(path);
  for (const char* name : {"a", "b", "c"}) folder.write(name, run);
  folder.publish();
}

/// Publishes one run after another, and tells when the first is out: on a busy machine that takes its time.
[[noreturn]] void publish_without_end(const fs::path& path, int tells) {
  publish_run(path, "0");
  static_cast<void>(!::write(tells, "x", 1));
  for (int run = 1;; ++run) publish_run(path, std::to_string(run));
}

// A child that publishes one run after another is killed at any time.
TEST(ResultFolder, AKillAtAnyTimeLeavesNoMixedSetThatLooksWhole) {
  const TempFolder temp;
  int seals = 0;
  for (int kill_us = 0; kill_us < 20000; kill_us += 250) {
    int told[2];
    ASSERT_EQ(::pipe(told), 0);
    const pid_t child = ::fork();
    if (child == 0) publish_without_end(temp.path(), told[1]);
    char began = 0;
    ASSERT_EQ(::read(told[0], &began, 1), 1);
    ::close(told[0]);
    ::close(told[1]);
    ::usleep(static_cast<useconds_t>(kill_us));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    seals += int{fs::exists(temp.path() / "c")};
    ASSERT_FALSE(is_mixed(temp.path())) << kill_us;
  }
  EXPECT_GT(seals, 0);
}

TEST(ResultFolder, OfTwoRunsAtTheSameTimeOneIsLeftWhole) {
  const TempFolder temp;
  for (int round = 0; round < 30; ++round) {
    std::thread first(publish_run, temp.path(), "first"), second(publish_run, temp.path(), "second");
    first.join();
    second.join();
    ASSERT_TRUE(fs::exists(temp.path() / "c"));
    ASSERT_FALSE(is_mixed(temp.path()));
    ASSERT_EQ(temp.count(), 3u);
  }
}

TEST(ResultFolder, TwoWritersDoNotMixHalfFiles) {
  const TempFolder temp;
  ResultFolder first(temp.path()), second(temp.path());
  const std::string a(100000, 'a'), b(50000, 'b');
  first.write("one.txt", a);
  second.write("one.txt", b);
  first.publish();
  EXPECT_TRUE(read_text(temp.path() / "one.txt") == a);
  second.publish();
  EXPECT_TRUE(read_text(temp.path() / "one.txt") == b);
  EXPECT_EQ(temp.count(), 1u);
}

/// A set with a folder of files beside its own.
void publish_frames(const fs::path& path, const std::vector<std::string>& frames) {
  ResultFolder folder(path);
  folder.begin_folder("frames", ".png", "owner");
  for (std::size_t k = 0; k < frames.size(); ++k) folder.write_numbered(k, frames[k]);
  folder.write("owner", "");
  folder.write("seal", "");
  folder.publish();
}

TEST(ResultFolder, AFolderOfFilesIsPublishedAndReplacedAsAWhole) {
  const TempFolder temp;
  publish_frames(temp.path(), {"a", "b", "c"});
  EXPECT_EQ(read_text(temp.path() / "frames/000002.png"), "c");
  publish_frames(temp.path(), {"d"});
  EXPECT_EQ(read_text(temp.path() / "frames/000000.png"), "d");
  EXPECT_FALSE(fs::exists(temp.path() / "frames/000001.png"));
  EXPECT_EQ(temp.count(), 3u);
}

TEST(ResultFolder, AFolderThatWasAbandonedLeavesNothing) {
  const TempFolder temp;
  {
    ResultFolder folder(temp.path());
    folder.begin_folder("frames", ".png", "owner");
    folder.write_numbered(0, "a");
  }
  EXPECT_EQ(temp.count(), 0u);
}

TEST(ResultFolder, AFolderThatIsNotOfAnEarlierSetIsNotTouched) {
  const auto beginning = [](const TempFolder& temp) {
    return complaint([&] { ResultFolder(temp.path()).begin_folder("frames", ".png", "owner"); });
  };
  const TempFolder without_owner, with_more, with_link;
  fs::create_directory(without_owner.path() / "frames");
  without_owner.write("frames/000000.png", "mine");
  EXPECT_THAT(beginning(without_owner), HasSubstr("is there already, and not from an earlier run"));
  publish_frames(with_more.path(), {"a"});
  with_more.write("frames/notes.txt", "mine");
  EXPECT_THAT(beginning(with_more), HasSubstr("is there already"));
  fs::create_symlink(without_owner.path() / "frames", with_link.path() / "frames");
  EXPECT_THAT(beginning(with_link), HasSubstr("is there already"));

  ResultFolder folder(with_more.path());
  folder.leave_out_folder("frames", ".png", "owner");
  folder.write("seal", "");
  folder.publish();
  EXPECT_EQ(read_text(with_more.path() / "frames/notes.txt"), "mine");
}

TEST(ResultFolder, AnEarlierSetsFolderGoesWhenItIsLeftOut) {
  const TempFolder temp;
  publish_frames(temp.path(), {"a"});
  ResultFolder folder(temp.path());
  folder.leave_out_folder("frames", ".png", "owner");
  folder.leave_out("owner");
  folder.write("seal", "new");
  folder.publish();
  EXPECT_EQ(temp.count(), 1u);
}

}  // namespace
}  // namespace lineservo::apps
