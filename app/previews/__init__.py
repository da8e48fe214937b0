"""What an irregularity looks like, before anything is computed over it."""
