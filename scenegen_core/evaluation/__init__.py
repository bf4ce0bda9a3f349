"""Evaluation as in the paper's tables: take objects out of rooms and ask where they would go."""
