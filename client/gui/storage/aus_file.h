#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "client/face/face.h"
#include "common/result.h"

namespace aucast::gui {

// Changes one AU in the text of an aus.toml (data/faces/FORMAT.md). Everything else, including
// comments and order, stays byte for byte. Pure.

/// The lines `name = activation` of a drive table.
using Drive = std::vector<std::pair<std::string, float>>;

/// The drive table for these activations (one per channel), in the face's order, without zeros. If
/// left_X and right_X are equal, they become one line X, unless the face has a channel named X.
[[nodiscard]] Drive drive_of(const face::Face& face, const std::vector<float>& activations);

/// The drive in words: "zygomaticus major 0.8, jaw 1.5".
[[nodiscard]] std::string drive_in_words(const Drive& drive);

/// The text of an AU file that has only this AU. `note` may be empty.
[[nodiscard]] std::string aus_text(int number, const Drive& drive, const std::string& note);

/// `text` with the drive of AU `number` replaced, or, if it has no such AU, with a new [[au]] at
/// its end. `note` becomes the AU's note; empty: the note stays. Fails with BadData
/// "file:line:column: ..." if the text is not an AU file, or if it spreads that drive over several
/// lines; these are not rewritten, because comments between them would be lost.
[[nodiscard]] Result<std::string> with_au(std::string_view text, std::string_view file, int number,
                                          const Drive& drive, const std::string& note = {});

/// `text` without the [[au]] of AU `number`, if it has one. Fails with BadData if the text is not
/// an AU file, or writes its AUs as values of one array.
[[nodiscard]] Result<std::string> without_au(std::string_view text, std::string_view file,
                                             int number);

}  // namespace aucast::gui
