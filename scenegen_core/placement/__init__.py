"""Placement: which poses are possible, how good each is, which to offer, and why."""
