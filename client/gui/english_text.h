#pragma once

namespace aucast::gui {

/// A text of the window and the key by which tr() and the files of data/languages know it.
struct EnglishText {
  const char* key;
  const char* text;
};

}  // namespace aucast::gui
