/* SPDX-License-Identifier: MIT */
/* What groups of a model file may hold: one table for reading and for writing. */
#ifndef TRK_MODELFILE_TABLE_H
#define TRK_MODELFILE_TABLE_H

#include "base/base.h"
#include <truckride/frame.h>

typedef enum trk_entry_kind {
    TRK_ENTRY_APART,     /* read and written by a function of its own                     */
    TRK_ENTRY_NUMBER,    /* double                                                        */
    TRK_ENTRY_WHOLE,     /* int32_t                                                       */
    TRK_ENTRY_TRIPLE,    /* double[3]                                                     */
    TRK_ENTRY_POINT,     /* double[3], mirrored with its part                             */
    TRK_ENTRY_DIRECTION, /* double[3], or an axis: "x", "-x", ...                         */
    TRK_ENTRY_WORD,      /* int32_t by the names of its values                            */
    TRK_ENTRY_FREEDOMS,  /* int32_t, sum of those listed                                  */
    TRK_ENTRY_CURVE,     /* const trk_curve *: the name of one, or a group that makes one */
    TRK_ENTRY_LAW,       /* const trk_law *: likewise                                     */
    TRK_ENTRY_LINK       /* int32_t, id by name                                           */
} trk_entry_kind;

typedef enum trk_bound { TRK_ANY, TRK_NOT_NEGATIVE, TRK_POSITIVE } trk_bound;

typedef struct trk_word {
    const char *text; /* NULL at the end */
    int32_t value;
} trk_word;

typedef struct trk_entry {
    const char *key; /* NULL at the end */
    trk_entry_kind kind;
    size_t offset; /* of the field in the options */
    trk_bound bound;
    bool required;
    const trk_word *words;
} trk_entry;

extern const trk_word trk_freedom_words[];

extern const trk_entry trk_curve_entries[], trk_body_entries[], trk_mass_entries[],
    trk_road_entries[], trk_link_entries[], trk_wheel_entries[], trk_axle_entries[],
    trk_axle_bar_entries[], trk_arm_entries[], trk_mount_entries[], trk_bar_entries[],
    trk_end_entries[], trk_beam_entries[], trk_stock_entries[], trk_frame_entries[],
    trk_material_entries[], trk_section_entries[], trk_port_entries[], trk_sensor_entries[];

/* A kind of law: how files call it, what it holds, the functions of law.h without their types. */
typedef struct trk_law_form {
    const char *key;
    trk_law_kind kind;
    const trk_entry *entries;
    void (*init)(void *options);
    trk_status (*create)(trk_context *context, const char *name, const void *options,
                         trk_law **out_law);
    trk_status (*get)(const trk_law *law, void *out_options);
} trk_law_form;
enum { TRK_LAW_FORMS = 6 };
extern const trk_law_form trk_law_forms[TRK_LAW_FORMS];

/* A material, and the dimensions of a section: frame.h says which are which. */
typedef struct trk_material {
    double young, shear, density;
} trk_material;

typedef struct trk_profile {
    double height, width, web, flange, outer, wall; /* [m] */
} trk_profile;

typedef struct trk_profile_form {
    const char *key;
    const trk_entry *entries;
} trk_profile_form;
enum { TRK_PROFILE_FORMS = 4 };
extern const trk_profile_form trk_profile_forms[TRK_PROFILE_FORMS];

/* Options of any law. */
typedef union trk_law_options {
    trk_tire_options tire;
    trk_stops_options stops;
    trk_leaf_options leaf;
    trk_friction_options friction;
    trk_air_spring_options air_spring;
    trk_seal_options seal;
} trk_law_options;

/* Point masses and roads have no options struct of their own. */
typedef struct trk_file_mass {
    int32_t body;
    double mass;     /* [kg] */
    double point[3]; /* [m] */
} trk_file_mass;

typedef struct trk_file_road {
    double x, y; /* [m] */
} trk_file_road;

#endif
