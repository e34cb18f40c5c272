#include "common/film_name.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "common/text.h"

namespace aucast {

bool is_film(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 14> kEndings{".mp4", ".m4v", ".mov",  ".mkv", ".webm",
                                                      ".avi", ".mpg", ".mpeg", ".ts",  ".wmv",
                                                      ".flv", ".ogv", ".3gp",  ".y4m"};
  const std::string ending = file_ending(path);
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

}  // namespace aucast
