"""What this machine is called in its networks."""

from __future__ import annotations

import re
import socket
from ipaddress import ip_address

import ifaddr

EVERYWHERE = "::" if socket.has_dualstack_ipv6() else "0.0.0.0"  # noqa: S104 (only with --lan)
ANY = ("0.0.0.0", "::")  # noqa: S104 (only compared with)
ELSEWHERE = ("203.0.113.1", 9)  # documentation address (RFC 5737); nothing is sent to it
HOST_NAME = re.compile(r"[A-Za-z0-9]([A-Za-z0-9-]{0,61}[A-Za-z0-9])?")  # one label (RFC 1123)


def lan_names() -> tuple[str, ...]:
    """What this machine is reached by: addresses, the likeliest first, then its names."""
    own = [ip_address(_text(ip.ip)) for card in ifaddr.get_adapters() for ip in card.ips]
    reached = [str(ip) for ip in own if not (ip.is_loopback or ip.is_link_local)]
    outward = _outward_address()
    reached.sort(key=lambda name: (name != outward, ":" in name))
    host = socket.gethostname().partition(".")[0]
    named = [host, f"{host}.local"] if HOST_NAME.fullmatch(host) else []
    return tuple(dict.fromkeys([*reached, *named, "localhost", "127.0.0.1", "::1"]))


def _text(address: str | tuple[str, int, int]) -> str:
    """The address that ifaddr gives, which is a tuple for IPv6."""
    return address if isinstance(address, str) else address[0]


def _outward_address() -> str:
    """This machine's address on the way to all others; "" without a network."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect(ELSEWHERE)
        except OSError:
            return ""
        address: str = probe.getsockname()[0]
        return address
