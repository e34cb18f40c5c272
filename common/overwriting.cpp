#include "common/overwriting.h"

#include <system_error>

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

}  // namespace aucast
