#pragma once

#include <filesystem>
#include <vector>

#include "common/result.h"
#include "server/engine/nats_library.h"

namespace aucast::server {

/// The folders in which the module may be: first the folder of this program, as in a build; then
/// the one into which `cmake --install` puts the module, found relative to the first.
[[nodiscard]] std::vector<std::filesystem::path> nats_module_folders();

/// Loads the module from the first of these folders that has it. Fails with a Usage error that says
/// what to install if none has it; with Unreadable if others than root and the owner of this
/// program could have put it there, the system cannot load it, or it is of another build. A group
/// in which one of these two is alone counts as they do. The module is never unloaded: libnats has
/// threads, with destructors, that outlive every connection.
[[nodiscard]] Result<const NatsModule*> load_nats_module(
    const std::vector<std::filesystem::path>& folders);

}  // namespace aucast::server
