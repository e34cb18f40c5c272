#pragma once

#include <cstddef>
#include <cstdint>
#include <future>
#include <mutex>
#include <string>
#include <thread>
#include <variant>
#include <vector>

namespace aucast::test {

/// Waits for the next connection.
struct Accept {};
/// Waits until exactly these bytes have come, and nothing else.
struct Expect {
  std::string bytes;
};
/// Waits for a whole {hello ...}.
struct ExpectHello {};
/// Waits for the client's end of sending; whatever comes before that is only recorded.
struct ExpectEnd {};
/// Sends the bytes `portion` at a time; all at once when it is 0. A client that does not read, or
/// is gone, is no failure: the test itself checks how much a client has read.
struct Send {
  std::string bytes;
  std::size_t portion = 0;
};
/// Waits for the test to be ready.
struct Until {
  std::shared_future<void> ready;
};
/// Ends the sending side and goes on.
struct HalfClose {};
struct Close {};
/// Closes so that the client sees a reset.
struct Reset {};

using Step =
    std::variant<Accept, Expect, ExpectHello, ExpectEnd, Send, Until, HalfClose, Close, Reset>;

/// A server on 127.0.0.1 that plays a list of steps on a thread of its own, then keeps its sockets
/// open until it is destroyed.
class ScriptedServer {
 public:
  explicit ScriptedServer(std::vector<Step> steps);
  ~ScriptedServer();  ///< breaks off the step it is in
  ScriptedServer(const ScriptedServer&) = delete;
  ScriptedServer& operator=(const ScriptedServer&) = delete;

  [[nodiscard]] std::uint16_t port() const { return port_; }
  /// Waits for the last step. Returns what went wrong, and in which step; empty: nothing.
  [[nodiscard]] std::string finish();
  /// All bytes that came, over all connections.
  [[nodiscard]] std::string received() const;

 private:
  void play(const std::vector<Step>& steps);
  [[nodiscard]] std::string play_step(const Accept& step);
  [[nodiscard]] std::string play_step(const Expect& step);
  [[nodiscard]] std::string play_step(const ExpectHello& step);
  [[nodiscard]] std::string play_step(const ExpectEnd& step);
  [[nodiscard]] std::string play_step(const Send& step);
  [[nodiscard]] std::string play_step(const Until& step);
  [[nodiscard]] std::string play_step(const HalfClose& step);
  [[nodiscard]] std::string play_step(const Close& step);
  [[nodiscard]] std::string play_step(const Reset& step);
  [[nodiscard]] bool wait_for(int descriptor, short what) const;
  /// Reads one more byte. Returns false when the client has ended or is gone, or the time is up.
  [[nodiscard]] bool read_byte(char& byte);
  void close_client();

  int listener_ = -1;
  int client_ = -1;
  int quit_[2] = {-1, -1};  // a pipe: closing its end breaks off every wait
  std::uint16_t port_ = 0;
  mutable std::mutex mutex_;
  std::string received_;  // guarded by mutex_
  std::string failure_;   // of the thread; read after it has been joined
  std::jthread thread_;
};

}  // namespace aucast::test
