"""How all tests run: the same examples each time, and no clock that fails them."""

from __future__ import annotations

from hypothesis import settings

settings.register_profile("scenegen", deadline=None, derandomize=True)
settings.load_profile("scenegen")
