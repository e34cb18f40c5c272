#include "common/mesh/net.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "common/mesh/flat_buffer.h"
#include "tests/support/allocations.h"
#include "tests/support/small_model.h"

namespace aucast::mesh {
namespace {

Result<Net> net_of(const std::string& file) {
  return Net::make(test::bytes_of(file), "small.tflite");
}

TEST(Net, RunsWhatAFileDescribes) {
  auto net = net_of(test::SmallModel().file());
  ASSERT_TRUE(net.has_value()) << net.error().message;
  EXPECT_EQ(net->input_shape(), (Shape{1, 2, 2, 1}));
  const std::vector<float> in{1, 2, -1, 0.25F};
  std::copy(in.begin(), in.end(), net->input().begin());
  net->run();
  ASSERT_EQ(net->outputs(), 1U);
  // 2x + 1 and -3x, cut off at 0.
  const std::vector<float> expected{3, 0, 5, 0, 0, 3, 1.5F, 0};
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), net->output(0).begin()));
}

TEST(Net, GivesTheSameNumbersAgain) {
  auto net = net_of(test::SmallModel().file());
  ASSERT_TRUE(net.has_value());
  std::fill(net->input().begin(), net->input().end(), 0.7F);
  net->run();
  const std::vector<float> first(net->output(0).begin(), net->output(0).end());
  net->run();
  EXPECT_TRUE(std::equal(first.begin(), first.end(), net->output(0).begin()));
}

TEST(Net, AllocatesNothingWhileItRuns) {
  auto net = net_of(test::SmallModel().file());
  ASSERT_TRUE(net.has_value());
  const std::size_t before = aucast::test::allocations();
  net->run();
  EXPECT_EQ(aucast::test::allocations(), before);
}

void expect_bad(const std::string& file, const std::string& why) {
  const auto net = net_of(file);
  ASSERT_FALSE(net.has_value());
  EXPECT_EQ(net.error().kind, ErrorKind::BadData);
  EXPECT_NE(net.error().message.find("small.tflite"), std::string::npos);
  EXPECT_NE(net.error().message.find(why), std::string::npos) << net.error().message;
}

TEST(Net, SaysWhatIsWrongWithAModel) {
  expect_bad("", "it is no TFLite file");
  expect_bad("something else altogether", "it is no TFLite file");
  test::SmallModel model;
  model.code = 99;
  expect_bad(model.file(), "operator 99");
  model = {};
  model.weights = {1};
  expect_bad(model.file(), "not as many numbers");
  model = {};
  model.input = 17;
  expect_bad(model.file(), "a tensor that it does not have");
  model = {};
  model.input = 5;  // what it is to make
  expect_bad(model.file(), "does not fit");
  model = {};
  model.out_shape = {1, 2, 3, 2};
  expect_bad(model.file(), "does not fit");
  model = {};
  model.out_shape = {1, 1 << 20, 1 << 20, 2};
  expect_bad(model.file(), "shape");
  model = {};
  model.out_shape = {1, -2, 2, 2};
  expect_bad(model.file(), "shape");
}

TEST(Net, IsNeverReadBeyondTheEndOfAFileCutOffAnywhere) {
  const std::string whole = test::SmallModel().file();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const std::string cut(whole, 0, length);
    const std::vector<std::uint8_t> exact(cut.begin(), cut.end());  // for the address sanitizer
    const auto net = Net::make(exact, "cut");
    if (net.has_value()) {
      EXPECT_GT(length + 4, whole.size()) << "more than the padding is missing";
    }
  }
}

TEST(Net, BearsAnyByteBeingAnother) {
  const std::string whole = test::SmallModel().file();
  for (std::size_t place = 0; place < whole.size(); ++place) {
    for (const int change : {1, 0x7f, 0x80, 0xff}) {
      std::string other = whole;
      other[place] = static_cast<char>(other[place] ^ change);
      auto net = net_of(other);
      if (!net.has_value()) {
        EXPECT_EQ(net.error().kind, ErrorKind::BadData);
        continue;
      }
      net->run();  // it says something else, or the same
    }
  }
}

TEST(FlatBuffer, ReadsHalves) {
  EXPECT_EQ(half_to_float(0x0000), 0.0F);
  EXPECT_EQ(half_to_float(0x3c00), 1.0F);
  EXPECT_EQ(half_to_float(0xc000), -2.0F);
  EXPECT_EQ(half_to_float(0x3555), 0.333251953125F);
  EXPECT_EQ(half_to_float(0x0001), std::ldexp(1.0F, -24));
  EXPECT_EQ(half_to_float(0x7bff), 65504.0F);
  EXPECT_TRUE(std::isinf(half_to_float(0x7c00)));
  EXPECT_TRUE(std::isnan(half_to_float(0x7e00)));
}

/// {"a": 3, "b": [7, -2]} with one byte for each number.
const std::vector<std::uint8_t> kFlexMap{
    'a', 0,    'b',  0,     // keys
    2,   7,    0xfe,        // a vector of integers
    2,   8,    7,           // positions of both keys, at place 8
    2,   1,    2,           // where the keys are, their width, how many values
    3,   9,    4,    0x2c,  // 3; the vector; the types of both
    4,   0x24, 1};          // the root: how far back, a map, one byte

TEST(FlatBuffer, ReadsTheOptionsOfCustomOperators) {
  const auto map = read_flex_map(kFlexMap);
  ASSERT_TRUE(map.has_value());
  ASSERT_EQ(map->size(), 2U);
  EXPECT_EQ((*map)[0].first, "a");
  EXPECT_EQ((*map)[0].second, std::vector<double>{3});
  EXPECT_EQ((*map)[1].first, "b");
  EXPECT_EQ((*map)[1].second, (std::vector<double>{7, -2}));
}

TEST(FlatBuffer, BearsDamagedOptions) {
  for (std::size_t length = 0; length < kFlexMap.size(); ++length) {
    const std::vector<std::uint8_t> cut(kFlexMap.begin(),
                                        kFlexMap.begin() + static_cast<std::ptrdiff_t>(length));
    static_cast<void>(read_flex_map(cut));
  }
  for (std::size_t place = 0; place < kFlexMap.size(); ++place) {
    for (int value = 0; value < 256; ++value) {
      std::vector<std::uint8_t> other = kFlexMap;
      other[place] = static_cast<std::uint8_t>(value);
      static_cast<void>(read_flex_map(other));
    }
  }
  EXPECT_FALSE(read_flex_map({}).has_value());
}

}  // namespace
}  // namespace aucast::mesh
