"""The certificate for phones in the same network."""

from __future__ import annotations

import ssl
import stat
import subprocess
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest

from scenegen_core.errors import SceneGenError
from server.certificate import kept_certificate, read_certificate
from server.network import lan_names

NOW = datetime.now(UTC)
NAMES = ("192.168.1.5", "fd00::5", "laptop", "laptop.local", "localhost", "127.0.0.1", "::1")


def openssl(*arguments: str) -> str:
    return subprocess.run(
        ["openssl", *arguments], check=True, capture_output=True, text=True
    ).stdout


def test_it_is_for_every_name_and_address(tmp_path: Path) -> None:
    file = tmp_path / "own.pem"
    assert set(kept_certificate(file, NAMES, now=NOW).names) == set(NAMES)
    for name in NAMES:
        kind = "-checkip" if ":" in name or name[0].isdigit() else "-checkhost"
        said = openssl("x509", "-in", str(file), "-noout", kind, name)
        assert "does match" in said, name


def test_it_lasts_no_longer_than_browsers_accept(tmp_path: Path) -> None:
    file = tmp_path / "own.pem"
    kept_certificate(file, NAMES, now=NOW)
    dates = openssl("x509", "-in", str(file), "-noout", "-dates").splitlines()
    begins, ends = (ssl.cert_time_to_seconds(line.partition("=")[2]) for line in dates)
    assert begins < NOW.timestamp() < ends
    assert ends - begins < 397 * 86400


def test_only_its_owner_can_read_the_key(tmp_path: Path) -> None:
    file = tmp_path / "var" / "own.pem"
    kept_certificate(file, NAMES, now=NOW)
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    assert list(file.parent.iterdir()) == [file]


def test_it_is_kept_while_it_fits(tmp_path: Path) -> None:
    file = tmp_path / "own.pem"
    first = kept_certificate(file, NAMES, now=NOW)
    fewer = tuple(name for name in NAMES if name != "laptop.local")
    assert kept_certificate(file, fewer, now=NOW + timedelta(days=300)) == first
    other_ipv6 = (*NAMES, "fd00::1234")  # changes from day to day; nobody types it
    assert kept_certificate(file, other_ipv6, now=NOW) == first


def test_another_address_needs_another_one_with_another_token(tmp_path: Path) -> None:
    file = tmp_path / "own.pem"
    first = kept_certificate(file, NAMES, now=NOW)
    token = first.token
    second = kept_certificate(file, (*NAMES, "10.0.0.7"), now=NOW)
    assert "10.0.0.7" in second.names
    assert second.fingerprint != first.fingerprint
    assert second.token != token


def test_it_is_renewed_before_it_ends(tmp_path: Path) -> None:
    file = tmp_path / "own.pem"
    first = kept_certificate(file, NAMES, now=NOW)
    day_before = first.ends - timedelta(days=1)
    renewed = kept_certificate(file, NAMES, now=day_before)
    assert renewed.ends > first.ends + timedelta(days=300)


@pytest.mark.parametrize("content", [b"", b"Dear diary", b"-----BEGIN CERTIFICATE-----\nAAAA"])
def test_a_damaged_one_is_made_again(tmp_path: Path, content: bytes) -> None:
    file = tmp_path / "own.pem"
    file.write_bytes(content)
    file.chmod(0o644)
    assert "localhost" in kept_certificate(file, NAMES, now=NOW).names
    assert stat.S_IMODE(file.stat().st_mode) == 0o600


def test_the_fingerprint_is_the_one_that_others_see(tmp_path: Path) -> None:
    file = tmp_path / "own.pem"
    mine = kept_certificate(file, NAMES, now=NOW).fingerprint
    seen = openssl("x509", "-in", str(file), "-noout", "-fingerprint", "-sha256")
    assert seen.strip().partition("=")[2] == mine


def test_the_token_is_kept_with_the_key_and_long_enough(tmp_path: Path) -> None:
    file = tmp_path / "own.pem"
    token = kept_certificate(file, NAMES, now=NOW).token
    assert kept_certificate(file, NAMES, now=NOW).token == token
    assert len(token) == 20  # of 64 letters each: 120 bits
    assert token not in file.read_text()


def test_a_place_where_it_cannot_be_kept_is_named() -> None:
    with pytest.raises(SceneGenError, match=r"cannot be kept in /proc/own\.pem.*--store"):
        kept_certificate(Path("/proc/own.pem"), NAMES, now=NOW)


def made_with_openssl(directory: Path, *, days: int = 30, password: str = "") -> tuple[Path, Path]:
    """A certificate of the user's own, by openssl: an RSA key, a name and no address."""
    cert, key = directory / "cert.pem", directory / "key.pem"
    lock = ("-passout", f"pass:{password}") if password else ("-nodes",)
    subject = ("-subj", "/CN=me", "-addext", "subjectAltName=DNS:me.example.net")
    made = ("-newkey", "rsa:2048", "-days", str(days), "-out", str(cert), "-keyout", str(key))
    openssl("req", "-x509", *lock, *subject, *made)
    return cert, key


def test_a_user_can_bring_their_own(tmp_path: Path) -> None:
    cert, key = made_with_openssl(tmp_path)
    mine = read_certificate(cert, key, now=NOW)
    assert mine.names == ("me.example.net",)
    assert mine.token != ""


def test_one_that_cannot_be_used_is_refused_in_words(tmp_path: Path) -> None:
    cert, key = made_with_openssl(tmp_path)
    with pytest.raises(SceneGenError, match=r"ended on \d+ \w+ 20\d\d; get a new one"):
        read_certificate(cert, key, now=NOW + timedelta(days=31))
    with pytest.raises(SceneGenError, match="belong together"):
        read_certificate(cert, cert, now=NOW)
    with pytest.raises(SceneGenError, match="nowhere"):
        read_certificate(tmp_path / "nowhere", key, now=NOW)


def test_a_key_with_a_password_asks_nobody(tmp_path: Path) -> None:
    cert, key = made_with_openssl(tmp_path, password="secret")
    with pytest.raises(SceneGenError, match="without a password"):
        read_certificate(cert, key, now=NOW)


def test_this_machine_is_always_among_the_names() -> None:
    assert {"localhost", "127.0.0.1", "::1"} <= set(lan_names())
