/* SPDX-License-Identifier: MIT */
/* What gnuplot is told. */
#ifndef TRUCKRIDE_CLI_PLOT_SCRIPT_H
#define TRUCKRIDE_CLI_PLOT_SCRIPT_H

#include "plot.h"

/* What gnuplot calls the format of a suffix, with the size of the page; NULL if there is none. */
const char *plot_terminal(const char *path, int panels, char *buffer, size_t room);

/* Write the script that draws a page. */
void plot_script(FILE *file, const char *path, const plot_page *page);

#endif
