"""Corpora of rooms: readers, and the reductions made before learning from them."""
