#include "server/settings/manual_page.h"

#include "common/manual.h"
#include "server/settings/option_table.h"
#include "server/settings/transmitter_options.h"
#include "server/streams/convert_command.h"

namespace aucast::server {
namespace {

void add_options(ManualPage& page) {
  page.section("OPTIONS");
  for (const OptionRow& row : option_table()) {
    if (!row.heading.empty()) page.heading(row.heading);
    std::string tag = typed_name(row);
    if (!row.argument.empty()) tag += " " + std::string(row.argument);
    std::string text(row.more);
    if (!row.fallback.empty() && row.kind != OptionRow::Kind::Flag) {
      text += " Default: " + std::string(row.fallback) + ".";
    }
    page.item(tag, text);
  }
  page.item("-v, --verbose", "The same as --log-level debug.");
  page.item("-q, --quiet", "The same as --log-level error.");
  page.item("-h, --help", "A page that fits the screen.");
  page.item("--version", "Version, protocol and licence.");
}

void add_settings(ManualPage& page) {
  page.section("SETTINGS");
  page.paragraph(
      "Every option but those of the command line only (--check, --print-config) can be set in a "
      "settings file, then in the environment, then on the command line; the last one wins. The "
      "file is TOML, one line an option: bind = \"0.0.0.0\", port = 4650, live = true, "
      "source = [\"talk.txt\", \"/srv/streams\"]. A name that is no option is an error.");
  page.paragraph(
      "The environment has AUCAST_TRANSMITTER_ and the option in capitals with _ for -: "
      "AUCAST_TRANSMITTER_CLIENT_TIMEOUT=30. Several sources are separated by commas. "
      "AUCAST_TRANSMITTER_CONFIG names the settings file as --config does.");
}

void add_the_rest(ManualPage& page) {
  page.section("SIGNALS");
  page.item("SIGTERM, SIGINT",
            "Nobody is accepted any more, every client gets {-2}, and it ends within 2 seconds. "
            "Another one ends it at once.");
  page.item("SIGHUP",
            "Certificates, token and sources are read again, from where the start found them; the "
            "settings file, the environment and all other options are not. Who is connected keeps "
            "what it has; what is broken is said in the log and changes nothing.");
  page.item("SIGUSR1", "Writes to the log how things are, at the level info.");
  page.section("SYSTEMD");
  page.paragraph(
      "au-transmitter stays in the foreground and speaks sd_notify(3): READY, RELOADING, STOPPING, "
      "STATUS and WATCHDOG. A listening socket that is passed (LISTEN_FDS) takes the place of "
      "--bind and --port. au-transmitter.service and au-transmitter.socket come with it.");
  page.section("FILES");
  page.item("/etc/aucast/au-transmitter.toml", "The settings file that is read if it is there.");
  page.section("EXIT STATUS");
  page.item("0", "Done, also when a signal ended it.");
  page.item("1", "Failed while running.");
  page.item("2", "The command line or the environment asks for what does not exist.");
  page.item("3",
            "A source or the settings file is wrong; the message names file, line and column.");
  page.item("4", "A file cannot be read.");
  page.item("5", "Cannot listen.");
  page.section("CONVERT");
  add_help_page(page, "au-transmitter", convert_help_text());
  page.section("EXAMPLES");
  page.example("au-transmitter data/streams/six_expressions.txt");
  page.example("au-transmitter --bind 0.0.0.0 --live --loop talk.txt");
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
  add_options(page);
  add_settings(page);
  add_the_rest(page);
  return page.text();
}

std::optional<std::string> completion(const std::vector<std::string>& arguments) {
  return asked_completion(arguments, "au-transmitter",
                          options_in(help_text() + convert_help_text()), {"convert"});
}

}  // namespace aucast::server
