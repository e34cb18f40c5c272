#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/support/process.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {

/// A finished run of the real face-player, with what it wrote to --stats; null if it wrote nothing.
struct PlayerRun {
  Finished finished;
  nlohmann::json stats;
};

/// Runs face-player with `arguments` and --stats.
[[nodiscard]] inline PlayerRun run_player(std::vector<std::string> arguments,
                                          std::vector<std::string> variables = {}) {
  const TempFolder folder;
  arguments.insert(arguments.begin(), program("face-player"));
  const bool counts = arguments.size() > 1 && arguments[1] != "pose" && arguments[1] != "rules" &&
                      arguments[1] != "gallery" && arguments[1] != "export";
  if (counts) {
    arguments.insert(arguments.end(), {"--stats", (folder.path() / "stats.json").string()});
  }
  PlayerRun run;
  run.finished = test::run(std::move(arguments), std::move(variables));
  const std::string text = folder.read("stats.json");
  if (!text.empty()) run.stats = nlohmann::json::parse(text);
  return run;
}

}  // namespace aucast::test
