/* SPDX-License-Identifier: MIT */
/* A model file on its way to a spec. */
#ifndef TRK_MODELFILE_READER_H
#define TRK_MODELFILE_READER_H

#include "base/names.h"
#include "modelfile/table.h"
#include "modelfile/tree.h"

/* Which half of a mirrored part is being made. */
typedef enum trk_side { TRK_SIDE_NONE, TRK_SIDE_LEFT, TRK_SIDE_RIGHT } trk_side;

typedef struct trk_reader {
    trk_context *context;
    const char *source, *folder; /* folder: of tables; may be NULL */
    trk_tree tree;
    trk_spec *spec;
    trk_side side;
    trk_names curve_names, law_names; /* of the sections; further ones have no name to ask for */
    trk_curve **curves;
    trk_law **laws;
    int64_t curve_count, curve_capacity, law_count, law_capacity;
    int64_t elements; /* of beams that frames have made */
} trk_reader;

/* What a group describes, for messages: "link" and its name. */
typedef struct trk_subject {
    const char *what, *name;
} trk_subject;

enum { TRK_NAME_ROOM = 256 }; /* longer names than a spec takes, so that it refuses them */

/* "source:line:column: ..." */
trk_status trk_reader_fail(const trk_reader *reader, trk_place place, trk_status status,
                           const char *format, ...) TRK_PRINTF(4, 5);
/* A status of another room, whose message gets the place in front. */
trk_status trk_reader_pass(const trk_reader *reader, trk_place place, trk_status status);
/* The value is of another kind than `wanted`, "a number". */
trk_status trk_reader_fail_kind(const trk_reader *reader, const trk_node *value,
                                trk_subject subject, const char *wanted);

/* Read a group: its keys must be those of the table, the fields of the options are set. */
trk_status trk_reader_group(trk_reader *reader, const trk_node *group, trk_subject subject,
                            const trk_entry *entries, void *options);
/* One value as an entry says. */
trk_status trk_reader_value(trk_reader *reader, const trk_node *value, trk_subject subject,
                            const trk_entry *entry, void *field);
/* A number within a bound; a point, mirrored if the part is; true or false. NULL value: nothing is set. */
trk_status trk_reader_number(const trk_reader *reader, const trk_node *value, trk_subject subject,
                             trk_bound bound, double *out);
trk_status trk_reader_point(const trk_reader *reader, const trk_node *value, trk_subject subject,
                            double *out);
trk_status trk_reader_truth(const trk_reader *reader, const trk_node *value, trk_subject subject,
                            bool *out);
trk_status trk_reader_text(const trk_reader *reader, const trk_node *value, trk_subject subject,
                           const char **out);

/* A name, of a mirrored part with its side: "front_*_spring" and "seat" become "front_left_spring" and
 * "seat_left". References replace '*' only. */
const char *trk_reader_name(const trk_reader *reader, const char *name, char out[TRK_NAME_ROOM]);
const char *trk_reader_reference(const trk_reader *reader, const char *name,
                                 char out[TRK_NAME_ROOM]);

/* Id of a part by the name that stands in a value. */
trk_status trk_reader_find(const trk_reader *reader, const trk_node *value, trk_subject subject,
                           trk_part part, int32_t *out_id);
/* Body by name, or the node of a frame next to a point; *out_body stays if both values are NULL. */
trk_status trk_reader_body(const trk_reader *reader, const trk_node *body, const trk_node *frame,
                           trk_subject subject, const double *point, int32_t *out_body);

/* Curve or law by name or from a group; owned by the reader. */
trk_status trk_reader_curve(trk_reader *reader, const trk_node *value, trk_subject subject,
                            const trk_curve **out_curve);
trk_status trk_reader_law(trk_reader *reader, const trk_node *value, trk_subject subject,
                          const trk_law **out_law);

/* Ends of a link or beam. */
typedef struct trk_ends {
    int32_t body[2], road[2];
    double point[2][3]; /* [m] */
} trk_ends;
trk_status trk_reader_ends(const trk_reader *reader, const trk_node *part, trk_subject subject,
                           trk_ends *out_ends);

/* Body, frame or "ground" by name alone. */
trk_status trk_reader_place(const trk_reader *reader, const trk_node *end, trk_subject subject,
                            const double *point, int32_t *out_body);

/* Stiffness and mass of a beam: of its section, and values that stand beside it. */
trk_status trk_reader_beam(trk_reader *reader, const trk_node *group, trk_subject subject,
                           const trk_entry *entries, trk_beam_options *out_options);

/* Make the parts of one group of a section. */
typedef trk_status (*trk_make)(trk_reader *reader, const trk_node *part);
trk_status trk_make_curve(trk_reader *reader, const trk_node *part);
trk_status trk_make_law(trk_reader *reader, const trk_node *part);
trk_status trk_make_material(trk_reader *reader, const trk_node *part);
trk_status trk_make_section(trk_reader *reader, const trk_node *part);
trk_status trk_make_body(trk_reader *reader, const trk_node *part);
trk_status trk_make_frame(trk_reader *reader, const trk_node *part);
trk_status trk_make_axle(trk_reader *reader, const trk_node *part);
trk_status trk_make_mount(trk_reader *reader, const trk_node *part);
trk_status trk_make_mass(trk_reader *reader, const trk_node *part);
trk_status trk_make_road(trk_reader *reader, const trk_node *part);
trk_status trk_make_beam(trk_reader *reader, const trk_node *part);
trk_status trk_make_link(trk_reader *reader, const trk_node *part);
trk_status trk_make_bar(trk_reader *reader, const trk_node *part);
trk_status trk_make_port(trk_reader *reader, const trk_node *part);
trk_status trk_make_sensor(trk_reader *reader, const trk_node *part);

#endif
