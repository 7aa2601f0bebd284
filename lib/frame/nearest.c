/* SPDX-License-Identifier: MIT */
/* The body next to a point. */
#include "spec/vary.h"
#include <truckride/frame.h>

#include <math.h>

trk_status trk_spec_nearest_body(const trk_spec *spec, const char *pattern, const double *point,
                                 int32_t *out_body)
{
    TRK_REQUIRE(NULL, spec, "trk_spec_nearest_body");
    trk_context *context = spec->context;
    TRK_REQUIRE(context, pattern, "trk_spec_nearest_body");
    TRK_REQUIRE(context, point, "trk_spec_nearest_body");
    TRK_REQUIRE(context, out_body, "trk_spec_nearest_body");
    *out_body = 0;
    for (int k = 0; k < 3; k++)
        if (!isfinite(point[k]))
            return trk_fail(context, TRK_E_RANGE,
                            "trk_spec_nearest_body: point[%d] is %g; a finite number is needed", k,
                            point[k]);
    double least = INFINITY;
    for (int32_t b = 1; b <= trk_spec_count(spec, TRK_PART_BODY); b++) {
        const double *cg = spec->bodies[b - 1].cg;
        const double distance = hypot(hypot(cg[0] - point[0], cg[1] - point[1]), cg[2] - point[2]);
        if ((*out_body == 0 || distance < least) &&
            trk_spec_matches(pattern, trk_spec_part_name(spec, TRK_PART_BODY, b))) {
            least = distance;
            *out_body = b;
        }
    }
    return *out_body ? TRK_OK
                     : trk_fail(context, TRK_E_NAME,
                                "trk_spec_nearest_body: no body of '%s' is called '%s'", spec->name,
                                pattern);
}
