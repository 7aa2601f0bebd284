/* SPDX-License-Identifier: MIT */
/* Two specs, to the bit. */
#ifndef TRK_TESTS_MODELFILE_COMPARE_H
#define TRK_TESTS_MODELFILE_COMPARE_H

#include "support.h"

#include <truckride/modelfile.h>

static inline void same_bytes(const void *a, const void *b, size_t size, const char *what,
                              const char *name)
{
    if (memcmp(a, b, size) != 0)
        fail_msg("%s of '%s' is not the same", what, name);
}

#define SAME(field) same_bytes(&a.field, &b.field, sizeof a.field, #field, name)

static inline void same_curves(const trk_curve *a, const trk_curve *b, const char *name)
{
    assert_int_equal(a == NULL, b == NULL);
    if (!a)
        return;
    assert_string_equal(trk_curve_name(a), trk_curve_name(b));
    assert_int_equal(trk_curve_count(a), trk_curve_count(b));
    assert_int_equal(trk_curve_interpolation(a), trk_curve_interpolation(b));
    assert_int_equal(trk_curve_extrapolation(a), trk_curve_extrapolation(b));
    const size_t size = (size_t)trk_curve_count(a) * sizeof(double);
    same_bytes(trk_curve_x(a), trk_curve_x(b), size, "x", name);
    same_bytes(trk_curve_y(a), trk_curve_y(b), size, "y", name);
}

#define SAME_LAW(kind)                                                                             \
    do {                                                                                           \
        trk_##kind##_options a, b;                                                                 \
        trk_##kind##_options_init(&a, sizeof a);                                                   \
        trk_##kind##_options_init(&b, sizeof b);                                                   \
        assert_int_equal(trk_law_get_##kind(x, &a), TRK_OK);                                       \
        assert_int_equal(trk_law_get_##kind(y, &b), TRK_OK);                                       \
        same_bytes(&a, &b, sizeof a, #kind, name);                                                 \
    } while (0)

static inline void same_laws(const trk_law *x, const trk_law *y, const char *name)
{
    assert_int_equal(trk_law_get_kind(x), trk_law_get_kind(y));
    if (!x)
        return;
    assert_string_equal(trk_law_name(x), trk_law_name(y));
    switch (trk_law_get_kind(x)) {
    case TRK_LAW_TIRE: SAME_LAW(tire); break;
    case TRK_LAW_LEAF: SAME_LAW(leaf); break;
    case TRK_LAW_FRICTION: SAME_LAW(friction); break;
    case TRK_LAW_AIR_SPRING: SAME_LAW(air_spring); break;
    case TRK_LAW_SEAL: SAME_LAW(seal); break;
    default: {
        trk_stops_options a, b;
        trk_stops_options_init(&a, sizeof a);
        trk_stops_options_init(&b, sizeof b);
        assert_int_equal(trk_law_get_stops(x, &a), TRK_OK);
        assert_int_equal(trk_law_get_stops(y, &b), TRK_OK);
        SAME(bump_clearance);
        SAME(bump_stiffness);
        SAME(rebound_clearance);
        SAME(rebound_stiffness);
        same_curves(a.bump_curve, b.bump_curve, name);
        same_curves(a.rebound_curve, b.rebound_curve, name);
    }
    }
}

static inline void same_link(const trk_spec *x, const trk_spec *y, int32_t id, const char *name)
{
    trk_link_options a, b;
    trk_link_options_init(&a, sizeof a);
    trk_link_options_init(&b, sizeof b);
    assert_int_equal(trk_spec_get_link(x, id, &a), TRK_OK);
    assert_int_equal(trk_spec_get_link(y, id, &b), TRK_OK);
    same_curves(a.spring_curve, b.spring_curve, name);
    same_curves(a.damper_curve, b.damper_curve, name);
    same_laws(a.law, b.law, name);
    a.spring_curve = a.damper_curve = b.spring_curve = b.damper_curve = NULL;
    a.law = b.law = NULL;
    SAME(motion);
    SAME(from_body);
    SAME(from_road);
    SAME(to_body);
    SAME(from_point);
    SAME(to_point);
    SAME(direction);
    SAME(stiffness);
    SAME(damping);
    SAME(spring_scale);
    SAME(damper_scale);
    SAME(spring_offset);
}

#define SAME_OPTIONS(kind)                                                                         \
    do {                                                                                           \
        trk_##kind##_options a, b;                                                                 \
        trk_##kind##_options_init(&a, sizeof a);                                                   \
        trk_##kind##_options_init(&b, sizeof b);                                                   \
        assert_int_equal(trk_spec_get_##kind(x, id, &a), TRK_OK);                                  \
        assert_int_equal(trk_spec_get_##kind(y, id, &b), TRK_OK);                                  \
        same_bytes(&a, &b, sizeof a, #kind, name);                                                 \
    } while (0)

static inline void same_part(const trk_spec *x, const trk_spec *y, trk_part part, int32_t id)
{
    struct {
        int32_t body, reserved;
        double mass, point[3], x, y;
    } first = {0}, second = {0};
    const char *name = trk_spec_part_name(x, part, id);
    assert_string_equal(name, trk_spec_part_name(y, part, id));
    switch (part) {
    case TRK_PART_BODY: SAME_OPTIONS(body); break;
    case TRK_PART_LINK: same_link(x, y, id, name); break;
    case TRK_PART_BEAM: SAME_OPTIONS(beam); break;
    case TRK_PART_PORT: SAME_OPTIONS(port); break;
    case TRK_PART_SENSOR: SAME_OPTIONS(sensor); break;
    case TRK_PART_MASS:
        assert_int_equal(trk_spec_get_mass(x, id, &first.body, &first.mass, first.point), TRK_OK);
        assert_int_equal(trk_spec_get_mass(y, id, &second.body, &second.mass, second.point),
                         TRK_OK);
        break;
    default:
        assert_int_equal(trk_spec_get_road(x, id, &first.x, &first.y), TRK_OK);
        assert_int_equal(trk_spec_get_road(y, id, &second.x, &second.y), TRK_OK);
    }
    same_bytes(&first, &second, sizeof first, "mass or road", name);
}

static inline void same_specs(const trk_spec *x, const trk_spec *y)
{
    static const trk_part parts[] = {TRK_PART_BODY, TRK_PART_BEAM, TRK_PART_MASS,  TRK_PART_ROAD,
                                     TRK_PART_LINK, TRK_PART_PORT, TRK_PART_SENSOR};
    assert_string_equal(trk_spec_name(x), trk_spec_name(y));
    for (size_t p = 0; p < sizeof parts / sizeof *parts; p++) {
        assert_int_equal(trk_spec_count(x, parts[p]), trk_spec_count(y, parts[p]));
        for (int32_t id = 1; id <= trk_spec_count(x, parts[p]); id++)
            same_part(x, y, parts[p], id);
    }
}

/* Text of a spec; to be freed by free(). */
static inline char *text_of(trk_context *context, const trk_spec *spec)
{
    size_t length = 0;
    assert_ok(context, trk_model_file_format(spec, 0, NULL, &length));
    char *text = malloc(length + 1);
    assert_non_null(text);
    assert_ok(context, trk_model_file_format(spec, length + 1, text, NULL));
    assert_int_equal(strlen(text), length);
    return text;
}

#endif
