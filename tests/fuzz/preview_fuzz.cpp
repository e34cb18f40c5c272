// What the mirror's child says: records of its pictures. The first byte says in how large pieces
// the others come. The same bytes are read as orders to the child, too.

#include <algorithm>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "common/check.h"
#include "common/preview/orders.h"
#include "common/preview/preview_reader.h"
#include "common/preview/preview_writer.h"
#include "tests/fuzz/fuzz_input.h"

using aucast::preview::PreviewReader;
using aucast::preview::Record;
using aucast::preview::Seen;

namespace {

/// What has been read, as text and numbers that can be compared.
struct Read {
  std::vector<std::string> records;
  bool broken = false;
  friend bool operator==(const Read&, const Read&) = default;
};

/// A picture that was read is written as it was read.
std::string written(const Seen& seen) {
  std::string bytes = aucast::preview::seen_record(seen);
  PreviewReader reader;
  reader.feed(bytes);
  const auto again = reader.next();
  AUCAST_CHECK(again && *again && std::get<Seen>(**again) == seen);
  return bytes;
}

std::string told(const Record& record) {
  struct Teller {
    std::string operator()(const aucast::preview::Listening& it) { return "on " + it.address; }
    std::string operator()(const Seen& it) { return written(it); }
    std::string operator()(const aucast::preview::Live& it) { return "live " + it.address; }
    std::string operator()(const aucast::preview::Private&) { return "private"; }
    std::string operator()(const aucast::preview::Watching& it) { return std::to_string(it.count); }
    std::string operator()(const aucast::preview::Refused& it) { return "no " + it.sentence; }
  };
  return std::visit(Teller{}, record);
}

Read read(std::string_view bytes, std::size_t piece) {
  PreviewReader reader;
  Read all;
  while (!bytes.empty()) {
    reader.feed(bytes.substr(0, piece));
    bytes.remove_prefix(std::min(piece, bytes.size()));
    for (;;) {
      const auto record = reader.next();
      if (!record) {
        all.broken = true;
        AUCAST_CHECK(!reader.next());
        return all;
      }
      if (!*record) break;
      all.records.push_back(told(**record));
    }
  }
  return all;
}

void read_orders(std::string_view bytes) {
  aucast::fuzz::Script script(bytes);
  while (!script.empty()) {
    const auto order = aucast::preview::parse_order(script.line());
    if (!order) continue;
    const std::string text = aucast::preview::order_text(*order);
    AUCAST_CHECK(text.ends_with('\n'));
    AUCAST_CHECK(aucast::preview::parse_order(text.substr(0, text.size() - 1)) == order);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto [bytes, piece] = aucast::fuzz::pieced(data, size);
  AUCAST_CHECK(read(bytes, std::string_view::npos) == read(bytes, piece));
  read_orders(bytes);
  return 0;
}
