"""Computing stored cases once more, to see whether they still give the same numbers."""
