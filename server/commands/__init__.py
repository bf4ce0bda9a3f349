"""The commands of ``scenegen``: each module has ``add_arguments(parser)`` and ``run(arguments)``."""
