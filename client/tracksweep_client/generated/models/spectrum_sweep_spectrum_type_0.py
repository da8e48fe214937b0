from typing import Literal

SpectrumSweepSpectrumType0 = Literal[
    "fra-1", "fra-2", "fra-3", "fra-4", "fra-5", "fra-6", "german-high", "german-low", "tb3352-ballastless"
]

SPECTRUM_SWEEP_SPECTRUM_TYPE_0_VALUES: set[SpectrumSweepSpectrumType0] = {
    "fra-1",
    "fra-2",
    "fra-3",
    "fra-4",
    "fra-5",
    "fra-6",
    "german-high",
    "german-low",
    "tb3352-ballastless",
}


def check_spectrum_sweep_spectrum_type_0(value: str) -> SpectrumSweepSpectrumType0:
    if value in SPECTRUM_SWEEP_SPECTRUM_TYPE_0_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {SPECTRUM_SWEEP_SPECTRUM_TYPE_0_VALUES!r}")
