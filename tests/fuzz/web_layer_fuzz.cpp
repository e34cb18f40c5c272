// A hostile WebSocket peer: the first byte says in how large pieces the others come.

#include <cstdint>
#include <string>

#include "common/check.h"
#include "common/web/layer.h"
#include "tests/fuzz/fuzz_input.h"

using aucast::web::Layer;

namespace {

constexpr std::size_t kFrameBytesMax = 300;

struct Heard {
  std::string text;
  std::string answer;
  bool failed = false;
  bool ended = false;
  friend bool operator==(const Heard&, const Heard&) = default;
};

/// Whether our side asks the peer before each piece if it is there.
enum class Asks : std::uint8_t { Once, BeforeEachPiece };

Heard hear(std::string_view wire, std::size_t piece, Asks asks = Asks::Once) {
  Layer layer(kFrameBytesMax);
  Heard heard;
  while (!wire.empty()) {
    if (asks == Asks::BeforeEachPiece) layer.ping();
    const bool good = layer.received(wire.substr(0, piece), heard.text);
    AUCAST_CHECK(good != layer.failed());
    wire.remove_prefix(std::min(piece, wire.size()));
  }
  layer.ping();
  layer.send("{1}");
  heard.answer = layer.take_output();
  heard.failed = layer.failed();
  heard.ended = layer.ended();
  return heard;
}

/// What a server says: whole frames without a mask, and nothing after a Close.
void check_frames(std::string_view wire, bool closes) {
  bool closed = false;
  while (!wire.empty()) {
    AUCAST_CHECK(!closed && wire.size() >= 2);
    const auto first = static_cast<unsigned char>(wire[0]);
    const auto size = static_cast<unsigned char>(wire[1]);
    AUCAST_CHECK(first == 0x81 || first == 0x88 || first == 0x89 || first == 0x8a);
    AUCAST_CHECK(size <= 125 && wire.size() >= 2U + size);
    closed = first == 0x88;
    wire.remove_prefix(2U + size);
  }
  AUCAST_CHECK(closed == closes);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto [wire, piece] = aucast::fuzz::pieced(data, size);
  const Heard whole = hear(wire, std::string_view::npos);
  AUCAST_CHECK(whole == hear(wire, piece));
  AUCAST_CHECK(whole.text.size() <= wire.size());
  for (const char c : whole.text) AUCAST_CHECK(static_cast<unsigned char>(c) < 0x80);
  check_frames(whole.answer, whole.failed || whole.ended);
  const Heard asked = hear(wire, piece, Asks::BeforeEachPiece);
  AUCAST_CHECK(asked.text == whole.text);
  AUCAST_CHECK(asked.failed == whole.failed && asked.ended == whole.ended);
  check_frames(asked.answer, asked.failed || asked.ended);
  return 0;
}
