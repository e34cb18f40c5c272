#include "server/engine/nats_options.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/certificates.h"
#include "tests/support/temp_folder.h"

namespace aucast::server {
namespace {

using aucast::test::TempFolder;

constexpr const char* kHere = "nats://127.0.0.1/talk";
constexpr const char* kThere = "nats://nats.example.org/talk";
constexpr const char* kSecret = "natss://nats.example.org/talk";

/// What is wrong; empty: nothing.
std::string wrong(const EngineSettings& settings, ErrorKind kind, const char* address = kHere) {
  const auto options = nats_options(address, settings);
  if (options) return {};
  EXPECT_EQ(options.error().kind, kind);
  const std::string message = options.error().message;
  return message.substr(0, message.find(" (try --help)"));
}

TEST(NatsOptions, ASecretIsAWordOrANameWithItsPassword) {
  const TempFolder folder;
  EngineSettings settings;
  settings.token = folder.write("token", "  s3cret\n");
  auto options = nats_options(kHere, settings);
  ASSERT_TRUE(options.has_value()) << options.error().message;
  EXPECT_EQ(options->token, "s3cret");
  EXPECT_EQ(options->address.stream, "talk");

  settings = {};
  settings.login = folder.write("login", "anna:pass:word {1}\r\n");
  options = nats_options(kHere, settings);
  ASSERT_TRUE(options.has_value()) << options.error().message;
  EXPECT_EQ(options->token, "");
  EXPECT_EQ(options->user, "anna");
  EXPECT_EQ(options->password, "pass:word {1}") << "all behind the first colon";

  settings = {};
  EXPECT_EQ(wrong(settings, ErrorKind::Usage), "") << "nothing is needed";
}

TEST(NatsOptions, ALoginIsOneLine) {
  const TempFolder folder;
  for (const std::string text : {"", "anna", ":word", "anna:word\nbert:word\n", "an\nna:word"}) {
    EngineSettings settings;
    settings.login = folder.write("login", text);
    EXPECT_EQ(wrong(settings, ErrorKind::BadData),
              settings.login.string() + ": one line is expected, NAME:PASSWORD");
  }
  EngineSettings settings;
  settings.login = folder.write("login", std::string("anna:wo\0rd", 10));
  EXPECT_NE(wrong(settings, ErrorKind::BadData), "");
  settings.login = folder.write("login", "anna:" + std::string(2000, 'x'));
  EXPECT_NE(wrong(settings, ErrorKind::Unreadable), "");
}

TEST(NatsOptions, NoSecretGoesOverTheNetworkForEverybodyToRead) {
  const TempFolder folder;
  EngineSettings token;
  token.token = folder.write("token", "s3cret");
  EXPECT_EQ(wrong(token, ErrorKind::Usage, kThere),
            "everybody on the way to nats.example.org could read the token: use natss://");
  EXPECT_EQ(wrong(token, ErrorKind::Usage, kSecret), "");
  EXPECT_EQ(wrong(token, ErrorKind::Usage, "nats://127.0.0.1,nats.example.org/talk"),
            "everybody on the way to nats.example.org could read the token: use natss://");
  EngineSettings login;
  login.login = folder.write("login", "anna:word");
  EXPECT_EQ(wrong(login, ErrorKind::Usage, kThere),
            "everybody on the way to nats.example.org could read the password: use natss://");
  EXPECT_EQ(wrong(login, ErrorKind::Usage, kSecret), "");
}

TEST(NatsOptions, WhoWeAreIsShownInOneWay) {
  const TempFolder folder;
  const auto file = folder.write("file", "a:b");
  EngineSettings all;
  all.token = file;
  all.login = file;
  all.creds = file;
  all.nkey = "UKEY";
  all.seed = file;
  for (unsigned ways = 0; ways < 16; ++ways) {
    EngineSettings some;
    if ((ways & 1U) != 0) some.token = all.token;
    if ((ways & 2U) != 0) some.login = all.login;
    if ((ways & 4U) != 0) some.creds = all.creds;
    if ((ways & 8U) != 0) {
      some.nkey = all.nkey;
      some.seed = all.seed;
    }
    const bool several = (ways & (ways - 1)) != 0;
    EXPECT_EQ(wrong(some, ErrorKind::Usage),
              several ? "--nats-token-file, --nats-login, --nats-creds, --nats-nkey: one of them, "
                        "not several"
                      : "")
        << ways;
  }
}

TEST(NatsOptions, HalvesOfAPairAreRefused) {
  const TempFolder folder;
  const auto file = folder.write("file", "text");
  EngineSettings settings;
  settings.nkey = "UKEY";
  EXPECT_EQ(wrong(settings, ErrorKind::Usage), "--nats-nkey and --nats-seed go together");
  settings = {};
  settings.seed = file;
  EXPECT_EQ(wrong(settings, ErrorKind::Usage), "--nats-nkey and --nats-seed go together");
  settings = {};
  settings.tls.certificate = file;
  EXPECT_EQ(wrong(settings, ErrorKind::Usage), "--nats-tls-cert and --nats-tls-key go together");
  settings = {};
  settings.tls.key = file;
  EXPECT_EQ(wrong(settings, ErrorKind::Usage), "--nats-tls-cert and --nats-tls-key go together");
}

TEST(NatsOptions, AFileThatTheLibraryWouldNotNameIsNamed) {
  const TempFolder folder;
  const auto file = folder.write("file", "text");
  const auto missing = folder.path() / "missing";
  for (auto EngineSettings::*path : {&EngineSettings::creds, &EngineSettings::token,
                                     &EngineSettings::login, &EngineSettings::seed}) {
    EngineSettings settings;
    if (path == &EngineSettings::seed) settings.nkey = "UKEY";
    settings.*path = missing;
    EXPECT_NE(wrong(settings, ErrorKind::Unreadable).find(missing.string()), std::string::npos);
  }
  for (auto tls::Files::*path :
       {&tls::Files::certificate, &tls::Files::key, &tls::Files::authorities}) {
    EngineSettings settings;
    settings.tls.certificate = settings.tls.key = file;
    settings.tls.*path = missing;
    EXPECT_NE(wrong(settings, ErrorKind::Unreadable).find(missing.string()), std::string::npos);
  }
}

TEST(NatsOptions, RevocationListsThatNobodyWouldHeedAreRefused) {
  test::Authority authority;
  EngineSettings settings;
  settings.tls.authorities = authority.file();
  EXPECT_EQ(wrong(settings, ErrorKind::BadData, kSecret), "");
  settings.tls.authorities =
      authority.file_with_revoked(authority.issue("nats", "DNS:nats.example.org"));
  EXPECT_EQ(wrong(settings, ErrorKind::BadData, kSecret),
            settings.tls.authorities.string() +
                ": has revocation lists, which NATS' library does not heed; name a file without "
                "them (--nats-tls-ca)");
}

}  // namespace
}  // namespace aucast::server
