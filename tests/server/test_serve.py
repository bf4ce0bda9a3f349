"""``scenegen serve`` as a program: starts, says what it has, stops."""

from __future__ import annotations

import re
import signal
import socket
import ssl
from email.message import Message
from pathlib import Path
from urllib.error import HTTPError
from urllib.request import Request, urlopen

import pytest
from websockets.sync.client import connect
from websockets.typing import Origin, Subprotocol

from server.cli import main
from server.commands.serve import listen
from server.protocol import SUBPROTOCOL, Ack, Hello, Models, PutBoxes, Welcome
from tests.server.driving import TABLE, Page, page, started


@pytest.mark.parametrize("signum", [signal.SIGINT, signal.SIGTERM])
def test_it_says_what_it_has_serves_and_stops_without_a_complaint(
    page_files: Path, tmp_path: Path, signum: signal.Signals
) -> None:
    options = ("--port", "0", "--store", str(tmp_path / "store"), "--page", str(page_files))
    with started(*options) as (process, printed):
        assert re.search(r"Knowledge: \d+ examples from \d+ rooms", printed)
        assert "Rooms to open: 2" in printed
        assert "this machine only" in printed
        assert "make run LAN=1" in printed
        found = re.search(r"http://(127\.0\.0\.1:\d+)", printed)
        assert found is not None
        with page(f"ws://{found[1]}") as here:
            here.open()
            process.send_signal(signum)
            out, err = process.communicate()
    assert process.returncode == 0
    assert "kept" in out
    assert err == ""


@pytest.fixture
def options(page_files: Path, tmp_path: Path) -> tuple[str, ...]:
    store = str(tmp_path / "var" / "store")
    return ("--port", "0", "--store", store, "--page", str(page_files))


def test_several_processes_serve_one_store(options: tuple[str, ...]) -> None:
    """Whichever process a socket comes to, the session goes on, and its models are there."""
    with started("--workers", "2", *options) as (process, printed):
        found = re.search(r"http://(127\.0\.0\.1:\d+)", printed)
        assert found is not None
        with page(f"ws://{found[1]}") as here:
            session = here.open().session
            here.until(Ack)
            (digest,) = here.until(Models).boxes.values()
        for revision in range(1, 9):
            with page(f"ws://{found[1]}") as here:
                here.send(Hello(session=session, revision=revision))
                assert here.until(Welcome).revision == revision
                here.send(PutBoxes(seq=1, boxes=(TABLE,)))
                assert here.until(Ack).revision == revision + 1
            for name in (f"assets/{digest}.glb", f"usdz/{digest}.usdz"):
                with urlopen(f"http://{found[1]}/{name}") as response:
                    assert response.status == 200
        process.send_signal(signal.SIGTERM)
        out, err = process.communicate()
    assert (process.returncode, err) == (0, "")
    assert "kept" in out


def test_no_process_at_all_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["serve", "--workers", "0"])
    assert "--workers" in capsys.readouterr().err


def test_phones_join_over_https_with_the_token_that_is_printed(
    options: tuple[str, ...], tmp_path: Path
) -> None:
    with started("--lan", *options) as (process, printed):
        port, token = re.search(r"https://localhost:(\d+)", printed), re.search(r"/#(\S+)", printed)
        assert port is not None
        assert token is not None
        trusting = trusting_only(tmp_path / "var" / "certificate.pem")
        address = f"https://localhost:{port[1]}"
        assert "SceneGen" in fetched(f"{address}/", trusting)[1]
        elsewhere = {"Host": "laptop.local"}  # as if another machine had asked
        assert fetched(f"{address}/", trusting, elsewhere)[0] == 403
        known = {**elsewhere, "Cookie": f"scenegen-join={token[1]}"}
        assert fetched(f"{address}/", trusting, known)[0] == 200
        with connect(
            f"wss://localhost:{port[1]}/socket",
            ssl=trusting,
            origin=Origin(address),
            subprotocols=[Subprotocol(SUBPROTOCOL)],
            proxy=None,
        ) as socket:
            Page(socket).open()
        process.send_signal(signal.SIGINT)
        assert process.communicate()[1] == ""


def trusting_only(certificate: Path) -> ssl.SSLContext:
    """As a phone whose owner said yes to this certificate; names are still checked."""
    context = ssl.create_default_context(cafile=certificate)
    context.verify_flags |= ssl.VERIFY_X509_PARTIAL_CHAIN
    return context


def fetched(
    url: str, context: ssl.SSLContext | None = None, headers: dict[str, str] | None = None
) -> tuple[int, str, Message]:
    """Status, text and headers of the answer."""
    try:
        answer = urlopen(Request(url, headers=headers or {}), context=context)
    except HTTPError as error:
        answer = error
    with answer:
        return answer.status, answer.read().decode(), answer.headers


def test_a_page_without_encryption_explains_the_warning_and_says_no_more(
    options: tuple[str, ...],
) -> None:
    with started("--lan", *options) as (process, printed):
        guide = re.search(r"http://\S+:(\d+)/#(\S+)", printed)
        port = re.search(r"https://localhost:(\d+)", printed)
        assert guide is not None
        assert port is not None
        _, text, headers = fetched(f"http://localhost:{guide[1]}/")
        assert "not private" in text
        assert f":{port[1]}/" in text
        assert guide[2] not in text
        assert "default-src 'none'" in headers["content-security-policy"]
        for path in ("rooms", "socket", "?join=" + guide[2]):
            assert fetched(f"http://localhost:{guide[1]}/{path}")[1] == text
        with socket.create_connection(("localhost", int(guide[1]))):  # as browsers do, to be ready
            process.send_signal(signal.SIGINT)
            assert process.communicate()[1] == ""


def test_the_address_stays_the_same_over_a_restart(options: tuple[str, ...]) -> None:
    tokens, fingerprints = set(), set()
    for _ in range(2):
        with started("--lan", *options) as (_, printed):
            tokens |= set(re.findall(r"/#(\S+)", printed))
            fingerprints |= set(re.findall(r"SHA-256\): (\S+)", printed))
    assert len(tokens) == 1
    assert len(fingerprints) == 1


def test_a_key_without_its_certificate_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["serve", "--lan", "--key", "key.pem"]) == 2
    assert "--cert FILE" in capsys.readouterr().err


def test_a_server_for_all_without_https_asks_for_the_token(options: tuple[str, ...]) -> None:
    with started("--host", "0.0.0.0", *options) as (_, printed):
        found = re.search(r"http://\S+:(\d+)/\?join=(\S+)", printed)
        assert found is not None
        address, stranger = f"http://localhost:{found[1]}/", {"Host": "laptop"}
        assert fetched(address, headers=stranger)[0] == 403
        known = {**stranger, "Cookie": f"scenegen-join={found[2]}"}
        assert fetched(address, headers=known)[0] == 200


def test_no_message_waits_for_the_one_before_it_to_be_acknowledged() -> None:
    with (
        listen("127.0.0.1", 0) as listener,
        socket.create_connection(listener.getsockname()),
        listener.accept()[0] as accepted,
    ):
        assert accepted.getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY) != 0


def test_a_taken_port_gives_a_sentence(
    page_files: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        store = str(tmp_path / "store")
        code = main(["serve", "--port", str(port), "--store", store, "--page", str(page_files)])
    assert code == 2
    text = capsys.readouterr().err
    assert text.startswith(f"scenegen: Port {port} of 127.0.0.1 cannot be used")
    assert f"--port {port + 1}" in text


@pytest.mark.parametrize(
    ("option", "value"), [("--knowledge", "gone.npz"), ("--store", "/proc/nowhere/store")]
)
def test_what_cannot_be_used_is_named(
    page_files: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], option: str, value: str
) -> None:
    store = ["--store", str(tmp_path / "store")]
    code = main(["serve", "--port", "0", "--page", str(page_files), *store, option, value])
    assert code == 2
    assert value in capsys.readouterr().err


@pytest.mark.parametrize("port", ["70000", "-1", "http"])
def test_what_is_no_port_is_refused(port: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["serve", "--port", port])
    assert f"--port: invalid port value: '{port}'" in capsys.readouterr().err


def test_each_command_is_listed_with_what_it_does(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["--help"])
    text = capsys.readouterr().out
    assert [
        name for name in ("serve", "place", "graph", "learn") if f"    {name}" not in text
    ] == []


@pytest.mark.parametrize("command", ["serve", "place", "graph", "learn"])
def test_each_command_explains_its_options(
    command: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as error:
        main([command, "--help"])
    assert error.value.code == 0
    assert f"scenegen {command}" in capsys.readouterr().out
