/* SPDX-License-Identifier: MIT */
/* Ladder frames of a model file. */
#include <math.h>

#include "modelfile/reader.h"

enum { MOST_ELEMENTS = 100000 }; /* of all frames of a file: a slip of the pen makes more */

/* A list of numbers in memory of the reader's context. */
static trk_status read_list(const trk_reader *reader, const trk_node *list, trk_subject subject,
                            double **out, int32_t *out_count)
{
    int32_t k = 0;
    *out = NULL;
    if (list->kind != TRK_NODE_LIST)
        return trk_reader_fail_kind(reader, list, subject, "a list of numbers");
    *out_count = trk_node_count(list);
    *out = trk_new(reader->context, *out_count, sizeof **out);
    if (!*out)
        return TRK_E_MEMORY;
    TRK_EACH(value, list)
    {
        trk_status status = trk_reader_number(reader, value, subject, TRK_ANY, &(*out)[k++]);
        if (status)
            return status;
    }
    return TRK_OK;
}

/* Elements that the frame will have, about. */
static trk_status count_elements(trk_reader *reader, const trk_node *part,
                                 const trk_frame_options *frame, const double *station)
{
    double count = (double)frame->crosses * fmax(1, frame->member_elements);
    for (int32_t k = 1; k < frame->stations; k++) {
        const double length = fabs(station[k] - station[k - 1]);
        count += 2 * (frame->longest > 0 ? ceil(length / frame->longest) : 1);
    }
    if (!((double)reader->elements + count <= MOST_ELEMENTS))
        return trk_reader_fail(reader, part->key_place, TRK_E_RANGE,
                               "frame '%.80s' has %g elements; all frames may have %d", part->key,
                               count, (int)MOST_ELEMENTS);
    reader->elements += (int64_t)count;
    return TRK_OK;
}

static trk_status add_frame(trk_reader *reader, const trk_node *part, trk_frame_options *frame)
{
    const trk_subject subject = {"frame", part->key};
    trk_beam_options rail, member;
    double *station = NULL, *cross = NULL;
    trk_status status =
        trk_reader_beam(reader, trk_node_find(part, "rail"),
                        (trk_subject){"rail of frame", part->key}, trk_stock_entries, &rail);
    if (status == TRK_OK)
        status = trk_reader_beam(reader, trk_node_find(part, "member"),
                                 (trk_subject){"member of frame", part->key}, trk_stock_entries,
                                 &member);
    if (status == TRK_OK)
        status =
            read_list(reader, trk_node_find(part, "stations"), subject, &station, &frame->stations);
    if (status == TRK_OK)
        status = read_list(reader, trk_node_find(part, "cross_members"), subject, &cross,
                           &frame->crosses);
    if (status == TRK_OK)
        status = count_elements(reader, part, frame, station);
    frame->station = station;
    frame->cross = cross;
    frame->rail = &rail;
    frame->member = &member;
    if (status == TRK_OK)
        status = trk_reader_pass(reader, part->key_place,
                                 trk_spec_add_frame(reader->spec, part->key, frame));
    trk_free(reader->context, station);
    trk_free(reader->context, cross);
    return status;
}

trk_status trk_make_frame(trk_reader *reader, const trk_node *part)
{
    trk_frame_options frame;
    trk_frame_options_init(&frame, sizeof frame);
    trk_status status = trk_reader_group(reader, part, (trk_subject){"frame", part->key},
                                         trk_frame_entries, &frame);
    return status ? status : add_frame(reader, part, &frame);
}
