#include "client/app/window/playing/server_choice.h"

#include <utility>

#include "client/app/remote_options.h"
#include "client/gui/storage/home_folder.h"
#include "client/gui/storage/kept_settings.h"
#include "client/net/security.h"

namespace aucast::app {

void ServerChoice::set(const gui::RemoteSettings& settings, std::vector<std::string> recent) {
  settings_ = settings;
  worked_ = settings;
  recent_ = std::move(recent);
}

void ServerChoice::answered() {
  worked_ = settings_;
  gui::remember_address(recent_, settings_);
}

Result<net::RemoteOptions> ServerChoice::server_of(const gui::RemoteSettings& settings,
                                                   bool voice) const {
  net::SecurityOptions protection = options_.security;
  protection.tls |= settings.tls;
  if (protection.tls && !settings.authorities_file.empty()) {
    protection.files.authorities = gui::with_home(settings.authorities_file);
  }
  if (!settings.token_file.empty()) protection.token = gui::with_home(settings.token_file);
  auto security = net::load_security(protection, settings.address);
  if (!security) return security.error();
  const net::Endpoint asked{settings.address, static_cast<std::uint16_t>(settings.port)};
  net::RemoteOptions remote = remote_options(options_, asked, *std::move(security));
  remote.others = settings.others;
  remote.speed.reset();
  if (settings.speed_ms > 0) remote.speed = Milliseconds(settings.speed_ms);
  remote.reconnect = settings.reconnect || !remote.others.empty();
  remote.stream = settings.stream;
  remote.voice = options_.voice || voice;
  remote.captions = true;
  set_buffers(settings, remote.buffers);
  return remote;
}

}  // namespace aucast::app
