#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/result.h"

struct ssl_ctx_st;

namespace aucast::tls {

/// PEM files; which of them are needed depends on the side.
struct Files {
  std::filesystem::path certificate;  ///< our own, followed by those of the authorities in between
  std::filesystem::path key;          ///< of the certificate
  std::filesystem::path authorities;  ///< one of these must have issued the peer's certificate; if
                                      ///< the file has any revocation lists, it must have the
                                      ///< issuer's, up to date and not listing that certificate
  friend bool operator==(const Files&, const Files&) = default;
};

/// What all TLS connections of one side have in common: TLS 1.2 or later, our certificate, the
/// authorities that we trust. Cheap to copy; connections keep the context that they began with, so
/// it can be replaced at any time.
class Context {
 public:
  /// Needs certificate and key. With `authorities`, clients must show a certificate that one of the
  /// authorities has issued. Fails with Unreadable or BadData and a message that names the file and
  /// the cause. `options`: for messages, how the names of the options for the files begin.
  [[nodiscard]] static Result<Context> for_server(const Files& files,
                                                  const std::string& options = "--tls");
  /// Without `authorities` the system's are trusted. Certificate and key are for servers that ask
  /// for a client certificate.
  [[nodiscard]] static Result<Context> for_client(const Files& files,
                                                  const std::string& options = "--tls");

  /// The DNS names that our own certificate is for; they may be like "*.example.org".
  [[nodiscard]] std::vector<std::string> names() const;
  /// A sentence for the log when other users have access to the key; else empty.
  [[nodiscard]] const std::string& warning() const { return warning_; }

 private:
  friend class Layer;
  Context(std::shared_ptr<ssl_ctx_st> context, bool server, std::string authorities_option,
          std::string warning)
      : context_(std::move(context)),
        server_(server),
        authorities_option_(std::move(authorities_option)),
        warning_(std::move(warning)) {}

  std::shared_ptr<ssl_ctx_st> context_;
  bool server_;
  std::string authorities_option_;  ///< the option that names the authorities
  std::string warning_;
};

}  // namespace aucast::tls
