# SPDX-License-Identifier: MIT
"""Which bodies carry which: links and beams as a graph, and its distances from the road."""
from __future__ import annotations

from .._options import Link
from ..spec import Description


class Layout:
    """Bodies (by id) in groups: beams join those of a frame, any other body is a group of its own.

    links: links at a body
    groups: bodies of a group, by the first of them
    rank: number of links between a group and the road; what is not linked floats above
    """

    def __init__(self, description: Description) -> None:
        self.bodies = [(name, body) for name, body in description.bodies.items()]
        self.links: dict[int, list[Link]] = {}
        self._around: dict[int, set[int]] = {}
        for link in description.links.values():
            for here, there in ((link.from_body, link.to_body), (link.to_body, link.from_body)):
                self.links.setdefault(here, []).append(link)
                self._around.setdefault(here, set()).add(there)
        self._leader: dict[int, int] = {}
        for beam in description.beams.values():
            ends = [self.group_of(end) for end in (beam.from_body, beam.to_body) if end]
            for end in ends:
                self._leader[end] = min(ends)
        self.groups: dict[int, list[int]] = {}
        for number in range(1, len(self.bodies) + 1):
            self.groups.setdefault(self.group_of(number), []).append(number)
        self.rank = self._ranks()

    def group_of(self, number: int) -> int:
        while self._leader.get(number, number) != number:
            number = self._leader[number]
        return number

    def is_frame(self, group: int) -> bool:
        return group in self._leader

    def height(self, group: int) -> float:
        """Mean height of the centres of gravity [m]."""
        numbers = self.groups[group]
        return sum(self.bodies[number - 1][1].cg[2] for number in numbers) / len(numbers)

    def around(self, group: int) -> set[int]:
        """Bodies linked to a group."""
        found = {there for number in self.groups[group] for there in self._around.get(number, ())}
        return found - {0} - set(self.groups[group])

    def _ranks(self) -> dict[int, int]:
        reached = {group for group, numbers in self.groups.items()
                   if any(link.from_road for number in numbers
                          for link in self.links.get(number, ()))}
        reached = reached or set(list(self.groups)[:1])
        rank, level = {}, 1
        while reached:
            rank.update(dict.fromkeys(reached, level))
            level += 1
            reached = {self.group_of(there) for group in reached
                       for there in self.around(group)} - set(rank)
        return {group: rank.get(group, level) for group in self.groups}
