#include "client/app/stream_table.h"

#include <algorithm>
#include <cstddef>

#include "client/gui/model/view_text.h"
#include "common/text.h"

namespace aucast::app {

std::string stream_names(const protocol::StreamList& list) {
  std::string text;
  for (const protocol::ListedStream& stream : list.streams) text += stream.name + "\n";
  return text;
}

std::string stream_table(const protocol::StreamList& list) {
  constexpr std::size_t kApart = 2;
  std::size_t words_at = 0;
  std::size_t title_at = 0;
  for (const protocol::ListedStream& stream : list.streams) {
    words_at = std::max(words_at, stream.name.size() + kApart);
    title_at = std::max(title_at, gui::stream_in_words(stream).size() + kApart);
  }
  title_at += words_at;
  std::string text;
  for (const protocol::ListedStream& stream : list.streams) {
    std::string line = stream.name;
    line.resize(words_at, ' ');
    line += gui::stream_in_words(stream);
    line.resize(title_at, ' ');
    line += printable(stream.title);
    text.append(line, 0, line.find_last_not_of(' ') + 1).append("\n");
  }
  return text;
}

}  // namespace aucast::app
