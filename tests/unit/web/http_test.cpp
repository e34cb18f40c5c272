#include "common/web/http.h"

#include <gtest/gtest.h>

#include "tests/support/seeded.h"

namespace aucast::web {
namespace {

constexpr std::size_t kBytesMax = 4096;

constexpr const char* kGood = "GET /metrics?x=1 HTTP/1.1\r\nHost: a\r\nAccept: */*\r\n\r\n";

int refusal(const std::string& bytes) {
  const HttpProgress progress = read_http_request(bytes, kBytesMax);
  EXPECT_FALSE(progress.request && progress.refusal);
  return progress.refusal ? progress.refusal->status : 0;
}

TEST(HttpRequest, GetAndHeadAreUnderstood) {
  const HttpProgress get = read_http_request(kGood, kBytesMax);
  ASSERT_TRUE(get.request);
  EXPECT_EQ(get.request->path, "/metrics");
  EXPECT_FALSE(get.request->head);
  EXPECT_FALSE(get.head);
  const HttpProgress head = read_http_request("HEAD / HTTP/1.0\r\n\r\n", kBytesMax);
  ASSERT_TRUE(head.request);
  EXPECT_TRUE(head.request->head);
  EXPECT_TRUE(head.head);
  const HttpProgress refused = read_http_request("HEAD / HTTP/2.0\r\n\r\n", kBytesMax);
  ASSERT_TRUE(refused.refusal);
  EXPECT_TRUE(refused.head);
}

TEST(HttpRequest, ATargetMayNameTheHostWhichThenCounts) {
  const HttpProgress get =
      read_http_request("GET http://b:80/x?y HTTP/1.1\r\nHost: a\r\n\r\n", kBytesMax);
  ASSERT_TRUE(get.request);
  EXPECT_EQ(get.request->path, "/x");
  EXPECT_EQ(get.request->field("host"), "b:80");
  EXPECT_TRUE(read_http_request("GET https://b/ HTTP/1.1\r\nHost: a\r\n\r\n", kBytesMax).request);
  const HttpProgress root =
      read_http_request("GET HTTP://b HTTP/1.1\r\nHost: a\r\n\r\n", kBytesMax);
  ASSERT_TRUE(root.request);
  EXPECT_EQ(root.request->path, "/");
}

TEST(HttpRequest, ABodyOfNoBytesIsNone) {
  EXPECT_TRUE(read_http_request("GET / HTTP/1.1\r\nHost: a\r\nContent-Length: 0\r\n\r\n", kBytesMax)
                  .request);
}

TEST(HttpRequest, HalfARequestIsWaitedFor) {
  const std::string good = kGood;
  for (std::size_t length = 0; length < good.size(); ++length) {
    const HttpProgress progress = read_http_request(good.substr(0, length), kBytesMax);
    EXPECT_FALSE(progress.request || progress.refusal) << length;
  }
}

TEST(HttpRequest, WhatIsNotUnderstoodIsRefused) {
  EXPECT_EQ(refusal("POST / HTTP/1.1\r\nHost: a\r\n\r\n"), 405);
  EXPECT_EQ(refusal("GET / HTTP/2.0\r\nHost: a\r\n\r\n"), 505);
  EXPECT_EQ(refusal("GET / FTP/1.1\r\nHost: a\r\n\r\n"), 400);
  EXPECT_EQ(refusal("GET / HTTP/1.1\r\n\r\n"), 400) << "no Host";
  EXPECT_EQ(refusal("GET / HTTP/1.1\r\nHost: \r\n\r\n"), 400) << "an empty one";
  EXPECT_EQ(refusal("GET / HTTP/1.1\r\nHost: a\r\nhost: b\r\n\r\n"), 400) << "two of them";
  EXPECT_EQ(refusal("GET / HTTP/1.1\r\nHost: a\r\nContent-Length: 3\r\n\r\nabc"), 400);
  EXPECT_EQ(refusal("GET / HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: chunked\r\n\r\n"), 400);
  EXPECT_EQ(refusal("GET / HTTP/1.1\r\nHost: a\r\n folded\r\n\r\n"), 400);
  EXPECT_EQ(refusal("GET / HTTP/1.1\r\nHost : a\r\n\r\n"), 400);
  EXPECT_EQ(refusal("GET / HTTP/1.1\r\nHost: a\nX: y\r\n\r\n"), 400) << "a bare LF";
  EXPECT_EQ(refusal("GET ftp://a/ HTTP/1.1\r\nHost: a\r\n\r\n"), 400);
  EXPECT_EQ(refusal("GET https HTTP/1.1\r\nHost: a\r\n\r\n"), 400);
  EXPECT_EQ(refusal("GET http:///x HTTP/1.1\r\nHost: a\r\n\r\n"), 400);
  EXPECT_EQ(refusal("GET a/ HTTP/1.1\r\nHost: a\r\n\r\n"), 400);
  EXPECT_EQ(refusal("GET /a b HTTP/1.1\r\nHost: a\r\n\r\n"), 400);
  EXPECT_EQ(refusal("GET\r\n\r\n"), 400);
  EXPECT_EQ(refusal("\x16\x03\x01"), 400) << "TLS";
  EXPECT_EQ(refusal("{hello v=2}"), 400);
  EXPECT_EQ(refusal("\r\n"), 400);
}

TEST(HttpRequest, FieldsAreFoundByNameInAnyCase) {
  const std::string head =
      "GET / HTTP/1.1\r\nhOsT:\t [::1]:80 \r\nX-Forwarded-For: a\r\nx-forwarded-for: b\r\n\r\n";
  const auto request = read_http_request(head + "more", kBytesMax);
  ASSERT_TRUE(request.request);
  EXPECT_EQ(request.request->field("host"), "[::1]:80");
  EXPECT_EQ(request.request->field("x-forwarded-for"), "a, b");
  EXPECT_EQ(request.request->field("origin"), "");
  EXPECT_TRUE(request.request->version_1_1);
  EXPECT_EQ(request.request->head_bytes, head.size());
}

TEST(HasWord, FindsAWordOfAListWhateverItsCaseAndParameters) {
  EXPECT_TRUE(has_word("keep-alive, Upgrade", "upgrade"));
  EXPECT_TRUE(has_word("br;q=1.0, GZIP;q=0.5", "gzip"));
  EXPECT_FALSE(has_word("br, gzip;q=0", "gzip"));
  EXPECT_FALSE(has_word("gzip ; Q=0.000", "gzip"));
  EXPECT_FALSE(has_word("xgzip, gzipx", "gzip"));
  EXPECT_FALSE(has_word("", "gzip"));
}

TEST(HttpRequest, LengthIsBounded) {
  const std::string start = "GET / HTTP/1.1\r\nHost: a\r\nX: ";
  const std::string rest(kBytesMax - start.size() - 4, 'x');
  EXPECT_EQ(refusal(start + rest + "\r\n\r\n"), 0);
  EXPECT_EQ(refusal(start + rest + "x\r\n\r\n"), 431);
  EXPECT_EQ(refusal("GET /" + std::string(1'000'000, 'x')), 431);
}

TEST(HttpRequest, NoiseIsNeverARequest) {
  test::Seeded random;
  SCOPED_TRACE(random.trace());
  for (int round = 0; round < 20'000; ++round) {
    std::string bytes = kGood;
    const int changes = random.integer(1, 4);
    for (int change = 0; change < changes; ++change) {
      const auto at =
          static_cast<std::size_t>(random.integer(0, static_cast<int>(bytes.size()) - 1));
      bytes[at] = static_cast<char>(random.integer(0, 255));
    }
    const HttpProgress progress = read_http_request(bytes, kBytesMax);
    ASSERT_FALSE(progress.request && progress.refusal);
    if (progress.request) {
      for (const char c : progress.request->path) ASSERT_TRUE(c > 0x20 && c < 0x7f);
    }
  }
}

TEST(HttpReply, SaysItsLengthAndThatItIsTheLast) {
  const std::string reply = format_http_reply({404, "text/plain", "no\n"}, false);
  EXPECT_TRUE(reply.starts_with("HTTP/1.1 404 Not Found\r\n"));
  EXPECT_NE(reply.find("\r\nContent-Length: 3\r\n"), std::string::npos);
  EXPECT_NE(reply.find("\r\nConnection: close\r\n"), std::string::npos);
  EXPECT_TRUE(reply.ends_with("\r\n\r\nno\n"));
  EXPECT_TRUE(format_http_reply({200, "text/plain", "ok\n"}, true).ends_with("\r\n\r\n"));
}

TEST(HttpReply, NoStatusHasThePhraseOfAnother) {
  EXPECT_TRUE(format_http_reply({505, "text/plain", "no\n"}, false)
                  .starts_with("HTTP/1.1 505 HTTP Version Not Supported\r\n"));
  EXPECT_TRUE(
      format_http_reply({500, "text/plain", "no\n"}, false).starts_with("HTTP/1.1 500 \r\n"));
}

TEST(HttpReply, OneWithoutABodyHasNoLength) {
  const std::string reply = format_http_reply(
      {.status = 304, .type = "", .cache = "no-cache", .fields = {"ETag: \"a\""}}, false);
  EXPECT_EQ(reply,
            "HTTP/1.1 304 Not Modified\r\nCache-Control: no-cache\r\n"
            "X-Content-Type-Options: nosniff\r\nETag: \"a\"\r\nConnection: close\r\n\r\n");
}

}  // namespace
}  // namespace aucast::web
