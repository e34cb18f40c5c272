#include "common/tls/layer.h"

#include <openssl/err.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <utility>

#include "common/check.h"
#include "common/text.h"

namespace aucast::tls {
namespace {

/// The first byte of everything that can begin a connection: a handshake or an alert.
constexpr char kHandshakeRecord = 0x16;
constexpr char kAlertRecord = 0x15;

int length_of(std::string_view bytes) {
  AUCAST_CHECK(bytes.size() <= static_cast<std::size_t>(std::numeric_limits<int>::max()));
  return static_cast<int>(bytes.size());
}

bool is_address(const std::string& host) {
  ASN1_OCTET_STRING* const address = a2i_IPADDRESS(host.c_str());
  ASN1_OCTET_STRING_free(address);
  return address != nullptr;
}

/// An address may not be sent as the name that is asked for, but is checked all the same.
void expect_host(SSL* ssl, const std::string& host) {
  // To the library an empty name means any.
  AUCAST_CHECK(!host.empty());
  X509_VERIFY_PARAM* const wanted = SSL_get0_param(ssl);
  if (is_address(host)) {
    AUCAST_CHECK(X509_VERIFY_PARAM_set1_ip_asc(wanted, host.c_str()) == 1);
    return;
  }
  std::string name = host;
  SSL_ctrl(ssl, SSL_CTRL_SET_TLSEXT_HOSTNAME, TLSEXT_NAMETYPE_host_name, name.data());
  X509_VERIFY_PARAM_set_hostflags(wanted, X509_CHECK_FLAG_NO_PARTIAL_WILDCARDS);
  AUCAST_CHECK(X509_VERIFY_PARAM_set1_host(wanted, host.c_str(), host.size()) == 1);
}

std::string time_text(const ASN1_TIME* time) {
  const std::unique_ptr<BIO, decltype(&BIO_free)> bio(BIO_new(BIO_s_mem()), BIO_free);
  if (!bio || time == nullptr || ASN1_TIME_print(bio.get(), time) != 1) return "an unknown time";
  char* text = nullptr;
  const long length = BIO_get_mem_data(bio.get(), &text);
  return escaped({text, static_cast<std::size_t>(length)});
}

/// The names and addresses that a certificate is for; its subject where it has none.
std::string names_of(X509* certificate) {
  std::string names;
  const auto add = [&names](std::string_view name) {
    names += (names.empty() ? "" : ", ") + escaped(name);
  };
  auto* const found = static_cast<GENERAL_NAMES*>(
      X509_get_ext_d2i(certificate, NID_subject_alt_name, nullptr, nullptr));
  for (int i = 0; i < sk_GENERAL_NAME_num(found); ++i) {
    const GENERAL_NAME* const name = sk_GENERAL_NAME_value(found, i);
    if (name->type == GEN_DNS) {
      add({reinterpret_cast<const char*>(ASN1_STRING_get0_data(name->d.dNSName)),
           static_cast<std::size_t>(ASN1_STRING_length(name->d.dNSName))});
    } else if (name->type == GEN_IPADD) {
      ASN1_OCTET_STRING* const bytes = name->d.iPAddress;
      char* const text = i2s_ASN1_OCTET_STRING(nullptr, bytes);
      const unsigned char* b = ASN1_STRING_get0_data(bytes);
      if (ASN1_STRING_length(bytes) == 4) {
        add(std::to_string(b[0]) + "." + std::to_string(b[1]) + "." + std::to_string(b[2]) + "." +
            std::to_string(b[3]));
      } else if (text != nullptr) {
        add(text);
      }
      OPENSSL_free(text);
    }
  }
  GENERAL_NAMES_free(found);
  if (!names.empty()) return names;
  std::array<char, 256> subject{};
  X509_NAME_oneline(X509_get_subject_name(certificate), subject.data(),
                    static_cast<int>(subject.size()));
  return escaped(subject.data());
}

/// What is wrong with the peer's certificate, with the remedy in terms of the option that names the
/// authorities.
std::string verdict(long code, X509* certificate, const std::string& host, bool server,
                    const std::string& option) {
  const std::string whose = server ? "the client's certificate " : "the server's certificate ";
  switch (code) {
    case X509_V_ERR_CERT_HAS_EXPIRED:
      return whose + "has expired" +
             (certificate != nullptr ? " on " + time_text(X509_get0_notAfter(certificate)) : "");
    case X509_V_ERR_CERT_NOT_YET_VALID:
      return whose + "is not valid yet; is the clock of this computer right?";
    case X509_V_ERR_DEPTH_ZERO_SELF_SIGNED_CERT:
    case X509_V_ERR_SELF_SIGNED_CERT_IN_CHAIN:
    case X509_V_ERR_UNABLE_TO_GET_ISSUER_CERT:
    case X509_V_ERR_UNABLE_TO_GET_ISSUER_CERT_LOCALLY:
    case X509_V_ERR_UNABLE_TO_VERIFY_LEAF_SIGNATURE:
      return whose + "comes from an authority that is not known here" +
             (server ? " (" + option + ")" : "; " + option + " FILE names one to believe");
    case X509_V_ERR_CERT_REVOKED:
      return whose + "has been revoked";
    case X509_V_ERR_UNABLE_TO_GET_CRL:
      return whose + "comes from an authority of which " + option + " has no revocation list";
    case X509_V_ERR_CRL_HAS_EXPIRED:
      return whose + "cannot be checked: its authority's revocation list in " + option +
             " is out of date";
    case X509_V_ERR_HOSTNAME_MISMATCH:
    case X509_V_ERR_IP_ADDRESS_MISMATCH:
      return whose + "is for " + (certificate != nullptr ? names_of(certificate) : "another host") +
             ", not for " + escaped(host);
    default:
      break;
  }
  return whose + "is not believed: " + X509_verify_cert_error_string(code);
}

/// Whether an alert of the peer is about certificates.
bool about_certificates(int reason) {
  return reason == SSL_R_TLSV1_ALERT_UNKNOWN_CA || reason == SSL_R_SSLV3_ALERT_BAD_CERTIFICATE ||
         reason == SSL_R_SSLV3_ALERT_CERTIFICATE_EXPIRED ||
         reason == SSL_R_SSLV3_ALERT_CERTIFICATE_UNKNOWN ||
         reason == SSL_R_SSLV3_ALERT_CERTIFICATE_REVOKED ||
         reason == SSL_R_TLSV1_ALERT_ACCESS_DENIED ||
         reason == SSL_R_TLSV13_ALERT_CERTIFICATE_REQUIRED;
}

}  // namespace

/// What the library must be able to tell us about one connection; it stays where it is.
struct Layer::Peer {
  std::string host;
  bool server = false;
  std::string authorities_option{};
  std::string verdict{};  ///< on the certificate, when it is not believed

  /// Called by the library for each certificate of the peer's chain.
  static int on_verified(int good, X509_STORE_CTX* chain) {
    if (good == 1) return good;
    auto* const ssl =
        static_cast<SSL*>(X509_STORE_CTX_get_ex_data(chain, SSL_get_ex_data_X509_STORE_CTX_idx()));
    auto* const peer = static_cast<Peer*>(SSL_get_ex_data(ssl, 0));
    peer->verdict =
        tls::verdict(X509_STORE_CTX_get_error(chain), X509_STORE_CTX_get_current_cert(chain),
                     peer->host, peer->server, peer->authorities_option);
    return good;
  }
};

void Layer::Free::operator()(ssl_st* ssl) const {
  SSL_free(ssl);
}

Layer::Layer(const Context& context, const std::string& host)
    : peer_(std::make_unique<Peer>(Peer{host, context.server_, context.authorities_option_})),
      ssl_(SSL_new(context.context_.get())) {
  BIO* const in = BIO_new(BIO_s_mem());
  BIO* const out = BIO_new(BIO_s_mem());
  if (!ssl_ || in == nullptr || out == nullptr) throw std::bad_alloc();
  // An empty BIO means "later", not "the end".
  BIO_set_mem_eof_return(in, -1);
  BIO_set_mem_eof_return(out, -1);
  SSL_set_bio(ssl_.get(), in, out);
  SSL_set_ex_data(ssl_.get(), 0, peer_.get());
  SSL_set_verify(ssl_.get(), SSL_get_verify_mode(ssl_.get()), Peer::on_verified);
  if (peer_->server) {
    SSL_set_accept_state(ssl_.get());
    return;
  }
  SSL_set_connect_state(ssl_.get());
  expect_host(ssl_.get(), host);
  shake_hands();
}

Layer::~Layer() = default;
Layer::Layer(Layer&&) noexcept = default;
Layer& Layer::operator=(Layer&&) noexcept = default;

bool Layer::looks_like_tls(std::string_view wire) const {
  return wire.front() == kHandshakeRecord || (!peer_->server && wire.front() == kAlertRecord);
}

bool Layer::received(std::string_view wire, std::string& plain) {
  if (why_ != Why::None) return false;
  if (wire.empty() || ended_) return true;
  if (!std::exchange(heard_, true) && !looks_like_tls(wire)) {
    why_ = Why::NotTls;
    reason_ = peer_->server
                  ? "the client does not speak TLS, as this server wants (--tls)"
                  : "the server does not speak TLS; leave out --tls (of aucasts:// the s), or "
                    "serve with --tls-cert";
    return false;
  }
  BIO_write(SSL_get_rbio(ssl_.get()), wire.data(), length_of(wire));
  if (!ready()) shake_hands();
  while (ready() && why_ == Why::None && !ended_) {
    std::array<char, 4096> bytes;
    ERR_clear_error();
    const int count = SSL_read(ssl_.get(), bytes.data(), static_cast<int>(bytes.size()));
    if (count > 0) {
      plain.append(bytes.data(), static_cast<std::size_t>(count));
      continue;
    }
    const int error = SSL_get_error(ssl_.get(), count);
    if (error == SSL_ERROR_WANT_READ || error == SSL_ERROR_WANT_WRITE) break;
    if (error == SSL_ERROR_ZERO_RETURN) {
      ended_ = true;
      BIO_reset(SSL_get_rbio(ssl_.get()));
    } else {
      fail();
    }
  }
  return why_ == Why::None;
}

void Layer::shake_hands() {
  ERR_clear_error();
  const int done = SSL_do_handshake(ssl_.get());
  if (done == 1) return;
  const int error = SSL_get_error(ssl_.get(), done);
  if (error != SSL_ERROR_WANT_READ && error != SSL_ERROR_WANT_WRITE) fail();
}

void Layer::fail() {
  const unsigned long code = ERR_get_error();
  ERR_clear_error();
  const int reason = ERR_GET_REASON(code);
  const char* const text = ERR_reason_error_string(code);
  const std::string said = text == nullptr ? "no cause is known" : text;
  why_ = Why::Untrusted;
  if (reason == SSL_R_CERTIFICATE_VERIFY_FAILED) {
    reason_ = peer_->verdict;
  } else if (reason == SSL_R_PEER_DID_NOT_RETURN_A_CERTIFICATE) {
    reason_ = "the client showed no certificate (--tls-client-ca)";
  } else if (about_certificates(reason)) {
    reason_ = peer_->server ? "the client does not accept this server's certificate: " + said
                            : "the server wants a certificate of ours that it believes: " + said +
                                  "; --tls-cert and --tls-key show one";
  } else {
    why_ = Why::Broken;
    reason_ = "it broke off: " + said;
  }
}

void Layer::send(std::string_view plain) {
  if (why_ != Why::None || plain.empty()) return;
  ERR_clear_error();
  // The BIO takes everything, so it is always written whole.
  if (SSL_write(ssl_.get(), plain.data(), length_of(plain)) <= 0) fail();
}

void Layer::end() {
  if (why_ != Why::None || !ready()) return;
  ERR_clear_error();
  SSL_shutdown(ssl_.get());
  ERR_clear_error();
}

std::string Layer::take_output() {
  BIO* const out = SSL_get_wbio(ssl_.get());
  std::string bytes(BIO_ctrl_pending(out), '\0');
  if (!bytes.empty()) BIO_read(out, bytes.data(), length_of(bytes));
  return bytes;
}

std::size_t Layer::held_bytes() const {
  return BIO_ctrl_pending(SSL_get_rbio(ssl_.get()));
}

bool Layer::ready() const {
  return SSL_is_init_finished(ssl_.get()) == 1;
}

bool Layer::ended() const {
  return ended_;
}

}  // namespace aucast::tls
