"""Rooms and the boxes in them: values, geometry, frames and files."""
