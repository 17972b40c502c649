"""Frames and arrays of other libraries."""
