#include <cstdio>
#include <exception>
#include <new>

#include "speaker/speaker_app.h"

int main(int argc, char** argv) {
  try {
    return aucast::speaker::run_speaker({argv + 1, argv + argc});
  } catch (const std::bad_alloc&) {
    std::fputs("au-speaker: there is not enough memory left to go on\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "au-speaker: %s\n", error.what());
  } catch (...) {
    std::fputs("au-speaker: unknown failure\n", stderr);
  }
  return 1;
}
