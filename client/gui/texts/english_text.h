#pragma once

namespace aucast::gui {

/// A text of the window, and its key for tr() and the files of data/languages.
struct EnglishText {
  const char* key;
  const char* text;
};

}  // namespace aucast::gui
