"""Models by the hash of their bytes."""

from __future__ import annotations

from hashlib import blake2b

import pytest

from server.assets import Assets
from server.catalogue import Catalogue, Item
from server.furniture import furniture_glb
from server.looks import look

SOFA = look("Sofa", (0.9, 2.0, 0.8))
OSLO = Item("oslo", "Oslo", "Sofa", (0.9, 2.0, 0.8), b"glTF of the user")


def test_a_model_is_named_by_the_hash_of_its_bytes() -> None:
    assets = Assets(Catalogue())
    digest = assets.digest(SOFA)
    glb = assets.get(digest)
    assert glb == furniture_glb("Sofa", (0.9, 2.0, 0.8))
    assert digest == blake2b(glb, digest_size=16).hexdigest()


def test_sizes_that_are_the_same_to_the_centimetre_share_a_model() -> None:
    assets = Assets(Catalogue())
    assert assets.digest(look("Sofa", (0.904, 1.996, 0.8))) == assets.digest(SOFA)
    assert assets.digest(look("Sofa", (0.91, 2.0, 0.8))) != assets.digest(SOFA)


def test_something_thinner_than_a_centimetre_still_has_a_model() -> None:
    assets = Assets(Catalogue())
    assert assets.get(assets.digest(look("Picture", (0.001, 1.0, 0.7)))) is not None


def test_a_model_that_was_dropped_to_save_memory_is_made_again() -> None:
    assets = Assets(Catalogue(), most=1)
    first = assets.digest(SOFA)
    assets.digest(look("Table", (0.8, 1.2, 0.7)))
    assert assets.get(first) == furniture_glb("Sofa", (0.9, 2.0, 0.8))


@pytest.mark.parametrize("digest", ["0" * 32, "", "../../etc/passwd"])
def test_an_unknown_hash_is_no_model(digest: str) -> None:
    assert Assets(Catalogue()).get(digest) is None


def test_an_item_of_the_catalogue_shows_its_own_model_at_any_size() -> None:
    assets = Assets(Catalogue(items=(OSLO,)))
    digest = assets.digest(look("Sofa", (1.0, 3.0, 0.8), item="oslo"))
    assert assets.get(digest) == b"glTF of the user"


def test_an_item_that_is_no_longer_in_the_catalogue_is_shown_by_made_furniture() -> None:
    assets = Assets(Catalogue())
    gone = look("Sofa", (0.9, 2.0, 0.8), item="oslo")
    assert assets.digest(gone) == assets.digest(SOFA)
