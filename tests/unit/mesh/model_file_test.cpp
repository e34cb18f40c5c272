#include "common/mesh/model_file.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/support/small_model.h"

namespace aucast::mesh {
namespace {

using test::FlatTable;

constexpr std::int8_t kFloats = 0;
constexpr std::int8_t kHalves = 1;
constexpr std::int8_t kIntegers = 2;

FlatTable tensor(std::vector<std::int32_t> shape, std::int8_t type = kFloats, int buffer = 0) {
  return FlatTable().integers(0, std::move(shape)).byte(1, type).number(2, buffer);
}

/// A net of one step from tensor 0 to tensor 1. Everything can be another.
struct OneStep {
  FlatTable code = FlatTable().byte(0, static_cast<std::int8_t>(Operator::Relu));
  FlatTable step = FlatTable().number(0, 0).integers(1, {0}).integers(2, {1});
  std::vector<FlatTable> tensors{tensor({1, 4, 6, 2}), tensor({1, 4, 6, 2})};
  std::vector<FlatTable> buffers{FlatTable()};
  std::size_t graphs = 1;

  void is(Operator kind, const FlatTable& options) {
    code = FlatTable().byte(0, static_cast<std::int8_t>(kind));
    step.table(4, options);
  }

  [[nodiscard]] Result<Model> read() const {
    const FlatTable graph =
        FlatTable().tables(0, tensors).integers(1, {0}).integers(2, {1}).tables(3, {step});
    const std::string file = FlatTable()
                                 .tables(1, {code})
                                 .tables(2, std::vector<FlatTable>(graphs, graph))
                                 .tables(4, buffers)
                                 .file();
    return read_model(test::bytes_of(file), "a.tflite");
  }
  /// What is wrong with it; empty: nothing.
  [[nodiscard]] std::string wrong() const {
    const auto model = read();
    if (model) return {};
    EXPECT_EQ(model.error().kind, ErrorKind::BadData);
    const std::string begin = "a.tflite: not a model that can be used: ";
    EXPECT_EQ(model.error().message.substr(0, begin.size()), begin);
    return model.error().message.substr(begin.size());
  }
};

Step step_of(const OneStep& net) {
  const auto model = net.read();
  EXPECT_TRUE(model.has_value()) << model.error().message;
  return model ? model->steps.at(0) : Step{};
}

TEST(ModelFile, MissingDimensionsAreOneAndComeFirst) {
  OneStep net;
  net.tensors = {tensor({6, 2}), tensor({})};
  const auto model = net.read();
  ASSERT_TRUE(model.has_value()) << model.error().message;
  EXPECT_EQ(model->tensors[0].shape, (Shape{1, 1, 6, 2}));
  EXPECT_EQ(model->tensors[0].rank, 2U);
  EXPECT_EQ(model->tensors[1].shape, (Shape{1, 1, 1, 1}));
  EXPECT_EQ(model->inputs, std::vector<std::size_t>{0});
  EXPECT_EQ(model->outputs, std::vector<std::size_t>{1});
}

TEST(ModelFile, NumbersMayBeFloatsHalvesOrIntegers) {
  OneStep net;
  const std::string floats("\0\0\x80\x3f\0\0\0\xc0", 8);  // 1 and -2
  const std::string integers("\x05\0\0\0\xff\xff\xff\xff", 8);
  net.buffers = {FlatTable(), FlatTable().bytes(0, floats),
                 FlatTable().bytes(0, test::half_bytes({3, -4})), FlatTable().bytes(0, integers)};
  net.tensors = {tensor({2}), tensor({2}), tensor({2}, kFloats, 1), tensor({2}, kHalves, 2),
                 tensor({2}, kIntegers, 3)};
  const auto model = net.read();
  ASSERT_TRUE(model.has_value()) << model.error().message;
  EXPECT_FALSE(model->tensors[0].constant);
  EXPECT_EQ(model->tensors[2].values, (std::vector<float>{1, -2}));
  EXPECT_EQ(model->tensors[3].values, (std::vector<float>{3, -4}));
  EXPECT_EQ(model->tensors[4].integers, (std::vector<std::int32_t>{5, -1}));
  for (std::size_t index = 2; index < 5; ++index) EXPECT_TRUE(model->tensors[index].constant);

  net.tensors[2] = tensor({3}, kFloats, 1);
  EXPECT_EQ(net.wrong(), "a tensor has not as many numbers as its shape");
  net.tensors[2] = tensor({2}, 3, 1);
  EXPECT_EQ(net.wrong(), "a tensor has a type that is not known here");
  net.tensors[2] = tensor({2}, kFloats, 4);
  EXPECT_EQ(net.wrong(), "it is damaged");
}

TEST(ModelFile, TensorsHaveTheirLimits) {
  OneStep net;
  constexpr auto kMost = static_cast<std::int32_t>(kTensorNumbersMax);
  net.tensors = {tensor({kMost}), tensor({kMost})};
  EXPECT_EQ(net.wrong(), "");
  net.tensors.push_back(tensor({1}));
  EXPECT_EQ(net.wrong(), "it is too large") << "all tensors together";
  for (const auto& shape : std::vector<std::vector<std::int32_t>>{
           {kMost + 1}, {2, kMost}, {1, 0}, {-1}, {1, 1, 1, 1, 1}}) {
    net.tensors = {tensor({1}), tensor(shape)};
    EXPECT_EQ(net.wrong(), "a tensor has a shape that cannot be");
  }
}

TEST(ModelFile, OperatorsGoByNumberOrName) {
  OneStep net;
  net.code = FlatTable().byte(0, 127).number(3, 200);
  EXPECT_EQ(net.wrong(), "operator 200 is not known here")
      << "large ones have a field of their own";
  net.code = FlatTable().byte(0, 0).number(3, static_cast<std::int32_t>(Operator::Prelu));
  EXPECT_EQ(step_of(net).kind, Operator::Prelu);
  net.code = FlatTable().byte(0, 32).bytes(1, "TransformLandmarks");
  EXPECT_EQ(step_of(net).kind, Operator::TransformLandmarks);
  net.code = FlatTable().byte(0, 32).bytes(1, "TransformLandmark");
  EXPECT_EQ(net.wrong(), "operator 32 is not known here");
}

TEST(ModelFile, AWindowHasItsPaddingStridesAndActivation) {
  OneStep net;
  net.is(Operator::Conv2d, FlatTable().byte(0, 1).number(1, 2).number(2, 3).byte(3, 3));
  const Step conv = step_of(net);
  EXPECT_FALSE(conv.same_padding);
  EXPECT_EQ(conv.stride_width, 2U);
  EXPECT_EQ(conv.stride_height, 3U);
  EXPECT_EQ(conv.activation, Activation::Relu6);

  net = {};
  net.is(Operator::MaxPool2d,
         FlatTable().number(1, 1).number(2, 1).number(3, 4).number(4, 5).byte(5, 1));
  const Step pool = step_of(net);
  EXPECT_TRUE(pool.same_padding);
  EXPECT_EQ(pool.filter_width, 4U);
  EXPECT_EQ(pool.filter_height, 5U);
  EXPECT_EQ(pool.activation, Activation::Relu);

  net = {};
  net.is(Operator::DepthwiseConv2d, FlatTable().number(3, 7));
  EXPECT_EQ(step_of(net).depth_multiplier, 7U);
}

TEST(ModelFile, OptionsThatWouldGiveOtherNumbersAreRefused) {
  const std::pair<Operator, FlatTable> kWrong[] = {
      {Operator::Conv2d, FlatTable().number(1, 0)},     // a stride
      {Operator::Conv2d, FlatTable().number(2, 4097)},  // another
      {Operator::Conv2d, FlatTable().byte(3, 2)},       // ReLU from -1 to 1
      {Operator::Conv2d, FlatTable().number(4, 2)},     // gaps between the weights
      {Operator::DepthwiseConv2d, FlatTable().number(6, 2)},
      {Operator::DepthwiseConv2d, FlatTable().number(3, -1)},
      {Operator::Add, FlatTable().byte(0, 4)},
      {Operator::Concatenation, FlatTable().number(0, 4)},  // a dimension
      {Operator::Concatenation, FlatTable().number(0, -5)},
      {Operator::StridedSlice, FlatTable().number(4, 1)},  // a mask
  };
  for (const auto& [kind, options] : kWrong) {
    OneStep net;
    net.is(kind, options);
    EXPECT_EQ(net.wrong(), "an operator has options that are not known here")
        << static_cast<int>(kind);
  }
  OneStep net;
  net.step.bytes(5, "none");
  EXPECT_EQ(net.wrong(), "the options of a custom operator are damaged");
}

TEST(ModelFile, AnAxisCountsAllFourDimensions) {
  for (const auto& [axis, expected] :
       std::vector<std::pair<int, std::size_t>>{{0, 2}, {1, 3}, {-1, 3}, {-2, 2}}) {
    OneStep net;
    net.tensors = {tensor({6, 2}), tensor({6, 2})};
    net.is(Operator::Concatenation, FlatTable().number(0, axis));
    EXPECT_EQ(step_of(net).axis, expected) << axis;
  }
}

TEST(ModelFile, HasOneGraphWhoseStepsMakeOneTensorEach) {
  OneStep net;
  net.graphs = 2;
  EXPECT_EQ(net.wrong(), "it has not one graph");
  net = {};
  net.step = FlatTable().number(0, 0).integers(1, {0}).integers(2, {1, 0});
  EXPECT_EQ(net.wrong(), "it is damaged");
  net.step = FlatTable().number(0, 0).integers(1, {}).integers(2, {1});
  EXPECT_EQ(net.wrong(), "it is damaged");
  net.step = FlatTable().number(0, 1).integers(1, {0}).integers(2, {1});
  EXPECT_EQ(net.wrong(), "it is damaged") << "there is no second operator";
  net.step = FlatTable().number(0, 0).integers(1, {0}).integers(2, {2});
  EXPECT_EQ(net.wrong(), "it names a tensor that it does not have");
}

}  // namespace
}  // namespace aucast::mesh
