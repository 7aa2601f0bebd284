/* SPDX-License-Identifier: MIT */
/* Models of the linear tests. */
#ifndef TRK_TESTS_LINEAR_MODELS_H
#define TRK_TESTS_LINEAR_MODELS_H

#include "support.h"

#include <truckride/linear.h>
#include <truckride/vehicle.h>

static const double two_pi = 6.283185307179586476925286766559;

enum { MAXIMUM = 16 }; /* coordinates of any model here */

/* Compile and destroy a spec; free bodies are welcome. */
static inline trk_model *compile(trk_context *context, trk_spec *spec)
{
    trk_model *model;
    trk_model_options options;
    trk_model_options_init(&options, sizeof options);
    options.allow_free = 1;
    assert_ok(context, trk_model_compile(context, spec, &options, &model));
    trk_spec_destroy(spec);
    return model;
}

static inline trk_model *builtin(trk_context *context, trk_vehicle vehicle)
{
    trk_spec *spec;
    assert_ok(context, trk_vehicle_create_builtin(context, vehicle, TRK_VARIANT_LINEAR, &spec));
    return compile(context, spec);
}

/* n equal masses one above the other, equal springs and dampers between them, on nothing. */
static inline trk_spec *chain(trk_context *context, int n, double mass, double damping,
                              double stiffness)
{
    trk_spec *spec;
    assert_ok(context, trk_spec_create(context, "chain", &spec));
    trk_body_options body;
    trk_link_options link;
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    body.mass = mass;
    link.stiffness = stiffness;
    link.damping = damping;
    for (int k = 0; k < n; k++) {
        char name[] = {(char)('a' + k), '\0'};
        link.from_body = link.to_body;
        assert_ok(context, trk_spec_add_body(spec, name, &body, &link.to_body));
        if (k > 0)
            assert_ok(context, trk_spec_add_link(spec, name, &link, NULL));
    }
    return spec;
}

#endif
