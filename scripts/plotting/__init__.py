"""Figures of results files."""
