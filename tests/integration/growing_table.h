#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace aucast::test {

// OpenFace's table as far as it matters here: AU 12 at 25 rows a second.

inline constexpr const char* kHeader = "face_id,timestamp,success,AU12_r\n";

inline std::string row(int frame, const std::string& of_five) {
  const int ms = frame * 40;
  return "0," + std::to_string(ms / 1000) + "." + std::to_string(1000 + ms % 1000).substr(1) +
         ",1," + of_five + "\n";
}

/// Opens, appends, closes: as a shell's >> does.
inline void append(const std::filesystem::path& path, const std::string& text) {
  const int file = ::open(path.c_str(), O_WRONLY | O_APPEND);
  ASSERT_GE(file, 0);
  ASSERT_EQ(::write(file, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  ::close(file);
}

}  // namespace aucast::test
