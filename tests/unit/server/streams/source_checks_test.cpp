#include "server/streams/source_checks.h"

#include <string>

#include <gtest/gtest.h>

namespace aucast::server {
namespace {

/// What is wrong; empty when nothing is.
std::string complaint(const TransmitterOptions& options) {
  const auto can = check_sources(options);
  if (can) return {};
  EXPECT_EQ(can.error().kind, ErrorKind::Usage);
  EXPECT_TRUE(can.error().message.ends_with(" (try --help)")) << can.error().message;
  return can.error().message;
}

TransmitterOptions preview() {
  TransmitterOptions options;
  options.sources = {"camera:/dev/video2"};
  options.preview = true;
  return options;
}

TEST(SourceChecks, APreviewIsOfOneCamera) {
  TransmitterOptions options = preview();
  EXPECT_EQ(complaint(options), "");
  options.sources = {"talk.txt"};
  EXPECT_NE(complaint(options).find("the only SOURCE"), std::string::npos);
  options.sources = {"camera", "talk.txt"};
  EXPECT_NE(complaint(options).find("the only SOURCE"), std::string::npos);
}

TEST(SourceChecks, WhatAPreviewShowsGoesNowhereElse) {
  const auto refused_with = [](auto&& change) {
    TransmitterOptions options = preview();
    change(options);
    return complaint(options);
  };
  const auto goes_without = [](const std::string& text, const std::string& name) {
    return text.find("goes without " + name + " ") != std::string::npos;
  };
  using Options = TransmitterOptions;
  EXPECT_TRUE(goes_without(
      refused_with([](Options& o) { o.push.addresses = {"aucasts://campus/talk"}; }), "--push"));
  EXPECT_TRUE(goes_without(refused_with([](Options& o) { o.engine.publish = "nats://hub/talk"; }),
                           "--publish"));
  EXPECT_TRUE(goes_without(refused_with([](Options& o) {
                             o.web.address = HttpAddress{"0.0.0.0", 8080};
                           }),
                           "--web"));
  EXPECT_TRUE(goes_without(refused_with([](Options& o) { o.credentials.publishers = "p"; }),
                           "--accept-push"));
  EXPECT_TRUE(goes_without(refused_with([](Options& o) { o.record = "r"; }), "--record"));
  const auto for_guests = [](Options& o) {
    o.credentials.token = "t";
    o.credentials.tls.certificate = "c";
  };
  EXPECT_EQ(refused_with(for_guests), "");
}

TEST(SourceChecks, ARecordingIsOfWhatIsBeingWritten) {
  TransmitterOptions options;
  options.record = "kept.txt";
  options.sources = {"talk.txt"};
  EXPECT_NE(complaint(options).find("no SOURCE is"), std::string::npos);
  options.sources = {"talk.txt", "-"};
  EXPECT_EQ(complaint(options), "");
  options.sources = {"talk.txt"};
  options.check = true;
  EXPECT_EQ(complaint(options), "") << "nothing is served";
}

TEST(SourceChecks, AVoiceIsOfTheSameKindAsItsFace) {
  TransmitterOptions options;
  options.voice.file = "-";
  options.sources = {"-"};
  EXPECT_NE(complaint(options).find("would both read stdin"), std::string::npos);
  options.sources = {"talk.txt"};
  EXPECT_NE(complaint(options).find("so must be the face"), std::string::npos);
  options.voice.file = "talk.wav";
  EXPECT_EQ(complaint(options), "");
  options.sources = {"camera"};
  EXPECT_NE(complaint(options).find("beside a live SOURCE"), std::string::npos);
  options.voice.none = true;
  EXPECT_EQ(complaint(options), "");
}

}  // namespace
}  // namespace aucast::server
