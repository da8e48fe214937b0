"""The case of a file. Apart from the solver, whose import takes longer than finding out that a file is wrong."""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from app.cases.schemas import CaseFile
from app.console import fail_with_problems, read_file
from app.pointer import pointer_to
from solver.case import Case
from solver.profile import read_profile
from solver.quantity import InvalidParameterError


def read_case(path: Path) -> Case:
    """The case of a file, or the end of the program with what is wrong in it."""
    text = read_file(path)
    try:
        content = json.loads(text)
    except ValueError:
        content = None  # what is wrong with it, Pydantic says better
    if isinstance(content, dict) and "irregularity" in content:
        content["irregularity"] = _with_profiles(content["irregularity"], path.parent)
        text = json.dumps(content).encode()
    try:
        return CaseFile.model_validate_json(text).to_case()
    except ValidationError as error:
        problems = [(_dotted(each["loc"], content), each["msg"]) for each in error.errors()]
        fail_with_problems(f"{path} is not a valid case:", problems)
    except InvalidParameterError as error:
        fail_with_problems(f"{path} is not a valid case:", [(error.parameter, error.problem)])


def _with_profiles(irregularity: Any, folder: Path) -> Any:
    """An irregularity, or the terms of a sum, with the profiles that it names by file."""
    if not isinstance(irregularity, dict):
        return irregularity
    if irregularity.get("kind") == "measured" and isinstance(name := irregularity.get("file"), str):
        positions, heights = _profile(folder / name)
        others = {key: value for key, value in irregularity.items() if key != "file"}
        return others | {"positions_m": positions, "heights_m": heights}
    if isinstance(terms := irregularity.get("terms"), list):
        return irregularity | {"terms": [_with_profiles(term, folder) for term in terms]}
    return irregularity


def _profile(path: Path) -> tuple[tuple[float, ...], tuple[float, ...]]:
    try:
        return read_profile(read_file(path).decode(errors="replace"))
    except InvalidParameterError as error:
        fail_with_problems(f"{path} is not a profile:", [(error.parameter, error.problem)])


def _dotted(loc: Sequence[str | int], content: Any) -> str:
    """A field as people write it."""
    return pointer_to(("body", *loc), content).lstrip("/").replace("/", ".") or "the file"
