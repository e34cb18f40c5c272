#pragma once

#include <ostream>
#include <string>

#include <gtest/gtest.h>

namespace aucast::face::test {

/// A change to one file of a face, and the message that it must cause, without the file's path.
struct BadFile {
  std::string file;
  std::string from;
  std::string to;
  std::string message;
};

inline void PrintTo(const BadFile& bad, std::ostream* out) {
  *out << bad.file << bad.message;
}

/// Names a case by its number, since a message cannot be a name.
[[nodiscard]] inline std::string case_name(const ::testing::TestParamInfo<BadFile>& info) {
  return std::to_string(info.index);
}

}  // namespace aucast::face::test
