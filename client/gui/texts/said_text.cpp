#include "client/gui/texts/said_text.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "client/gui/texts/texts.h"

namespace aucast::gui {
namespace {

using Values = std::vector<std::string>;

/// What `text` has at the places of a pattern, each as short as possible; nullopt if the text does
/// not match the pattern. Between two places of a pattern there is always some text.
std::optional<Values> places_in(std::string_view text, std::string_view pattern) {
  Values values;
  while (!pattern.empty()) {
    const std::size_t open = pattern.find('{');
    const std::string_view before = pattern.substr(0, open);
    if (!text.starts_with(before)) return std::nullopt;
    text.remove_prefix(before.size());
    if (open == std::string_view::npos) break;
    pattern.remove_prefix(pattern.find('}', open) + 1);
    const std::string_view behind = pattern.substr(0, pattern.find('{'));
    // The last part ends the text, so that "; " within a reason does not end the pattern.
    const bool last = behind.size() == pattern.size();
    if (last && !text.ends_with(behind)) return std::nullopt;
    const std::size_t end = last ? text.size() - behind.size() : text.find(behind);
    if (end == std::string_view::npos || end == 0 || end > text.size()) return std::nullopt;
    values.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  if (!text.empty()) return std::nullopt;
  return values;
}

bool is_said(std::string_view key) {
  return key.starts_with("net.") || key.starts_with("made.") || key.starts_with("bad.");
}

/// Words that name an option of face-player, for which the window has a field, as a pattern, and
/// what the window says in place of them. scripts/tidy.py checks that they are said so.
struct InWindow {
  std::string_view said;
  TextKey text;
};
constexpr std::array<InWindow, 4> kInWindow = {
    {{"{code} a token is needed here (--token-file)", "play.needs_token"},
     {"{code} this server speaks TLS only (face-player --tls)", "play.tls_only"},
     {"the server does not speak TLS; leave out --tls (of aucasts:// the s), or serve with "
      "--tls-cert",
      "play.no_tls"},
     {"the server's certificate comes from an authority that is not known here; {option} FILE "
      "names one to believe",
      "play.unknown_authority"}}};

std::optional<std::string> translated(std::string_view english);

/// Translates what can be translated; returns whether any of it can.
bool translate(Values& values) {
  bool any = false;
  for (std::string& value : values) {
    auto better = translated(value);
    any |= better.has_value();
    if (better) value = *std::move(better);
  }
  return any;
}

std::optional<std::string> translated(std::string_view english) {
  for (const InWindow& one : kInWindow) {
    auto values = places_in(english, one.said);
    if (!values) continue;
    translate(*values);
    return filled(one.text.row(), *values);
  }
  for (std::size_t row = 0; row < kEnglish.size(); ++row) {
    if (!is_said(kEnglish[row].key)) continue;
    auto values = places_in(english, kEnglish[row].text);
    if (!values) continue;
    const bool any = translate(*values);
    // Of "host: words" nothing is known but the colon.
    if (std::string_view(kEnglish[row].key) == "net.at" && !any) continue;
    return filled(row, *values);
  }
  return std::nullopt;
}

}  // namespace

std::string in_used_language(const std::string& english) {
  return translated(english).value_or(english);
}

std::vector<std::string> places_said(TextKey row, const std::string& english) {
  return places_in(english, kEnglish[row.row()].text).value_or(Values());
}

std::string error_in_used_language(const Error& error) {
  const auto known = translated(error.message);
  if (known || !other_language()) return known.value_or(error.message);
  switch (error.kind) {
    case ErrorKind::BadData:
      return std::string(tr("said.bad_data")) + "\n" + error.message;
    case ErrorKind::Unreadable:
      return std::string(tr("said.unreadable")) + "\n" + error.message;
    case ErrorKind::Failed:
    case ErrorKind::Usage:
    case ErrorKind::Network:
      break;
  }
  return error.message;
}

}  // namespace aucast::gui
