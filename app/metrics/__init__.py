"""What operators are shown, by Prometheus."""
