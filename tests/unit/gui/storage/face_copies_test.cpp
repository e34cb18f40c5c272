#include "client/gui/storage/face_copies.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <functional>

#include <gtest/gtest.h>

#include "client/gui/storage/user_face.h"
#include "tests/unit/gui/storage/user_face_fixture.h"

namespace aucast::gui {
namespace {

namespace fs = std::filesystem;

constexpr fs::perms kWrite =
    fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;

class FaceCopies : public UserFaceTest {
 protected:
  /// Does it in another process, which is nobody if this is root: root may write everywhere.
  [[nodiscard]] bool works_for_a_user(const std::function<bool()>& work) const {
    constexpr uid_t kNobody = 65534;
    const bool root = ::geteuid() == 0;
    if (root) {
      fs::create_directories(mine_);
      EXPECT_EQ(::chown(folder_.path().c_str(), kNobody, kNobody), 0);
      for (const auto& entry : fs::recursive_directory_iterator(folder_.path())) {
        EXPECT_EQ(::chown(entry.path().c_str(), kNobody, kNobody), 0) << entry.path();
      }
    }
    const pid_t child = ::fork();
    if (child == 0) {
      if (root && ::setuid(kNobody) != 0) ::_exit(2);
      ::_exit(work() ? 0 : 1);
    }
    int status = 1;
    return child > 0 && ::waitpid(child, &status, 0) == child && status == 0;
  }
};

TEST_F(FaceCopies, AShippedFaceIsCopiedOnce) {
  const auto copy = writable_face(shipped_, faces_);
  ASSERT_TRUE(copy) << copy.error().message;
  EXPECT_EQ(*copy, mine_ / "plain");
  EXPECT_TRUE(face::load_face(*copy, folder_.path()));
  folder_.write("home/aucast/faces/plain/aus.toml", "mine");
  EXPECT_EQ(*writable_face(shipped_ / "", faces_), *copy);
  EXPECT_EQ(folder_.read("home/aucast/faces/plain/aus.toml"), "mine");
  EXPECT_EQ(std::distance(fs::directory_iterator(mine_), {}), 1);
}

TEST_F(FaceCopies, ACopyHasWhatItsFaceTakesFromAnother) {
  const fs::path other = shipped_.parent_path() / "other";
  fs::create_directories(other);
  fs::copy(shipped_ / "mesh.ply", other / "mesh.ply");
  std::string text = folder_.read("shipped/plain/face.toml");
  for (const std::string file : {"muscles.toml", "aus.toml"}) {
    text.replace(text.find('"' + file), 1, "\"../plain/");
  }
  folder_.write("shipped/other/face.toml", text);
  ASSERT_TRUE(face::load_face(other, folder_.path()));
  const auto copy = writable_face(other, faces_);
  ASSERT_TRUE(copy) << copy.error().message;
  const std::string whole = folder_.read("home/aucast/faces/other/face.toml");
  EXPECT_EQ(whole.find(".."), std::string::npos) << whole;
  const auto file = save_aus(*copy, {{77, {{"jaw", 1.5F}}, {}}});
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(*file, *copy / "aus.toml");
  const auto face = face::load_face(*copy, folder_.path());
  ASSERT_TRUE(face) << face.error().message;
  EXPECT_TRUE(face->recordings.contains(77));
  EXPECT_FALSE(face::load_face(other, folder_.path())->recordings.contains(77));
}

TEST_F(FaceCopies, TheUsersOwnFaceIsWrittenWhereItIs) {
  const auto copy = writable_face(shipped_, faces_);
  ASSERT_TRUE(copy);
  EXPECT_EQ(*writable_face(*copy, faces_), *copy);
}

TEST_F(FaceCopies, ACopyThatCannotBeMadeIsSaid) {
  folder_.write("home", "a file where a folder should be");
  const auto copy = writable_face(shipped_, faces_);
  ASSERT_FALSE(copy);
  EXPECT_EQ(copy.error().message.find("this face cannot be copied to " + mine_.string() + ": "), 0U)
      << copy.error().message;
}

TEST_F(FaceCopies, ACopyHasItsOwnNameAndSaysWhatItIsACopyOf) {
  const auto copy = copy_face(shipped_, faces_, "Anna's é 2");
  ASSERT_TRUE(copy) << copy.error().message;
  EXPECT_EQ(*copy, mine_ / "Anna's é 2");
  auto face = face::load_face(*copy, folder_.path());
  ASSERT_TRUE(face) << face.error().message;
  EXPECT_EQ(face->name, "Anna's é 2");
  EXPECT_EQ(face->copy_of, "plain");
  const auto again = copy_face(*copy, faces_, "berta");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(origin_of(*again), "plain") << "the copy of a copy";
  EXPECT_EQ(std::distance(fs::directory_iterator(mine_), {}), 2);
  EXPECT_EQ(face::load_face(shipped_, folder_.path())->name, "small");
}

TEST_F(FaceCopies, ALinkedFolderIsNotFollowed) {
  fs::create_directory_symlink(shipped_, shipped_ / "round");
  fs::create_directory(shipped_ / "notes");
  folder_.write("shipped/plain/notes/list.txt", "mine");
  const auto copy = copy_face(shipped_, faces_, "anna");
  ASSERT_TRUE(copy) << copy.error().message;
  EXPECT_FALSE(fs::exists(fs::symlink_status(*copy / "round")));
  EXPECT_EQ(folder_.read("home/aucast/faces/anna/notes/list.txt"), "mine");
}

TEST_F(FaceCopies, AFileWithoutANameStaysSo) {
  folder_.write("shipped/plain/face.toml", "mesh = \"\"\n");
  const auto copy = copy_face(shipped_, faces_, "anna");
  ASSERT_TRUE(copy) << copy.error().message;
  EXPECT_NE(folder_.read("home/aucast/faces/anna/face.toml").find("mesh = \"\"\n"),
            std::string::npos);
}

TEST_F(FaceCopies, ACopyOfItsFacesNameIsCalledOnesOwnInPictures) {
  const auto copy = writable_face(shipped_, faces_);
  ASSERT_TRUE(copy) << copy.error().message;
  const auto face = face::load_face(*copy, folder_.path());
  ASSERT_TRUE(face) << face.error().message;
  EXPECT_EQ(face->name, "own_plain");
  EXPECT_EQ(face->copy_of, "plain");
}

TEST_F(FaceCopies, ACopyKeepsHowItsAusCame) {
  const auto copy = copy_face(shipped_, faces_, "anna");
  ASSERT_TRUE(copy) << copy.error().message;
  const std::string came = folder_.read("shipped/plain/aus.toml");
  ASSERT_TRUE(save_aus(*copy, {{77, {{"jaw", 1.5F}}, {}}}));
  EXPECT_EQ(folder_.read("home/aucast/faces/anna/original_aus.toml"), came);
  const auto again = copy_face(*copy, faces_, "berta");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(folder_.read("home/aucast/faces/berta/original_aus.toml"), came);
}

TEST_F(FaceCopies, NothingIsCopiedOrRenamedOverWhatIsThere) {
  const auto copy = copy_face(shipped_, faces_, "anna");
  ASSERT_TRUE(copy) << copy.error().message;
  folder_.write("home/aucast/faces/notes/list.txt", "mine");
  fs::create_directory(mine_ / "empty");
  fs::create_directory_symlink("/no/such/folder", mine_ / "dangling");
  for (const char* name : {"anna", "notes", "empty", "dangling"}) {
    const auto copied = copy_face(shipped_, faces_, name);
    ASSERT_FALSE(copied) << name;
    EXPECT_EQ(copied.error().message,
              (mine_ / name).string() + ": is there already; choose another name");
    EXPECT_FALSE(rename_face(*copy, name)) << name;
  }
  EXPECT_EQ(folder_.read("home/aucast/faces/notes/list.txt"), "mine");
  EXPECT_EQ(std::distance(fs::directory_iterator(mine_), {}), 4);
}

TEST_F(FaceCopies, ARenamedFaceKeepsAllThatIsSavedInIt) {
  const auto copy = writable_face(shipped_, faces_);
  ASSERT_TRUE(copy);
  ASSERT_TRUE(save_aus(*copy, {{77, {{"jaw", 1.5F}}, "yawn"}}));
  const auto renamed = rename_face(*copy, "anna");
  ASSERT_TRUE(renamed) << renamed.error().message;
  EXPECT_FALSE(fs::exists(*copy));
  const auto face = face::load_face(*renamed, folder_.path());
  ASSERT_TRUE(face) << face.error().message;
  EXPECT_EQ(face->name, "anna");
  EXPECT_EQ(face->copy_of, "plain");
  EXPECT_TRUE(face->recordings.contains(77));
  EXPECT_TRUE(fs::exists(*renamed / "aus.toml~"));
  EXPECT_EQ(*writable_face(shipped_, faces_), mine_ / "plain") << "another copy";
}

TEST_F(FaceCopies, ARenamingThatFailsChangesNothing) {
  const auto copy = copy_face(shipped_, faces_, "anna");
  ASSERT_TRUE(copy);
  folder_.write("home/aucast/faces/anna/face.toml", "nonsense");
  const auto renamed = rename_face(*copy, "berta");
  ASSERT_FALSE(renamed);
  EXPECT_NE(renamed.error().message.find("face.toml:1:"), std::string::npos);
  EXPECT_TRUE(fs::exists(*copy));
  EXPECT_FALSE(fs::exists(mine_ / "berta"));
  const auto gone = rename_face(mine_ / "gone", "berta");
  ASSERT_FALSE(gone);
  EXPECT_EQ(gone.error().message.find("this face cannot be renamed to " + mine_.string()), 0U);
}

TEST_F(FaceCopies, ADeletedFaceIsGoneWhole) {
  const auto copy = copy_face(shipped_, faces_, "anna");
  ASSERT_TRUE(copy);
  ASSERT_TRUE(copy_face(shipped_, faces_, "berta"));
  ASSERT_TRUE(delete_face(*copy));
  EXPECT_EQ(std::distance(fs::directory_iterator(mine_), {}), 1);
  const auto again = delete_face(*copy);
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().message.find("this face cannot be deleted: " + copy->string()), 0U)
      << again.error().message;
}

TEST_F(FaceCopies, OfALinkOnlyTheLinkIsRenamedAndDeleted) {
  fs::create_directories(mine_);
  fs::create_directory_symlink(shipped_, mine_ / "linked");
  const std::string before = folder_.read("shipped/plain/face.toml");
  const auto renamed = rename_face(mine_ / "linked", "anna");
  ASSERT_TRUE(renamed) << renamed.error().message;
  EXPECT_TRUE(fs::is_symlink(*renamed));
  EXPECT_EQ(folder_.read("shipped/plain/face.toml"), before);
  const auto copy = copy_face(*renamed, faces_, "berta");
  ASSERT_TRUE(copy) << copy.error().message;
  EXPECT_FALSE(fs::is_symlink(*copy));
  ASSERT_TRUE(delete_face(*renamed));
  EXPECT_TRUE(fs::exists(shipped_ / "mesh.ply"));
  EXPECT_TRUE(fs::exists(*copy / "mesh.ply"));
}

/// What is edited must not get into a copy of another face that happens to have its name.
TEST_F(FaceCopies, AnEditedFaceIsNotSavedInACopyOfAnother) {
  ASSERT_TRUE(copy_face(shipped_, faces_, "anna"));
  const fs::path other = folder_.path() / "others" / "anna";
  fs::create_directories(other.parent_path());
  fs::copy(shipped_, other, fs::copy_options::recursive);
  const auto copy = writable_face(other, faces_);
  ASSERT_TRUE(copy) << copy.error().message;
  EXPECT_EQ(*copy, mine_ / "anna 2");
  EXPECT_EQ(origin_of(*copy), fs::canonical(other).string());
  EXPECT_EQ(origin_of(*copy_face(*copy, faces_, "berta")), origin_of(*copy)) << "a copy of it";
}

TEST_F(FaceCopies, AShippedFaceIsNotWrittenToThroughALink) {
  fs::create_directories(mine_);
  fs::create_directory_symlink(shipped_, mine_ / "plain");
  const auto copy = writable_face(shipped_, faces_);
  ASSERT_TRUE(copy) << copy.error().message;
  EXPECT_EQ(*copy, mine_ / "plain 2");
  EXPECT_FALSE(fs::equivalent(*copy, shipped_));
  EXPECT_EQ(*writable_face(mine_ / "plain", faces_), mine_ / "plain 3");
}

/// TOML has many ways to write a text.
TEST_F(FaceCopies, AFaceIsCopiedAndRenamedHoweverItsNameIsWritten) {
  const std::string text = folder_.read("shipped/plain/face.toml");
  int number = 0;
  for (const std::string written :
       {"''", "'x'", "'it\"s'", R"("")", R"("it\"s")", R"("\\")", R"("\u00e9")", R"("""it"s""")",
        "\"\"\"\nx\ny\"\"\"\"\"", "'''x\ny'''", R"("""\"""")"}) {
    std::string other = text;
    const std::size_t at = other.find("\"small\"");
    ASSERT_NE(at, std::string::npos);
    folder_.write("shipped/plain/face.toml", other.replace(at, 7, written));
    ASSERT_TRUE(face::load_face(shipped_, folder_.path())) << written;
    const std::string name = "anna " + std::to_string(++number);
    const auto copy = copy_face(shipped_, faces_, name);
    ASSERT_TRUE(copy) << written << ": " << copy.error().message;
    const auto face = face::load_face(*copy, folder_.path());
    ASSERT_TRUE(face) << written << ": " << face.error().message;
    EXPECT_EQ(face->name, name);
    EXPECT_EQ(face->copy_of, "plain");
  }
}

TEST_F(FaceCopies, AFaceOfAnyNameIsSavedAndRenamed) {
  int number = 0;
  for (const char* name : {"it\"s", "a\\b", "a\nb", "\xff", "'"}) {
    const fs::path odd = shipped_.parent_path() / name;
    fs::copy(shipped_, odd, fs::copy_options::recursive);
    const auto copy = writable_face(odd, faces_);
    ASSERT_TRUE(copy) << name << ": " << copy.error().message;
    ASSERT_TRUE(save_aus(*copy, {{77, {{"jaw", 1.5F}}, {}}})) << name;
    EXPECT_TRUE(face::load_face(*copy, folder_.path())) << name;
    const auto renamed = rename_face(*copy, "anna " + std::to_string(++number));
    ASSERT_TRUE(renamed) << name << ": " << renamed.error().message;
    EXPECT_TRUE(face::load_face(*renamed, folder_.path())) << name;
  }
}

TEST_F(FaceCopies, AReadOnlyFaceIsCopied) {
  folder_.write("shipped/plain/notes/list.txt", "notes");
  for (const fs::path& path : {shipped_ / "notes" / "list.txt", shipped_ / "notes", shipped_}) {
    fs::permissions(path, kWrite, fs::perm_options::remove);
  }
  EXPECT_TRUE(works_for_a_user([&] { return copy_face(shipped_, faces_, "anna").has_value(); }));
  for (const fs::path& path : {shipped_ / "notes", shipped_}) {
    fs::permissions(path, fs::perms::owner_write, fs::perm_options::add);
  }
  EXPECT_EQ(folder_.read("home/aucast/faces/anna/notes/list.txt"), "notes");
  const auto copy = mine_ / "anna";
  EXPECT_NE(fs::status(copy / "notes").permissions() & fs::perms::owner_write, fs::perms::none);
  EXPECT_TRUE(save_aus(copy, {{77, {{"jaw", 1.5F}}, {}}}));
}

TEST_F(FaceCopies, WhatAnotherProgramIsCopyingIsLeftAlone) {
  folder_.write("home/aucast/faces/.anna.unfinished/face.toml", "half");
  folder_.write("home/aucast/faces/.unfinished 1/face.toml", "half");
  const auto copy = copy_face(shipped_, faces_, "anna");
  ASSERT_TRUE(copy) << copy.error().message;
  EXPECT_EQ(folder_.read("home/aucast/faces/.anna.unfinished/face.toml"), "half");
  EXPECT_EQ(folder_.read("home/aucast/faces/.unfinished 1/face.toml"), "half");
  EXPECT_EQ(std::distance(fs::directory_iterator(mine_), {}), 3);
}

TEST_F(FaceCopies, WhatAnInterruptedCopyLeftIsRemovedByALaterOne) {
  folder_.write("home/aucast/faces/.unfinished 1/face.toml", "half");
  folder_.write("home/aucast/faces/mine/face.toml", "whole");
  const auto yesterday = fs::file_time_type::clock::now() - std::chrono::hours(24);
  for (const char* name : {".unfinished 1", "mine"}) fs::last_write_time(mine_ / name, yesterday);
  const auto copy = copy_face(shipped_, faces_, "anna");
  ASSERT_TRUE(copy) << copy.error().message;
  EXPECT_FALSE(fs::exists(mine_ / ".unfinished 1"));
  EXPECT_EQ(folder_.read("home/aucast/faces/mine/face.toml"), "whole");
}

TEST_F(FaceCopies, WhatCannotBeDeletedOfOneFaceIsNotInTheWayOfTheNext) {
  ASSERT_TRUE(copy_face(shipped_, faces_, "anna"));
  ASSERT_TRUE(copy_face(shipped_, faces_, "berta"));
  const fs::path half = mine_ / ".deleted 1";
  folder_.write("home/aucast/faces/.deleted 1/face.toml", "stays");
  fs::permissions(half, kWrite, fs::perm_options::remove);
  EXPECT_TRUE(works_for_a_user([&] { return delete_face(mine_ / "anna").has_value(); }));
  EXPECT_EQ(std::distance(fs::directory_iterator(mine_), {}), 2);
  fs::permissions(half, fs::perms::owner_write, fs::perm_options::add);
  ASSERT_TRUE(delete_face(mine_ / "berta"));
  EXPECT_TRUE(fs::is_empty(mine_)) << "what can be deleted by now is";
}

TEST_F(FaceCopies, AFaceFromElsewhereIsNotTheShippedOneOfItsName) {
  const auto of_shipped = writable_face(shipped_, faces_);
  ASSERT_TRUE(of_shipped) << of_shipped.error().message;
  EXPECT_EQ(shipped_origin(*of_shipped, faces_.shipped), shipped_);
  const fs::path other = folder_.path() / "others" / "plain";
  fs::create_directories(other.parent_path());
  fs::copy(shipped_, other, fs::copy_options::recursive);
  const auto copy = writable_face(other, faces_);
  ASSERT_TRUE(copy) << copy.error().message;
  EXPECT_EQ(*copy, mine_ / "plain 2");
  EXPECT_EQ(shipped_origin(*copy, faces_.shipped), "");
  ASSERT_TRUE(delete_face(*of_shipped));
  ASSERT_TRUE(rename_face(*copy, "plain"));
  EXPECT_EQ(*writable_face(other / "", faces_), mine_ / "plain") << "the copy that was made of it";
  EXPECT_EQ(*writable_face(shipped_, faces_), mine_ / "plain 2");
}

TEST_F(FaceCopies, AFaceWithoutAusOfItsOwnIsNotCopiedInVain) {
  fs::remove(shipped_ / "face.toml");
  folder_.write("shipped/plain/faceline.dat", "0\n");
  EXPECT_EQ(*writable_face(shipped_, faces_), shipped_);
  EXPECT_FALSE(fs::exists(mine_));
}

TEST_F(FaceCopies, AClassicFaceIsCopiedAndRenamedByItsFolder) {
  fs::remove(shipped_ / "face.toml");
  folder_.write("shipped/plain/faceline.dat", "0\n");
  const auto copy = copy_face(shipped_, faces_, "anna");
  ASSERT_TRUE(copy) << copy.error().message;
  const auto renamed = rename_face(*copy, "berta");
  ASSERT_TRUE(renamed) << renamed.error().message;
  EXPECT_TRUE(is_face(*renamed));
}

}  // namespace
}  // namespace aucast::gui
