#include "server/web/page_files.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace aucast::server {
namespace {

using test::TempFolder;

class PageFilesTest : public ::testing::Test {
 protected:
  PageFilesTest() {
    std::filesystem::create_directory(folder_.path() / "data");
    std::filesystem::create_directory(folder_.path() / ".git");
    folder_.write("index.html", "<p>page");
    folder_.write("page.wasm", "plain");
    folder_.write("page.wasm.gz", "compressed");
    folder_.write("data/mesh.ply", "ply");
    folder_.write(".git/secret", "x");
    folder_.write(".hidden", "x");
  }

  [[nodiscard]] SharedReply ask(const std::string& path,
                                std::map<std::string, std::string, std::less<>> fields = {}) const {
    const auto files = PageFiles::read(folder_.path());
    EXPECT_TRUE(files) << files.error().message;
    return files->reply({.path = path, .version_1_1 = true, .fields = std::move(fields)});
  }
  static std::string tag(const SharedReply& reply) {
    const auto& fields = reply.head.fields;
    const auto found = std::find_if(fields.begin(), fields.end(), [](const std::string& field) {
      return field.starts_with("ETag: ");
    });
    return found == fields.end() ? "" : found->substr(6);
  }
  static bool has(const SharedReply& reply, const std::string& field) {
    const auto& fields = reply.head.fields;
    return std::find(fields.begin(), fields.end(), field) != fields.end();
  }

  TempFolder folder_;
};

TEST_F(PageFilesTest, GivesThePageAndItsFiles) {
  EXPECT_EQ(*ask("/").body, "<p>page");
  EXPECT_EQ(ask("/").head.type, "text/html; charset=utf-8");
  EXPECT_EQ(*ask("/index.html").body, "<p>page");
  EXPECT_EQ(*ask("/data/mesh.ply").body, "ply");
  EXPECT_EQ(ask("/data/mesh.ply").head.type, "application/octet-stream");
  EXPECT_EQ(ask("/page.wasm").head.type, "application/wasm");
  EXPECT_EQ(ask("/").head.cache, "no-cache");
}

TEST_F(PageFilesTest, NothingElseIsThere) {
  for (const char* path : {"/none", "/data", "/data/", "//index.html", "/../index.html",
                           "/data/../index.html", "/.hidden", "/.git/secret", "/%69ndex.html"}) {
    const SharedReply reply = ask(path);
    EXPECT_EQ(reply.head.status, 404) << path;
    EXPECT_EQ(reply.body, nullptr);
  }
}

TEST_F(PageFilesTest, CompressedOnlyForWhoAcceptsIt) {
  const SharedReply compressed = ask("/page.wasm", {{"accept-encoding", "br, gzip"}});
  EXPECT_EQ(*compressed.body, "compressed");
  EXPECT_TRUE(has(compressed, "Content-Encoding: gzip"));
  EXPECT_TRUE(has(compressed, "Vary: Accept-Encoding"));
  EXPECT_EQ(compressed.head.type, "application/wasm");
  const SharedReply plain = ask("/page.wasm", {{"accept-encoding", "gzip;q=0"}});
  EXPECT_EQ(*plain.body, "plain");
  EXPECT_FALSE(has(plain, "Content-Encoding: gzip"));
  EXPECT_EQ(*ask("/", {{"accept-encoding", "gzip"}}).body, "<p>page");
  EXPECT_EQ(ask("/page.wasm.gz").head.status, 404) << "it is another form of page.wasm";
}

TEST_F(PageFilesTest, WhoHasAFileIsToldSo) {
  const std::string plain = tag(ask("/page.wasm"));
  const std::string compressed = tag(ask("/page.wasm", {{"accept-encoding", "gzip"}}));
  EXPECT_NE(plain, compressed);
  for (const std::string& known : {plain, "W/" + plain, "\"other\", " + plain, std::string("*")}) {
    const SharedReply reply = ask("/page.wasm", {{"if-none-match", known}});
    EXPECT_EQ(reply.head.status, 304) << known;
    EXPECT_EQ(reply.body, nullptr);
    EXPECT_EQ(tag(reply), plain);
  }
  EXPECT_EQ(ask("/page.wasm", {{"if-none-match", compressed}}).head.status, 200);
  folder_.write("page.wasm", "changed");
  EXPECT_EQ(*ask("/page.wasm", {{"if-none-match", plain}}).body, "changed");
}

TEST_F(PageFilesTest, EveryFileHasAPolicyOfWhatMayRun) {
  const auto& fields = ask("/").head.fields;
  EXPECT_TRUE(std::any_of(fields.begin(), fields.end(), [](const std::string& field) {
    return field.starts_with("Content-Security-Policy: default-src 'none'; script-src 'self' ");
  }));
  EXPECT_TRUE(has(ask("/page.wasm"), "Access-Control-Allow-Origin: *"));
}

TEST_F(PageFilesTest, WithoutAPageTheRemedyIsSaid) {
  const auto none = PageFiles::read(folder_.path() / "none");
  ASSERT_TRUE(none);
  EXPECT_FALSE(none->has_page());
  const SharedReply reply = none->reply({.path = "/"});
  EXPECT_EQ(reply.head.status, 404);
  EXPECT_NE(reply.head.body.find("scripts/build_web.sh"), std::string::npos);
  EXPECT_TRUE(PageFiles::read(folder_.path())->has_page());
}

TEST_F(PageFilesTest, AFolderThatIsNoPageIsRefused) {
  for (int i = 0; i < 2000; ++i) folder_.write(std::to_string(i), "");
  const auto files = PageFiles::read(folder_.path());
  ASSERT_FALSE(files);
  EXPECT_EQ(files.error().message,
            folder_.path().string() +
                ": holds more than 2000 files; take out what does not belong to the page");
}

/// The files are sparse, and none is read.
TEST_F(PageFilesTest, AFolderThatTakesTooMuchMemoryIsRefused) {
  for (const char* const name : {"a", "b", "c", "d"}) {
    std::filesystem::resize_file(folder_.write(name, ""), std::uintmax_t{64} << 20U);
  }
  const auto files = PageFiles::read(folder_.path());
  ASSERT_FALSE(files);
  EXPECT_EQ(files.error().kind, ErrorKind::Unreadable);
  EXPECT_EQ(files.error().message,
            folder_.path().string() +
                ": holds more than 256 MiB; take out what does not belong to the page");
}

TEST_F(PageFilesTest, AFileThatCannotBeReadIsNamed) {
  std::filesystem::create_symlink(folder_.path() / "nowhere", folder_.path() / "broken.js");
  const auto files = PageFiles::read(folder_.path());
  ASSERT_FALSE(files);
  EXPECT_EQ(files.error().kind, ErrorKind::Unreadable);
  EXPECT_NE(files.error().message.find("broken.js"), std::string::npos) << files.error().message;
}

}  // namespace
}  // namespace aucast::server
