#pragma once

#include <filesystem>

namespace aucast::face::test {

/// The project's data folder.
inline const std::filesystem::path kData = AUCAST_TEST_DATA;

}  // namespace aucast::face::test
