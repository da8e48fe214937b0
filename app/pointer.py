"""Where in a JSON document a validation error is."""

from collections.abc import Sequence
from typing import Any


def pointer_to(loc: Sequence[str | int], body: Any) -> str:
    """JSON Pointer of a validation error. The names Pydantic gives to branches of unions are not part of the body."""
    if loc[0] != "body":
        return "/" + "/".join(map(str, loc))
    path: list[str] = []
    node, tagged = body, False
    for part in loc[1:]:
        if isinstance(node, dict):
            if part == node.get("kind") and not tagged:
                tagged = True
                continue
            if part in node or part == loc[-1]:
                path.append(str(part))
                node, tagged = node.get(part), False
        elif isinstance(node, list) and isinstance(part, int) and part < len(node):
            path.append(str(part))
            node, tagged = node[part], False
    return "".join("/" + part.replace("~", "~0").replace("/", "~1") for part in path)
