// Part of every program that is built with ThreadSanitizer. Its runtime (LLVM 14) makes room for a
// thread's pending signals within the thread's first blocking call and forgets a signal that comes
// just then. So the first call of the main thread is made here, before anybody can know the
// program.
#include <poll.h>

namespace {

[[maybe_unused]] const int kFirstBlockingCall = ::poll(nullptr, 0, 0);

}  // namespace
