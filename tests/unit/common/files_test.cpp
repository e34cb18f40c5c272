#include "common/files.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <stop_token>
#include <utility>

#include <gtest/gtest.h>

#include "common/temporary_file.h"
#include "tests/support/temp_folder.h"

namespace aucast {
namespace {

TEST(ReadFile, GivesTheBytes) {
  const test::TempFolder folder;
  const std::string bytes("a\0b\n", 4);
  EXPECT_EQ(read_file(folder.write("x", bytes)).value(), bytes);
}

TEST(ReadFile, NamesFileAndReason) {
  const test::TempFolder folder;
  const auto missing = read_file(folder.path() / "none");
  ASSERT_FALSE(missing.has_value());
  EXPECT_EQ(missing.error().kind, ErrorKind::Unreadable);
  EXPECT_TRUE(missing.error().message.ends_with(
      "none: cannot be read: No such file or directory; check the name"));

  const auto directory = read_file(folder.path());
  ASSERT_FALSE(directory.has_value());
  EXPECT_NE(directory.error().message.find("it is a folder"), std::string::npos);
}

TEST(ReadFile, AskedToStopItReadsNoFurther) {
  const test::TempFolder folder;
  const auto file = folder.write("x", "bytes");
  std::stop_source stop;
  EXPECT_TRUE(read_file(file, 100, stop.get_token()));
  stop.request_stop();
  EXPECT_FALSE(read_file(file, 100, stop.get_token()));
}

TEST(ReadFile, RefusesWhatIsTooLong) {
  const test::TempFolder folder;
  const auto file = folder.write("x", std::string(100, 'x'));
  EXPECT_TRUE(read_file(file, 100).has_value());
  EXPECT_FALSE(read_file(file, 99).has_value());
}

TEST(ReadFile, NeverWaitsForWhatIsNoFile) {
  const test::TempFolder folder;
  const auto fifo = folder.path() / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  const auto pipe = read_file(fifo);
  ASSERT_FALSE(pipe.has_value());
  EXPECT_EQ(pipe.error().kind, ErrorKind::Unreadable);
  EXPECT_NE(pipe.error().message.find("fifo: cannot be read: it is a pipe"), std::string::npos);

  const auto device = read_file("/dev/zero");
  ASSERT_FALSE(device.has_value());
  EXPECT_NE(device.error().message.find("it is a device"), std::string::npos);
  EXPECT_EQ(read_file("/dev/null").value(), "");
}

TEST(ReadFile, RefusesAnEndlessFileOfProc) {
  const auto endless = read_file("/proc/self/pagemap");
  ASSERT_FALSE(endless.has_value());
  EXPECT_NE(endless.error().message.find("it grows while it is read"), std::string::npos);
}

TEST(ReadFile, RefusesAHugeFileBeforeItIsRead) {
  const test::TempFolder folder;
  const auto file = folder.write("x", "");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 40U);  // sparse: reading would take hours
  const auto huge = read_file(file);
  ASSERT_FALSE(huge.has_value());
  EXPECT_NE(huge.error().message.find("it is longer than"), std::string::npos);
}

TEST(ReadFile, NamesAFileThatATerminalWouldObeyHarmlessly) {
  const auto missing = read_file("/no/\x1b[2J\n.txt");
  ASSERT_FALSE(missing.has_value());
  EXPECT_TRUE(missing.error().message.starts_with("/no/\\x1b[2J\\x0a.txt: cannot be read"));
}

TEST(ReadSecretFile, SaysWhetherOthersHaveAccess) {
  const test::TempFolder folder;
  const auto file = folder.write("x", "word");
  for (const auto& [mode, open] : {std::pair{0600U, false}, {0640U, false}, {0644U, true}}) {
    std::filesystem::permissions(file, static_cast<std::filesystem::perms>(mode));
    const auto secret = read_secret_file(file, 100);
    ASSERT_TRUE(secret.has_value());
    EXPECT_EQ(secret->bytes, "word");
    EXPECT_EQ(secret->open_to_others, open);
  }
}

TEST(WriteFileAtomically, ReplacesAndLeavesNothingBeside) {
  const test::TempFolder folder;
  const auto file = folder.write("x", "old");
  ASSERT_TRUE(write_file_atomically(file, "new").has_value());
  EXPECT_EQ(folder.read("x"), "new");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(WriteFileAtomically, KeepsTheOldFileWhenItFails) {
  const test::TempFolder folder;
  const auto result = write_file_atomically(folder.path() / "missing" / "x", "new");
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().kind, ErrorKind::Failed);
  EXPECT_TRUE(result.error().message.ends_with(
      "cannot be written: No such file or directory; choose another folder"));
  EXPECT_FALSE(write_file_atomically(folder.path(), "new").has_value());
}

TEST(WriteFileAtomically, SaysThatTheDiskIsFull) {
  const auto result = write_file_atomically("/dev/full", "new");
  ASSERT_FALSE(result.has_value());
  EXPECT_NE(result.error().message.find("No space left"), std::string::npos);
}

TEST(WriteFileAtomically, ReplacesALinkAndDoesNotFollowIt) {
  const test::TempFolder folder;
  const auto victim = folder.write("victim", "dear");
  const auto file = folder.path() / "stats.json";
  std::filesystem::create_symlink(victim, file);
  // Where a name that can be guessed would be looked for.
  std::filesystem::create_symlink(victim, file.string() + ".part-" + std::to_string(::getpid()));
  ASSERT_TRUE(write_file_atomically(file, "new").has_value());
  EXPECT_EQ(folder.read("victim"), "dear");
  EXPECT_EQ(folder.read("stats.json"), "new");
  EXPECT_FALSE(std::filesystem::is_symlink(file));
}

TEST(WriteFileAtomically, StandardOutputIsWrittenToAndNotReplaced) {
  const test::TempFolder folder;
  const auto path = folder.write("out", "before\n");
  const int out = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  ASSERT_GE(out, 0);
  ASSERT_EQ(::lseek(out, 0, SEEK_END), 7);
  for (const char* form : {"/proc/self/fd/", "/dev/fd/"}) {
    const std::string name = form + std::to_string(out);
    EXPECT_TRUE(check_writable(name));
    EXPECT_TRUE(write_file_atomically(name, "more\n"));
    EXPECT_FALSE(create_temporary_beside(name));
    EXPECT_EQ(::write(out, "and\n", 4), 4);
  }
  EXPECT_EQ(folder.read("out"), "before\nmore\nand\nmore\nand\n");
  ::close(out);
  const std::string closed = "/dev/fd/" + std::to_string(out);
  EXPECT_FALSE(check_writable(closed));
  EXPECT_FALSE(write_file_atomically(closed, "lost\n"));
}

TEST(WriteFileAtomically, KeepsTheModeOfTheFileThatWasThere) {
  namespace fs = std::filesystem;
  const test::TempFolder folder;
  const auto file = folder.write("x", "old");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  ASSERT_TRUE(write_file_atomically(file, "new").has_value());
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(ReplaceFile, KeepsTheModeOfTheFileThatWasThere) {
  namespace fs = std::filesystem;
  const test::TempFolder folder;
  const auto file = folder.write("x.mp4", "old");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  const auto temporary = create_temporary_beside(file);
  ASSERT_TRUE(temporary.has_value());
  ASSERT_TRUE(replace_file(*temporary, file).has_value());
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(TemporaryFile, IsGoneWithItsObjectUnlessItGotItsName) {
  namespace fs = std::filesystem;
  const test::TempFolder folder;
  const auto file = folder.path() / "x.mp4";
  {
    auto first = TemporaryFile::beside(file);
    ASSERT_TRUE(first.has_value());
    const fs::path of_first = first->path();
    auto second = TemporaryFile::beside(file);
    ASSERT_TRUE(second.has_value());
    *first = std::move(*second);
    EXPECT_FALSE(fs::exists(of_first)) << "another has come in its place";
    EXPECT_TRUE(fs::exists(first->path()));
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
  {
    auto made = TemporaryFile::beside(file);
    ASSERT_TRUE(made.has_value());
    ASSERT_TRUE(made->replace(file));
    EXPECT_TRUE(made->path().empty());
  }
  EXPECT_TRUE(fs::exists(file));
  EXPECT_FALSE(TemporaryFile::beside(folder.path() / "none" / "x").has_value());
}

TEST(WriteFileAtomically, NeverWaitsForTheReaderOfAFifo) {
  const test::TempFolder folder;
  const auto fifo = folder.path() / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  const auto nobody = write_file_atomically(fifo, "new");
  ASSERT_FALSE(nobody.has_value());
  EXPECT_EQ(nobody.error().kind, ErrorKind::Failed);
  EXPECT_TRUE(nobody.error().message.ends_with("cannot be written: nobody reads it"));
}

TEST(CheckWritable, TheReaderOfAFifoMayComeLater) {
  const test::TempFolder folder;
  const auto fifo = folder.path() / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  EXPECT_TRUE(check_writable(fifo).has_value());
  const int reader = ::open(fifo.c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  EXPECT_TRUE(check_writable(fifo).has_value());
  pollfd state{reader, POLLIN, 0};
  EXPECT_EQ(::poll(&state, 1, 0), 0) << "no writer came and went";
  ::close(reader);
}

TEST(CheckWritable, ASocketIsNeverWrittenTo) {
  const test::TempFolder folder;
  const std::string path = (folder.path() / "socket").string();
  const int listener = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof(address.sun_path) - 1);
  ASSERT_EQ(::bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
  const auto can = check_writable(path);
  ASSERT_FALSE(can.has_value());
  EXPECT_TRUE(can.error().message.ends_with("it is a socket"));
  ::close(listener);
}

TEST(CheckWritable, ADescriptorOfOurOwnIsJudgedByHowItWasOpened) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()), 0);
  const std::string name = "/dev/fd/" + std::to_string(ends[0]);
  EXPECT_TRUE(check_writable(name)) << "a socket, as standard output of a service may be";
  EXPECT_TRUE(write_file_atomically(name, "told"));
  std::array<char, 8> got{};
  EXPECT_EQ(::read(ends[1], got.data(), got.size()), 4);
  for (const int end : ends) ::close(end);
  const test::TempFolder folder;
  const int input = ::open(folder.write("in", "").c_str(), O_RDONLY | O_CLOEXEC);
  const auto can = check_writable("/dev/fd/" + std::to_string(input));
  ASSERT_FALSE(can);
  EXPECT_TRUE(can.error().message.ends_with("it is open for reading only"));
  ::close(input);
}

TEST(CheckWritable, ChangesNothing) {
  const test::TempFolder folder;
  const auto file = folder.write("stats.json", "old");
  EXPECT_TRUE(check_writable(file).has_value());
  EXPECT_TRUE(check_writable(folder.path() / "new").has_value());
  EXPECT_EQ(folder.read("stats.json"), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
  EXPECT_FALSE(check_writable(folder.path()).has_value());
  EXPECT_FALSE(check_writable(folder.path() / "none" / "x").has_value());
}

TEST(WholePath, StartsAtTheRootAndGoesNoWayTwice) {
  EXPECT_EQ(whole_path("/a/../b/./c"), "/b/c");
  EXPECT_EQ(whole_path("x/../y"), std::filesystem::current_path() / "y");
}

TEST(WholePath, IsAsItIsWhereTheCurrentFolderIsGone) {
  const auto before = std::filesystem::current_path();
  {
    const test::TempFolder folder;
    std::filesystem::current_path(folder.path());
  }
  const auto whole = whole_path("x");
  std::filesystem::current_path(before);
  EXPECT_EQ(whole, "x");
}

TEST(FindDataFolder, TakesTheChosenOneAndNothingElse) {
  const test::TempFolder folder;
  EXPECT_EQ(find_data_folder(folder.path()).value(), folder.path());
  const auto missing = find_data_folder(folder.path() / "none");
  ASSERT_FALSE(missing.has_value());
  EXPECT_EQ(missing.error().kind, ErrorKind::Unreadable);
  EXPECT_NE(missing.error().message.find("--data"), std::string::npos);
}

}  // namespace
}  // namespace aucast
