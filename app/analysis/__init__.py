"""What a study shows: differences along one axis, and statistics over realisations."""
