#include "tests/support/certificates.h"

#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/x509v3.h>

#include <cstdio>
#include <stdexcept>

namespace aucast::test {
namespace {

constexpr long kDay = 86'400;

void want(bool done) {
  if (!done) throw std::runtime_error("OpenSSL cannot make a certificate");
}

std::shared_ptr<EVP_PKEY> make_key() {
  return {EVP_EC_gen("P-256"), EVP_PKEY_free};
}

void add_extension(X509* certificate, X509* issuer, int kind, const std::string& value) {
  X509V3_CTX context;
  X509V3_set_ctx_nodb(&context);
  X509V3_set_ctx(&context, issuer, certificate, nullptr, nullptr, 0);
  X509_EXTENSION* const extension = X509V3_EXT_conf_nid(nullptr, &context, kind, value.c_str());
  want(extension != nullptr && X509_add_ext(certificate, extension, -1) == 1);
  X509_EXTENSION_free(extension);
}

/// Without signature and extensions.
std::shared_ptr<X509> make_certificate(const std::string& name, EVP_PKEY* key, long serial,
                                       int from_days, int days) {
  std::shared_ptr<X509> certificate(X509_new(), X509_free);
  want(certificate != nullptr);
  X509_set_version(certificate.get(), X509_VERSION_3);
  ASN1_INTEGER_set(X509_get_serialNumber(certificate.get()), serial);
  X509_gmtime_adj(X509_getm_notBefore(certificate.get()), from_days * kDay);
  X509_gmtime_adj(X509_getm_notAfter(certificate.get()), (from_days + days) * kDay);
  X509_set_pubkey(certificate.get(), key);
  const auto* const text = reinterpret_cast<const unsigned char*>(name.c_str());
  X509_NAME_add_entry_by_txt(X509_get_subject_name(certificate.get()), "CN", MBSTRING_ASC, text, -1,
                             -1, 0);
  return certificate;
}

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

std::string write_certificate(const TempFolder& folder, const std::string& name,
                              X509* certificate) {
  const std::string path = (folder.path() / (name + ".pem")).string();
  const File file(std::fopen(path.c_str(), "w"), std::fclose);
  want(file && PEM_write_X509(file.get(), certificate) == 1);
  return path;
}

std::string write_key(const TempFolder& folder, const std::string& name, EVP_PKEY* key) {
  const std::string path = (folder.path() / (name + ".key")).string();
  const File file(std::fopen(path.c_str(), "w"), std::fclose);
  want(file && PEM_write_PrivateKey(file.get(), key, nullptr, nullptr, 0, nullptr, nullptr) == 1);
  return path;
}

}  // namespace

Authority::Authority(const std::string& name) : key_(make_key()) {
  certificate_ = make_certificate(name, key_.get(), serial_++, -400, 800);
  X509* const own = certificate_.get();
  X509_set_issuer_name(own, X509_get_subject_name(own));
  add_extension(own, own, NID_basic_constraints, "critical,CA:TRUE");
  want(X509_sign(own, key_.get(), EVP_sha256()) > 0);
  file_ = write_certificate(folder_, name, own);
}

Authority::~Authority() = default;

Certificate Authority::issue(const std::string& name, const std::string& names, int from_days,
                             int days) {
  const auto key = make_key();
  const auto certificate = make_certificate(name, key.get(), serial_++, from_days, days);
  X509_set_issuer_name(certificate.get(), X509_get_subject_name(certificate_.get()));
  add_extension(certificate.get(), certificate_.get(), NID_subject_alt_name, names);
  want(X509_sign(certificate.get(), key_.get(), EVP_sha256()) > 0);
  return {write_certificate(folder_, name, certificate.get()), write_key(folder_, name, key.get())};
}

std::string Authority::file_with_revoked(const Certificate& revoked, int days) const {
  const File in(std::fopen(revoked.file.c_str(), "r"), std::fclose);
  const std::shared_ptr<X509> certificate(
      in ? PEM_read_X509(in.get(), nullptr, nullptr, nullptr) : nullptr, X509_free);
  const std::shared_ptr<ASN1_TIME> from(X509_gmtime_adj(nullptr, -20 * kDay), ASN1_TIME_free);
  const std::shared_ptr<ASN1_TIME> to(X509_gmtime_adj(nullptr, days * kDay), ASN1_TIME_free);
  const std::shared_ptr<X509_CRL> list(X509_CRL_new(), X509_CRL_free);
  X509_REVOKED* const entry = X509_REVOKED_new();
  want(certificate && from && to && list && entry != nullptr);
  X509_REVOKED_set_serialNumber(entry, X509_get_serialNumber(certificate.get()));
  X509_REVOKED_set_revocationDate(entry, from.get());
  X509_CRL_set_version(list.get(), X509_CRL_VERSION_2);
  X509_CRL_set_issuer_name(list.get(), X509_get_subject_name(certificate_.get()));
  X509_CRL_set1_lastUpdate(list.get(), from.get());
  X509_CRL_set1_nextUpdate(list.get(), to.get());
  want(X509_CRL_add0_revoked(list.get(), entry) == 1);
  want(X509_CRL_sign(list.get(), key_.get(), EVP_sha256()) > 0);

  const std::string path = write_certificate(folder_, "with_revoked", certificate_.get());
  const File out(std::fopen(path.c_str(), "a"), std::fclose);
  want(out && PEM_write_X509_CRL(out.get(), list.get()) == 1);
  return path;
}

}  // namespace aucast::test
