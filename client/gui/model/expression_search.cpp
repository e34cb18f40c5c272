#include "client/gui/model/expression_search.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include <vector>

#include "client/gui/texts/texts.h"
#include "common/action_unit.h"
#include "common/text.h"

namespace aucast::gui {
namespace {

/// The numbers of a set of AUs such as "1,L12:80"; none of "0".
std::vector<int> numbers_of(const std::string& aus) {
  std::vector<int> numbers;
  for (const std::string_view term : split(aus, ',')) {
    const std::size_t digits = std::min(term.find_first_of("0123456789"), term.size());
    int number = 0;
    std::from_chars(term.data() + digits, term.data() + term.size(), number);
    if (number > 0) numbers.push_back(number);
  }
  return numbers;
}

/// Whether the words are in the FACS name of an AU of this set, or another name of one.
bool names_au(const std::string& aus, const std::string& words) {
  const auto named = facs_number(words);
  const std::vector<int> numbers = numbers_of(aus);
  return std::any_of(numbers.begin(), numbers.end(), [&](int number) {
    const auto name = facs_name(number);
    return named == number || (name && lowered(*name).find(words) != std::string::npos);
  });
}

}  // namespace

std::string in_words(const ExpressionButton& button) {
  const std::string& aus = button.kind == ExpressionKind::Macro ? std::string() : button.aus;
  if (button.source.empty() || aus.empty()) return aus + button.source;
  return aus + "\n" + button.source;
}

bool is_meant(const ExpressionButton& button, const std::string& words) {
  std::string numbers = words;
  std::replace(numbers.begin(), numbers.end(), ' ', ',');
  const std::string text = lowered(button.label + "\n" + data_word(button.label) + "\n" +
                                   button.name + "\n" + in_words(button));
  return text.find(words) != std::string::npos || text.find(numbers) != std::string::npos ||
         names_au(button.aus, words);
}

}  // namespace aucast::gui
