#include <cstdio>

#include "server/transmitter_app.h"

int main(int argc, char** argv) {
  try {
    return aucast::server::run_transmitter({argv + 1, argv + argc});
  } catch (...) {
    std::fputs("au-transmitter: stopped by an unexpected failure, such as no memory left\n",
               stderr);
    return 1;
  }
}
