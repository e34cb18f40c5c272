#include "common/tls/context.h"

#include <openssl/err.h>
#include <openssl/ssl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <utility>

#include "common/text.h"

namespace aucast::tls {
namespace {

/// The first cause that OpenSSL noted, which is the one nearest to the trouble.
std::string cause_and_clear() {
  const unsigned long code = ERR_get_error();
  ERR_clear_error();
  const char* const reason = code == 0 ? nullptr : ERR_reason_error_string(code);
  return reason == nullptr ? "no cause is known" : reason;
}

Result<void> readable(const std::filesystem::path& path, const std::string& what) {
  if (::access(path.c_str(), R_OK) == 0) return {};
  return Error{ErrorKind::Unreadable,
               path.string() + ": cannot be read: " + system_reason(errno) + " (" + what + ")"};
}

Error bad_file(const std::filesystem::path& path, const std::string& what) {
  return {ErrorKind::BadData, path.string() + ": " + what + ": " + cause_and_clear()};
}

Result<void> use_own(SSL_CTX* context, const Files& files) {
  if (auto can = readable(files.certificate, "--tls-cert"); !can) return can;
  if (auto can = readable(files.key, "--tls-key"); !can) return can;
  if (SSL_CTX_use_certificate_chain_file(context, files.certificate.c_str()) != 1) {
    return bad_file(files.certificate, "is no certificate in PEM form");
  }
  if (SSL_CTX_use_PrivateKey_file(context, files.key.c_str(), SSL_FILETYPE_PEM) != 1) {
    return bad_file(files.key, "is no key of " + files.certificate.string() + " in PEM form");
  }
  return {};
}

Result<void> believe(SSL_CTX* context, const std::filesystem::path& authorities,
                     const std::string& option) {
  if (auto can = readable(authorities, option); !can) return can;
  if (SSL_CTX_load_verify_file(context, authorities.c_str()) != 1) {
    return bad_file(authorities, "holds no certificates in PEM form");
  }
  return {};
}

/// A key that wants a pass phrase must not stop a service at a prompt.
int no_pass_phrase(char*, int, int, void*) {
  return 0;
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

Result<Context> Context::for_server(const Files& files) {
  auto context = make(TLS_server_method());
  if (!context) return no_library();
  SSL_CTX_set_options(context.get(), SSL_OP_CIPHER_SERVER_PREFERENCE);
  if (auto own = use_own(context.get(), files); !own) return own.error();
  if (!files.authorities.empty()) {
    if (auto can = believe(context.get(), files.authorities, "--tls-client-ca"); !can) {
      return can.error();
    }
    SSL_CTX_set_client_CA_list(context.get(), SSL_load_client_CA_file(files.authorities.c_str()));
    SSL_CTX_set_verify(context.get(), SSL_VERIFY_PEER | SSL_VERIFY_FAIL_IF_NO_PEER_CERT, nullptr);
  }
  return Context(std::move(context), true);
}

Result<Context> Context::for_client(const Files& files) {
  auto context = make(TLS_client_method());
  if (!context) return no_library();
  if (files.authorities.empty()) {
    if (SSL_CTX_set_default_verify_paths(context.get()) != 1) return no_library();
  } else if (auto can = believe(context.get(), files.authorities, "--tls-ca"); !can) {
    return can.error();
  }
  if (!files.certificate.empty()) {
    if (auto own = use_own(context.get(), files); !own) return own.error();
  }
  SSL_CTX_set_verify(context.get(), SSL_VERIFY_PEER, nullptr);
  return Context(std::move(context), false);
}

}  // namespace aucast::tls
