/* SPDX-License-Identifier: MIT */
/* Pages of curves, and gnuplot's script of one. Names stand in quotes that do not expand. */
#include "plot_script.h"
#include "common/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What gnuplot calls the format of a suffix, with the size of the page; NULL if there is none. */
const char *plot_terminal(const char *path, int panels, char *buffer, size_t room)
{
    const int height = panels < 2 ? 500 : panels < 5 ? 320 * panels : 240 * panels;
    const char *suffix = text_suffix(path);
    if (strcmp(suffix, ".png") == 0)
        snprintf(buffer, room, "pngcairo size 1000,%d font 'sans,11'", height);
    else if (strcmp(suffix, ".svg") == 0)
        snprintf(buffer, room, "svg size 1000,%d font 'sans,12' background 'white'", height);
    else if (strcmp(suffix, ".pdf") == 0)
        snprintf(buffer, room, "pdfcairo size 25cm,%.1fcm font 'sans,11'", 0.025 * height);
    else
        return NULL;
    return buffer;
}

void plot_add(plot_page *page, const char *label, bool logarithmic, const char *title,
              const double *y, size_t stride)
{
    int k = 0;
    while (k < page->panels && strcmp(page->panel[k].label, label) != 0)
        k++;
    if (k == page->panels) {
        plot_panel *panels = need((size_t)page->panels + 1, sizeof *panels);
        if (k > 0)
            memcpy(panels, page->panel, (size_t)k * sizeof *panels);
        free(page->panel);
        page->panel = panels;
        page->panel[page->panels++] = (plot_panel){.label = label, .logarithmic = logarithmic};
    }
    plot_panel *p = &page->panel[k];
    plot_curve *curves = need((size_t)p->curves + 1, sizeof *curves);
    if (p->curves > 0)
        memcpy(curves, p->curve, (size_t)p->curves * sizeof *curves);
    free(p->curve);
    p->curve = curves;
    p->curve[p->curves++] = (plot_curve){title, y, stride};
}

void plot_free(plot_page *page)
{
    for (int k = 0; k < page->panels; k++)
        free(page->panel[k].curve);
    free(page->panel);
    page->panel = NULL;
    page->panels = 0;
}

/* In single quotes gnuplot expands nothing; a quote is doubled. */
static void quote(FILE *file, const char *text)
{
    fputc('\'', file);
    for (; *text; text++) {
        if (*text == '\'')
            fputc('\'', file);
        fputc((unsigned char)*text < 32 ? ' ' : *text, file);
    }
    fputc('\'', file);
}

static double place(const plot_page *page, int64_t k)
{
    return page->x ? page->x[k] : page->start + (double)k * page->step;
}

/* Of many points the least and the largest of each group: no peak is lost. */
static void put_curve(FILE *file, const plot_page *page, const plot_curve *c)
{
    enum { MOST = 4000 };
    const int64_t group = page->points / MOST + 1;
    for (int64_t k = 0; k < page->points; k += group) {
        int64_t least = k, largest = k;
        for (int64_t i = k; i < k + group && i < page->points; i++) {
            const double y = c->y[(size_t)i * c->stride];
            least = y < c->y[(size_t)least * c->stride] ? i : least;
            largest = y > c->y[(size_t)largest * c->stride] ? i : largest;
        }
        const int64_t first = least < largest ? least : largest;
        const int64_t second = least < largest ? largest : least;
        for (int64_t i = first; i <= second; i += second > first ? second - first : 1)
            fprintf(file, "%.9g %.9g\n", place(page, i), c->y[(size_t)i * c->stride]);
    }
}

/* What is seven decades below the top is rounding. */
static void put_range(FILE *file, const plot_page *page, const plot_panel *p)
{
    double top = 0;
    for (int c = 0; c < p->curves; c++)
        for (int64_t k = 0; k < page->points; k++)
            top = fmax(top, p->curve[c].y[(size_t)k * p->curve[c].stride]);
    if (p->logarithmic && top > 0)
        fprintf(file, "set yrange [%.9g<*:*]\nset format y '10^{%%L}'\n", 1e-7 * top);
    else
        fputs("set yrange [*:*]\nset format y '%g'\n", file);
}

static void put_panel(FILE *file, const plot_page *page, int number)
{
    const plot_panel *p = &page->panel[number];
    for (int k = 0; k < p->curves; k++) {
        fprintf(file, "$curve%d << END\n", k);
        put_curve(file, page, &p->curve[k]);
        fputs("END\n", file);
    }
    fprintf(file, "%s logscale y\n", p->logarithmic ? "set" : "unset");
    put_range(file, page, p);
    fputs("set ylabel ", file);
    quote(file, p->label);
    fputs(" noenhanced\nset xlabel ", file);
    quote(file, number + 1 == page->panels ? page->label : "");
    fputs(" noenhanced\nplot ", file);
    for (int k = 0; k < p->curves; k++) { /* eight colours, then other dashes */
        fprintf(file, "%s$curve%d using 1:2 with lines linewidth 1.2 dashtype %d title ",
                k ? ", " : "", k, k / 8 % 5 + 1);
        quote(file, p->curve[k].title);
    }
    fputs("\n", file);
}

void plot_script(FILE *file, const char *path, const plot_page *page)
{
    char terminal[96];
    size_t longest = 0;
    for (int k = 0; k < page->panels; k++)
        for (int c = 0; c < page->panel[k].curves; c++)
            if (strlen(page->panel[k].curve[c].title) > longest)
                longest = strlen(page->panel[k].curve[c].title);
    fprintf(file, "set terminal %s enhanced\nset encoding utf8\nset grid\n",
            plot_terminal(path, page->panels, terminal, sizeof terminal));
    fprintf(file, "set key outside right top noenhanced\nset lmargin 14\nset rmargin %d\n",
            (int)(longest < 40 ? longest : 40) + 10);
    fprintf(file, "set multiplot layout %d,1 title ", page->panels);
    quote(file, page->title);
    fprintf(file, " noenhanced\n%s logscale x\n", page->logarithmic ? "set" : "unset");
    fprintf(file, "set xrange [%.9g:%.9g]\n", place(page, 0), place(page, page->points - 1));
    for (int k = 0; k < page->panels; k++)
        put_panel(file, page, k);
    fputs("unset multiplot\n", file);
}
