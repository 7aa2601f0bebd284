/* SPDX-License-Identifier: MIT */
/* The groups that become parts of a spec. */
#include "modelfile/table.h"

static const trk_word motions[] = {
    {"translation", TRK_MOTION_TRANSLATION}, {"rotation", TRK_MOTION_ROTATION}, {NULL, 0}};

static const trk_word quantities[] = {{"displacement", TRK_QUANTITY_DISPLACEMENT},
                                      {"velocity", TRK_QUANTITY_VELOCITY},
                                      {"acceleration", TRK_QUANTITY_ACCELERATION},
                                      {"elongation", TRK_QUANTITY_ELONGATION},
                                      {"rate", TRK_QUANTITY_RATE},
                                      {"force", TRK_QUANTITY_FORCE},
                                      {NULL, 0}};

static const trk_word interpolations[] = {
    {"pchip", TRK_INTERPOLATION_PCHIP},     {"not_a_knot", TRK_INTERPOLATION_NOT_A_KNOT},
    {"natural", TRK_INTERPOLATION_NATURAL}, {"akima", TRK_INTERPOLATION_AKIMA},
    {"linear", TRK_INTERPOLATION_LINEAR},   {NULL, 0}};

static const trk_word extrapolations[] = {
    {"slope", TRK_EXTRAPOLATION_SLOPE}, {"clamp", TRK_EXTRAPOLATION_CLAMP}, {NULL, 0}};

const trk_word trk_freedom_words[] = {
    {"x", TRK_FREE_X},         {"y", TRK_FREE_Y},     {"z", TRK_FREE_Z}, {"roll", TRK_FREE_ROLL},
    {"pitch", TRK_FREE_PITCH}, {"yaw", TRK_FREE_YAW}, {NULL, 0}};

#define APART(key)                                                                                 \
    {                                                                                              \
        key, TRK_ENTRY_APART, 0, TRK_ANY, false, NULL                                              \
    }
#define NEEDED(key)                                                                                \
    {                                                                                              \
        key, TRK_ENTRY_APART, 0, TRK_ANY, true, NULL                                               \
    }
#define NUMBER(type, field, bound)                                                                 \
    {                                                                                              \
#field, TRK_ENTRY_NUMBER, offsetof(type, field), bound, false, NULL                        \
    }
#define NEEDED_NUMBER(type, field, bound)                                                          \
    {                                                                                              \
#field, TRK_ENTRY_NUMBER, offsetof(type, field), bound, true, NULL                         \
    }
#define OF_KIND(kind, type, field)                                                                 \
    {                                                                                              \
#field, TRK_ENTRY_##kind, offsetof(type, field), TRK_ANY, false, NULL                      \
    }
#define WORD(type, field, words)                                                                   \
    {                                                                                              \
#field, TRK_ENTRY_WORD, offsetof(type, field), TRK_ANY, false, words                       \
    }
#define END                                                                                        \
    {                                                                                              \
        NULL, TRK_ENTRY_APART, 0, TRK_ANY, false, NULL                                             \
    }

const trk_entry trk_curve_entries[] = {APART("name"),
                                       APART("points"),
                                       APART("csv"),
                                       APART("x"),
                                       APART("y"),
                                       APART("x_scale"),
                                       APART("y_scale"),
                                       APART("decimal_comma"),
                                       WORD(trk_curve_options, interpolation, interpolations),
                                       WORD(trk_curve_options, extrapolation, extrapolations),
                                       END};

const trk_entry trk_body_entries[] = {APART("mirror"),
                                      OF_KIND(FREEDOMS, trk_body_options, freedoms),
                                      NUMBER(trk_body_options, mass, TRK_NOT_NEGATIVE),
                                      {"inertia", TRK_ENTRY_TRIPLE,
                                       offsetof(trk_body_options, inertia), TRK_NOT_NEGATIVE, false,
                                       NULL},
                                      OF_KIND(POINT, trk_body_options, cg),
                                      END};

const trk_entry trk_mass_entries[] = {
    APART("mirror"),
    APART("body"),
    APART("frame"),
    NEEDED_NUMBER(trk_file_mass, mass, TRK_POSITIVE),
    {"point", TRK_ENTRY_POINT, offsetof(trk_file_mass, point), TRK_ANY, true, NULL},
    END};

const trk_entry trk_road_entries[] = {APART("mirror"), NEEDED_NUMBER(trk_file_road, x, TRK_ANY),
                                      NEEDED_NUMBER(trk_file_road, y, TRK_ANY), END};

#define FORCE_ENTRIES                                                                              \
    NUMBER(trk_link_options, stiffness, TRK_ANY),                                                  \
        NUMBER(trk_link_options, damping, TRK_NOT_NEGATIVE),                                       \
        OF_KIND(CURVE, trk_link_options, spring_curve),                                            \
        NUMBER(trk_link_options, spring_scale, TRK_NOT_NEGATIVE),                                  \
        NUMBER(trk_link_options, spring_offset, TRK_ANY),                                          \
        OF_KIND(CURVE, trk_link_options, damper_curve),                                            \
        NUMBER(trk_link_options, damper_scale, TRK_NOT_NEGATIVE),                                  \
        OF_KIND(LAW, trk_link_options, law)

/* A spring, damper or tire of an axle. */
const trk_entry trk_wheel_entries[] = {APART("x"), NEEDED("y"), APART("z"), FORCE_ENTRIES, END};

const trk_entry trk_axle_entries[] = {NEEDED("x"),
                                      APART("z"),
                                      APART("frame"),
                                      APART("roll_inertia"),
                                      APART("tires"),
                                      APART("springs"),
                                      APART("dampers"),
                                      APART("bump_stops"),
                                      APART("anti_roll_bar"),
                                      OF_KIND(FREEDOMS, trk_body_options, freedoms),
                                      NEEDED_NUMBER(trk_body_options, mass, TRK_NOT_NEGATIVE),
                                      {"inertia", TRK_ENTRY_TRIPLE,
                                       offsetof(trk_body_options, inertia), TRK_NOT_NEGATIVE, false,
                                       NULL},
                                      END};

const trk_entry trk_axle_bar_entries[] = {FORCE_ENTRIES, END};

/* One direction of a mount. */
const trk_entry trk_arm_entries[] = {APART("point"), FORCE_ENTRIES, END};

const trk_entry trk_mount_entries[] = {
    APART("mirror"),   NEEDED("from"),        NEEDED("to"),     APART("point"),
    APART("vertical"), APART("longitudinal"), APART("lateral"), END};

const trk_entry trk_link_entries[] = {APART("mirror"),
                                      NEEDED("from"),
                                      NEEDED("to"),
                                      APART("point"),
                                      WORD(trk_link_options, motion, motions),
                                      OF_KIND(DIRECTION, trk_link_options, direction),
                                      FORCE_ENTRIES,
                                      END};

const trk_entry trk_bar_entries[] = {NEEDED("from"), NEEDED("to"),
                                     OF_KIND(DIRECTION, trk_link_options, direction), FORCE_ENTRIES,
                                     END};

const trk_entry trk_end_entries[] = {APART("body"),   APART("frame"), APART("road"),
                                     APART("ground"), APART("point"), END};

#define STOCK_ENTRIES                                                                              \
    APART("section"), NUMBER(trk_beam_options, axial, TRK_NOT_NEGATIVE),                           \
        NUMBER(trk_beam_options, torsion, TRK_NOT_NEGATIVE),                                       \
        NUMBER(trk_beam_options, bending_y, TRK_NOT_NEGATIVE),                                     \
        NUMBER(trk_beam_options, bending_z, TRK_NOT_NEGATIVE),                                     \
        NUMBER(trk_beam_options, shear_y, TRK_NOT_NEGATIVE),                                       \
        NUMBER(trk_beam_options, shear_z, TRK_NOT_NEGATIVE),                                       \
        NUMBER(trk_beam_options, mass_per_length, TRK_NOT_NEGATIVE),                               \
        NUMBER(trk_beam_options, inertia_x, TRK_NOT_NEGATIVE),                                     \
        NUMBER(trk_beam_options, inertia_y, TRK_NOT_NEGATIVE),                                     \
        NUMBER(trk_beam_options, inertia_z, TRK_NOT_NEGATIVE),                                     \
        NUMBER(trk_beam_options, mass_damping, TRK_NOT_NEGATIVE),                                  \
        NUMBER(trk_beam_options, stiffness_damping, TRK_NOT_NEGATIVE)

const trk_entry trk_beam_entries[] = {APART("mirror"), NEEDED("from"),
                                      NEEDED("to"),    OF_KIND(DIRECTION, trk_beam_options, up),
                                      STOCK_ENTRIES,   END};

/* What the rails and members of a frame are cut from. */
const trk_entry trk_stock_entries[] = {STOCK_ENTRIES, END};

const trk_entry trk_frame_entries[] = {NEEDED("stations"),
                                       NEEDED("cross_members"),
                                       NEEDED("rail"),
                                       NEEDED("member"),
                                       NEEDED_NUMBER(trk_frame_options, half_width, TRK_POSITIVE),
                                       NUMBER(trk_frame_options, z, TRK_ANY),
                                       NUMBER(trk_frame_options, longest, TRK_NOT_NEGATIVE),
                                       OF_KIND(WHOLE, trk_frame_options, member_elements),
                                       OF_KIND(FREEDOMS, trk_frame_options, freedoms),
                                       END};

const trk_entry trk_material_entries[] = {NEEDED_NUMBER(trk_material, young, TRK_POSITIVE),
                                          NEEDED_NUMBER(trk_material, shear, TRK_POSITIVE),
                                          NEEDED_NUMBER(trk_material, density, TRK_POSITIVE), END};

const trk_entry trk_section_entries[] = {APART("channel"), APART("box"),       APART("rectangle"),
                                         APART("tube"),    NEEDED("material"), END};

static const trk_entry walled_entries[] = {NEEDED_NUMBER(trk_profile, height, TRK_POSITIVE),
                                           NEEDED_NUMBER(trk_profile, width, TRK_POSITIVE),
                                           NEEDED_NUMBER(trk_profile, web, TRK_POSITIVE),
                                           NEEDED_NUMBER(trk_profile, flange, TRK_POSITIVE), END};

static const trk_entry rectangle_entries[] = {NEEDED_NUMBER(trk_profile, height, TRK_POSITIVE),
                                              NEEDED_NUMBER(trk_profile, width, TRK_POSITIVE), END};

static const trk_entry tube_entries[] = {NEEDED_NUMBER(trk_profile, outer, TRK_POSITIVE),
                                         NEEDED_NUMBER(trk_profile, wall, TRK_POSITIVE), END};

const trk_profile_form trk_profile_forms[TRK_PROFILE_FORMS] = {{"channel", walled_entries},
                                                               {"box", walled_entries},
                                                               {"rectangle", rectangle_entries},
                                                               {"tube", tube_entries}};

const trk_entry trk_port_entries[] = {APART("mirror"),
                                      APART("body"),
                                      APART("frame"),
                                      WORD(trk_port_options, motion, motions),
                                      OF_KIND(POINT, trk_port_options, point),
                                      OF_KIND(DIRECTION, trk_port_options, direction),
                                      END};

const trk_entry trk_sensor_entries[] = {APART("mirror"),
                                        WORD(trk_sensor_options, quantity, quantities),
                                        APART("body"),
                                        APART("frame"),
                                        OF_KIND(LINK, trk_sensor_options, link),
                                        WORD(trk_sensor_options, motion, motions),
                                        OF_KIND(POINT, trk_sensor_options, point),
                                        OF_KIND(DIRECTION, trk_sensor_options, direction),
                                        END};

static const trk_entry tire_entries[] = {NUMBER(trk_tire_options, stiffness, TRK_NOT_NEGATIVE),
                                         NUMBER(trk_tire_options, stiffening, TRK_NOT_NEGATIVE),
                                         NUMBER(trk_tire_options, damping, TRK_NOT_NEGATIVE),
                                         NUMBER(trk_tire_options, preload, TRK_NOT_NEGATIVE), END};

static const trk_entry stops_entries[] = {
    NUMBER(trk_stops_options, bump_clearance, TRK_NOT_NEGATIVE),
    NUMBER(trk_stops_options, bump_stiffness, TRK_NOT_NEGATIVE),
    OF_KIND(CURVE, trk_stops_options, bump_curve),
    NUMBER(trk_stops_options, rebound_clearance, TRK_NOT_NEGATIVE),
    NUMBER(trk_stops_options, rebound_stiffness, TRK_NOT_NEGATIVE),
    OF_KIND(CURVE, trk_stops_options, rebound_curve),
    END};

static const trk_entry leaf_entries[] = {
    NEEDED_NUMBER(trk_leaf_options, friction, TRK_POSITIVE),
    NUMBER(trk_leaf_options, friction_slope, TRK_NOT_NEGATIVE),
    NEEDED_NUMBER(trk_leaf_options, approach_bump, TRK_POSITIVE),
    NUMBER(trk_leaf_options, approach_rebound, TRK_NOT_NEGATIVE), END};

static const trk_entry friction_entries[] = {
    NEEDED_NUMBER(trk_friction_options, friction, TRK_POSITIVE),
    NEEDED_NUMBER(trk_friction_options, stiffness, TRK_POSITIVE), END};

static const trk_entry air_spring_entries[] = {
    NEEDED_NUMBER(trk_air_spring_options, pressure, TRK_POSITIVE),
    NEEDED_NUMBER(trk_air_spring_options, volume, TRK_POSITIVE),
    NEEDED_NUMBER(trk_air_spring_options, area, TRK_POSITIVE),
    NUMBER(trk_air_spring_options, area_slope, TRK_ANY),
    NUMBER(trk_air_spring_options, exponent, TRK_POSITIVE),
    NUMBER(trk_air_spring_options, ambient, TRK_POSITIVE),
    NUMBER(trk_air_spring_options, auxiliary_volume, TRK_NOT_NEGATIVE),
    NUMBER(trk_air_spring_options, conductance, TRK_NOT_NEGATIVE),
    NUMBER(trk_air_spring_options, temperature, TRK_POSITIVE),
    END};

static const trk_entry seal_entries[] = {NUMBER(trk_seal_options, sliding, TRK_NOT_NEGATIVE),
                                         NUMBER(trk_seal_options, breakaway, TRK_NOT_NEGATIVE),
                                         NUMBER(trk_seal_options, stribeck, TRK_POSITIVE),
                                         NUMBER(trk_seal_options, creep, TRK_POSITIVE), END};

#define LAW_FUNCTIONS(name)                                                                        \
    static void init_##name(void *options)                                                         \
    {                                                                                              \
        trk_##name##_options_init(options, sizeof(trk_##name##_options));                          \
    }                                                                                              \
    static trk_status create_##name(trk_context *context, const char *text, const void *options,   \
                                    trk_law **out_law)                                             \
    {                                                                                              \
        return trk_law_create_##name(context, text, options, out_law);                             \
    }                                                                                              \
    static trk_status get_##name(const trk_law *law, void *out_options)                            \
    {                                                                                              \
        return trk_law_get_##name(law, out_options);                                               \
    }
#define LAW_FORM(name, kind)                                                                       \
    {                                                                                              \
#name, kind, name##_entries, init_##name, create_##name, get_##name                        \
    }

LAW_FUNCTIONS(tire)
LAW_FUNCTIONS(stops)
LAW_FUNCTIONS(leaf)
LAW_FUNCTIONS(friction)
LAW_FUNCTIONS(air_spring)
LAW_FUNCTIONS(seal)

const trk_law_form trk_law_forms[TRK_LAW_FORMS] = {
    LAW_FORM(tire, TRK_LAW_TIRE),
    LAW_FORM(stops, TRK_LAW_STOPS),
    LAW_FORM(leaf, TRK_LAW_LEAF),
    LAW_FORM(friction, TRK_LAW_FRICTION),
    LAW_FORM(air_spring, TRK_LAW_AIR_SPRING),
    LAW_FORM(seal, TRK_LAW_SEAL),
};
