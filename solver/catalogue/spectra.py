"""Spectra of the vertical profile of a rail."""

from solver.catalogue.entry import Entry, Source, by_name, of_every_value
from solver.spectrum import AnySpectrum, PowerLaw, Rational

# The literature does not settle whether the German and the American densities are one- or two-sided.
SIDES = Source("read as one-sided: the literature does not settle it", "A")


def _spectrum(name: str, title: str, spectrum: AnySpectrum, source: Source, **more: Source) -> Entry[AnySpectrum]:
    return Entry(
        name=name,
        title=title,
        values=spectrum,
        provenance=of_every_value(spectrum, source, more),
        basis=of_every_value(spectrum, "vertical profile of one rail", {}),
    )


def _german(name: str, title: str, roughness: float) -> Entry[AnySpectrum]:
    spectrum = Rational(
        per="rad/m",
        sides=1,
        roughness=roughness,
        cutoff=0.8246,
        lower_cutoff=0.0206,
        wavelength_range=(3.0, 150.0),
    )
    source = Source("German spectra of high-speed track", "V")
    return _spectrum(name, title, spectrum, source, sides=SIDES)


def _american(number: int, roughness_cm2: float) -> Entry[AnySpectrum]:
    spectrum = Rational(
        per="rad/m",
        sides=1,
        roughness=0.25 * roughness_cm2 * 1e-4,  # cm^2 to m^2; the quarter belongs to the formula
        cutoff=0.8245,
        wavelength_range=(1.524, 304.8),
    )
    source = Source(f"Federal Railroad Administration (USA), line class {number}, with the factor 0.25", "V")
    return _spectrum(f"fra-{number}", f"FRA line class {number}", spectrum, source, sides=SIDES)


SPECTRA: dict[str, Entry[AnySpectrum]] = by_name(
    _spectrum(
        "tb3352-ballastless",
        "Ballastless high-speed track, China, mean spectrum (63.2 %)",
        PowerLaw(
            per="1/m",
            sides=1,
            coefficients=tuple(a * 1e-6 for a in (1.0544e-5, 3.5588e-3, 1.9784e-2, 3.9488e-4)),  # mm^2 to m^2
            exponents=(3.3891, 1.9271, 1.3643, 3.4516),
            breaks=(0.0187, 0.0474, 0.1533),
            wavelength_range=(2.0, 200.0),
            speed_range_kmh=(300.0, 350.0),
        ),
        Source("TB/T 3352-2014, vertical profile; alike in three independent public codes", "V"),
    ),
    _german("german-low", "German high-speed track, low disturbance", 4.032e-7),
    _german("german-high", "German high-speed track, high disturbance", 10.80e-7),
    *(_american(n, a) for n, a in enumerate((1.2107, 1.0181, 0.6816, 0.5376, 0.2095, 0.0339), 1)),
)
