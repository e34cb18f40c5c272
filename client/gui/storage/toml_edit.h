#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "common/result.h"
#include "common/toml_document.h"

namespace aucast::gui {

/// The index of the byte at a line and column of a TOML file; nullopt: the file has too few lines.
[[nodiscard]] std::optional<std::size_t> byte_at(std::string_view toml, LinePosition place);

/// Replaces a text of the file; all else stays as it is. `old`: the value to replace, as it was
/// read from this `toml`. Fails with BadData if `old` is not a text.
[[nodiscard]] Result<void> put_text(std::string& toml, std::string_view file, const TomlValue& old,
                                    const std::string& text);

}  // namespace aucast::gui
