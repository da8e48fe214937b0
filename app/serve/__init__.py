"""The whole service on one machine: the parts, and the supervisor that keeps them running."""
