#pragma once

#include <string>
#include <variant>
#include <vector>

namespace aucast::gui {

/// What is heard, and where.
struct SoundView {
  bool there = false;   ///< there is a sound device
  bool missed = false;  ///< sound is wanted, but there is no device
  int volume = 100;     ///< percent
  bool muted = false;
  int peak_percent = 0;  ///< level of the sound before volume and mute; 100: the maximum, 0: 48 dB
                         ///< below the maximum
  std::string device;    ///< the chosen one; empty: the default one
  std::vector<std::string> devices;  ///< those to choose from
  friend bool operator==(const SoundView&, const SoundView&) = default;
};

/// Title and captions.
struct SpokenView {
  std::string title;    ///< of the stream; empty: it has none
  std::string caption;  ///< to be shown now, UTF-8; empty: none
  bool shown = true;    ///< whether captions are shown over the face
  friend bool operator==(const SpokenView&, const SpokenView&) = default;
};

// The commands about sound and captions.

struct SetVolume {
  int percent = 100;
};
struct ToggleMute {};
/// Looks up which sound devices there are.
struct ListDevices {};
/// Chooses the sound device; empty: the default one.
struct ChooseDevice {
  std::string name;
};
struct ToggleCaptions {};
using SoundCommand = std::variant<SetVolume, ToggleMute, ListDevices, ChooseDevice, ToggleCaptions>;

}  // namespace aucast::gui
