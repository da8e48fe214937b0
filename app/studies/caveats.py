"""What is allowed in a study and yet worth a warning, told before anything is computed."""

import math
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from typing import Literal, NamedTuple

from pydantic import BaseModel, Field

from app.cases.schemas import KMH_PER_M_PER_S
from app.studies.resonance import p2_hz
from solver.case import Case, Dip, Harmonic, Irregularity, Spectral, Sum
from solver.catalogue import SPECTRA
from solver.railhead import Banded, Term

FEW_STEPS = 20  # per wavelength and per pad: with twice as many as are required at least, peaks are resolved
FEW_WAVES = 3  # within the window: with fewer, its peaks are of a chance piece of the longest wave
NEAR = 0.1  # of the resonance's frequency: so wide that speeds 10 % apart do not step over it
MOST_RESONANCES = 20  # that are looked for: each takes some 20 ms

Code = Literal["spectrum-outside-band", "spectrum-outside-speeds", "coarse-step", "short-window", "p2-resonance"]


class _Reason(NamedTuple):
    field: str
    words: str
    unit: str


REASONS: Mapping[Code, _Reason] = {
    "spectrum-outside-band": _Reason("irregularity", "wavelengths for which the spectrum was not drawn up", "m"),
    "spectrum-outside-speeds": _Reason("speed_kmh", "speeds for which the spectrum was not drawn up", "km/h"),
    "coarse-step": _Reason(
        "numerics/time_step_s", f"fewer than {FEW_STEPS} time steps per pad or shortest wavelength", "steps"
    ),
    "short-window": _Reason(
        "numerics/window_s", f"a window shorter than {FEW_WAVES} of the longest waves", "wavelengths"
    ),
    "p2-resonance": _Reason(
        "speed_kmh", "waves at the resonance of wheel and track (P2), where peaks do not just grow with speed", "Hz"
    ),
}


class Caveat(BaseModel):
    """What is worth knowing before a study is computed."""

    code: Code = Field(description="Stable name of the reason.")
    pointer: str = Field(description="JSON Pointer into the request: what could be changed.")
    detail: str = Field(description="The reason in words.")
    cases: int = Field(description="How many cases it concerns.")


def caveats(cases: Sequence[Case], sweep: str) -> list[Caveat]:
    """What is worth knowing of cases, once per reason.

    Parameters
    ----------
    cases : sequence of Case
    sweep : str
        The kind of sweep they are from, which tells where its fields are.
    """
    found: dict[Code, int] = defaultdict(int)
    extremes: dict[Code, list[float]] = defaultdict(list)
    resonances = _Resonances()
    for case in cases:
        notes = dict(_notes(case)) | resonances.notes(case)
        for code, value in notes.items():
            found[code] += 1
            extremes[code].append(value)
    return [
        Caveat(
            code=code,
            pointer=_pointer(REASONS[code].field, sweep),
            detail=f"{count} of {len(cases)} cases have {REASONS[code].words}: {_range(code, extremes[code])}.",
            cases=count,
        )
        for code, count in found.items()
    ]


def _notes(case: Case) -> Iterator[tuple[Code, float]]:
    """What is worth a warning, and the number by which one sees it."""
    speed_kmh = round(case.speed * KMH_PER_M_PER_S, 9)
    for term in _terms(case.irregularity):
        if isinstance(term, Spectral):
            spectrum = SPECTRA[term.spectrum].values if isinstance(term.spectrum, str) else term.spectrum
            low, high = spectrum.wavelength_range or (0, math.inf)
            if term.wavelength_min < low or term.wavelength_max > high:
                yield "spectrum-outside-band", term.wavelength_min if term.wavelength_min < low else term.wavelength_max
            slow, fast = spectrum.speed_range_kmh or (0, math.inf)
            if not slow <= speed_kmh <= fast:
                yield "spectrum-outside-speeds", speed_kmh
    travelled = case.speed * case.time_step
    steps = min(case.track.pad_spacing, case.irregularity.shortest_wavelength) / travelled
    if steps < FEW_STEPS:
        yield "coarse-step", steps
    longest = max(map(_longest, _terms(case.irregularity)))
    if case.speed * case.numerics.window < FEW_WAVES * longest:
        yield "short-window", case.speed * case.numerics.window / longest


class _Resonances:
    """The resonance of every pair of track and vehicle: many cases share them, as objects."""

    def __init__(self) -> None:
        self._known: dict[tuple[int, int], float] = {}

    def notes(self, case: Case) -> dict[Code, float]:
        """The frequency of the resonance, if the case excites it."""
        key = id(case.track), id(case.vehicle)
        if key not in self._known:
            if len(self._known) == MOST_RESONANCES:
                return {}
            self._known[key] = p2_hz(case.track, case.vehicle)
        resonance = self._known[key]
        excited = any(_excites(term, case.speed, resonance) for term in _terms(case.irregularity))
        return {"p2-resonance": resonance} if excited else {}


def _excites(term: Term, speed: float, hz: float) -> bool:
    if isinstance(term, Harmonic):
        return abs(speed / term.wavelength - hz) < NEAR * hz
    return isinstance(term, Banded) and speed / term.wavelength_max <= hz <= speed / term.wavelength_min


def _terms(irregularity: Irregularity) -> tuple[Term, ...]:
    return irregularity.terms if isinstance(irregularity, Sum) else (irregularity,)


def _longest(term: Term) -> float:
    if isinstance(term, Banded):
        return term.wavelength_max
    return term.wavelength if isinstance(term, Harmonic) else term.length if isinstance(term, Dip) else 0.0


def _range(code: Code, values: Sequence[float]) -> str:
    least, most = (f"{value:.3g}" for value in (min(values), max(values)))
    return f"{least if least == most else f'{least} to {most}'} {REASONS[code].unit}"


def _pointer(field: str, sweep: str) -> str:
    if field.startswith("numerics"):
        return f"/{field}"
    return {"preset": "/sweep", "list": "/sweep/cases"}.get(sweep, f"/sweep/{field}")
