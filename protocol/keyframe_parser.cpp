#include "protocol/keyframe_parser.h"

#include "protocol/limits.h"

namespace aucast::protocol {
namespace {

/// The bounds of a number by its place: no number is read past its digits, so none can overflow.
struct NumberBounds {
  std::uint64_t max = 0;
  int digits_max = 0;
  const char* rule = "";
};

constexpr NumberBounds kAuBounds{kAuNumberMax, 2, "an AU number is 0-99, of one or two digits"};
constexpr NumberBounds kPercentBounds{100, 3, "an intensity is 0-100 percent"};
constexpr NumberBounds kTimeBounds{kKeyframeTimeMsMax, 7,
                                   "the time of a keyframe is 0-3600000 ms (an hour)"};
constexpr NumberBounds kPlaceBounds{kPlaceMsMax, kNumberDigitsMax,
                                    "a place in the stream is 0-1000000000000 ms"};

}  // namespace

std::optional<ByteFault> KeyframeParser::accept(char byte) {
  if (is_digit(byte)) return add_digit(byte);
  if (digits_ > 0) end_number();
  if (is_blank_here(byte) || take_mark(byte)) return std::nullopt;
  return unexpected(expected(byte), byte);
}

std::optional<ByteFault> KeyframeParser::finish(char end) {
  if (digits_ > 0) end_number();
  switch (state_) {
    case State::TermOrTiming:
    case State::AfterAu:
    case State::AfterIntensity:
    case State::AfterTime:
    case State::AfterPlace:
      return std::nullopt;
    default:
      break;
  }
  if (end != 0) return unexpected(expected(end), end);
  return ByteFault{DecodeFault::IllegalByte, "expected " + expected(end) + ", found the end"};
}

std::optional<ByteFault> KeyframeParser::add_digit(char byte) {
  const NumberBounds* bounds = nullptr;
  switch (state_) {
    case State::Begin:
    case State::TermOrTiming:
    case State::Term:
      state_ = State::AuNumber;
      side_ = Side::Both;
      [[fallthrough]];
    case State::AuNumber:
      bounds = &kAuBounds;
      break;
    case State::Percent:
      bounds = &kPercentBounds;
      break;
    case State::Time:
      bounds = &kTimeBounds;
      break;
    case State::Place:
      bounds = &kPlaceBounds;
      break;
    default:
      return unexpected(expected(byte), byte);
  }
  number_ = digits_ == 0 ? 0 : number_;
  const std::uint64_t number = number_ * 10 + static_cast<std::uint64_t>(byte - '0');
  if (digits_ == bounds->digits_max || number > bounds->max) {
    return ByteFault{DecodeFault::NumberTooBig, bounds->rule};
  }
  number_ = number;
  ++digits_;
  return std::nullopt;
}

void KeyframeParser::end_number() {
  digits_ = 0;
  switch (state_) {
    case State::AuNumber:
      keyframe_.terms.push_back({static_cast<std::uint8_t>(number_), side_, 100});
      state_ = State::AfterAu;
      return;
    case State::Percent:
      keyframe_.terms.back().percent = static_cast<std::uint8_t>(number_);
      state_ = State::AfterIntensity;
      return;
    case State::Time:
      keyframe_.time_ms = static_cast<std::uint32_t>(number_);
      state_ = State::AfterTime;
      return;
    case State::Place:
      keyframe_.place_ms = number_;
      state_ = State::AfterPlace;
      return;
    default:
      return;
  }
}

bool KeyframeParser::take_mark(char byte) {
  switch (state_) {
    case State::Begin:
      if (byte != '~') return begin_term(byte);
      keyframe_.changes_only = true;
      state_ = State::TermOrTiming;
      return true;
    case State::TermOrTiming:
      if (byte != ';') return begin_term(byte);
      state_ = State::Time;
      return true;
    case State::Term:
      return begin_term(byte);
    case State::AfterAu:
      if (byte == ':') {
        state_ = State::Percent;
        return true;
      }
      if (const auto percent = percent_of_letter(byte)) {
        keyframe_.terms.back().percent = *percent;
        state_ = State::AfterIntensity;
        return true;
      }
      return join_term(byte);
    case State::AfterIntensity:
      return join_term(byte);
    case State::AfterTime:
      if (byte != '@') return false;
      state_ = State::Place;
      return true;
    default:
      return false;
  }
}

bool KeyframeParser::begin_term(char byte) {
  if (byte != 'L' && byte != 'R') return false;
  side_ = byte == 'L' ? Side::Left : Side::Right;
  state_ = State::AuNumber;
  return true;
}

bool KeyframeParser::join_term(char byte) {
  if (byte == ',' || (byte == '+' && syntax_ == TermSyntax::Text)) {
    state_ = State::Term;
    return true;
  }
  if (byte != ';') return false;
  state_ = State::Time;
  return true;
}

bool KeyframeParser::is_blank_here(char byte) const {
  return is_blank(byte) || (byte == '\t' && syntax_ == TermSyntax::Text);
}

std::string KeyframeParser::expected(char byte) const {
  const std::string separator = syntax_ == TermSyntax::Text ? "',', '+', ';'" : "',', ';'";
  switch (state_) {
    case State::Begin:
    case State::Term:
      return "an AU number, L or R";
    case State::TermOrTiming:
      return "an AU number, L, R or ';'";
    case State::AuNumber:
      return "an AU number";
    case State::AfterAu:
      return "':', a letter of A-E x y z, " + separator + " or the end";
    case State::Percent:
      return percent_of_letter(byte) ? "a percent (a letter stands without ':', as in 12C)"
                                     : "a percent";
    case State::AfterIntensity:
      return separator + " or the end";
    case State::Time:
      return "a time in milliseconds";
    case State::AfterTime:
      return "'@' or the end";
    case State::Place:
      return "a place in milliseconds";
    case State::AfterPlace:
      return "the end";
  }
  return "nothing";
}

}  // namespace aucast::protocol
