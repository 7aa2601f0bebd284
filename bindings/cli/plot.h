/* SPDX-License-Identifier: MIT */
/* Drawings of curves, by gnuplot as a child process that is fed through a pipe. */
#ifndef TRUCKRIDE_CLI_PLOT_H
#define TRUCKRIDE_CLI_PLOT_H

#include "session.h"

/* A curve over the x of its page. */
typedef struct plot_curve {
    const char *title;
    const double *y; /* y[k * stride] */
    size_t stride;
} plot_curve;

/* Curves of one unit. */
typedef struct plot_panel {
    const char *label; /* of the y axis */
    bool logarithmic;
    int curves;
    plot_curve *curve;
} plot_panel;

/* Panels below each other over one x axis: x0 + k step, or x[k]. */
typedef struct plot_page {
    const char *title, *label;
    bool logarithmic;
    int64_t points;
    const double *x; /* NULL: even */
    double start, step;
    int panels;
    plot_panel *panel;
} plot_page;

/* Can this file be drawn? Asked before long work; EXIT_DONE or, with a message, the exit code. */
int plot_check(session *s, const char *path);

/* Draw the page into the file. */
int plot_draw(session *s, const char *path, const plot_page *page);

/* Panels for channels by their units; each array is freed by plot_free(). */
void plot_add(plot_page *page, const char *label, bool logarithmic, const char *title,
              const double *y, size_t stride);
void plot_free(plot_page *page);

#endif
