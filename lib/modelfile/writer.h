/* SPDX-License-Identifier: MIT */
/* A spec on its way to a model file: each part with the fields that are not at their defaults. */
#ifndef TRK_MODELFILE_WRITER_H
#define TRK_MODELFILE_WRITER_H

#include "modelfile/emit.h"
#include "modelfile/table.h"

typedef struct trk_writer {
    const trk_spec *spec;
    trk_emit emit;
} trk_writer;

/* Values of the options that differ from the defaults, and those that must be there. */
void trk_write_fields(trk_writer *w, const trk_entry *entries, const void *options,
                      const void *defaults);
void trk_write_triple(trk_emit *emit, const char *key, const double *triple);

/* A curve or law as a group; named: the key is its name. */
void trk_write_curve(trk_writer *w, const char *key, const trk_curve *curve, bool named);
void trk_write_law(trk_writer *w, const char *key, const trk_law *law, bool named);

/* What stands in the group of a part. */
void trk_write_body(trk_writer *w, int32_t id);
void trk_write_beam(trk_writer *w, int32_t id);
void trk_write_mass(trk_writer *w, int32_t id);
void trk_write_road(trk_writer *w, int32_t id);
void trk_write_link(trk_writer *w, int32_t id);
void trk_write_port(trk_writer *w, int32_t id);
void trk_write_sensor(trk_writer *w, int32_t id);

#endif
