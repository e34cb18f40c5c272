#include "client/gui/storage/toml_edit.h"

#include <algorithm>

#include "common/text.h"
#include "common/toml_writer.h"

namespace aucast::gui {
namespace {

/// Where a text ends, behind its quotes; `at` is that of the first quote.
std::size_t end_of_text(std::string_view toml, std::size_t at) {
  const char quote = toml[at];
  const bool three = toml.substr(at).starts_with(std::string(3, quote));
  const std::string closing(three ? 3 : 1, quote);
  std::size_t end = at + closing.size();
  while (end < toml.size() && !toml.substr(end).starts_with(closing)) {
    end += quote == '"' && toml[end] == '\\' ? 2U : 1U;
  }
  end += closing.size();
  // The text itself may end with quotes.
  while (three && end < toml.size() && toml[end] == quote) ++end;
  return std::min(end, toml.size());
}

}  // namespace

/// Columns count characters: in UTF-8, all bytes but continuation bytes.
std::optional<std::size_t> byte_at(std::string_view toml, LinePosition place) {
  std::size_t at = 0;
  for (std::size_t line = 1; line < place.line; ++line) {
    at = toml.find('\n', at);
    if (at == std::string_view::npos) return std::nullopt;
    ++at;
  }
  for (std::size_t column = 1; column < place.column && at < toml.size(); ++column) {
    ++at;
    while (at < toml.size() && is_continuation(toml[at])) ++at;
  }
  return at;
}

Result<void> put_text(std::string& toml, std::string_view file, const TomlValue& old,
                      const std::string& text) {
  const auto at = byte_at(toml, old.place);
  if (old.kind != TomlValue::Kind::Text || !at || *at >= toml.size()) {
    return Error{ErrorKind::BadData,
                 at_place(file, old.place.line, old.place.column, "this is not a text in quotes")};
  }
  toml.replace(*at, end_of_text(toml, *at) - *at, toml_text(text));
  return {};
}

}  // namespace aucast::gui
