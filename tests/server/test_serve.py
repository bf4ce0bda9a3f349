"""``scenegen serve`` as a program: starts, says what it has, stops."""

from __future__ import annotations

import re
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from server.cli import main
from tests.server.driving import page

SERVE = (sys.executable, "-m", "server.cli", "serve")


@contextmanager
def started(*arguments: str) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """The running program and what it printed before it was ready."""
    with subprocess.Popen(
        [*SERVE, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None
        printed = ""
        try:
            while "Stop with" not in printed and (line := process.stdout.readline()):
                printed += line
            yield process, printed
        finally:
            process.kill()


@pytest.mark.parametrize("signum", [signal.SIGINT, signal.SIGTERM])
def test_it_says_what_it_has_serves_and_stops_without_a_complaint(
    page_files: Path, tmp_path: Path, signum: signal.Signals
) -> None:
    options = ("--port", "0", "--store", str(tmp_path / "store"), "--page", str(page_files))
    with started(*options) as (process, printed):
        assert re.search(r"Knowledge: \d+ examples from \d+ rooms", printed)
        assert "Rooms to open: 2" in printed
        assert "this machine only" in printed
        found = re.search(r"http://(127\.0\.0\.1:\d+)", printed)
        assert found is not None
        with page(f"ws://{found[1]}") as here:
            here.open()
            process.send_signal(signum)
            out, err = process.communicate()
    assert process.returncode == 0
    assert "kept" in out
    assert err == ""


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
