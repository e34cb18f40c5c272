#pragma once

#include <filesystem>

#include "client/gui/texts/texts.h"
#include "common/result.h"

namespace aucast::gui {

/// Reads a file of data/languages. BadData "file:line:column: ..." if a text is missing or unknown,
/// or its places to be filled in differ from the English text's.
[[nodiscard]] Result<Language> load_language(const std::filesystem::path& file);

}  // namespace aucast::gui
