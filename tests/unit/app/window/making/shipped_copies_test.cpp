#include "client/app/window/making/shipped_copies.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace aucast::app {
namespace {

namespace fs = std::filesystem;

class ShippedCopiesTest : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* const face : {"default", "anna"}) {
      for (const test::TempFolder* const folder : {&shipped_, &beside_}) {
        folder->write(std::string(face) + "/mesh.ply", "mesh");
        folder->write(std::string(face) + "/maps/skin.txt", "skin");
      }
    }
  }
  [[nodiscard]] bool contain(const char* face) { return copies_.contain(beside_.path() / face); }

  test::TempFolder shipped_;
  test::TempFolder beside_;
  ShippedCopies copies_{shipped_.path()};
};

TEST_F(ShippedCopiesTest, AreTheSameByteByByte) {
  EXPECT_TRUE(contain("anna"));
  EXPECT_TRUE(contain("default"));
  EXPECT_FALSE(contain("nobody"));
  beside_.write("anna/mesh.ply", "a larger mesh");
  EXPECT_FALSE(contain("anna"));
  beside_.write("anna/mesh.ply", "mush");
  EXPECT_FALSE(contain("anna")) << "of the same size";
  EXPECT_TRUE(contain("default"));
  beside_.write("default/more.txt", "");
  EXPECT_FALSE(contain("default"));
}

TEST_F(ShippedCopiesTest, FilesThatStayAreNotReadAgain) {
  ASSERT_TRUE(contain("anna"));
  const fs::path mesh = beside_.path() / "anna/mesh.ply";
  const auto written = fs::last_write_time(mesh);
  beside_.write("anna/mesh.ply", "mush");
  fs::last_write_time(mesh, written);
  EXPECT_TRUE(contain("anna")) << "who reads it sees the other bytes";
  fs::last_write_time(mesh, written + std::chrono::seconds(1));
  EXPECT_FALSE(contain("anna"));
}

}  // namespace
}  // namespace aucast::app
