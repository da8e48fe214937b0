"""The case of a file. Apart from the solver, whose import takes longer than finding out that a file is wrong."""

from pathlib import Path

from pydantic import ValidationError

from app.cases.schemas import CaseFile
from app.console import fail_with_problems, read_file
from solver.case import IRREGULARITY_KINDS, Case
from solver.quantity import InvalidParameterError


def read_case(path: Path) -> Case:
    """The case of a file, or the end of the program with what is wrong in it."""
    try:
        return CaseFile.model_validate_json(read_file(path)).to_case()
    except ValidationError as error:
        problems = [(_dotted(each["loc"]), each["msg"]) for each in error.errors()]
        fail_with_problems(f"{path} is not a valid case:", problems)
    except InvalidParameterError as error:
        fail_with_problems(f"{path} is not a valid case:", [(error.parameter, error.problem)])


def _dotted(loc: tuple[str | int, ...]) -> str:
    """A field as people write it: Pydantic also names the kind it took an irregularity for."""
    return ".".join(str(part) for part in loc if part not in IRREGULARITY_KINDS) or "the file"
