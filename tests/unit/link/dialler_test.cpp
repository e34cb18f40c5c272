#include "common/link/dialler.h"

#include <pthread.h>
#include <unistd.h>

#include <chrono>
#include <memory>

#include <gtest/gtest.h>

#include "tests/support/certificates.h"
#include "tests/support/loopback.h"
#include "tests/support/run_until.h"
#include "tests/unit/link/recording_user.h"

namespace aucast::link {
namespace {

using namespace std::chrono_literals;
using aucast::test::bind_to_loopback;
using aucast::test::listen_on_loopback;
using aucast::test::LoopbackSocket;

class DiallerTest : public ::testing::Test {
 protected:
  ~DiallerTest() override {
    ::close(listener_.descriptor);
    ::close(deaf_.descriptor);
  }

  /// What comes of it; waits for it.
  Dialled dial(const std::string& host, std::uint16_t port) {
    options_.host = host;
    options_.port = port;
    std::optional<Dialled> result;
    dialler_.dial(options_, [&result](Dialled dialled) { result = std::move(dialled); });
    EXPECT_FALSE(result) << "not from within dial()";
    EXPECT_TRUE(aucast::test::run_until(io_, [&] { return result.has_value(); }));
    io_.restart();
    return result.value_or(DialFailure{false, "nothing came of it"});
  }
  std::string failure(const std::string& host, std::uint16_t port) {
    const Dialled dialled = dial(host, port);
    const auto* const failed = std::get_if<DialFailure>(&dialled);
    return failed == nullptr ? "" : (failed->final ? "final: " : "") + failed->reason;
  }

  asio::io_context io_{1};
  Dialler dialler_{io_};
  DialOptions options_;
  LoopbackSocket listener_ = listen_on_loopback();
  LoopbackSocket deaf_ = bind_to_loopback();
};

TEST_F(DiallerTest, ReachesAnAddressAndLocalhost) {
  EXPECT_EQ(failure("127.0.0.1", listener_.port), "");
  EXPECT_EQ(failure("localhost", listener_.port), "");
  EXPECT_EQ(failure("au.localhost", listener_.port), "") << "no resolver knows it";
}

TEST_F(DiallerTest, SaysCauseAndRemedy) {
  EXPECT_TRUE(
      failure("127.0.0.1", deaf_.port).starts_with("Connection refused; is au-transmitter"));
  EXPECT_TRUE(
      failure("localhost", deaf_.port).starts_with("Connection refused; is au-transmitter"));
  EXPECT_NE(failure("no-such-host.invalid", 1).find("; check the host's name"), std::string::npos);
}

/// No thread can be had whose stack is larger than the address space.
class NoThreads {
 public:
  NoThreads() {
    ::pthread_getattr_default_np(&before_);
    pthread_attr_t attributes;
    ::pthread_getattr_default_np(&attributes);
    ::pthread_attr_setstacksize(&attributes, std::size_t{1} << 60U);
    ::pthread_setattr_default_np(&attributes);
    ::pthread_attr_destroy(&attributes);
  }
  ~NoThreads() {
    ::pthread_setattr_default_np(&before_);
    ::pthread_attr_destroy(&before_);
  }
  NoThreads(const NoThreads&) = delete;
  NoThreads& operator=(const NoThreads&) = delete;

 private:
  pthread_attr_t before_{};
};

TEST_F(DiallerTest, ALookUpWithoutAThreadHasFailed) {
  const NoThreads none;
  EXPECT_NE(failure("no-such-host.invalid", 1).find("; the system is short of threads"),
            std::string::npos);
}

TEST_F(DiallerTest, ASecretGoesToThisComputerOrOverTls) {
  options_.secret = true;
  EXPECT_EQ(failure("127.0.0.1", listener_.port), "");
}

TEST_F(DiallerTest, CancelledNothingIsTold) {
  options_.host = "127.0.0.1";
  options_.port = listener_.port;
  bool told = false;
  dialler_.dial(options_, [&told](Dialled) { told = true; });
  dialler_.cancel();
  io_.run_for(100ms);
  EXPECT_FALSE(told);
}

TEST_F(DiallerTest, MayGoWhileItConnects) {
  options_.host = "127.0.0.1";
  options_.port = listener_.port;
  bool told = false;
  auto dialler = std::make_unique<Dialler>(io_);
  dialler->dial(options_, [&told](Dialled) { told = true; });
  // The host is known now, and a connection is being made.
  ASSERT_EQ(io_.run_one_for(10s), 1U);
  dialler.reset();
  io_.run_for(100ms);
  EXPECT_FALSE(told);
}

TEST_F(DiallerTest, TheHandshakeHasTheRestOfTheTime) {
  const aucast::test::Authority authority;
  options_.tls = *tls::Context::for_client({{}, {}, authority.file()});
  options_.time_max = 300ms;
  options_.limits.drain_time = 1ms;
  const Dialled dialled = dial("127.0.0.1", listener_.port);
  const auto* const link = std::get_if<std::shared_ptr<Link>>(&dialled);
  ASSERT_NE(link, nullptr);
  test::RecordingUser user;
  (*link)->start(user);
  EXPECT_TRUE(aucast::test::run_until(io_, [&] { return user.ending.has_value(); }));
  EXPECT_TRUE(user.closed_as(Ending::Why::TlsFailed)) << "the listener says nothing";
  EXPECT_FALSE(user.opened);
}

}  // namespace
}  // namespace aucast::link
