#include "tests/support/temp_folder.h"

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "common/check.h"

namespace aucast::test {

TempFolder::TempFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "aucast-test-XXXXXX").string();
  AUCAST_CHECK(::mkdtemp(pattern.data()) != nullptr);
  path_ = pattern;
}

TempFolder::~TempFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path TempFolder::write(const std::string& name, std::string_view bytes) const {
  const auto file = path_ / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

std::string TempFolder::read(const std::string& name) const {
  std::ifstream file(path_ / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace aucast::test
