// Any text as a rules file: an error with the file's name, or rules that leave every intensity
// between 0 and 1.

#include "client/face/au_blender.h"
#include "common/check.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_input.h"

using namespace aucast;
using namespace aucast::face;

namespace {

/// All AUs, each side another intensity.
AuFrame busy_frame() {
  AuFrame frame;
  for (std::size_t number = 1; number < frame.left.size(); ++number) {
    frame.left[number] = static_cast<float>(number) / kAuNumberMax;
    frame.right[number] = 1;
  }
  return frame;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Folder kFolder("_rules");
  kFolder.write("rules.toml", fuzz::text_of(data, size));
  const auto rules = load_rules(kFolder.path() / "rules.toml");
  if (!rules) {
    AUCAST_CHECK(rules.error().message.find("rules.toml") != std::string::npos);
    return 0;
  }
  std::vector<RuleFired> fired;
  const AuFrame blended = blend(*rules, busy_frame(), &fired);
  for (const auto& side : {blended.left, blended.right}) {
    for (const float intensity : side) AUCAST_CHECK(intensity >= 0 && intensity <= 1);
  }
  return 0;
}
