#include "client/gui/storage/home_folder.h"

#include <cstdlib>

namespace aucast::gui {

std::string with_home(std::string_view typed, const char* home) {
  const bool begins = typed == "~" || typed.starts_with("~/");
  if (!begins || home == nullptr || home[0] != '/') return std::string(typed);
  std::string_view folder = home;
  typed.remove_prefix(1);
  while (folder.ends_with('/') && (folder.size() > 1 || !typed.empty())) folder.remove_suffix(1);
  return std::string(folder).append(typed);
}

std::string with_home(std::string_view typed) {
  return with_home(typed, std::getenv("HOME"));
}

}  // namespace aucast::gui
