// Any text as a file of expressions: an error with the file's name, or named sets whose intensities
// and activations are in their ranges.

#include <set>

#include "common/check.h"
#include "common/expressions/expressions.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_input.h"

using namespace aucast;

namespace {

void check_expression(const Expression& expression) {
  AUCAST_CHECK(!expression.name.empty() && !expression.label.empty());
  for (const AuTerm& term : canonical_terms(expression.aus)) AUCAST_CHECK(term.percent <= 100);
  for (const ExpressionMuscle& muscle : expression.muscles) {
    AUCAST_CHECK(muscle.left >= 0 && muscle.right >= 0);
  }
  if (!expression.pad) return;
  for (const float place : *expression.pad) AUCAST_CHECK(place >= -1 && place <= 1);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Folder kFolder("_expressions");
  const auto file = kFolder.path() / "expressions.toml";
  kFolder.write("expressions.toml", fuzz::text_of(data, size));
  const auto expressions = load_expressions(file);
  if (!expressions) {
    AUCAST_CHECK(expressions.error().message.find("expressions.toml") != std::string::npos);
    return 0;
  }
  std::set<std::string> names;
  for (const Expression& expression : *expressions) {
    AUCAST_CHECK(names.insert(expression.name).second);
    check_expression(expression);
  }
  return 0;
}
