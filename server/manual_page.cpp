#include "server/manual_page.h"

#include "common/manual.h"
#include "server/settings/option_table.h"
#include "server/settings/transmitter_options.h"
#include "server/streams/convert_command.h"

namespace aucast::server {
namespace {

void add_settings(ManualPage& page) {
  page.section("SETTINGS");
  page.paragraph(
      "An option can be set in a settings file, in the environment and on the command line; the "
      "last one wins. Some (--check, --print-config) are for the command line only. The file is "
      "TOML with one option a line: bind = \"0.0.0.0\", port = 4650, live = true, source = "
      "[\"talk.txt\", \"/srv/streams\"]. An unknown name is an error.");
  page.paragraph(
      "The variable of an option is AUCAST_TRANSMITTER_ and its name in capitals, with _ for -: "
      "AUCAST_TRANSMITTER_CLIENT_TIMEOUT=30. Commas separate several sources. "
      "AUCAST_TRANSMITTER_CONFIG names the settings file, as --config does.");
  page.paragraph(
      "In the texts above, {-2} is the packet that ends a stream. A client of level 2 begins with "
      "a hello; a classic client, of level 1, sends none and gets AUs without intensities, sides "
      "and times. protocol/PROTOCOL.md describes both.");
}

void add_the_rest(ManualPage& page) {
  page.section("SIGNALS");
  page.item(
      "SIGTERM, SIGINT",
      "Stops accepting clients, sends {-2} to those it has and exits within 2 seconds. A second "
      "signal ends it at once. With --drain-time the first signal starts the drain, a second sends "
      "{-2} to those that are left, and a third ends it at once.");
  page.item("SIGHUP",
            "Reads certificates, token and sources again, from the same places; not the settings "
            "file, the environment or other options. Connected clients keep their streams. If "
            "something is broken, the log says so and nothing changes.");
  page.item("SIGUSR1", "Writes the status to the log, at level info.");
  page.section("SYSTEMD");
  page.paragraph(
      "au-transmitter stays in the foreground and speaks sd_notify(3): READY, RELOADING, STOPPING, "
      "STATUS and WATCHDOG. A listening socket that is passed (LISTEN_FDS) takes the place of "
      "--bind and --port. au-transmitter.service and au-transmitter.socket are installed with it.");
  page.section("FILES");
  page.item("/etc/aucast/au-transmitter.toml", "The settings file that is read if it exists.");
  page.section("EXIT STATUS");
  page.item("0", "Done; also when a signal ended it.");
  page.item("1", "Failed while running.");
  page.item("2",
            "A mistake on the command line or in the environment; also a source whose name cannot "
            "be a stream's, or is that of another source.");
  page.item("3",
            "A source or the settings file is wrong; the message names file, line and column.");
  page.item("4", "A file cannot be read.");
  page.item("5", "Cannot listen.");
  page.section("CONVERT");
  page.command(convert_page());
  page.section("EXAMPLES");
  for (const std::string_view line : transmitter_page().examples) page.example(line);
  page.example("au-transmitter --print-config --bind :: /srv/streams > au-transmitter.toml");
  page.section("SEE ALSO");
  page.paragraph("face-player(1)");
}

}  // namespace

std::string manual_page() {
  ManualPage page("au-transmitter", version_number(), "streams sets of FACS Action Units");
  page.section("SYNOPSIS");
  page.paragraph("au-transmitter [OPTIONS] SOURCE...");
  page.paragraph("au-transmitter convert [OPTIONS] IN OUT");
  page.section("DESCRIPTION");
  page.paragraph(
      "Serves stream files and recordings of AU recognisers over TCP to face-player(1) and its "
      "like, any number at a time. When it is ready it prints one line, \"listening on "
      "ADDR:PORT\"; the log goes to stderr.");
  page.section("OPTIONS");
  page.options(transmitter_page().rows);
  add_settings(page);
  add_the_rest(page);
  return page.text();
}

std::optional<std::string> completion(const std::vector<std::string>& arguments) {
  return asked_completion(arguments, {transmitter_page(), convert_page()});
}

}  // namespace aucast::server
