"""The nearest neighbours of distributions, exact, without comparing all with all.

The earth mover's distance on the line is the integral of |Q1(t) - Q2(t)| over t in [0, 1], where Q
are the quantile functions. Over each of equal intervals of t the difference of the means is a lower
bound of the mean of the difference; so the L1 distance of vectors of such means never exceeds the
distance of the distributions, and neither does the difference of the two means over all.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from pygirth import _girth

#: Intervals of the quantile functions.
INTERVALS = 32
#: More than a bound exceeds the distance by rounding, as a share of the values.
ROUNDING = 1e-9


class Distributions(NamedTuple):
    """Distributions behind each other: number i from offsets[i] to offsets[i + 1]."""

    values: np.ndarray
    shares: np.ndarray
    offsets: np.ndarray

    def __len__(self) -> int:
        return len(self.offsets) - 1

    def one(self, number: int) -> tuple[np.ndarray, np.ndarray]:
        """Values and shares."""
        part = slice(self.offsets[number], self.offsets[number + 1])
        return self.values[part], self.shares[part]

    def some(self, first: int, end: int) -> "Distributions":
        """The distributions of a range of numbers."""
        part = slice(self.offsets[first], self.offsets[end])
        offsets = self.offsets[first : end + 1] - self.offsets[first]
        return Distributions(self.values[part], self.shares[part], offsets)


def distances_to(
    one: tuple[np.ndarray, np.ndarray], number: int, all: Distributions, wanted: np.ndarray
) -> np.ndarray:
    """The exact distances of one distribution from some; NaN where one of two is empty. It has the
    `number` among all, and each distance the bits of that of the lower number from the higher."""
    return _girth.transport_distances(*one, number, *all, np.ascontiguousarray(wanted, np.int64))


def block_of(rows: Distributions, columns: Distributions, is_diagonal: bool) -> np.ndarray:
    """The distances of all of one block from all of one behind it, or of the block itself."""
    everyone = np.arange(len(columns))
    found = [
        distances_to(rows.one(i), i if is_diagonal else 0, columns, everyone)
        for i in range(len(rows))
    ]
    return np.array(found).reshape(len(rows), len(columns))


def means_of(values: np.ndarray, shares: np.ndarray) -> np.ndarray:
    """The means of a quantile function over the intervals; NaN of an empty distribution."""
    if not len(values):
        return np.full(INTERVALS, np.nan)
    upto = np.concatenate([[0.0], np.cumsum(shares)])
    integral = np.concatenate([[0.0], np.cumsum(values * shares)])
    at = np.linspace(0, 1, INTERVALS + 1) * upto[-1]
    return np.diff(np.interp(at, upto, integral)) * INTERVALS


class Index:
    """The means of every distribution, by which bounds of distances are found."""

    def __init__(self, all: Distributions) -> None:
        self.all = all
        self.means = np.array([means_of(*all.one(i)) for i in range(len(all))]).reshape(-1, INTERVALS)
        middle = self.means.mean(axis=1)
        known = np.flatnonzero(~np.isnan(middle))
        self.order = known[np.argsort(middle[known], kind="stable")]
        self.middle = middle[self.order]

    def nearest(
        self, number: int, k: int
    ) -> tuple[np.ndarray, np.ndarray, int]:
        """Numbers and distances of the `k` nearest of one, nearest first, of equals the lower
        number; and how many distances were computed. -1 and NaN where there are fewer."""
        one = self.all.one(number)
        numbers, distances = np.full(k, -1, np.int64), np.full(k, np.nan)
        means = self.means[number]
        if np.isnan(means[0]):
            return numbers, distances, 0
        middle = means.mean()
        slack = ROUNDING * (np.abs(one[0]).max() + np.abs(self.middle).max())
        # The nearest by their means, which give a radius that holds k.
        at = int(np.searchsorted(self.middle, middle))
        some = self.order[max(0, at - 2 * k - 16) : at + 2 * k + 16]
        some = some[some != number]
        first = some[np.argsort(self._bounds(means, some), kind="stable")[:k]]
        found = dict(zip(first.tolist(), distances_to(one, number, self.all, first).tolist()))
        radius = max(found.values()) if len(found) == k else np.inf
        # Whatever is within it has its mean within it, and its bound.
        low, high = np.searchsorted(self.middle, [middle - radius - slack, middle + radius + slack])
        rest = self.order[low : high + 1]
        rest = rest[(rest != number) & ~np.isin(rest, first)]
        bounds = self._bounds(means, rest)
        near = np.argsort(bounds, kind="stable")
        for begin in range(0, len(near), 16):
            group = near[begin : begin + 16]
            if bounds[group[0]] > radius + slack:
                break
            exact = distances_to(one, number, self.all, rest[group])
            found.update(zip(rest[group].tolist(), exact.tolist()))
            if len(found) >= k:
                radius = sorted(found.values())[k - 1]
        best = sorted((distance, other) for other, distance in found.items())[:k]
        for i, (distance, other) in enumerate(best):
            numbers[i], distances[i] = other, distance
        return numbers, distances, len(found)

    def _bounds(self, means: np.ndarray, numbers: np.ndarray) -> np.ndarray:
        return np.abs(self.means[numbers] - means).sum(axis=1) / INTERVALS


def nearest_of(
    index: Index, queries: np.ndarray, k: int
) -> tuple[np.ndarray, np.ndarray, int]:
    """`Index.nearest` of several."""
    found = [index.nearest(query, k) for query in queries.tolist()]
    numbers = np.array([one[0] for one in found], np.int64).reshape(-1, k)
    distances = np.array([one[1] for one in found]).reshape(-1, k)
    return numbers, distances, sum(one[2] for one in found)
