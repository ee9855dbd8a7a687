"""References as JSON: what is short, or holds no other lists or objects, stands on a line of its own."""

import json


def text(value, indent=0):
    """A value as JSON, a row a line."""
    parts = value.values() if isinstance(value, dict) else value if isinstance(value, (list, tuple)) else ()
    line = json.dumps(value)
    if len(line) <= 110 or not any(isinstance(part, (dict, list, tuple)) for part in parts):
        return line
    start = "\n" + " " * (indent + 1)
    if isinstance(value, dict):
        rows = [f"{json.dumps(str(key))}: {text(part, indent + 1)}" for key, part in value.items()]
        ends = "{}"
    else:
        rows = [text(part, indent + 1) for part in value]
        ends = "[]"
    return ends[0] + start + f",{start}".join(rows) + "\n" + " " * indent + ends[1]
