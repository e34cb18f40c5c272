// What the programs say for manual pages and completion, and what `cmake --install` puts in place.
#include <filesystem>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "tests/integration/installed.h"
#include "tests/support/process.h"
#include "tests/support/raw_client.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {
namespace {

using namespace std::chrono_literals;

std::string out_of(const std::string& name, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), program(name));
  const Finished finished = run(arguments);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  return finished.out;
}

std::set<std::string> options_of(const std::string& text) {
  std::set<std::string> options;
  const std::regex option("--[a-z][a-z-]*");
  for (std::sregex_iterator at(text.begin(), text.end(), option), end; at != end; ++at) {
    options.insert(at->str());
  }
  return options;
}

/// A manual page without roff's fonts and escapes.
std::string plain(const std::string& page) {
  std::string text = std::regex_replace(page, std::regex("\\\\f[BR]"), " ");
  std::erase(text, '\\');
  return text;
}

struct Pages {
  const char* program;
  std::vector<std::vector<std::string>> help;
};

const Pages kPrograms[] = {
    {"au-transmitter", {{"--help"}, {"convert", "--help"}}},
    {"face-player",
     {{"--help"},
      {"play", "--help"},
      {"pose", "--help"},
      {"rules", "--help"},
      {"gallery", "--help"},
      {"export", "--help"}}},
#ifdef AUCAST_HAS_SPEAKER
    {"au-speaker", {{"--help"}}},
#endif
};

TEST(Manual, HasEveryOptionOfHelpAndSoHasTheCompletion) {
  for (const Pages& pages : kPrograms) {
    const auto manual = options_of(plain(out_of(pages.program, {"--help-man"})));
    const auto completion = options_of(out_of(pages.program, {"--help-completion"}));
    const auto zsh = options_of(out_of(pages.program, {"--help-completion", "zsh"}));
    const std::string fish = out_of(pages.program, {"--help-completion", "fish"});
    for (const auto& arguments : pages.help) {
      const auto help = options_of(out_of(pages.program, arguments));
      EXPECT_GT(help.size(), 2U) << "of " << pages.program;
      for (const std::string& option : help) {
        EXPECT_TRUE(manual.contains(option)) << pages.program << " " << option;
        EXPECT_TRUE(completion.contains(option)) << pages.program << " " << option;
        EXPECT_TRUE(zsh.contains(option)) << pages.program << " " << option;
        EXPECT_NE(fish.find(" -l " + option.substr(2) + "\n"), std::string::npos)
            << pages.program << " " << option;
      }
    }
  }
}

TEST(Manual, IsReadWithoutAWarning) {
  if (run({"sh", "-c", "command -v man && command -v groff"}).exit_code != 0) {
    GTEST_SKIP() << "man or groff is not here";
  }
  const TempFolder folder;
  for (const Pages& pages : kPrograms) {
    const auto file =
        folder.write(std::string(pages.program) + ".1", out_of(pages.program, {"--help-man"}));
    const Finished checked =
        run({"man", "--warnings=all", "-E", "UTF-8", "-l", "-Tutf8", file}, {"MANWIDTH=80"});
    EXPECT_EQ(checked.exit_code, 0);
    EXPECT_EQ(checked.err, "") << pages.program;
    EXPECT_NE(checked.out.find("(1)"), std::string::npos) << "its title";
  }
}

TEST_F(Installed, EverythingIsInItsPlaceAndWorksThere) {
  namespace fs = std::filesystem;
  for (const char* path :
       {"bin/au-transmitter", "bin/face-player", "share/aucast/faces", "share/aucast/rules",
        "share/man/man1/au-transmitter.1", "share/man/man1/face-player.1",
        "share/bash-completion/completions/au-transmitter",
        "share/bash-completion/completions/face-player", "share/zsh/site-functions/_au-transmitter",
        "share/zsh/site-functions/_face-player",
        "share/fish/vendor_completions.d/au-transmitter.fish",
        "share/fish/vendor_completions.d/face-player.fish",
        "lib/systemd/system/au-transmitter.service", "lib/systemd/system/au-transmitter.socket"}) {
    EXPECT_TRUE(fs::exists(at(path))) << path;
  }
  // Data is found beside the programs, not where they were built.
  const Finished pose = run({at("bin/face-player"), "pose", "6,12"});
  EXPECT_EQ(pose.exit_code, 0) << pose.err;
  Process server({at("bin/au-transmitter"), "--port", "0", at("share/aucast/streams")});
  EXPECT_TRUE(server.read_line(kPatience)) << server.err();
  server.signal(SIGTERM);
  EXPECT_EQ(server.wait(kPatience), 0);
}

TEST_F(Installed, NatsIsAModuleThatIsFoundFromTheProgramAndMayBeMissing) {
  const std::vector<std::string> follow = {at("bin/au-transmitter"), "--port", "0",
                                           "nats://127.0.0.1:1/talk"};
#ifdef AUCAST_NATS_MODULE
  ASSERT_TRUE(std::filesystem::exists(at(AUCAST_NATS_MODULE)));
  Process server(follow);
  EXPECT_TRUE(server.read_line(kPatience)) << server.err();
  server.signal(SIGTERM);
  EXPECT_EQ(server.wait(kPatience), 0);
  EXPECT_NE(server.err().find("no server of NATS answers yet"), std::string::npos) << server.err();
  std::filesystem::rename(at(AUCAST_NATS_MODULE), at("aucast-nats.so"));
#endif
  // Where the program is started from counts for nothing.
  const Finished without = run(
      {"sh", "-c", R"(cd "$0" && exec "$@")", at(""), follow[0], follow[1], follow[2], follow[3]});
  EXPECT_EQ(without.exit_code, 2);
  EXPECT_NE(without.err.find("NATS is not installed: the package aucast-nats has it"),
            std::string::npos)
      << without.err;
}

TEST_F(Installed, ExampleOfSettingsIsUnderstood) {
  const std::string example = at("share/doc/aucast/au-transmitter.toml");
  const Finished printed = run({at("bin/au-transmitter"), "--config", example, "--print-config"});
  EXPECT_EQ(printed.exit_code, 0) << printed.err;
  EXPECT_NE(printed.out.find("max-clients = 10000  # " + example), std::string::npos);
}

TEST_F(Installed, UnitStartsTheProgramThatWasInstalledWithIt) {
  const Finished line =
      run({"grep", "^ExecStart=", at("lib/systemd/system/au-transmitter.service")});
  EXPECT_EQ(line.out, "ExecStart=" + at("bin/au-transmitter") + "\n");
}

TEST_F(Installed, UnitsPassSystemdsOwnCheck) {
  if (run({"sh", "-c", "command -v systemd-analyze"}).exit_code != 0) {
    GTEST_SKIP() << "systemd-analyze is not here";
  }
  const std::string unit = at("lib/systemd/system/au-transmitter.service");
  const Finished checked = run({"systemd-analyze", "verify", "--man=no", unit,
                                at("lib/systemd/system/au-transmitter.socket")});
  EXPECT_EQ(checked.out + checked.err, "") << "nothing to complain of";
  EXPECT_EQ(checked.exit_code, 0);
  const Finished security =
      run({"systemd-analyze", "security", "--offline=true", "--threshold=20", unit});
  EXPECT_EQ(security.exit_code, 0) << "exposure at most 2.0 of 10\n" << security.out;
}

}  // namespace
}  // namespace aucast::test
