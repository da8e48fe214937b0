"""A running service, as the program's commands talk to it."""
