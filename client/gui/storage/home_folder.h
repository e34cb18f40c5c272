#pragma once

#include <string>
#include <string_view>

namespace aucast::gui {

/// The path that somebody typed, as the system takes it: "~" alone or before a slash is replaced by
/// the home folder. A folder that is really called "~" is typed as "./~". `home` is the value of
/// HOME; if it is null or no absolute path, the text stays as it is.
[[nodiscard]] std::string with_home(std::string_view typed, const char* home);
/// The same with this process' HOME.
[[nodiscard]] std::string with_home(std::string_view typed);

}  // namespace aucast::gui
