// What --preview tells and is told, over sockets of our own in the place of standard input and
// output.
#include "server/preview/preview.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "common/preview/preview_reader.h"
#include "tests/support/run_until.h"

namespace aucast::server {
namespace {

using test::run_until;

class PreviewTest : public testing::Test {
 protected:
  void SetUp() override {
    std::signal(SIGPIPE, SIG_IGN);  // as serve() does
    std::array<int, 2> ends{};
    ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()), 0);
    ours_ = ends[0];
    const auto started = preview_.start(ends[1], ends[1]);
    ::close(ends[1]);
    ASSERT_TRUE(started.has_value()) << started.error().message;
  }
  void TearDown() override {
    if (ours_ >= 0) ::close(ours_);
  }

  void order(const std::string& line) {
    ASSERT_EQ(::send(ours_, line.data(), line.size(), 0), static_cast<ssize_t>(line.size()));
  }
  /// The next record, for which the loop runs.
  std::optional<preview::Record> next() {
    std::optional<preview::Record> found;
    const bool came = run_until(io_, [&] {
      if (found) return true;
      std::vector<char> chunk(1 << 16);
      const ssize_t got = ::recv(ours_, chunk.data(), chunk.size(), MSG_DONTWAIT);
      if (got > 0) reader_.feed({chunk.data(), static_cast<std::size_t>(got)});
      auto record = reader_.next();
      EXPECT_TRUE(record.has_value());
      if (!record || !*record) return false;
      found = std::move(**record);
      return true;
    });
    EXPECT_TRUE(came);
    return found;
  }
  void offer(std::uint8_t grey) {
    const std::vector<std::uint8_t> rgb(std::size_t{3} * 640 * 480, grey);
    mesh::Landmarks landmarks;
    landmarks.points[1] = {320, 120, 0};
    preview_.offer({{640, 480, rgb}, &landmarks, {{12, Side::Left, 40}}});
  }

  asio::io_context io_;
  int ours_ = -1;
  preview::PreviewReader reader_;
  std::vector<std::string> asked_;
  std::size_t watching_ = 0;
  int gone_ = 0;
  Preview preview_{io_,
                   {[this](const std::string& bind, std::uint16_t port) -> Result<std::string> {
                      asked_.push_back(bind + " " + std::to_string(port));
                      if (bind == "nowhere") return Error{ErrorKind::Network, "cannot listen"};
                      return bind + ":" + std::to_string(port);
                    },
                    [this] { asked_.emplace_back("private"); }, [this] { return watching_; },
                    [this] { ++gone_; }}};
};

TEST_F(PreviewTest, ShowsWhatIsSeenHalfAsLarge) {
  offer(77);
  const auto record = next();
  ASSERT_TRUE(record && std::holds_alternative<preview::Seen>(*record));
  const auto& seen = std::get<preview::Seen>(*record);
  EXPECT_EQ(seen.width, 320U);
  EXPECT_EQ(seen.height, 240U);
  EXPECT_EQ(seen.rgb, std::vector<std::uint8_t>(std::size_t{3} * 320 * 240, 77));
  ASSERT_EQ(seen.points.size(), mesh::kLandmarks);
  EXPECT_NEAR(seen.points[1].x, 0.5, 1e-4);
  EXPECT_NEAR(seen.points[1].y, 0.25, 1e-4);
  EXPECT_EQ(seen.aus, (std::vector<AuTerm>{{12, Side::Left, 40}}));
}

TEST_F(PreviewTest, DropsPicturesWhileNobodyReads) {
  for (int i = 0; i < 200; ++i) {
    offer(static_cast<std::uint8_t>(i));
    io_.poll();
  }
  // 45 MB were offered: what is read now is what fits between the two and one more.
  std::size_t read = 0;
  for (std::vector<char> chunk(1 << 20); io_.poll(), true;) {
    const ssize_t got = ::recv(ours_, chunk.data(), chunk.size(), MSG_DONTWAIT);
    if (got <= 0) break;
    read += static_cast<std::size_t>(got);
  }
  EXPECT_LT(read, std::size_t{10} << 20);
}

TEST_F(PreviewTest, EndsWhenOrdersAreGivenAndNoAnswerIsRead) {
  for (int i = 0; i < 40'000 && gone_ == 0; ++i) {
    order(std::string(40, 'x') + "\n");
    io_.poll();
  }
  EXPECT_EQ(gone_, 1);
  EXPECT_TRUE(asked_.empty());
}

TEST_F(PreviewTest, CarriesOutOrders) {
  order("live 4650 0.0.0.0\nlive 1 nowhere\nprivate\nhello\n");
  auto record = next();
  ASSERT_TRUE(record && std::holds_alternative<preview::Live>(*record));
  EXPECT_EQ(std::get<preview::Live>(*record).address, "0.0.0.0:4650");
  record = next();
  EXPECT_TRUE(record && std::holds_alternative<preview::Private>(*record)) << "nobody is let in";
  record = next();
  ASSERT_TRUE(record && std::holds_alternative<preview::Refused>(*record));
  EXPECT_EQ(std::get<preview::Refused>(*record).sentence, "cannot listen");
  record = next();
  EXPECT_TRUE(record && std::holds_alternative<preview::Private>(*record));
  record = next();
  EXPECT_TRUE(record && std::holds_alternative<preview::Refused>(*record));
  EXPECT_EQ(asked_, (std::vector<std::string>{"0.0.0.0 4650", "nowhere 1", "private"}));
}

TEST_F(PreviewTest, SaysHowManyWatch) {
  watching_ = 2;
  offer(1);
  const auto record = next();
  ASSERT_TRUE(record && std::holds_alternative<preview::Watching>(*record));
  EXPECT_EQ(std::get<preview::Watching>(*record).count, 2U);
}

TEST_F(PreviewTest, EndsOnceWhenItsReaderHasGone) {
  ::close(std::exchange(ours_, -1));
  offer(1);
  EXPECT_TRUE(run_until(io_, [&] { return gone_ > 0; }));
  offer(2);
  io_.poll();
  EXPECT_EQ(gone_, 1);
}

TEST_F(PreviewTest, APictureThatComesTooLateIsForgotten) {
  const auto asked = std::make_shared<int>(0);
  {
    Preview other(io_, {{}, {}, [asked] { return static_cast<std::size_t>(++*asked); }, {}});
    const std::vector<std::uint8_t> rgb(std::size_t{3} * 640 * 480);
    other.offer({{640, 480, rgb}, nullptr, {}});
  }
  io_.poll();
  EXPECT_EQ(*asked, 0);
}

TEST_F(PreviewTest, EndsAnOrderThatNeverEnds) {
  order(std::string(4000, 'x'));
  EXPECT_TRUE(run_until(io_, [&] { return gone_ > 0; }));
}

TEST_F(PreviewTest, WantsPipesOrSockets) {
  const int file = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  Preview other(io_, {});
  const auto started = other.start(file, file);
  ::close(file);
  ASSERT_FALSE(started.has_value());
  EXPECT_NE(started.error().message.find("is not a pipe or a socket"), std::string::npos);
}

}  // namespace
}  // namespace aucast::server
