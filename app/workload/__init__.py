"""What waits, what runs where, and how fast cases are done."""
