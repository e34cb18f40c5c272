#include "common/tls/context.h"

#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>

#include <string_view>
#include <utility>

#include "common/files.h"
#include "common/text.h"

namespace aucast::tls {
namespace {

/// More than all authorities of a system take.
constexpr std::size_t kPemBytesMax = std::size_t{4} << 20U;

/// The first cause that OpenSSL noted, which is the one nearest to the trouble.
std::string cause_and_clear() {
  const unsigned long code = ERR_get_error();
  ERR_clear_error();
  const char* const reason = code == 0 ? nullptr : ERR_reason_error_string(code);
  return reason == nullptr ? "no cause is known" : reason;
}

/// Files are read as all others are and OpenSSL gets bytes: it would wait for a FIFO.
using Bio = std::unique_ptr<BIO, decltype(&BIO_free)>;

Bio bio_of(std::string_view bytes) {
  return {BIO_new_mem_buf(bytes.data(), static_cast<int>(bytes.size())), BIO_free};
}

/// `option`: the option that named the file.
Error with_option(const Error& error, std::string_view option) {
  return {error.kind, error.message + " (" + std::string(option) + ")"};
}

Error bad_file(const std::filesystem::path& path, const std::string& what) {
  return {ErrorKind::BadData, at_place(path.string(), what + ": " + cause_and_clear())};
}

/// A key that wants a pass phrase must not stop a service at a prompt.
int no_pass_phrase(char*, int, int, void*) {
  return 0;
}

/// Our own certificate, then those of its authorities.
bool use_chain(SSL_CTX* context, BIO* pem) {
  using Certificate = std::unique_ptr<X509, decltype(&X509_free)>;
  const Certificate own(PEM_read_bio_X509_AUX(pem, nullptr, no_pass_phrase, nullptr), X509_free);
  if (own == nullptr || SSL_CTX_use_certificate(context, own.get()) != 1) return false;
  for (;;) {
    X509* const next = PEM_read_bio_X509(pem, nullptr, no_pass_phrase, nullptr);
    if (next == nullptr) break;
    if (SSL_CTX_add0_chain_cert(context, next) != 1) {
      X509_free(next);
      return false;
    }
  }
  // The end of the file looks like a missing certificate; anything else is one that is broken.
  const unsigned long end = ERR_peek_last_error();
  if (ERR_GET_LIB(end) != ERR_LIB_PEM || ERR_GET_REASON(end) != PEM_R_NO_START_LINE) return false;
  ERR_clear_error();
  return true;
}

bool use_key(SSL_CTX* context, BIO* pem) {
  EVP_PKEY* const key = PEM_read_bio_PrivateKey(pem, nullptr, no_pass_phrase, nullptr);
  const bool used = key != nullptr && SSL_CTX_use_PrivateKey(context, key) == 1;
  EVP_PKEY_free(key);
  return used;
}

/// The warning about the key's file; empty: none.
Result<std::string> use_own(SSL_CTX* context, const Files& files, const std::string& options) {
  const auto certificate = read_file(files.certificate, kPemBytesMax);
  if (!certificate) return with_option(certificate.error(), options + "-cert");
  const auto key = read_secret_file(files.key, kPemBytesMax);
  if (!key) return with_option(key.error(), options + "-key");
  if (!use_chain(context, bio_of(*certificate).get())) {
    return bad_file(files.certificate, "is no certificate in PEM form");
  }
  if (!use_key(context, bio_of(key->bytes).get())) {
    return bad_file(files.key,
                    "is no key of " + printable(files.certificate.string()) + " in PEM form");
  }
  if (!key->open_to_others) return std::string();
  return at_place(files.key.string(), "other users have access to the private key (chmod 600)");
}

/// Certificates and revocation lists that peers are checked with; servers name the certificates to
/// their clients. If there is any list, the peer's own certificate is looked up in that of its
/// issuer, which must be there and up to date. The certificates of authorities in between are not
/// looked up: the lists of their issuers are seldom at hand.
Result<void> believe(SSL_CTX* context, const std::filesystem::path& authorities,
                     std::string_view option, bool name_them) {
  const auto bytes = read_file(authorities, kPemBytesMax);
  if (!bytes) return with_option(bytes.error(), option);
  const auto free_all = [](STACK_OF(X509_INFO) * all) {
    sk_X509_INFO_pop_free(all, X509_INFO_free);
  };
  const std::unique_ptr<STACK_OF(X509_INFO), decltype(free_all)> all(
      PEM_X509_INFO_read_bio(bio_of(*bytes).get(), nullptr, no_pass_phrase, nullptr), free_all);
  X509_STORE* const store = SSL_CTX_get_cert_store(context);
  int certificates = 0;
  bool lists = false;
  for (int i = 0; i < sk_X509_INFO_num(all.get()); ++i) {
    const X509_INFO* const info = sk_X509_INFO_value(all.get(), i);
    if (info->crl != nullptr) {
      lists = true;
      X509_STORE_add_crl(store, info->crl);
    }
    if (info->x509 == nullptr || X509_STORE_add_cert(store, info->x509) != 1) continue;
    if (name_them) SSL_CTX_add_client_CA(context, info->x509);
    ++certificates;
  }
  if (certificates == 0) return bad_file(authorities, "holds no certificates in PEM form");
  // Also if a list could not be added: that must let nobody in.
  if (lists) X509_STORE_set_flags(store, X509_V_FLAG_CRL_CHECK);
  ERR_clear_error();
  return {};
}

std::shared_ptr<SSL_CTX> make(const SSL_METHOD* method) {
  ERR_clear_error();
  std::shared_ptr<SSL_CTX> context(SSL_CTX_new(method), SSL_CTX_free);
  if (!context) return nullptr;
  SSL_CTX_set_min_proto_version(context.get(), TLS1_2_VERSION);
  SSL_CTX_set_options(context.get(), SSL_OP_NO_RENEGOTIATION | SSL_OP_NO_COMPRESSION |
                                         SSL_OP_IGNORE_UNEXPECTED_EOF);
  // A connection that says little keeps no 32 KiB for it.
  SSL_CTX_set_mode(context.get(), SSL_MODE_RELEASE_BUFFERS);
  // Sessions are not taken up again: tickets would cost a thin link more than they save.
  SSL_CTX_set_session_cache_mode(context.get(), SSL_SESS_CACHE_OFF);
  SSL_CTX_set_num_tickets(context.get(), 0);
  SSL_CTX_set_default_passwd_cb(context.get(), no_pass_phrase);
  return context;
}

Error no_library() {
  return {ErrorKind::Failed, "the TLS library cannot be used: " + cause_and_clear()};
}

}  // namespace

Result<Context> Context::for_server(const Files& files, const std::string& options) {
  auto context = make(TLS_server_method());
  if (!context) return no_library();
  SSL_CTX_set_options(context.get(), SSL_OP_CIPHER_SERVER_PREFERENCE);
  auto warning = use_own(context.get(), files, options);
  if (!warning) return warning.error();
  if (!files.authorities.empty()) {
    auto believed = believe(context.get(), files.authorities, "--tls-client-ca", true);
    if (!believed) return believed.error();
    SSL_CTX_set_verify(context.get(), SSL_VERIFY_PEER | SSL_VERIFY_FAIL_IF_NO_PEER_CERT, nullptr);
  }
  return Context(std::move(context), true, "--tls-client-ca", std::move(*warning));
}

std::vector<std::string> Context::names() const {
  std::vector<std::string> names;
  const X509* const own = SSL_CTX_get0_certificate(context_.get());
  if (own == nullptr) return names;
  const std::unique_ptr<GENERAL_NAMES, decltype(&GENERAL_NAMES_free)> all(
      static_cast<GENERAL_NAMES*>(X509_get_ext_d2i(own, NID_subject_alt_name, nullptr, nullptr)),
      GENERAL_NAMES_free);
  for (int i = 0; i < sk_GENERAL_NAME_num(all.get()); ++i) {
    const GENERAL_NAME* const name = sk_GENERAL_NAME_value(all.get(), i);
    if (name->type != GEN_DNS) continue;
    const auto* const text = reinterpret_cast<const char*>(ASN1_STRING_get0_data(name->d.dNSName));
    names.emplace_back(text, static_cast<std::size_t>(ASN1_STRING_length(name->d.dNSName)));
  }
  return names;
}

Result<Context> Context::for_client(const Files& files, const std::string& options) {
  auto context = make(TLS_client_method());
  if (!context) return no_library();
  if (files.authorities.empty()) {
    if (SSL_CTX_set_default_verify_paths(context.get()) != 1) return no_library();
  } else if (auto believed = believe(context.get(), files.authorities, options + "-ca", false);
             !believed) {
    return believed.error();
  }
  Result<std::string> warning = std::string();
  if (!files.certificate.empty()) warning = use_own(context.get(), files, options);
  if (!warning) return warning.error();
  SSL_CTX_set_verify(context.get(), SSL_VERIFY_PEER, nullptr);
  return Context(std::move(context), false, options + "-ca", std::move(*warning));
}

}  // namespace aucast::tls
