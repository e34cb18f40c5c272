#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "client/face/face.h"
#include "common/result.h"

namespace aucast::gui {

// Changing one AU in the text of an aus.toml (data/faces/FORMAT.md) so that everything else, also
// comments and order, stays byte for byte. Pure.

/// One `name = activation` of a drive table.
using Drive = std::vector<std::pair<std::string, float>>;

/// What an aus.toml would say for these activations, one per channel: left and right alike under
/// one name where the face has no channel of that very name, zeros left out, in the face's order.
[[nodiscard]] Drive drive_of(const face::Face& face, const std::vector<float>& activations);

/// "zygomaticus major 0.8, jaw 1.5", for people.
[[nodiscard]] std::string drive_in_words(const Drive& drive);

/// A file of AUs with this one alone; `note` may be empty.
[[nodiscard]] std::string aus_text(int number, const Drive& drive, const std::string& note);

/// `text` with the drive of AU `number` replaced, or with a new [[au]] at its end when it has none.
/// `note` becomes the AU's note; empty: it stays as it is. BadData "file:line:column: ..." when the
/// text is no such file, or spreads that drive over several lines, which is not rewritten so that
/// no comment is lost.
[[nodiscard]] Result<std::string> with_au(std::string_view text, std::string_view file, int number,
                                          const Drive& drive, const std::string& note = {});

/// `text` without the [[au]] of AU `number`, if it has one. BadData when the text is no such file,
/// or writes its AUs as values of one array.
[[nodiscard]] Result<std::string> without_au(std::string_view text, std::string_view file,
                                             int number);

}  // namespace aucast::gui
