#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "client/player_app.h"

int main(int argc, char** argv) {
  try {
    return aucast::app::run_player(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const std::bad_alloc&) {
    std::fputs("face-player: there is not enough memory left to go on\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "face-player: %s\n", error.what());
  } catch (...) {
    std::fputs("face-player: unknown failure\n", stderr);
  }
  return 1;
}
