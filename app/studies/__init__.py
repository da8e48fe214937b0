"""Studies: what is asked for, and what has become of it."""
