# SPDX-License-Identifier: MIT
"""Outputs of a study over its parameters."""
from __future__ import annotations

from matplotlib.figure import Figure

from .. import study as studies
from .style import COLORS, label, new_figure, readable, styled


@styled
def study(shown: studies.Study, output: str = "", *, title: str = "") -> Figure:
    """One output, by default the first, over every parameter."""
    table = shown.table()
    name = output or next(iter(table.outputs))
    figure = new_figure(3.6 * max(1, len(table.parameters)), 3.4)
    panels = figure.subplots(1, len(table.parameters), sharey=True, squeeze=False)[0]
    for panel, (parameter, values) in zip(panels, table.parameters.items()):
        panel.plot(values, table.outputs[name], "o", color=COLORS[0], markersize=4, alpha=0.6,
                   markeredgewidth=0)
        panel.set_xlabel(readable(parameter))
    panels[0].set_ylabel(label(readable(name), shown.output_unit(name)))
    panels[0].set_title(title or f"{len(table.case)} cases")
    return figure
