#include "client/app/manual_page.h"

#include <vector>

#include "client/app/help_text.h"
#include "common/manual.h"

namespace aucast::app {
namespace {

const std::vector<std::string>& commands() {
  static const std::vector<std::string> kCommands{"play", "pose", "rules", "gallery"};
  return kCommands;
}

}  // namespace

std::string manual_page() {
  ManualPage page("face-player", AUCAST_VERSION, "draws a face that comes as FACS Action Units");
  page.section("DESCRIPTION");
  add_help_page(page, "face-player", help_text(""));
  for (const std::string& command : commands()) {
    page.section(command);
    add_help_page(page, "face-player", help_text(command));
  }
  page.section("SEE ALSO");
  page.paragraph("au-transmitter(1)");
  return page.text();
}

std::optional<std::string> completion(const std::vector<std::string>& arguments) {
  std::string help(help_text(""));
  for (const std::string& command : commands()) help += help_text(command);
  return asked_completion(arguments, "face-player", options_in(help), commands());
}

}  // namespace aucast::app
