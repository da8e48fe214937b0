from typing import Literal

CaveatCode = Literal["coarse-step", "p2-resonance", "short-window", "spectrum-outside-band", "spectrum-outside-speeds"]

CAVEAT_CODE_VALUES: set[CaveatCode] = {
    "coarse-step",
    "p2-resonance",
    "short-window",
    "spectrum-outside-band",
    "spectrum-outside-speeds",
}


def check_caveat_code(value: str) -> CaveatCode:
    if value in CAVEAT_CODE_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {CAVEAT_CODE_VALUES!r}")
