// What a window sees of a camera, written, cut anywhere and read back.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/preview/orders.h"
#include "common/preview/preview_reader.h"
#include "common/preview/preview_writer.h"

namespace aucast::preview {
namespace {

Seen two_pixels() {
  return {2,
          1,
          {1, 2, 3, '\n', 0, 255},
          {{0, 1}, {1, 0}},
          {{1, Side::Both, 0}, {12, Side::Left, 40}, {12, Side::Right, 100}}};
}

std::vector<Record> records_of(const std::string& bytes, std::size_t at_once) {
  PreviewReader reader;
  std::vector<Record> records;
  for (std::size_t at = 0; at < bytes.size(); at += at_once) {
    reader.feed(std::string_view(bytes).substr(at, at_once));
    while (true) {
      auto record = reader.next();
      EXPECT_TRUE(record.has_value());
      if (!record || !*record) break;
      records.push_back(std::move(**record));
    }
  }
  return records;
}

TEST(Preview, IsReadBackHoweverItIsCut) {
  const std::string bytes = "listening on 127.0.0.1:40123 0a1b\n" + seen_record(two_pixels()) +
                            live_record("0.0.0.0:4650") + watching_record(3) +
                            seen_record(two_pixels()) + private_record() +
                            refused_record("cannot listen\nthere");
  for (const std::size_t at_once : {std::size_t{1}, std::size_t{7}, bytes.size()}) {
    const auto records = records_of(bytes, at_once);
    ASSERT_EQ(records.size(), 7U);
    EXPECT_EQ(std::get<Listening>(records[0]).address, "127.0.0.1:40123");
    EXPECT_EQ(std::get<Listening>(records[0]).token, "0a1b");
    EXPECT_EQ(std::get<Seen>(records[1]), two_pixels());
    EXPECT_EQ(std::get<Live>(records[2]).address, "0.0.0.0:4650");
    EXPECT_EQ(std::get<Watching>(records[3]).count, 3U);
    EXPECT_EQ(std::get<Seen>(records[4]), two_pixels());
    EXPECT_TRUE(std::holds_alternative<Private>(records[5]));
    EXPECT_EQ(std::get<Refused>(records[6]).sentence, "cannot listen there");
  }
}

TEST(Preview, WhereAnybodyIsServedThereIsNoToken) {
  const auto records = records_of("listening on 192.0.2.1:4650\n", 5);
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(std::get<Listening>(records[0]).address, "192.0.2.1:4650");
  EXPECT_EQ(std::get<Listening>(records[0]).token, "");
}

TEST(Preview, APictureWithoutAFaceHasNoPointsAndNoAus) {
  Seen nobody = two_pixels();
  nobody.points.clear();
  nobody.aus.clear();
  const auto records = records_of(seen_record(nobody), 5);
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(std::get<Seen>(records[0]), nobody);
}

TEST(Preview, APointOutsideOfThePictureIsPutOntoItsEdge) {
  Seen seen = two_pixels();
  seen.points = {{-3, 2}, {std::numeric_limits<float>::quiet_NaN(), 0.5F}};
  const auto records = records_of(seen_record(seen), 1000);
  ASSERT_EQ(records.size(), 1U);
  const auto& points = std::get<Seen>(records[0]).points;
  EXPECT_EQ(points[0], (Point{0, 1}));
  EXPECT_EQ(points[1].x, 0);
  EXPECT_NEAR(points[1].y, 0.5, 1e-4);
}

TEST(Preview, WhatIsNoRecordIsRefusedFromThenOn) {
  const std::string rgb(6, 'x');
  for (const std::string& bad :
       {std::string("hello\n"), std::string("seen\n"), std::string("seen 2 1 0\n"),
        std::string("seen 0 1 0 0\n"), std::string("seen 2 9999999 0 0\n"),
        std::string("seen 2 1 99999999999 0\n"), std::string("seen 2 1 0 999999\n"),
        std::string("seen 2 1 -1 0\n"), std::string("seen 2 1 0 0 0\n"),
        std::string("watching x\n"), std::string("live\n"), std::string(5000, 'x'),
        std::string("refused ") + std::string(9000, 'x') + "\n", "seen 2 1 0 4\n" + rgb + "12:x",
        "seen 2 1 0 5\n" + rgb + "0:100", "seen 2 1 0 6\n" + rgb + "12:101",
        "seen 2 1 0 5\n" + rgb + "1:1,,", "seen 2 1 0 6\n" + rgb + "LR12:1"}) {
    PreviewReader reader;
    reader.feed(bad);
    const auto record = reader.next();
    ASSERT_FALSE(record.has_value()) << bad.substr(0, 40);
    EXPECT_EQ(record.error().kind, ErrorKind::BadData);
    reader.feed("private\n");
    EXPECT_FALSE(reader.next().has_value());
  }
}

TEST(Preview, WaitsForTheRestOfAPicture) {
  const std::string record = seen_record(two_pixels());
  for (std::size_t size = 0; size < record.size(); ++size) {
    PreviewReader reader;
    reader.feed(record.substr(0, size));
    const auto next = reader.next();
    ASSERT_TRUE(next.has_value());
    EXPECT_FALSE(next->has_value()) << size;
  }
}

TEST(Preview, ASmallPictureIsTheMeanOfSquares) {
  // 4 times as wide as may be, one pixel high: each pixel is the mean of four.
  std::vector<std::uint8_t> rgb;
  for (std::size_t x = 0; x < 4 * kSideMax; ++x) {
    for (const int value : {static_cast<int>(x % 4), 100, 255}) {
      rgb.push_back(static_cast<std::uint8_t>(value));
    }
  }
  const Seen small = small_picture(4 * kSideMax, 1, rgb);
  EXPECT_EQ(small.width, kSideMax);
  EXPECT_EQ(small.height, 1U);
  ASSERT_EQ(small.rgb.size(), 3 * kSideMax);
  EXPECT_EQ(small.rgb[0], 1);
  EXPECT_EQ(small.rgb[1], 100);
  EXPECT_EQ(small.rgb[2], 255);
  const std::vector<std::uint8_t> one{7, 8, 9};
  EXPECT_EQ(small_picture(1, 1, one).rgb, one);
}

TEST(Preview, OrdersAreReadBack) {
  for (const Order& order :
       {Order(GoLive{"0.0.0.0", 4650}), Order(GoLive{"::1", 0}), Order(GoPrivate{})}) {
    std::string line = order_text(order);
    ASSERT_TRUE(line.ends_with('\n'));
    line.pop_back();
    EXPECT_EQ(parse_order(line), order);
  }
  for (const char* none : {"", "live", "live 4650", "live x 0.0.0.0", "live 70000 0.0.0.0",
                           "live 1 a b", "private now", "LIVE 1 ::"}) {
    EXPECT_EQ(parse_order(none), std::nullopt) << none;
  }
}

}  // namespace
}  // namespace aucast::preview
