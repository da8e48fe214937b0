"""Peaks: the results, across studies."""
