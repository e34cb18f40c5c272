#include <cstdio>
#include <exception>
#include <new>

#include "server/transmitter_app.h"

int main(int argc, char** argv) {
  try {
    return aucast::server::run_transmitter({argv + 1, argv + argc});
  } catch (const std::bad_alloc&) {
    std::fputs("au-transmitter: there is not enough memory left to go on\n", stderr);
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "au-transmitter: stopped by an unexpected failure: %s\n", failure.what());
  } catch (...) {
    std::fputs("au-transmitter: stopped by an unexpected failure\n", stderr);
  }
  return 1;
}
