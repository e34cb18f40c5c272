#include <array>
#include <optional>
#include <string>
#include <vector>

#include "common/sources/au_columns.h"
#include "common/sources/clock_text.h"
#include "common/sources/format.h"
#include "common/text.h"

namespace aucast::sources {
namespace {

enum class TimeUnit : std::uint8_t { Milliseconds, Clock };
enum class Kind : std::uint8_t { Intensities, Evidence };

/// A table that is no more than columns.
struct Layout {
  std::string_view name;
  std::string_view note;
  double scale;
  std::string_view prefix;  ///< before an AU's number; empty: AFFDEX's words
  std::string_view suffix;
  Kind kind;
  std::string_view presence_prefix;  ///< empty: no presences
  std::string_view time;
  TimeUnit unit;
  std::string_view frame;
  std::string_view confidence;
  std::string_view faces;  ///< how many are seen
};

constexpr std::array<Layout, 4> kLayouts{{
    // Its head pose is left out: which way its signs go is not documented, and a wrong turn is
    // worse
    // than none.
    {"LibreFace", "", 5, "au_", "_intensity", Kind::Intensities, "au_", "frame_time_in_ms",
     TimeUnit::Milliseconds, "frame_idx", "face_detection_score", ""},
    // The same holds for its head orientation.
    {"FaceReader", "", 1, "Action Unit ", AuColumns::kAnySuffix, Kind::Intensities, "",
     "Video Time", TimeUnit::Clock, "", "", ""},
    {"iMotions (FACET)", "evidence read as intensity, approximate", 1, "AU", " Evidence",
     Kind::Evidence, "", "Timestamp", TimeUnit::Milliseconds, "FrameNo", "", "NoOfFaces"},
    // And for AFFDEX's head.
    {"iMotions (AFFDEX)", "likelihoods read as intensities, approximate", 100, "", "",
     Kind::Intensities, "", "Timestamp", TimeUnit::Milliseconds, "FrameNo", "", "NoOfFaces"},
}};

/// The AU that AFFDEX means, by the column's name in small letters without blanks. Smirk is left
/// out: it says that the sides differ, but not which is the stronger one.
std::uint8_t affdex_au(std::string_view column) {
  struct Word {
    std::string_view name;
    std::uint8_t number;
  };
  constexpr std::array<Word, 19> kWords{{{"innerbrowraise", 1},
                                         {"browraise", 2},
                                         {"browfurrow", 4},
                                         {"eyewiden", 5},
                                         {"cheekraise", 6},
                                         {"lidtighten", 7},
                                         {"nosewrinkle", 9},
                                         {"upperlipraise", 10},
                                         {"smile", 12},
                                         {"dimpler", 14},
                                         {"lipcornerdepressor", 15},
                                         {"chinraise", 17},
                                         {"lippucker", 18},
                                         {"lipstretch", 20},
                                         {"lippress", 24},
                                         {"mouthopen", 25},
                                         {"jawdrop", 26},
                                         {"lipsuck", 28},
                                         {"eyeclosure", 43}}};
  std::string letters = lowered(column);
  std::erase(letters, ' ');
  for (const Word& word : kWords) {
    if (word.name == letters) return word.number;
  }
  return 0;
}

AuColumns affdex_columns(const CsvReader& table) {
  AuColumns columns;
  for (std::size_t index = 0; index < table.columns().size(); ++index) {
    const std::uint8_t number = affdex_au(table.columns()[index]);
    if (number != 0) columns.add(number, Side::Both, index);
  }
  // A single such word may be anybody's.
  return columns.size() >= 5 ? columns : AuColumns();
}

std::optional<std::size_t> named(const CsvReader& table, std::string_view name) {
  return name.empty() ? std::nullopt : table.column(name);
}

class PlainTable final : public Format {
 public:
  PlainTable(const CsvReader& table, const Layout& layout)
      : layout_(layout),
        aus_(layout.prefix.empty() ? affdex_columns(table)
                                   : AuColumns(table, layout.prefix, layout.suffix)),
        time_(named(table, layout.time)),
        frame_(named(table, layout.frame)),
        confidence_(named(table, layout.confidence)),
        faces_(named(table, layout.faces)) {
    if (!layout.presence_prefix.empty()) {
      presences_ = AuColumns(table, layout.presence_prefix, "");
      presences_.remove(aus_);
    }
    if (layout.kind != Kind::Evidence) return;
    head_ = {table.column("Pitch Degrees"), table.column("Yaw Degrees"),
             table.column("Roll Degrees")};
  }

  [[nodiscard]] bool fits() const { return !aus_.empty(); }
  [[nodiscard]] std::string_view name() const override { return layout_.name; }
  [[nodiscard]] double native_scale() const override { return layout_.scale; }
  [[nodiscard]] std::string note() const override { return std::string(layout_.note); }

  void scan(CsvReader& row) override {
    const std::string_view time = row.text(time_);
    if (layout_.unit == TimeUnit::Clock && !time.empty() && !parse_clock(time)) {
      row.refuse(time_, "expected a time HH:MM:SS.fff, such as 00:01:20.040");
    }
  }

  void read(CsvReader& row, Observation& out) const override {
    out.seconds = seconds(row);
    out.frame = row.number(frame_);
    out.confidence = row.number(confidence_).value_or(1);
    out.tracked = row.number(faces_).value_or(1) > 0;
    if (layout_.kind == Kind::Evidence) {
      aus_.read_evidence(row, out);
    } else {
      aus_.read(row, out);
    }
    if (!out.aus.empty()) presences_.read_presence(row, out);
    const auto pitch = row.number(head_[0]);
    const auto yaw = row.number(head_[1]);
    const auto roll = row.number(head_[2]);
    // FACET: positive down, to the subject's left, and to the right shoulder, against landmarks.
    if (pitch && yaw && roll) {
      out.add_head({*yaw * kRadPerDegree, -*pitch * kRadPerDegree, -*roll * kRadPerDegree});
    }
  }

 private:
  [[nodiscard]] std::optional<double> seconds(CsvReader& row) const {
    if (layout_.unit == TimeUnit::Clock) return parse_clock(row.text(time_));
    const auto milliseconds = row.number(time_);
    if (!milliseconds) return std::nullopt;
    return *milliseconds / 1000;
  }

  const Layout& layout_;
  AuColumns aus_;
  AuColumns presences_;
  std::optional<std::size_t> time_, frame_, confidence_, faces_;
  std::array<std::optional<std::size_t>, 3> head_;
};

}  // namespace

std::unique_ptr<Format> open_plain(const CsvReader& table) {
  for (const Layout& layout : kLayouts) {
    auto format = std::make_unique<PlainTable>(table, layout);
    if (format->fits()) return format;
  }
  return nullptr;
}

}  // namespace aucast::sources
