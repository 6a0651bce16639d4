"""The version, that of the C library too."""

__version__ = "0.1.0"
