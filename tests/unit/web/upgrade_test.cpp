#include "common/web/upgrade.h"

#include <gtest/gtest.h>

namespace aucast::web {
namespace {

HttpRequest good() {
  return {.path = "/aucast",
          .version_1_1 = true,
          .fields = {{"upgrade", "WebSocket"},
                     {"connection", "keep-alive, Upgrade"},
                     {"sec-websocket-version", "13"},
                     {"sec-websocket-key", "dGhlIHNhbXBsZSBub25jZQ=="}}};
}

/// The status of the refusal; 0: none.
int refusal(const HttpRequest& request) {
  const auto reply = refuse_upgrade(request);
  return reply ? reply->status : 0;
}

TEST(Upgrade, AnswersTheKeyOfTheRfc) {
  EXPECT_EQ(refusal(good()), 0);
  EXPECT_EQ(accept_upgrade(good()),
            "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            "Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n\r\n");
}

TEST(Upgrade, SaysWhatIsMissing) {
  const auto without = [](const std::string& name) {
    HttpRequest request = good();
    request.fields.erase(name);
    return refusal(request);
  };
  EXPECT_EQ(without("upgrade"), 426);
  EXPECT_EQ(without("connection"), 426);
  EXPECT_EQ(without("sec-websocket-version"), 426);
  EXPECT_EQ(without("sec-websocket-key"), 400);
  HttpRequest head = good();
  head.head = true;
  EXPECT_EQ(refusal(head), 426);
  HttpRequest old = good();
  old.version_1_1 = false;
  EXPECT_EQ(refusal(old), 426);
}

TEST(Upgrade, RefusesOtherVersionsAndKeysThatAreNone) {
  HttpRequest version = good();
  version.fields["sec-websocket-version"] = "8";
  const auto refused = refuse_upgrade(version);
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->status, 426);
  EXPECT_EQ(refused->fields.back(), "Sec-WebSocket-Version: 13");
  for (const char* key :
       {"", "x", "dGhlIHNhbXBsZSBub25jZQ", "dGhlIHNhbXBsZSBub25jZQ=!",
        "dGhlIHNhbXBsZSBub25jZQ==, dGhlIHNhbXBsZSBub25jZQ==", "dGhlIHNhbXBsZSBub25 ZQ=="}) {
    HttpRequest request = good();
    request.fields["sec-websocket-key"] = key;
    EXPECT_EQ(refusal(request), 400) << key;
  }
}

}  // namespace
}  // namespace aucast::web
