#include "common/overwriting.h"

#include <set>
#include <system_error>

#include "common/files.h"
#include "common/text.h"

namespace aucast {

Result<void> check_not_read(const std::vector<std::filesystem::path>& outputs,
                            const std::vector<std::filesystem::path>& inputs) {
  std::error_code none;
  for (const std::filesystem::path& output : outputs) {
    // A terminal or /dev/null may be both.
    if (output == "-" || !std::filesystem::is_regular_file(output, none)) continue;
    for (const std::filesystem::path& input : inputs) {
      const bool standard = input == "-";
      if (!std::filesystem::equivalent(output, standard ? "/dev/stdin" : input, none)) continue;
      return Error{ErrorKind::Usage, printable(output.string()) + " would be written over " +
                                         (standard ? "standard input" : printable(input.string())) +
                                         ", which is read; choose another name or folder"};
    }
  }
  return {};
}

Result<void> check_distinct(const std::vector<std::filesystem::path>& outputs) {
  std::error_code none;
  std::set<std::filesystem::path> places;
  for (const std::filesystem::path& output : outputs) {
    const bool file = std::filesystem::is_regular_file(output, none);
    if (output.empty() || output == "-" || (!file && std::filesystem::exists(output, none))) {
      continue;
    }
    const auto place = std::filesystem::weakly_canonical(whole_path(output), none);
    // A link to itself leads nowhere.
    if (places.insert(place.empty() ? output : place).second) continue;
    return Error{ErrorKind::Usage, printable(output.string()) +
                                       " would be written twice, for two options; choose another "
                                       "name for one of them"};
  }
  return {};
}

}  // namespace aucast
