"""The spatial scene graph: what relations an object has, or would have, where it stands."""
