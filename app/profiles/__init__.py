"""Measured profiles of the rail head: uploaded once, named by their digest in any number of studies."""
