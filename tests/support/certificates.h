#pragma once

#include <memory>
#include <string>

#include "tests/support/temp_folder.h"

struct x509_st;
struct evp_pkey_st;

namespace aucast::test {

/// The files of a certificate and its key.
struct Certificate {
  std::string file;
  std::string key;
};

/// A certificate authority that is made for a test; its files are removed with the object.
class Authority {
 public:
  explicit Authority(const std::string& name = "authority");
  ~Authority();
  Authority(const Authority&) = delete;
  Authority& operator=(const Authority&) = delete;

  /// The file of the authority's own certificate, for those who are to trust the authority.
  [[nodiscard]] const std::string& file() const { return file_; }
  /// A certificate for `names`, in OpenSSL's form (DNS:localhost,IP:127.0.0.1), valid for `days`
  /// days, beginning `from_days` days from now.
  [[nodiscard]] Certificate issue(const std::string& name, const std::string& names,
                                  int from_days = -1, int days = 30);
  /// As file(), with the authority's list of revoked certificates, which holds `revoked` and is up
  /// to date for `days` days.
  [[nodiscard]] std::string file_with_revoked(const Certificate& revoked, int days = 30) const;

 private:
  TempFolder folder_;
  std::shared_ptr<evp_pkey_st> key_;
  std::shared_ptr<x509_st> certificate_;
  std::string file_;
  long serial_ = 1;
};

}  // namespace aucast::test
