from typing import Literal

CpuEstimateBasis = Literal["benchmark", "other-cases", "same-operator"]

CPU_ESTIMATE_BASIS_VALUES: set[CpuEstimateBasis] = {
    "benchmark",
    "other-cases",
    "same-operator",
}


def check_cpu_estimate_basis(value: str) -> CpuEstimateBasis:
    if value in CPU_ESTIMATE_BASIS_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {CPU_ESTIMATE_BASIS_VALUES!r}")
