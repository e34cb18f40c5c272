#pragma once

#include <memory>
#include <string>
#include <vector>

#include "client/sound/sound_out.h"
#include "common/result.h"

namespace aucast::sound {

/// Call it before the program has a second thread, since it changes the environment. On a computer
/// without sound, OpenAL would fill the terminal with what it tried; the functions below say the
/// outcome.
void quieten_openal();

/// Opens a device of OpenAL by name; empty: the default device. If there is no device of that name
/// or it cannot be opened, fails with ErrorKind::Failed and a sentence for the user that names the
/// available devices. Only one may be open at a time.
[[nodiscard]] Result<std::unique_ptr<SoundOut>> open_sound_device(const std::string& name);

/// The names of the devices that can be opened.
[[nodiscard]] std::vector<std::string> sound_devices();

}  // namespace aucast::sound
