#include "protocol/stream_file.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "common/error_list.h"
#include "common/text.h"
#include "common/text_file.h"
#include "protocol/caption.h"
#include "protocol/codec.h"
#include "protocol/limits.h"

namespace aucast::protocol {
namespace {

constexpr std::string_view kBlanks = " \t";

/// A byte that no text file has: a control character other than a tab.
bool is_control(char byte) {
  const auto code = static_cast<unsigned char>(byte);
  return (code < 0x20 && byte != '\t') || code == 0x7f;
}

/// A line without its comment and the blanks around it.
std::string_view content_of(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  return trimmed(line.substr(0, line.find('#')), kBlanks);
}

/// The remark about the tag that a refused line was probably meant to be.
std::string mistyped_tag(std::string_view content) {
  if (content.size() > kBeginTag.size() + 3) return {};
  return did_you_mean(content, {std::string(kBeginTag), std::string(kEndTag)});
}

class StreamFileParser {
 public:
  StreamFileParser(std::string_view text, std::string_view file, const KeyframeSink& sink)
      : text_(text), errors_(file), sink_(sink) {}

  Result<void> parse();

 private:
  enum class Part : std::uint8_t { Before, Inside, After };

  void read_line(std::string_view line);
  void read_tag(std::string_view content, std::size_t shift);
  void read_packet(std::string_view content, std::size_t shift);
  void read_outside(std::string_view content, std::size_t shift);
  void finish();
  /// `position`: of the byte in the line, from 0.
  void refuse(std::size_t position, const std::string& reason);
  void refuse_byte(std::size_t position, char byte);
  /// A line that cannot be read: it may have been a packet or a tag.
  void refuse_line(std::size_t position, const std::string& reason);

  std::string_view text_;
  ErrorList errors_;
  const KeyframeSink& sink_;
  std::optional<Error> refused_;  ///< by the sink
  Part part_ = Part::Before;
  std::size_t line_number_ = 0;
  std::size_t begin_line_ = 0;
  bool packet_seen_ = false;   ///< a packet, right or wrong, has come between the tags
  bool outside_said_ = false;  ///< the error about this region outside the tags was added
  std::uint64_t last_place_ms_ = 0;
};

Result<void> StreamFileParser::parse() {
  std::string_view rest = text_;
  if (rest.starts_with(kByteOrderMark)) rest.remove_prefix(kByteOrderMark.size());
  if (const std::size_t zero = rest.find('\0'); zero != std::string_view::npos) {
    // A picture or a sound: it has one mistake and not one a line.
    const std::string_view before = rest.substr(0, zero);
    line_number_ = 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    refuse_byte(before.size() - (before.rfind('\n') + 1), '\0');
    return errors_.error();
  }
  while (!rest.empty() && !refused_) {
    ++line_number_;
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    read_line(line);
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  if (refused_) return *refused_;
  finish();
  if (!errors_.empty()) return errors_.error();
  return {};
}

void StreamFileParser::read_line(std::string_view line) {
  if (line.size() > kStreamLineBytesMax) {
    refuse_line(kStreamLineBytesMax, "the line is longer than " +
                                         std::to_string(kStreamLineBytesMax) +
                                         " bytes; write one packet per line");
    return;
  }
  const auto control = std::find_if(line.begin(), line.end(), is_control);
  if (control != line.end()) {
    refuse_byte(static_cast<std::size_t>(control - line.begin()), *control);
    return;
  }
  const std::string_view content = content_of(line);
  if (content.empty()) return;
  const auto shift = static_cast<std::size_t>(content.data() - line.data());
  if (content == kBeginTag || content == kEndTag) {
    read_tag(content, shift);
  } else if (part_ == Part::Inside) {
    read_packet(content, shift);
  } else {
    read_outside(content, shift);
  }
}

void StreamFileParser::read_tag(std::string_view content, std::size_t shift) {
  const bool begins = content == kBeginTag;
  if (part_ == Part::After) {
    refuse(shift, "found " + std::string(content) + " after End_Stream; a file holds one stream");
  } else if (begins && part_ == Part::Before) {
    part_ = Part::Inside;
    begin_line_ = line_number_;
    packet_seen_ = false;
  } else if (begins) {
    refuse(shift, "a second Beg_Stream; the stream began on line " + std::to_string(begin_line_));
  } else {
    if (part_ == Part::Before && !outside_said_) {
      refuse(shift, "End_Stream without a Beg_Stream before it");
    } else if (part_ == Part::Inside && !packet_seen_) {
      refuse(shift,
             "the stream is empty; write at least one packet between the tags, such as 1,6,12");
    }
    part_ = Part::After;
    outside_said_ = false;
  }
}

void StreamFileParser::read_packet(std::string_view content, std::size_t shift) {
  packet_seen_ = true;
  Keyframe keyframe;
  if (const auto error = parse_stream_line(content, keyframe)) {
    refuse(shift + error->position, error->reason + mistyped_tag(content));
    return;
  }
  if (keyframe.place_ms && *keyframe.place_ms < last_place_ms_) {
    refuse(shift + content.find('@'), "the place goes backwards, to " +
                                          std::to_string(*keyframe.place_ms) + " ms after " +
                                          std::to_string(last_place_ms_) + " ms");
    return;
  }
  last_place_ms_ = keyframe.place_ms.value_or(last_place_ms_);
  if (auto taken = sink_(std::move(keyframe)); !taken) refused_ = taken.error();
}

/// Adds one error per region: a file without its tag is one mistake, not one per line.
void StreamFileParser::read_outside(std::string_view content, std::size_t shift) {
  if (std::exchange(outside_said_, true)) return;
  if (part_ == Part::Before) {
    refuse(shift, "expected Beg_Stream on a line of its own before the first packet, found '" +
                      escaped(content) + "'");
  } else {
    refuse(shift, "text after End_Stream: '" + escaped(content) +
                      "'; only blanks and comments may follow");
  }
}

void StreamFileParser::finish() {
  if (part_ == Part::After) return;
  const bool empty = line_number_ == 0;
  line_number_ = std::max<std::size_t>(line_number_, 1);
  if (empty) {
    refuse(0, "the file is empty");
  } else if (part_ == Part::Inside) {
    refuse(0,
           "the file ends without End_Stream; write it on a line of its own after the last packet");
  } else if (!outside_said_) {
    refuse(0, "there is no stream: Beg_Stream, packets and End_Stream are missing");
  }
}

void StreamFileParser::refuse(std::size_t position, const std::string& reason) {
  errors_.add(line_number_, position + 1, reason);
}

void StreamFileParser::refuse_byte(std::size_t position, char byte) {
  refuse_line(position, "this is not text: found the byte '" + escaped(std::string_view(&byte, 1)) +
                            "'; a stream file is ASCII or UTF-8 text");
}

void StreamFileParser::refuse_line(std::size_t position, const std::string& reason) {
  refuse(position, reason);
  packet_seen_ = true;
  outside_said_ = true;
}

}  // namespace

StreamTitle stream_title(std::string_view text) {
  constexpr std::string_view kTitle = "title:";
  constexpr std::string_view kLineBlanks = " \t\r";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end), kLineBlanks);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.starts_with('#')) {
      if (line.empty() || content_of(line) == kBeginTag) continue;
      break;
    }
    const std::string_view comment = trimmed(line.substr(1), kLineBlanks);
    if (lowered(comment.substr(0, kTitle.size())) == kTitle) {
      return {std::string(trimmed(comment.substr(kTitle.size()), kLineBlanks)), number};
    }
  }
  return {};
}

std::string title_complaint(const StreamTitle& title, std::string_view file) {
  const std::string& text = title.text;
  if (is_title(text)) return {};
  const std::string why = text.size() > kTitleBytesMax
                              ? "it has " + std::to_string(text.size()) + " bytes, of at most " +
                                    std::to_string(kTitleBytesMax)
                              : "it is no plain UTF-8 text";
  return at_place(file, title.line, 1, "the title is left out: " + why);
}

Result<StreamFile> parse_stream_file(std::string_view text, std::string_view file,
                                     const StopToken& stop) {
  StreamFile stream;
  stream.title = stream_title(text).text;
  // A keyframe a line: room for all of them at once, where growing takes three times as much.
  stream.keyframes.reserve(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')));
  const auto read = read_stream_file(text, file, [&](Keyframe&& keyframe) -> Result<void> {
    if (stop.stop_requested()) return stopped_early();
    stream.keyframes.push_back(std::move(keyframe));
    return {};
  });
  if (!read) return read.error();
  return stream;
}

Result<void> read_stream_file(std::string_view text, std::string_view file,
                              const KeyframeSink& sink) {
  return StreamFileParser(text, file, sink).parse();
}

std::optional<TextError> parse_stream_line(std::string_view content, Keyframe& out) {
  std::string_view inside = content;
  const std::size_t shift = content.starts_with('{') ? 1 : 0;
  if (shift == 1) {
    const std::size_t close = content.find('}');
    if (close == std::string_view::npos) {
      return TextError{content.size(), "the closing brace is missing"};
    }
    if (close + 1 != content.size()) {
      return TextError{close + 1, "text after the closing brace; write one packet per line"};
    }
    inside = content.substr(1, close - 1);
  }
  Keyframe keyframe;
  if (auto error = parse_keyframe(inside, TermSyntax::Text, keyframe)) {
    error->position += shift;
    return error;
  }
  if (keyframe.changes_only) {
    return TextError{content.find('~'), "a stream file names whole sets; '~' is for the wire only"};
  }
  out = std::move(keyframe);
  return std::nullopt;
}

MendedText mend_stream_text(std::string_view text) {
  MendedText mended;
  bool inside = false;
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    // Half a line may look like a whole one.
    if (end == std::string_view::npos) break;
    const std::string_view content = content_of(text.substr(0, end));
    Keyframe keyframe;
    if (content == kEndTag) break;
    if (inside && !content.empty() && parse_stream_line(content, keyframe)) break;
    inside = inside || content == kBeginTag;
    mended.text += text.substr(0, end + 1);
    text.remove_prefix(end + 1);
  }
  if (content_of(text.substr(0, text.find('\n'))) != kEndTag) {
    const auto ends = std::count(text.begin(), text.end(), '\n');
    mended.lines_left_out =
        static_cast<std::size_t>(ends) + (text.empty() || text.ends_with('\n') ? 0 : 1);
  }
  mended.text += std::string(kEndTag) + '\n';
  return mended;
}

std::string format_stream_line(const Keyframe& keyframe) {
  const std::string packet = encode(keyframe);
  return packet.substr(1, packet.size() - 2);
}

std::string format_stream_file(const StreamFile& stream) {
  std::string text;
  if (!stream.title.empty()) text = "# title: " + stream.title + '\n';
  text += std::string(kBeginTag) + '\n';
  for (const Keyframe& keyframe : stream.keyframes) text += format_stream_line(keyframe) + '\n';
  return text.append(kEndTag) + '\n';
}

std::uint64_t media_ms(const StreamFile& stream, std::uint32_t keyframe_ms) {
  return std::accumulate(stream.keyframes.begin(), stream.keyframes.end(), std::uint64_t{0},
                         [keyframe_ms](std::uint64_t sum, const Keyframe& keyframe) {
                           return sum + keyframe.time_ms.value_or(keyframe_ms);
                         });
}

}  // namespace aucast::protocol
