/* SPDX-License-Identifier: MIT */
/* Curves of a model file, from points in it or from a CSV table beside it. */
#include <string.h>

#include "modelfile/points.h"
#include "modelfile/suggest.h"

trk_status trk_points_take(trk_reader *reader, trk_points *p, int64_t count)
{
    p->x = trk_new(reader->context, 2 * count, sizeof *p->x);
    p->y = p->x ? p->x + count : NULL;
    p->count = count;
    return p->x ? TRK_OK : TRK_E_MEMORY;
}

static trk_status read_points(trk_reader *reader, const trk_node *list, trk_subject subject,
                              trk_points *p)
{
    if (list->kind != TRK_NODE_LIST)
        return trk_reader_fail_kind(reader, list, subject, "a list of points [x, y]");
    trk_status status = trk_points_take(reader, p, trk_node_count(list));
    int64_t k = 0;
    if (status)
        return status;
    TRK_EACH(pair, list)
    {
        if (pair->kind != TRK_NODE_LIST || trk_node_count(pair) != 2)
            return trk_reader_fail_kind(reader, pair, subject, "a point [x, y]");
        status = trk_reader_number(reader, pair + 1, subject, TRK_ANY, &p->x[k]);
        if (status == TRK_OK)
            status = trk_reader_number(reader, pair + 2, subject, TRK_ANY, &p->y[k]);
        if (status)
            return status;
        if (k > 0 && !(p->x[k] > p->x[k - 1]))
            return trk_reader_fail(reader, pair->place, TRK_E_RANGE,
                                   "%s '%.80s' goes from x = %g to %g, expected x to increase",
                                   subject.what, subject.name, p->x[k - 1], p->x[k]);
        k++;
    }
    if (k < 2)
        return trk_reader_fail(reader, list->place, TRK_E_RANGE,
                               "%s '%.80s' has %d points, expected 2 at least", subject.what,
                               subject.name, (int)k);
    return TRK_OK;
}

/* Factors of the group on x and y; a table that falls in x is turned round. */
static trk_status scale(const trk_reader *reader, const trk_node *group, trk_subject subject,
                        trk_points *p)
{
    double x_scale = 1, y_scale = 1;
    const trk_node *xs = trk_node_find(group, "x_scale"), *ys = trk_node_find(group, "y_scale");
    trk_status status = trk_reader_number(reader, xs, subject, TRK_ANY, &x_scale);
    if (status == TRK_OK)
        status = trk_reader_number(reader, ys, subject, TRK_ANY, &y_scale);
    if (status)
        return status;
    if (x_scale == 0)
        return trk_reader_fail(reader, xs->place, TRK_E_RANGE,
                               "'x_scale' of %s '%.80s' is 0, expected another number",
                               subject.what, subject.name);
    for (int64_t k = 0; xs && k < p->count; k++)
        p->x[k] *= x_scale;
    for (int64_t k = 0; ys && k < p->count; k++)
        p->y[k] *= y_scale;
    const bool falls = p->x[0] > p->x[p->count - 1];
    for (int64_t i = 0, j = p->count - 1; falls && i < j; i++, j--) {
        const double x = p->x[i], y = p->y[i];
        p->x[i] = p->x[j];
        p->y[i] = p->y[j];
        p->x[j] = x;
        p->y[j] = y;
    }
    return TRK_OK;
}

static trk_status read_data(trk_reader *reader, const trk_node *group, trk_subject subject,
                            trk_points *p)
{
    const trk_node *list = trk_node_find(group, "points"), *csv = trk_node_find(group, "csv");
    if (!list == !csv)
        return trk_reader_fail(reader, group->key_place, TRK_E_SYNTAX,
                               "%s '%.80s' has %s 'points' %s 'csv', expected one of them",
                               subject.what, subject.name, list ? "both" : "neither",
                               list ? "and" : "nor");
    for (int k = 0; list && k < 3; k++) {
        static const char *const of_csv[] = {"x", "y", "decimal_comma"};
        const trk_node *stray = trk_node_find(group, of_csv[k]);
        if (stray)
            return trk_reader_fail(reader, stray->key_place, TRK_E_SYNTAX,
                                   "'%s' of %s '%.80s' belongs to a table from 'csv'", stray->key,
                                   subject.what, subject.name);
    }
    trk_status status = list ? read_points(reader, list, subject, p)
                             : trk_points_from_csv(reader, csv, group, subject, p);
    return status == TRK_OK ? scale(reader, group, subject, p) : status;
}

/* A curve from its group, kept by the reader. */
static trk_status create_curve(trk_reader *reader, const trk_node *group, trk_subject subject)
{
    const char *name = subject.name;
    trk_points p = {0, NULL, NULL};
    trk_curve_options options;
    trk_curve_options_init(&options, sizeof options);
    trk_status status = trk_reader_group(reader, group, subject, trk_curve_entries, &options);
    if (status == TRK_OK)
        status = trk_reader_text(reader, trk_node_find(group, "name"), subject, &name);
    if (status == TRK_OK)
        status = trk_grow(reader->context, (void **)&reader->curves, &reader->curve_capacity,
                          reader->curve_count + 1, sizeof *reader->curves);
    if (status == TRK_OK)
        status = read_data(reader, group, subject, &p);
    if (status == TRK_OK) {
        status = trk_curve_create(reader->context, name, p.count, p.x, p.y, &options,
                                  &reader->curves[reader->curve_count]);
        reader->curve_count += status == TRK_OK;
        status = trk_reader_pass(reader, group->key_place, status);
    }
    trk_free(reader->context, p.x);
    return status;
}

trk_status trk_make_curve(trk_reader *reader, const trk_node *part)
{
    trk_status status = create_curve(reader, part, (trk_subject){"curve", part->key});
    if (status)
        return status;
    return trk_names_add(reader->context, &reader->curve_names, "curve", part->key);
}

trk_status trk_reader_curve(trk_reader *reader, const trk_node *value, trk_subject subject,
                            const trk_curve **out_curve)
{
    if (value->kind == TRK_NODE_GROUP) {
        trk_status status = create_curve(reader, value, (trk_subject){"curve", subject.name});
        if (status == TRK_OK)
            *out_curve = reader->curves[reader->curve_count - 1];
        return status;
    }
    if (value->kind != TRK_NODE_TEXT)
        return trk_reader_fail_kind(reader, value, subject, "the name of a curve or a group {...}");
    trk_suggestion suggestion = {NULL, 0};
    char tail[TRK_SUGGESTION_ROOM];
    const int32_t id = trk_names_find(&reader->curve_names, value->text);
    for (int32_t k = 1; id == 0 && k <= reader->curve_names.count; k++)
        trk_suggest(&suggestion, value->text, trk_names_text(&reader->curve_names, k));
    if (id == 0)
        return trk_reader_fail(reader, value->place, TRK_E_NAME,
                               "there is no curve '%.80s', which %s '%.80s' names%s", value->text,
                               subject.what, subject.name, trk_suggestion_tail(&suggestion, tail));
    *out_curve = reader->curves[id - 1];
    return TRK_OK;
}
