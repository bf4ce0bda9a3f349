"""The certificate for HTTPS in a local network: made and kept while it fits, or the user's own."""

from __future__ import annotations

import os
import socket
import ssl
from base64 import urlsafe_b64encode
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from hashlib import blake2b
from pathlib import Path
from tempfile import mkstemp

import trustme
from cryptography import x509
from cryptography.hazmat.primitives.hashes import SHA256

from scenegen_core.errors import SceneGenError

LIFETIME = timedelta(days=396)  # browsers refuse more than 398 (CA/Browser Forum, ballot SC31)
SLOW_CLOCK = timedelta(days=1)  # how far behind the clock of a phone may be
RENEWED = timedelta(days=7)  # before the end, so that no evening ends with an expired one
TOKEN_BYTES = 15  # 120 bits, 20 characters


@dataclass(frozen=True, slots=True)
class Certificate:
    """A certificate with its key, found usable."""

    cert: Path
    """PEM, the server's own certificate first."""
    key: Path
    names: tuple[str, ...]
    """The DNS names and addresses that it is for."""
    ends: datetime
    fingerprint: str
    """SHA-256, as browsers show it: ``AB:CD:…``."""

    @property
    def token(self) -> str:
        """What people from outside of this machine join with; as secret as the key it is of."""
        data = self.key.read_bytes()
        digest = blake2b(data, digest_size=TOKEN_BYTES, person=b"scenegen join").digest()
        return urlsafe_b64encode(digest).decode()


def kept_certificate(path: Path, names: Sequence[str], *, now: datetime) -> Certificate:
    """The certificate in the file, or a new one there if it does not fit any more.

    Args:
        path: One file for key and certificate that only its owner may read.
        names: DNS names and addresses that the server is reached by.
        now: The time.

    Raises:
        SceneGenError: The file cannot be written.
    """
    # Addresses of IPv6 change every day where privacy is on; they are no reason to warn again.
    lasting = {name for name in names if ":" not in name}
    try:
        kept = read_certificate(path, path, now=now + RENEWED)
        if lasting <= set(kept.names):
            return kept
    except SceneGenError:
        pass  # none yet, or of no use any more
    try:
        _write_private(path, _made(names, now))
    except OSError as error:
        raise SceneGenError(
            f"The certificate cannot be kept in {path}: {error.strerror}. "
            "Choose another directory with --store."
        ) from None
    return read_certificate(path, path, now=now)


def read_certificate(cert: Path, key: Path, *, now: datetime) -> Certificate:
    """A certificate and its key, both PEM; SceneGenError if a server cannot use them."""
    try:
        context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
        context.load_cert_chain(cert, key, password=str)  # a locked key fails, nobody is asked
        first = x509.load_pem_x509_certificates(cert.read_bytes())[0]
    except (OSError, ValueError) as error:  # SSLError is an OSError
        raise SceneGenError(
            f"The certificate {cert} with the key {key} cannot be used ({error}). Both must be "
            "PEM files that belong together, the key without a password."
        ) from None
    ends = first.not_valid_after_utc
    if ends < now:
        raise SceneGenError(f"The certificate {cert} ended on {ends:%d %B %Y}; get a new one.")
    return Certificate(cert, key, _names(first), ends, first.fingerprint(SHA256()).hex(":").upper())


def _names(cert: x509.Certificate) -> tuple[str, ...]:
    try:
        names = cert.extensions.get_extension_for_class(x509.SubjectAlternativeName).value
    except x509.ExtensionNotFound:
        return ()
    dns = names.get_values_for_type(x509.DNSName)
    return (*dns, *(str(ip) for ip in names.get_values_for_type(x509.IPAddress)))


def _made(names: Sequence[str], now: datetime) -> bytes:
    """Key and certificate. The authority that signs it is forgotten: it can sign nothing else."""
    begins = now.astimezone(UTC) - SLOW_CLOCK
    made = trustme.CA(organization_name="SceneGen").issue_cert(
        *names,
        organization_name="SceneGen",
        organization_unit_name=socket.gethostname()[:64],  # the most that X.509 allows
        not_before=begins,
        not_after=begins + LIFETIME,
    )
    return made.private_key_and_cert_chain_pem.bytes()


def _write_private(path: Path, data: bytes) -> None:
    """Write a file that nobody else can read at any moment."""
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, name = mkstemp(dir=path.parent, prefix=".certificate-")  # mode 0600
    with os.fdopen(handle, "wb") as file:
        file.write(data)
    Path(name).replace(path)
