// Files that are no certificates and keys, or not those that belong together.
#include "common/tls/context.h"

#include <gtest/gtest.h>

#include "tests/support/certificates.h"

namespace aucast::tls {
namespace {

void expect_error(const Result<Context>& made, ErrorKind kind, const std::string& text) {
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().kind, kind);
  EXPECT_NE(made.error().message.find(text), std::string::npos) << made.error().message;
}

TEST(TlsContext, NamesTheFileThatIsWrong) {
  test::Authority authority;
  const test::Certificate own = authority.issue("own", "DNS:a");
  const test::Certificate other = authority.issue("other", "DNS:b");
  const test::TempFolder folder;
  const auto junk = folder.write("junk.pem", "no certificate\n");

  EXPECT_TRUE(Context::for_server({own.file, own.key, {}}));
  expect_error(Context::for_server({"/nowhere/a.pem", own.key, {}}), ErrorKind::Unreadable,
               "/nowhere/a.pem: cannot be read: No such file or directory (--tls-cert)");
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

}  // namespace
}  // namespace aucast::tls
