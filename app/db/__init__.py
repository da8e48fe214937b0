"""Persistence: the tables, the database's clock, and transactions."""
