"""A small picture of curves as SVG, without another library."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from typing import Any

WIDTH, HEIGHT, LEFT, BELOW, ABOVE = 420, 220, 64, 38, 18
"""Sizes of the picture and of its margins, in pixels."""

COLOURS = ("#0072b2", "#000000", "#d55e00")

COLUMNS = WIDTH - LEFT - 8
"""Pixels across: a longer curve is drawn by the least and the greatest value of each."""


def curves(lines: Mapping[str, Sequence[Any]], x: str, y: str) -> str:
    """Curves of pairs of arrays (x, y), each with a name, and titles of both axes."""
    import numpy

    points = {name: [numpy.asarray(values, dtype=float) for values in pair] for name, pair in lines.items()}
    ends = [_ends([pair[axis] for pair in points.values()]) for axis in (0, 1)]
    if None in ends:
        return ""
    (left, right), (low, high) = ends  # type: ignore[misc]
    parts = [f'<rect x="{LEFT}" y="{ABOVE}" width="{COLUMNS}" height="{HEIGHT - ABOVE - BELOW}" fill="none" stroke="#999"/>']
    for i, (name, (across, up)) in enumerate(points.items()):
        place_x = LEFT + (across - left) / (right - left) * COLUMNS
        place_y = HEIGHT - BELOW - (up - low) / (high - low) * (HEIGHT - ABOVE - BELOW)
        colour = COLOURS[i % len(COLOURS)]
        path = " ".join(f"{px:.1f},{py:.1f}" for px, py in _thinned(place_x, place_y))
        parts.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="{1.5 - 0.5 * i}"/>')
        parts.append(_text(LEFT + 6 + 90 * i, ABOVE - 5, name, "start", colour))
    base = HEIGHT - BELOW
    parts += [
        _text(LEFT, base + 14, f"{left:.4g}", "start"),
        _text(WIDTH - 8, base + 14, f"{right:.4g}", "end"),
        _text(LEFT + COLUMNS / 2, base + 30, x, "middle"),
        _text(LEFT - 5, base, f"{low:.4g}", "end"),
        _text(LEFT - 5, ABOVE + 10, f"{high:.4g}", "end"),
        _text(LEFT - 5, (ABOVE + base) / 2, y, "end"),
    ]
    size = f'width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {WIDTH} {HEIGHT}"'
    style = 'style="background:#fff" font-family="sans-serif" font-size="11"'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {size} {style}>{"".join(parts)}</svg>'


def _ends(arrays: Sequence[Any]) -> tuple[float, float] | None:
    """The least and the greatest number, apart from each other; None without any."""
    import numpy

    numbers = numpy.concatenate(arrays)
    numbers = numbers[numpy.isfinite(numbers)]
    if not len(numbers):
        return None
    low, high = float(numbers.min()), float(numbers.max())
    apart = high > low
    return (low, high) if apart else (low - abs(low) / 10 - 1e-300, high + abs(high) / 10 + 1e-300)


def _thinned(across: Any, up: Any) -> list[tuple[float, float]]:
    """The points of a curve, at most two in a column of pixels: its least and its greatest value, in their order."""
    import numpy

    known = numpy.isfinite(across) & numpy.isfinite(up)
    across, up = across[known], up[known]
    if len(across) > 2 * COLUMNS:
        rows = numpy.array_split(numpy.arange(len(across)), COLUMNS)
        ends = [sorted((int(column[up[column].argmin()]), int(column[up[column].argmax()]))) for column in rows]
        kept = [row for pair in ends for row in pair]
        across, up = across[kept], up[kept]
    return list(zip(across.tolist(), up.tolist(), strict=True))


def _text(x: float, y: float, text: str, anchor: str, colour: str = "#333") -> str:
    return f'<text x="{x:g}" y="{y:g}" text-anchor="{anchor}" fill="{colour}">{escape(text)}</text>'
