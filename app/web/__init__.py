"""The page: HTML that holds no data, and the scripts that fetch it from the API."""
