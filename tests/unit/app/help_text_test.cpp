#include "client/app/help_text.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace aucast::app {
namespace {

TEST(HelpText, FitsOneScreen) {
  for (const char* command : {"", "play", "pose", "rules", "gallery"}) {
    const std::string_view text = help_text(command);
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 50) << command;
    std::size_t begin = 0;
    while (begin < text.size()) {
      const std::size_t end = text.find('\n', begin);
      EXPECT_LE(end - begin, 100U) << text.substr(begin, end - begin);
      begin = end + 1;
    }
  }
}

TEST(HelpText, NamesEveryOptionAndAnExample) {
  for (const char* option : {"--headless",
                             "--buffer",
                             "--playout",
                             "--threshold",
                             "--stream",
                             "--list",
                             "--protocol",
                             "--connect-timeout",
                             "--live",
                             "--live-delay",
                             "--reconnect",
                             "--tls",
                             "--tls-ca",
                             "--tls-cert",
                             "--tls-key",
                             "--token-file",
                             "--insecure-token",
                             "--speed",
                             "--mixer",
                             "--rules",
                             "--interpolation",
                             "--blink",
                             "--idle",
                             "--face",
                             "--data",
                             "--frames",
                             "--record",
                             "--sheet",
                             "--fps",
                             "--size",
                             "--stats",
                             "--background",
                             "--fast",
                             "--exit-at-end",
                             "--log-level",
                             "-v",
                             "-q",
                             "--help",
                             "--version",
                             "face-player --headless 10.0.0.7:4650"}) {
    EXPECT_NE(help_text("").find(option), std::string_view::npos) << option;
  }
  for (const char* option : {"--expression", "--muscle", "--list", "--png", "--obj", "--camera",
                             "--mixer", "--rules", "--face", "--size", "--data", "--background"}) {
    EXPECT_NE(help_text("pose").find(option), std::string_view::npos) << option;
  }
  for (const char* option : {"--only", "--sweep", "--size", "--camera", "--background", "--mixer",
                             "--rules", "--face", "--data", "face-player gallery pictures"}) {
    EXPECT_NE(help_text("gallery").find(option), std::string_view::npos) << option;
  }
  EXPECT_NE(help_text("rules").find("--explain"), std::string_view::npos);
}

TEST(HelpText, VersionNamesProtocolAndLicence) {
  EXPECT_NE(version_text().find("protocol 2"), std::string::npos);
  EXPECT_NE(version_text().find("MIT"), std::string::npos);
}

}  // namespace
}  // namespace aucast::app
