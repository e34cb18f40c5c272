// Two ends of TLS joined in memory: whom they believe, what they say when they do not, and that
// what goes in comes out however the wire cuts it.
#include "common/tls/layer.h"

#include <algorithm>
#include <optional>

#include <gtest/gtest.h>

#include "common/files.h"
#include "tests/support/certificates.h"
#include "tests/support/seeded.h"
#include "tests/support/temp_folder.h"

namespace aucast::tls {
namespace {

using test::Authority;
using test::Certificate;
using Why = Layer::Why;

Context server_of(const Certificate& own, const std::string& client_authorities = {}) {
  auto made = Context::for_server({own.file, own.key, client_authorities});
  EXPECT_TRUE(made) << made.error().message;
  return *made;
}

Context client_of(const std::string& authorities, const Certificate& own = {}) {
  auto made = Context::for_client({own.file, own.key, authorities});
  EXPECT_TRUE(made) << made.error().message;
  return *made;
}

/// Both ends and what each has been told.
struct Pair {
  Layer server;
  Layer client;
  std::string at_server{};
  std::string at_client{};

  /// Hands everything on, `portion` bytes at a time, until nothing moves.
  void settle(std::size_t portion = 100'000) {
    bool moved = true;
    while (moved) {
      moved = hand_on(client, server, at_server, portion);
      moved = hand_on(server, client, at_client, portion) || moved;
    }
  }

  static bool hand_on(Layer& from, Layer& to, std::string& plain, std::size_t portion) {
    const std::string wire = from.take_output();
    for (std::size_t begin = 0; begin < wire.size(); begin += portion) {
      to.received(wire.substr(begin, portion), plain);
    }
    return !wire.empty();
  }
};

class TlsChannel : public ::testing::Test {
 protected:
  Authority authority_{"right"};
  Certificate own_ = authority_.issue("server", "DNS:face.example,IP:10.1.2.3");

  /// The failure that the client ends with when it asks for `host` and believes `authorities`.
  Layer meet(const Certificate& certificate, const std::string& host,
             const std::string& authorities, std::optional<std::string> server_says = {}) {
    Pair pair{Layer(server_of(certificate)), Layer(client_of(authorities), host)};
    pair.settle();
    if (server_says) {
      EXPECT_NE(pair.server.reason().find(*server_says), std::string::npos) << pair.server.reason();
    }
    return std::move(pair.client);
  }
};

void expect_reason(const Layer& layer, Why why, const std::string& text) {
  EXPECT_EQ(layer.why(), why);
  EXPECT_NE(layer.reason().find(text), std::string::npos) << layer.reason();
}

TEST_F(TlsChannel, CarriesBytesBothWaysHoweverTheyAreCut) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (const std::size_t portion : {std::size_t{1}, std::size_t{7}, std::size_t{100'000}}) {
    Pair pair{Layer(server_of(own_)), Layer(client_of(authority_.file()), "face.example")};
    pair.settle(portion);
    ASSERT_TRUE(pair.server.ready());
    ASSERT_TRUE(pair.client.ready());
    std::string long_text;
    for (int i = 0; i < 40'000; ++i) long_text += static_cast<char>(seeded.integer(0, 255));
    pair.client.send("{hello v=2}");
    pair.server.send(long_text);
    pair.settle(portion);
    EXPECT_EQ(pair.at_server, "{hello v=2}");
    EXPECT_EQ(pair.at_client, long_text);
    EXPECT_FALSE(pair.client.ended());
    pair.server.send("{-2}");
    pair.server.end();
    pair.settle(portion);
    EXPECT_TRUE(pair.client.ended());
    EXPECT_FALSE(pair.server.ended());
    EXPECT_EQ(pair.at_client, long_text + "{-2}");
    // The other direction still stands.
    pair.client.send("1");
    pair.client.end();
    pair.settle(portion);
    EXPECT_EQ(pair.at_server, "{hello v=2}1");
    EXPECT_TRUE(pair.server.ended());
    EXPECT_EQ(pair.server.why(), Why::None);
    EXPECT_EQ(pair.client.why(), Why::None);
  }
}

TEST_F(TlsChannel, HoldsNothingOfWhatComesAfterThePeersEnd) {
  Pair pair{Layer(server_of(own_)), Layer(client_of(authority_.file()), "face.example")};
  pair.settle();
  pair.client.send("{-2}");
  pair.client.end();
  std::string wire = pair.client.take_output();
  const std::string record = "\x17\x03\x03" + std::string(10'000, 'x');
  wire += record;
  for (int i = 0; i < 100; ++i) {
    EXPECT_TRUE(pair.server.received(wire, pair.at_server));
    EXPECT_EQ(pair.server.held_bytes(), 0U);
    wire = record;
  }
  EXPECT_TRUE(pair.server.ended());
  EXPECT_EQ(pair.at_server, "{-2}");
  // The other direction still stands.
  pair.server.send("1");
  pair.settle();
  EXPECT_EQ(pair.at_client, "1");
}

TEST_F(TlsChannel, HoldsNoMoreThanARecordThatIsNotWhole) {
  Pair pair{Layer(server_of(own_)), Layer(client_of(authority_.file()), "face.example")};
  pair.settle();
  pair.client.send(std::string(1'000'000, 'x'));
  const std::string wire = pair.client.take_output();
  std::size_t most = 0;
  for (std::size_t begin = 0; begin < wire.size(); begin += 1000) {
    EXPECT_TRUE(pair.server.received(std::string_view(wire).substr(begin, 1000), pair.at_server));
    most = std::max(most, pair.server.held_bytes());
  }
  EXPECT_LE(most, 17'000U);
  EXPECT_EQ(pair.at_server.size(), 1'000'000U);
}

TEST_F(TlsChannel, BelievesAnAddressThatTheCertificateIsFor) {
  EXPECT_TRUE(meet(own_, "10.1.2.3", authority_.file()).ready());
}

TEST_F(TlsChannel, RefusesAnotherNameOrAddress) {
  expect_reason(meet(own_, "other.example", authority_.file()), Why::Untrusted,
                "the server's certificate is for face.example, 10.1.2.3, not for other.example");
  expect_reason(meet(own_, "10.1.2.4", authority_.file()), Why::Untrusted, "not for 10.1.2.4");
}

TEST_F(TlsChannel, AClientThatNamesNoHostIsAMistake) {
  const Context context = client_of(authority_.file());
  EXPECT_DEATH(Layer(context, ""), "broken invariant");
  EXPECT_DEATH(Layer(context, std::string("face\0example", 12)), "broken invariant");
}

TEST_F(TlsChannel, RefusesAnUnknownAuthority) {
  const Authority stranger("wrong");
  expect_reason(meet(own_, "face.example", stranger.file(), "does not accept this server's"),
                Why::Untrusted, "authority that is not known here; --tls-ca FILE");
}

TEST_F(TlsChannel, RefusesWhatHasExpiredOrIsNotYetValid) {
  const Certificate old = authority_.issue("old", "DNS:face.example", -20, 10);
  expect_reason(meet(old, "face.example", authority_.file()), Why::Untrusted,
                "the server's certificate has expired on ");
  const Certificate young = authority_.issue("young", "DNS:face.example", 5, 10);
  expect_reason(meet(young, "face.example", authority_.file()), Why::Untrusted, "is not valid yet");
}

TEST_F(TlsChannel, AsksForTheClientsCertificate) {
  Authority clients("clients");
  const Certificate known = clients.issue("player", "DNS:player");
  const Certificate unknown = authority_.issue("stranger", "DNS:player");
  const Context server = server_of(own_, clients.file());

  Pair right{Layer(server), Layer(client_of(authority_.file(), known), "face.example")};
  right.settle();
  EXPECT_TRUE(right.server.ready());
  EXPECT_EQ(right.client.why(), Why::None);

  Pair none{Layer(server), Layer(client_of(authority_.file()), "face.example")};
  none.settle();
  expect_reason(none.server, Why::Untrusted, "showed no certificate (--tls-client-ca)");
  expect_reason(none.client, Why::Untrusted, "the server wants a certificate of ours");

  Pair wrong{Layer(server), Layer(client_of(authority_.file(), unknown), "face.example")};
  wrong.settle();
  expect_reason(wrong.server, Why::Untrusted,
                "the client's certificate comes from an authority that is not known here");
  expect_reason(wrong.client, Why::Untrusted, "the server wants a certificate of ours");
}

TEST_F(TlsChannel, RefusesARevokedClient) {
  Authority clients("clients");
  const Certificate good = clients.issue("good", "DNS:player");
  const Certificate bad = clients.issue("bad", "DNS:player");
  const auto meet_client = [&](const Certificate& shown, const std::string& authorities) {
    Pair pair{Layer(server_of(own_, authorities)),
              Layer(client_of(authority_.file(), shown), "face.example")};
    pair.settle();
    return pair;
  };
  EXPECT_TRUE(meet_client(bad, clients.file()).server.ready()) << "as no list says otherwise";
  const std::string with_list = clients.file_with_revoked(bad);
  EXPECT_TRUE(meet_client(good, with_list).server.ready());
  const Pair refused = meet_client(bad, with_list);
  expect_reason(refused.server, Why::Untrusted, "the client's certificate has been revoked");
  expect_reason(refused.client, Why::Untrusted, "the server wants a certificate of ours");
  expect_reason(meet_client(good, clients.file_with_revoked(bad, -1)).server, Why::Untrusted,
                "revocation list in --tls-client-ca is out of date");
}

TEST_F(TlsChannel, RefusesARevokedServer) {
  const Certificate good = authority_.issue("good", "DNS:face.example");
  const std::string with_list = authority_.file_with_revoked(own_);
  EXPECT_TRUE(meet(good, "face.example", with_list).ready());
  expect_reason(meet(own_, "face.example", with_list), Why::Untrusted,
                "the server's certificate has been revoked");
}

TEST_F(TlsChannel, WithOneRevocationListWantsThatOfEachAuthority) {
  Authority other("other");
  const Certificate listed = authority_.issue("listed", "DNS:face.example");
  const test::TempFolder folder;
  const std::string with_list = read_file(authority_.file_with_revoked(listed)).value();
  const std::string both = folder.write("both.pem", read_file(other.file()).value() + with_list);
  EXPECT_TRUE(meet(own_, "face.example", both).ready());
  expect_reason(meet(other.issue("unlisted", "DNS:face.example"), "face.example", both),
                Why::Untrusted, "comes from an authority of which --tls-ca has no revocation list");
}

TEST_F(TlsChannel, SaysWhenThePeerSpeaksPlain) {
  std::string plain;
  Layer server(server_of(own_));
  EXPECT_FALSE(server.received("{hello v=2}", plain));
  expect_reason(server, Why::NotTls, "the client does not speak TLS");
  Layer client(client_of(authority_.file()), "face.example");
  EXPECT_FALSE(client.received("{1,6,12}", plain));
  expect_reason(client, Why::NotTls, "the server does not speak TLS");
  EXPECT_EQ(plain, "");
}

TEST_F(TlsChannel, RandomBytesEndItAndNothingElse) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  const Context context = server_of(own_);
  for (int round = 0; round < 500; ++round) {
    Layer server(context);
    std::string plain;
    std::string noise(1, '\x16');
    const int length = seeded.integer(0, 3000);
    for (int i = 0; i < length; ++i) noise += static_cast<char>(seeded.integer(0, 255));
    if (seeded.chance(0.5) && noise.size() > 5) noise.replace(0, 3, "\x16\x03\x01");
    server.received(noise, plain);
    EXPECT_FALSE(server.ready());
    EXPECT_EQ(plain, "");
    EXPECT_LT(server.take_output().size(), 100U);
  }
}

TEST_F(TlsChannel, DamageOnTheWayIsNoticed) {
  Pair pair{Layer(server_of(own_)), Layer(client_of(authority_.file()), "face.example")};
  pair.settle();
  pair.server.send("{1,6,12}");
  std::string wire = pair.server.take_output();
  wire[wire.size() / 2] = static_cast<char>(wire[wire.size() / 2] ^ 1);
  std::string plain;
  EXPECT_FALSE(pair.client.received(wire, plain));
  EXPECT_EQ(plain, "");
  EXPECT_EQ(pair.client.why(), Why::Broken);
}

}  // namespace
}  // namespace aucast::tls
