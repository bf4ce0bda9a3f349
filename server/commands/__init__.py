"""The commands of ``scenegen``: each has ``add_arguments(parser)`` and ``run(arguments)``."""
