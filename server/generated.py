"""Files that are generated from the protocol: writing them, and checking that they are fresh."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def write_or_check(path: Path, text: str, *, command: str) -> int:
    """Write the text, or with ``--check`` compare it with the file: the exit code."""
    parser = argparse.ArgumentParser(prog=f"python -m {command}")
    parser.add_argument("--check", action="store_true", help="fail if the file is stale")
    if parser.parse_args().check:
        if is_fresh(path, text):
            return 0
        sys.stderr.write(f"{path} is stale; run: python -m {command}\n")
        return 1
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")
    return 0


def is_fresh(path: Path, text: str) -> bool:
    """Whether the file holds exactly that text."""
    return path.exists() and path.read_text(encoding="utf-8") == text
