// Files that are no certificates and keys, or not those that belong together.
#include "common/tls/context.h"

#include <sys/stat.h>

#include <gtest/gtest.h>

#include "common/files.h"
#include "tests/support/certificates.h"
#include "tests/support/temp_folder.h"

namespace aucast::tls {
namespace {

void expect_error(const Result<Context>& made, ErrorKind kind, const std::string& text) {
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().kind, kind);
  EXPECT_NE(made.error().message.find(text), std::string::npos) << made.error().message;
}

TEST(TlsContext, KnowsTheNamesOfItsCertificate) {
  test::Authority authority;
  const test::Certificate own = authority.issue("own", "DNS:au.example,IP:10.0.0.7,DNS:*.b");
  EXPECT_EQ(Context::for_server({own.file, own.key, {}})->names(),
            (std::vector<std::string>{"au.example", "*.b"}));
  EXPECT_TRUE(Context::for_client({{}, {}, authority.file()})->names().empty());
}

TEST(TlsContext, NamesTheFileThatIsWrong) {
  test::Authority authority;
  const test::Certificate own = authority.issue("own", "DNS:a");
  const test::Certificate other = authority.issue("other", "DNS:b");
  const test::TempFolder folder;
  const auto junk = folder.write("junk.pem", "no certificate\n");

  EXPECT_TRUE(Context::for_server({own.file, own.key, {}}));
  expect_error(Context::for_server({"/nowhere/a.pem", own.key, {}}, "--web"), ErrorKind::Unreadable,
               "(--web-cert)");
  expect_error(Context::for_server({"/nowhere/a.pem", own.key, {}}), ErrorKind::Unreadable,
               "/nowhere/a.pem: cannot be read: No such file or directory; check the name "
               "(--tls-cert)");
  expect_error(Context::for_server({own.file, "/nowhere/a.key", {}}), ErrorKind::Unreadable,
               "/nowhere/a.key: cannot be read");
  expect_error(Context::for_server({junk, own.key, {}}), ErrorKind::BadData,
               "junk.pem: is no certificate in PEM form");
  expect_error(Context::for_server({own.file, other.key, {}}), ErrorKind::BadData,
               "other.key: is no key of ");
  expect_error(Context::for_server({own.file, own.key, junk}), ErrorKind::BadData,
               "junk.pem: holds no certificates");
  expect_error(Context::for_client({{}, {}, junk}), ErrorKind::BadData,
               "junk.pem: holds no certificates");
  EXPECT_TRUE(Context::for_client({}));
  EXPECT_TRUE(Context::for_client({own.file, own.key, authority.file()}));
}

TEST(TlsContext, NeverWaitsForAFifo) {
  test::Authority authority;
  const test::Certificate own = authority.issue("own", "DNS:a");
  const test::TempFolder folder;
  const auto fifo = folder.path() / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  expect_error(Context::for_server({fifo, own.key, {}}), ErrorKind::Unreadable, "it is a pipe");
  expect_error(Context::for_server({own.file, fifo, {}}), ErrorKind::Unreadable, "it is a pipe");
  expect_error(Context::for_server({own.file, own.key, fifo}), ErrorKind::Unreadable,
               "it is a pipe, not a file (--tls-client-ca)");
  expect_error(Context::for_client({{}, {}, fifo}), ErrorKind::Unreadable, "it is a pipe");
}

TEST(TlsContext, RefusesABrokenCertificateInTheChain) {
  test::Authority authority;
  const test::Certificate own = authority.issue("own", "DNS:a");
  const test::TempFolder folder;
  const std::string good = read_file(own.file).value();
  EXPECT_TRUE(Context::for_server({folder.write("chain.pem", good + good), own.key, {}}));
  const std::string broken = good + good.substr(0, good.size() / 2);
  expect_error(Context::for_server({folder.write("torn.pem", broken), own.key, {}}),
               ErrorKind::BadData, "torn.pem: is no certificate in PEM form");
}

TEST(TlsContext, WarnsOfAPrivateKeyThatOthersMayRead) {
  namespace fs = std::filesystem;
  test::Authority authority;
  const test::Certificate own = authority.issue("own", "DNS:a");
  for (const auto& [mode, is_said] : {std::pair{0600U, false}, {0640U, false}, {0644U, true}}) {
    fs::permissions(own.key, static_cast<fs::perms>(mode));
    const auto context = Context::for_server({own.file, own.key, {}});
    ASSERT_TRUE(context);
    EXPECT_EQ(!context->warning().empty(), is_said) << std::oct << mode << context->warning();
  }
}

}  // namespace
}  // namespace aucast::tls
