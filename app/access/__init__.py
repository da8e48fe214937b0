"""Who may do what: API keys, what they see, how often they may ask, and how much they may have computed."""
