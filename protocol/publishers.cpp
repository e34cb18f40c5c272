#include "protocol/publishers.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "common/files.h"
#include "common/text.h"
#include "protocol/codec.h"
#include "protocol/limits.h"
#include "protocol/secret.h"
#include "protocol/stream_file.h"
#include "protocol/word_packet.h"

namespace aucast::protocol {
namespace {

/// What is wrong with the words of a line, if anything.
std::optional<std::string> fault_of(const std::vector<std::string_view>& words) {
  if (words.front().size() > kTokenBytesMax) {
    return "the token is longer than " + std::to_string(kTokenBytesMax) + " bytes";
  }
  if (!is_field_value(words.front())) return "a token is printable ASCII without braces";
  if (words.front() == kBeginTag) return "this is a stream file, and no list of publishers";
  for (auto name = words.begin() + 1; name != words.end(); ++name) {
    if (!is_stream_name(*name)) {
      return "'" + escaped(*name) + "' is no stream's name: " + kStreamNameRule;
    }
  }
  return std::nullopt;
}

}  // namespace

Publishers::Verdict Publishers::verdict(std::string_view token, std::string_view name) const {
  Verdict verdict = Verdict::Unknown;
  for (const Publisher& publisher : all_) {
    if (!same_secret(token, publisher.token)) continue;
    const auto& names = publisher.names;
    const bool may = names.empty() || std::find(names.begin(), names.end(), name) != names.end();
    verdict = may ? Verdict::Welcome : Verdict::OtherNames;
  }
  return verdict;
}

Result<PublisherFile> read_publisher_file(const std::filesystem::path& path) {
  const auto file = read_secret_file(path, kPublisherFileBytesMax);
  if (!file) return file.error();
  std::vector<Publishers::Publisher> all;
  std::size_t number = 0;
  for (const std::string_view line : split(file->bytes, '\n')) {
    ++number;
    const auto wrong = [&path, number](const std::string& what) {
      return Error{ErrorKind::BadData, at_place(path.string(), number, 0, what)};
    };
    const auto words = split_words(line);
    if (words.empty() || words.front().starts_with('#')) continue;
    if (const auto fault = fault_of(words)) return wrong(*fault);
    const bool twice = std::any_of(all.begin(), all.end(), [&words](const auto& other) {
      return other.token == words.front();
    });
    if (twice) return wrong("this token stands on a line before");
    all.push_back({std::string(words.front()), {words.begin() + 1, words.end()}});
  }
  if (all.empty()) {
    return Error{ErrorKind::BadData, at_place(path.string(), "there is no token in it")};
  }
  PublisherFile publishers{Publishers(std::move(all)), {}};
  if (file->open_to_others) {
    publishers.warning =
        at_place(path.string(), "other users have access to the tokens (chmod 600)");
  }
  return publishers;
}

}  // namespace aucast::protocol
