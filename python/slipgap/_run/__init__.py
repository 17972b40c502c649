"""Progress and warnings of runs."""
