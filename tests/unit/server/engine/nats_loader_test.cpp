#include "server/engine/nats_loader.h"

#include <unistd.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/temp_folder.h"

namespace aucast::server {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFile = "aucast-nats.so";

/// Puts `module` there under the name that is looked for. Once it was tried it stays loaded and
/// must not be written over.
void place(const test::TempFolder& folder, const char* module) {
  fs::copy_file(module, folder.path() / kFile);
}

Error refusal(const std::vector<fs::path>& folders) {
  auto loaded = load_nats_module(folders);
  return loaded ? Error{ErrorKind::Failed, "it was loaded"} : loaded.error();
}

void expect_unreadable(const test::TempFolder& folder, const std::string& why) {
  const Error error = refusal({folder.path()});
  EXPECT_EQ(error.kind, ErrorKind::Unreadable);
  EXPECT_TRUE(error.message.starts_with((folder.path() / kFile).string() + ": not loaded: "))
      << error.message;
  EXPECT_NE(error.message.find(why), std::string::npos) << error.message;
}

TEST(NatsLoader, SaysWhatToInstallWhereThereIsNone) {
  const test::TempFolder first;
  const test::TempFolder second;
  const Error error = refusal({first.path(), second.path()});
  EXPECT_EQ(error.kind, ErrorKind::Usage);
  EXPECT_EQ(error.message,
            "NATS is not installed: the package aucast-nats has it, and a build "
            "with AUCAST_NATS (no aucast-nats.so in " +
                first.path().string() + ", " + second.path().string() +
                "); aucast:// for relays needs none");
}

TEST(NatsLoader, RefusesTheModuleOfAnotherBuild) {
  const test::TempFolder folder;
  place(folder, AUCAST_OTHER_BUILD);
  expect_unreadable(folder, "it is AUcast 0.0.1-of-old, and this au-transmitter is AUcast ");
  expect_unreadable(folder, "; install both from one build");
}

TEST(NatsLoader, RefusesWhatIsNoModule) {
  const test::TempFolder other;
  place(other, AUCAST_OTHER_LIBRARY);
  expect_unreadable(other, "it is nothing of AUcast");
  const test::TempFolder text;
  text.write(kFile, "no library at all");
  expect_unreadable(text, "file too short");
}

TEST(NatsLoader, TheFirstFolderThatHasOneDecides) {
  const test::TempFolder none;
  const test::TempFolder folder;
  place(folder, AUCAST_OTHER_BUILD);
  EXPECT_NE(refusal({none.path(), folder.path(), "/nonexistent"}).message.find("of-old"),
            std::string::npos);
}

TEST(NatsLoader, LoadsNothingThatOthersCouldHavePutThere) {
  const test::TempFolder folder;
  place(folder, AUCAST_OTHER_BUILD);
  const std::string why = "others than root and the owner of au-transmitter could have written it";
  fs::permissions(folder.path(), fs::perms::others_write, fs::perm_options::add);
  expect_unreadable(folder, why);
  fs::permissions(folder.path(), fs::perms::others_write, fs::perm_options::remove);
  fs::permissions(folder.path() / kFile, fs::perms::others_write, fs::perm_options::add);
  expect_unreadable(folder, why);
  fs::permissions(folder.path() / kFile, fs::perms::others_write, fs::perm_options::remove);
  expect_unreadable(folder, "of-old");
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give it to somebody else";
  for (const fs::path& path : {folder.path() / kFile, folder.path()}) {
    ASSERT_EQ(::chown(path.c_str(), 0, 65534), 0);
    expect_unreadable(folder, "of-old");
    fs::permissions(path, fs::perms::group_write, fs::perm_options::add);
    expect_unreadable(folder, why);
    ASSERT_EQ(::chown(path.c_str(), 0, 0), 0);
    expect_unreadable(folder, "of-old");
  }
  ASSERT_EQ(::chown((folder.path() / kFile).c_str(), 65534, 65534), 0);
  expect_unreadable(folder, why);
}

#ifdef AUCAST_HAS_NATS
/// Hears what is told; a thread of the library may tell it.
class Silent final : public NatsListener {
  void on_connected(const std::string& /*server*/) override {}
  void on_disconnected() override {}
  void on_message(Bus::Message /*message*/) override {}
  void on_error(const std::string& /*text*/) override {}
  void on_given_up(const std::string& /*why*/) override {}
};

TEST(NatsLoader, LoadsTheModuleOfThisBuildAgainAndAgain) {
  for (int i = 0; i < 3; ++i) {
    const auto module = load_nats_module(nats_module_folders());
    ASSERT_TRUE(module) << module.error().message;
    EXPECT_TRUE((*module)->new_subject());
    NatsServers nobody;
    nobody.urls = {"nats://127.0.0.1:1"};
    const auto connection = (*module)->connect(nobody, std::make_shared<Silent>());
    ASSERT_TRUE(connection) << connection.error().message;
    EXPECT_FALSE((*connection)->is_connected());
  }
}
#endif

}  // namespace
}  // namespace aucast::server
