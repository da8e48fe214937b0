"""Independent answers to check the moving-element solver against; they share no assembly code with it."""
