"""Hints about the interface for schemathesis: how text bodies are sent."""

import schemathesis


@schemathesis.serializer("application/toml", "text/csv")
def text(_, value):
    """A text goes out as it is, anything else as what Python says of it."""
    if isinstance(value, bytes):
        return value
    return ("" if value is None else str(value)).encode("utf-8", "replace")
