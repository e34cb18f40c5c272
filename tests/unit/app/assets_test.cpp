#include "client/app/assets.h"

#include <gtest/gtest.h>

#include "protocol/codec.h"
#include "tests/support/process.h"

namespace aucast::app {
namespace {

TEST(ShippedAssets, LoadAndNameTheirExpressions) {
  FaceOptions options;
  options.data = test::program("data");
  const auto assets = load_assets(options);
  ASSERT_TRUE(assets.has_value()) << assets.error().message;
  EXPECT_EQ(protocol::format_au_set(find_expression(**assets, "thesis-happiness")->aus),
            "1,6,12,14");
  EXPECT_EQ(describe(**assets, find_expression(**assets, "thesis-fear")->aus), "Fear");
  EXPECT_EQ(describe(**assets, *protocol::parse_au_set("12:33")), "12:33");
  const auto typo = find_expression(**assets, "hapiness");
  ASSERT_FALSE(typo.has_value());
  EXPECT_NE(typo.error().message.find("did you mean happiness?"), std::string::npos);
}

TEST(ShippedAssets, AMissingFaceIsUnreadable) {
  FaceOptions options;
  options.data = test::program("data");
  options.face = "/no/such/face";
  const auto assets = load_assets(options);
  ASSERT_FALSE(assets.has_value());
  EXPECT_EQ(assets.error().kind, ErrorKind::Unreadable);
}

}  // namespace
}  // namespace aucast::app
