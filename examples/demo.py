"""A speed sweep from beginning to end: serve, submit over HTTP, wait, print, draw.

Run it by ``make demo``. Everything it makes lies in ``demo/``; a second run finds its cases already computed.
"""

import json
from collections.abc import Iterable
from pathlib import Path

from rich.table import Table

from app.console import digits, out, shown_unit
from app.serve.own import own_service
from examples.figure import draw
from tracksweep_client import Service
from tracksweep_client.generated.models import PeakRow

STUDY = Path(__file__).parent / "speed_sweep.json"
DEMO = Path("demo")
DATA = DEMO / "data"

Largest = dict[tuple[str, str], dict[float, float]]


def largest_by_speed(peaks: Iterable[PeakRow]) -> Largest:
    """The largest peak at any position, by quantity and unit, then by speed in km/h."""
    largest: Largest = {}
    for peak in peaks:
        unit, factor = shown_unit(peak.unit)
        curve = largest.setdefault((peak.quantity, unit), {})
        curve[peak.speed_kmh] = max(curve.get(peak.speed_kmh, 0.0), factor * peak.peak)
    return largest


def table(largest: Largest) -> Table:
    """One line per quantity, one column per speed."""
    table = Table("largest peak", "unit", box=None, pad_edge=False)
    for speed in next(iter(largest.values())):
        table.add_column(f"{speed:g} km/h", justify="right")
    for (quantity, unit), curve in largest.items():
        table.add_row(quantity.replace("_", " "), unit, *map(digits, curve.values()))
    return table


def main() -> None:
    """Run the study of ``speed_sweep.json``."""
    DEMO.mkdir(exist_ok=True)
    print("Starting a service on", DATA)
    with own_service(DATA) as url, Service(url) as service:
        study = service.submit(json.loads(STUDY.read_text()))
        print(f"Submitted the study “{study.name}” to {url}")
        if study.cases_reused:
            print(f"{study.cases_reused} of {study.cases.total} cases were already computed")
        study = service.wait(study.id)
        if study.state != "succeeded":
            raise SystemExit(f"The study ended as {study.state}; {DATA / 'logs'} may tell why.")
        peaks = list(service.peaks(study_id=study.id, sort="speed_kmh"))
        service.save_peaks(DEMO / "peaks.csv", study_id=study.id, sort="speed_kmh")

    largest = largest_by_speed(peaks)
    out.print(table(largest))
    wave = f"a wave of {peaks[0].wavelength_m:g} m and {peaks[0].amplitude_mm:g} mm on a continuous slab"
    draw(largest, f"{study.name}: largest peaks over {wave}", DEMO / "peaks_vs_speed.png")
    print(f"Wrote {DEMO / 'peaks.csv'} and {DEMO / 'peaks_vs_speed.png'}")


if __name__ == "__main__":
    main()
