"""The catalogue: what can be asked for, with units, bounds and sources."""
