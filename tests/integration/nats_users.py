"""Who may use a server of NATS, for server_nats_test.py: NKeys, the JWTs and .creds files of a
decentralised operator, certificates. All of it is made by openssl, in a folder of the test's own.
"""

import base64
import binascii
import itertools
import json
import pathlib
import struct
import subprocess

PREFIXES = {"operator": 14 << 3, "account": 0, "user": 20 << 3}
SEED_PREFIX = 18 << 3
UNLIMITED = {name: -1 for name in ("subs", "data", "payload", "conn", "leaf", "imports", "exports")}
NUMBERS = itertools.count()


def openssl(*arguments):
    return subprocess.run(["openssl", *map(str, arguments)], check=True, capture_output=True).stdout


def base32(raw):
    """An NKey's text: with its checksum, without padding."""
    raw += struct.pack("<H", binascii.crc_hqx(raw, 0))
    return base64.b32encode(raw).rstrip(b"=").decode()


class NKey:
    """An Ed25519 key of an operator, an account or a user."""

    def __init__(self, folder, kind):
        prefix = PREFIXES[kind]
        self.pem = pathlib.Path(folder) / f"{kind}-{next(NUMBERS)}.pem"
        openssl("genpkey", "-algorithm", "ed25519", "-out", self.pem)
        secret = openssl("pkey", "-in", self.pem, "-outform", "DER")[-32:]
        public = openssl("pkey", "-in", self.pem, "-pubout", "-outform", "DER")[-32:]
        self.public = base32(bytes([prefix]) + public)
        self.seed = base32(bytes([SEED_PREFIX | prefix >> 5, (prefix & 31) << 3]) + secret)

    def seed_file(self):
        return write_secret(self.pem.with_suffix(".nk"), self.seed + "\n")

    def says(self, subject, kind, limits):
        """A JWT in which this key vouches for another one."""
        def part(value):
            return base64.urlsafe_b64encode(value).rstrip(b"=")
        claims = {"jti": str(next(NUMBERS)), "iat": 1, "iss": self.public, "sub": subject.public,
                  "name": kind, "nats": {"type": kind, "version": 2, **limits}}
        text = b".".join(part(json.dumps(value).encode()) for value in (
            {"typ": "JWT", "alg": "ed25519-nkey"}, claims))
        signed = self.pem.with_suffix(".jwt")
        signed.write_bytes(text)
        signature = openssl("pkeyutl", "-sign", "-rawin", "-inkey", self.pem, "-in", signed)
        return (text + b"." + part(signature)).decode()


def write_secret(path, text):
    path.touch(0o600)
    path.write_text(text)
    return path


class Operator:
    """An operator with one account, whose users a server knows by what they show."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.operator = NKey(folder, "operator")
        self.account = NKey(folder, "account")
        jwt = self.operator.says(self.operator, "operator", {})
        known = self.operator.says(self.account, "account",
                                   {"limits": {**UNLIMITED, "wildcards": True}})
        self.config = (f'operator: "{jwt}"\nresolver: MEMORY\n'
                       f'resolver_preload {{ {self.account.public}: "{known}" }}')

    def creds(self, account=None):
        """The .creds file of a new user of that account."""
        user = NKey(self.folder, "user")
        jwt = (account or self.account).says(user, "user", {
            "pub": {}, "sub": {}, "subs": -1, "data": -1, "payload": -1})
        return write_secret(user.pem.with_suffix(".creds"), "\n".join((
            "-----BEGIN NATS USER JWT-----", jwt, "------END NATS USER JWT------", "",
            "-----BEGIN USER NKEY SEED-----", user.seed, "------END USER NKEY SEED------", "")))


class Authority:
    """A certificate authority."""

    def __init__(self, folder, name="authority"):
        self.folder = pathlib.Path(folder)
        self.file = self.folder / f"{name}.pem"
        self.key = self.folder / f"{name}.key"
        openssl("req", "-x509", *self.new_key(self.key), "-days", "2", "-subj", f"/CN={name}",
                "-out", self.file)

    @staticmethod
    def new_key(path):
        path.touch(0o600)
        return ("-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256", "-nodes", "-keyout", path)

    def issue(self, names):
        """Certificate and key for these names, such as IP:127.0.0.1."""
        stem = self.folder / f"certificate-{next(NUMBERS)}"
        key = stem.with_suffix(".key")
        certificate = stem.with_suffix(".pem")
        request = stem.with_suffix(".csr")
        openssl("req", "-new", *self.new_key(key), "-subj", "/CN=aucast",
                "-addext", f"subjectAltName={names}", "-out", request)
        openssl("x509", "-req", "-in", request, "-CA", self.file, "-CAkey", self.key, "-days", "2",
                "-CAcreateserial", "-copy_extensions", "copy", "-out", certificate)
        return certificate, key
