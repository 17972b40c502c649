"""What notebooks and figures show of results."""
