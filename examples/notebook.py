"""How wheel–rail forces grow with speed, cell by cell: for Jupyter, or an editor that knows ``# %%``.

It needs a running service (``make serve``) at ``TRACKSWEEP_URL``.
"""

# %% What it would take
import json
from pathlib import Path

from tracksweep_client import Service

service = Service()
study = json.loads(Path("examples/speed_sweep.json").read_text())
estimate = service.estimate(study)
print(
    f"{estimate.cases.total} cases, {estimate.cases.new} of them new; about {estimate.cpu.expected_s:.0f} s of one core"
)

# %% Compute it, or find it computed
submitted = service.submit(study)
service.wait(submitted.id)

# %% Its peaks, a row each
peaks = service.to_dataframe(study_id=submitted.id)
print(peaks.pivot_table(index="quantity", columns="speed_kmh", values="peak", aggfunc="max"))

# %% One of them over speed
forces = peaks[(peaks.quantity == "wheel_rail_force") & (peaks.position == "wheelset_1")]
axes = forces.plot(x="speed_kmh", y=["maximum", "minimum"], marker="o", ylabel="wheel–rail force, N")
axes.figure.savefig("forces.png")

# %% The whole table for other programs
service.save_peaks("peaks.parquet", "parquet", study_id=submitted.id)
service.close()
