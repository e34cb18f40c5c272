#include "client/gui/said_text.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "client/gui/texts.h"

namespace aucast::gui {
namespace {

class SaidText : public testing::Test {
 protected:
  void TearDown() override { use_english(); }
  static void use_french() {
    auto french = load_language(std::filesystem::path(AUCAST_TEST_DATA) / "languages" / "fr.toml");
    ASSERT_TRUE(french) << french.error().message;
    use_language(*std::move(french));
  }
};

const std::vector<std::string> kSaid = {
    "cannot reach 127.0.0.1:4650: Connection refused; is au-transmitter running there, on an "
    "address (--bind) that can be reached from here?",
    "venus:4650: the connection ended before the end of the stream, {-2}; the server's log may say "
    "why",
    "[::1]:4650: the server refused: 404 there is no stream 'x' here",
    "venus:4650: cannot be reached: no answer within 500 ms; is au-transmitter running there, on "
    "an address (--bind) that can be reached from here?",
    "/tmp/a.glb: 3.49 MB, 133 targets\nfarthest vertex from the face itself: median 0.10 mm, nine "
    "of ten below 0.50 mm, worst 1.00 mm (200 random faces)",
    "/tmp/a.glb: 3.49 MB, 133 targets, 30 samples in 1.0 s\nfarthest vertex from the face itself: "
    "median 0.10 mm, nine of ten below 0.50 mm, worst 1.00 mm (30 samples)",
    "OpenFace 2: 10 rows, 2 without a face, 1 left out (no later time); one of 3 faces"};

TEST_F(SaidText, IsAsItCameInEnglish) {
  for (const std::string& text : kSaid) EXPECT_EQ(in_used_language(text), text);
}

TEST_F(SaidText, HasNoEnglishLeftInFrench) {
  use_french();
  for (const std::string& text : kSaid) {
    const std::string french = in_used_language(text);
    for (const char* english :
         {" the ", "refused", "cannot", "within", "worst", "rows", "faces", "targets", "answer"}) {
      EXPECT_EQ(french.find(english), std::string::npos) << french;
    }
  }
}

TEST_F(SaidText, KeepsNamesAndNumbersAndWhatItDoesNotKnow) {
  use_french();
  const std::string refused = in_used_language(kSaid[0]);
  EXPECT_NE(refused.find("127.0.0.1:4650"), std::string::npos) << refused;
  EXPECT_NE(in_used_language(kSaid[1]).find("{-2}"), std::string::npos);
  EXPECT_NE(in_used_language(kSaid[2]).find("[::1]:4650"), std::string::npos);
  for (const char* own : {"", "venus: a server's own words", "AU12 saved"}) {
    EXPECT_EQ(in_used_language(own), own);
  }
}

}  // namespace
}  // namespace aucast::gui
