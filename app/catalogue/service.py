"""The catalogue, from the solver's own lists."""

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

from app.access.schemas import CallerLimits
from app.catalogue.schemas import (
    CatalogueValue,
    FieldSource,
    Interval,
    Limits,
    NamedSet,
    ParameterInfo,
    PresetInfo,
    QuantityInfo,
    QuantityLimit,
    SpectrumInfo,
    WheelTread,
)
from app.settings import Settings
from app.studies.presets import PRESETS
from app.studies.schemas import MAX_LABELS, StudyRequest
from app.studies.sweep.vary import PARAMETERS, Parameter
from solver.catalogue import SPECTRA, TREADS, Entry
from solver.channels import CHANNELS
from solver.observables import OBSERVABLES, Observable
from solver.railhead import MAX_POINTS as MAX_PROFILE
from solver.railhead import MAX_TERMS
from solver.spectrum import MAX_POINTS, SPECTRUM_KINDS, AnySpectrum

_SCOPE = ("wavelength_range", "speed_range_kmh")
_KINDS = {cls: kind for kind, cls in SPECTRUM_KINDS.items()}


def quantities() -> list[QuantityInfo]:
    """Every quantity of which peaks are given."""
    return [_quantity(each) for each in OBSERVABLES.values()]


def _quantity(each: Observable) -> QuantityInfo:
    recorded = each.of or each.name
    return QuantityInfo(
        name=each.name,
        title=each.title,
        unit=each.unit,
        convention=each.convention,
        peak=each.peak,
        derived_from=each.of or None,
        positions=[channel.position for channel in CHANNELS if channel.quantity == recorded],
        limits=[
            QuantityLimit(value=limit.value, applies=limit.applies, source=limit.source.text, mark=limit.source.mark)
            for limit in each.limits
        ],
    )


def named_sets(part: str, catalogue: Mapping[str, Entry[Any]]) -> list[NamedSet]:
    """Tracks or vehicles, under the names that a study's ``part`` has for their values."""
    parameters = {".".join(each.inside[1:]): each for each in PARAMETERS.values() if each.inside[0] == part}
    return [
        NamedSet(
            name=entry.name,
            title=entry.title,
            values=[_value(entry, name, parameters.get(name)) for name in entry.provenance],
        )
        for entry in catalogue.values()
    ]


def _value(entry: Entry[Any], name: str, parameter: Parameter | None) -> CatalogueValue:
    value = entry.values
    for part in name.split("."):
        value = getattr(value, part)
    source = entry.provenance[name]
    return CatalogueValue(
        name=name if parameter is None else parameter.path.partition(".")[2],
        value=value,
        unit="" if parameter is None else parameter.quantity.unit,
        meaning=name.replace("_", " ") if parameter is None else parameter.quantity.meaning,
        basis=entry.basis[name],
        source=source.text,
        mark=source.mark,
    )


def wheel_treads() -> list[WheelTread]:
    """Every wheel tread."""
    return [
        WheelTread(
            name=entry.name,
            title=entry.title,
            factor=entry.values.factor,
            exponent=entry.values.exponent,
            source=entry.provenance["factor"].text,
            mark=entry.provenance["factor"].mark,
        )
        for entry in TREADS.values()
    ]


def spectra() -> list[SpectrumInfo]:
    """Every named spectrum."""
    return [_spectrum(entry) for entry in SPECTRA.values()]


def _spectrum(entry: Entry[AnySpectrum]) -> SpectrumInfo:
    values = asdict(entry.values)
    wavelengths, speeds = (values.pop(name) for name in _SCOPE)
    return SpectrumInfo(
        name=entry.name,
        title=entry.title,
        unit=f"m^2/({entry.values.per})",
        definition={"kind": _KINDS[type(entry.values)], **values},
        wavelength_range_m=_interval(wavelengths),
        speed_range_kmh=_interval(speeds),
        sources=[
            FieldSource(name=name, source=source.text, mark=source.mark)
            for name, source in entry.provenance.items()
            if name not in _SCOPE
        ],
    )


def _interval(ends: tuple[float, float] | None) -> Interval | None:
    return None if ends is None else Interval(min=ends[0], max=ends[1])


def presets() -> list[PresetInfo]:
    """Every ready-made study."""
    return [
        PresetInfo(
            name=name,
            title=preset.title,
            description=preset.description,
            cases=StudyRequest.model_validate(preset.study).count(),
            study=preset.study,
        )
        for name, preset in PRESETS.items()
    ]


def limits(settings: Settings, caller: CallerLimits) -> Limits:
    """How much can be asked for."""
    return Limits(
        caller=caller,
        max_cases_per_study=settings.max_cases_per_study,
        max_page_size=settings.max_page_size,
        max_body_bytes=settings.max_body_bytes,
        max_profile_bytes=settings.max_profile_bytes,
        max_profile_points=MAX_PROFILE,
        max_labels=MAX_LABELS,
        max_irregularity_terms=MAX_TERMS,
        max_spectrum_points=MAX_POINTS,
        parameters=[
            ParameterInfo(
                path=each.path,
                unit=each.quantity.unit,
                meaning=each.quantity.meaning,
                integer=each.type is int,
                default=each.default,
                minimum=each.quantity.ge,
                exclusive_minimum=each.quantity.gt,
                maximum=each.quantity.le,
                exclusive_maximum=each.quantity.lt,
            )
            for each in PARAMETERS.values()
        ],
    )
