"""The errors of the core, one tree; every text says what to do.

SceneGenError
├── SceneError       a room, a box or a file of them is not usable
├── KnowledgeError   knowledge is missing, broken or too small for the question
└── DataError        a corpus of rooms cannot be read or is too small
"""


class SceneGenError(Exception):
    """Base of all errors that a person can do something about."""


class SceneError(SceneGenError):
    """A room, a box or a scene file is not usable; says where and what to change."""


class KnowledgeError(SceneGenError):
    """Knowledge is missing, broken, of another version, or has too few examples."""


class DataError(SceneGenError):
    """A corpus of rooms cannot be read or is too small; names the file and the line."""
