"""Cases: what one simulation is at the boundary, and how it went."""
