#include <cstdio>
#include <exception>

#include "server/transmitter_app.h"

int main(int argc, char** argv) {
  try {
    return aucast::server::run_transmitter({argv + 1, argv + argc});
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "au-transmitter: stopped by an unexpected failure: %s\n", failure.what());
  } catch (...) {
    std::fputs("au-transmitter: stopped by an unexpected failure\n", stderr);
  }
  return 1;
}
