"""Time histories: stored archives, drawn on a screen or downloaded."""
