#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <vector>

#include "client/playback/keyframe_source.h"

namespace aucast::playback {

/// A stream that is there whole. Of each keyframe it keeps what a file tells, the AUs and the time,
/// and only the AUs that are not 0: 16 bytes and 8 for each AU, where an AuFrame alone takes 800.
/// A keyframe is made anew whenever it is asked for, with the same intensities bit for bit.
class KeyframeList {
 public:
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Keyframe;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = Keyframe;

    Iterator(const KeyframeList& list, std::size_t index) : list_(&list), index_(index) {}
    [[nodiscard]] Keyframe operator*() const { return (*list_)[index_]; }
    Iterator& operator++() {
      ++index_;
      return *this;
    }
    Iterator operator++(int) { return {*list_, index_++}; }
    friend bool operator==(const Iterator&, const Iterator&) = default;

   private:
    const KeyframeList* list_;
    std::size_t index_;
  };

  KeyframeList() = default;
  KeyframeList(std::initializer_list<Keyframe> keyframes);
  /// Not explicit: the same stream in another form.
  KeyframeList(const std::vector<Keyframe>& keyframes);

  /// Makes room for so many keyframes.
  void reserve(std::size_t keyframes) { ends_.reserve(keyframes); }
  void push_back(const Keyframe& keyframe) { add(keyframe.aus, keyframe.time); }
  void add(const AuFrame& aus, std::optional<Milliseconds> time);

  [[nodiscard]] std::size_t size() const { return ends_.size(); }
  [[nodiscard]] bool empty() const { return ends_.empty(); }
  [[nodiscard]] Keyframe operator[](std::size_t index) const;
  /// There must be one.
  [[nodiscard]] Keyframe front() const { return (*this)[0]; }
  [[nodiscard]] AuFrame aus(std::size_t index) const;
  [[nodiscard]] std::optional<Milliseconds> time(std::size_t index) const;
  [[nodiscard]] Iterator begin() const { return {*this, 0}; }
  [[nodiscard]] Iterator end() const { return {*this, size()}; }

 private:
  /// An AU that is not 0 on one side, or equal on both.
  struct Au {
    std::uint8_t number;
    Side side;
    float intensity;
  };
  struct End {
    std::uint64_t aus;     ///< how many of aus_ there are up to the end of this keyframe
    std::int64_t time_ms;  ///< kUntimed: it has no time
  };
  static constexpr std::int64_t kUntimed = -1;

  std::vector<Au> aus_;
  std::vector<End> ends_;
};

}  // namespace aucast::playback
