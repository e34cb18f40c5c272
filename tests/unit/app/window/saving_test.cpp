// Everything that the window saves, where it cannot be saved: on a full disk and in a read-only
// folder. It is said, what was there stays, and nothing is left behind.

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <map>

#include <gtest/gtest.h>

#include "client/app/window/making/composition_file.h"
#include "client/gui/editing/composer.h"
#include "client/gui/storage/face_copies.h"
#include "client/gui/storage/kept_settings.h"
#include "client/gui/storage/user_face.h"
#include "client/view/image.h"
#include "common/files.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/face/small_face.h"

namespace aucast::app {
namespace {

namespace fs = std::filesystem;

Result<void> outcome(const auto& saved) {
  return saved ? Result<void>() : Result<void>(saved.error());
}

/// A thing that is saved: what is in the folder before, and the saving of something longer.
struct Thing {
  const char* name;
  const char* file;  ///< that is replaced; empty: none
  void (*prepare)(const test::TempFolder& folder);
  Result<void> (*save)(const fs::path& folder);
};

void write_face(const test::TempFolder& folder) {
  face::test::write_small_face(folder);
}

Result<void> save_an_au(const fs::path& folder) {
  return outcome(gui::save_aus(folder, {{77, {{"jaw", 1.5F}}, {}}}));
}

void write_stream(const test::TempFolder& folder) {
  folder.write("mine.txt", "Beg_Stream\n1;500\nEnd_Stream\n");
}

Result<void> save_a_stream(const fs::path& folder) {
  gui::Composer composer;
  for (int number = 1; number <= 60; ++number) {
    composer.set_au(number, 100, 100, false);
    composer.add();
  }
  return outcome(save_stream(composer.keyframes(), folder / "mine.txt"));
}

void write_settings(const test::TempFolder& folder) {
  ASSERT_TRUE(gui::save_settings({}, folder.path() / "face-player.toml"));
}

Result<void> save_the_settings(const fs::path& folder) {
  gui::KeptSettings settings;
  settings.recent.assign(8, "lecture.example.org:4651");
  return gui::save_settings(settings, folder / "face-player.toml");
}

view::Image noise(int width) {
  view::Image image = view::make_image(width, 40);
  unsigned state = 1;
  for (auto& byte : image.rgba) byte = static_cast<std::uint8_t>((state = state * 75 + 74) >> 3U);
  return image;
}

void write_picture(const test::TempFolder& folder) {
  ASSERT_TRUE(view::write_png(noise(10), folder.path() / "face-player-1.png"));
}

Result<void> save_a_picture(const fs::path& folder) {
  return view::write_png(noise(50), folder / "face-player-1.png");
}

void write_shipped(const test::TempFolder& folder) {
  const test::TempFolder made;
  face::test::write_small_face(made);
  fs::copy(made.path(), folder.path() / "shipped", fs::copy_options::recursive);
  fs::permissions(folder.path() / "shipped", fs::perms::others_exec | fs::perms::others_read,
                  fs::perm_options::add);
}

/// The copy that the editor makes of a shipped face before the first saving.
Result<void> copy_a_face(const fs::path& folder) {
  return outcome(gui::writable_face(folder / "shipped", {folder, folder / "faces"}));
}

class Saving : public testing::TestWithParam<Thing> {
 protected:
  void SetUp() override {
    GetParam().prepare(folder_);
    before_ = files();
  }

  [[nodiscard]] std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path())) {
      if (!entry.is_regular_file()) continue;
      found[fs::relative(entry.path(), folder_.path()).string()] = *read_file(entry.path());
    }
    return found;
  }

  /// Saves in another process, which `limit` has taken something from; true when the failure is
  /// said.
  [[nodiscard]] bool failure_is_said(const std::function<void()>& limit) const {
    const pid_t child = ::fork();
    if (child == 0) {
      limit();
      const auto saved = GetParam().save(folder_.path());
      ::_exit(!saved && saved.error().kind == ErrorKind::Failed ? 0 : 1);
    }
    int status = 1;
    return child > 0 && ::waitpid(child, &status, 0) == child && status == 0;
  }

  /// Beside what was there only a version before, which is the same, may be.
  void expect_as_before() const {
    for (const auto& [name, bytes] : files()) {
      const bool version = name.ends_with('~');
      const auto old = before_.find(version ? name.substr(0, name.size() - 1) : name);
      ASSERT_NE(old, before_.end()) << name << " was left behind";
      EXPECT_EQ(bytes, old->second) << name;
    }
    for (const auto& [name, bytes] : before_) EXPECT_TRUE(files().contains(name)) << name;
  }

  test::TempFolder folder_;
  std::map<std::string, std::string> before_;
};

/// What RLIMIT_FSIZE does to a write is what a full disk does: it fails half-way.
TEST_P(Saving, OnAFullDiskLosesNothing) {
  std::vector<std::size_t> rooms{20, 100};
  // The disk is full at once, within the new file, and after the version before.
  const std::string file = GetParam().file;
  if (!file.empty()) rooms = {20, before_.at(file).size() / 2, before_.at(file).size()};
  for (const std::size_t room : rooms) {
    EXPECT_TRUE(failure_is_said([&] {
      std::signal(SIGXFSZ, SIG_IGN);
      const rlimit limit{room, room};
      ::setrlimit(RLIMIT_FSIZE, &limit);
    })) << room;
    expect_as_before();
  }
}

TEST_P(Saving, InAReadOnlyFolderIsSaid) {
  fs::permissions(folder_.path(), fs::perms::others_exec | fs::perms::others_read,
                  fs::perm_options::add);
  fs::permissions(folder_.path(), fs::perms::owner_write, fs::perm_options::remove);
  EXPECT_TRUE(failure_is_said([] {
    // Root may write everywhere, so it becomes nobody.
    if (::geteuid() == 0 && ::setuid(65534) != 0) ::_exit(2);
  }));
  fs::permissions(folder_.path(), fs::perms::owner_write, fs::perm_options::add);
  expect_as_before();
}

/// The other way round: with room it works, so that the tests above see failures of room.
TEST_P(Saving, WorksWhereThereIsRoom) {
  const auto saved = GetParam().save(folder_.path());
  EXPECT_TRUE(saved) << saved.error().message;
  EXPECT_NE(files(), before_);
}

INSTANTIATE_TEST_SUITE_P(
    Everything, Saving,
    testing::Values(Thing{"Au", "aus.toml", write_face, save_an_au},
                    Thing{"Stream", "mine.txt", write_stream, save_a_stream},
                    Thing{"Settings", "face-player.toml", write_settings, save_the_settings},
                    Thing{"Picture", "face-player-1.png", write_picture, save_a_picture},
                    Thing{"CopyOfAFace", "", write_shipped, copy_a_face}),
    [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace aucast::app
