/* SPDX-License-Identifier: MIT */
/* A vehicle with a law of every kind in it. */
#ifndef TRK_TESTS_LAWS_H
#define TRK_TESTS_LAWS_H

#include <truckride/spec.h>

/* Kinds are 1 to SUPPORT_LAWS. */
enum { SUPPORT_LAWS = TRK_LAW_SEAL };

/* A plausible law of a kind, "tire", "stop", "leaf", "pad", "air", "seal". */
trk_law *support_law(trk_context *context, trk_law_kind kind);

/*
 * Axle, frame and cab, one above the other on one road input, with all of them: tire; leaf spring, stop and seal
 * of the damper between axle and frame; air spring and friction between frame and cab. Sensors:
 * force of the tire, of the leaf spring, of the air spring, acceleration of the cab.
 */
trk_spec *support_every_law(trk_context *context);

/* The reference truck, its four axle springs with the friction of leaves. */
trk_spec *support_truck_on_leaves(trk_context *context);

/* The same with a body "tail" on a beam "tail" behind its frame: something for every trk_field. */
trk_spec *support_truck_with_tail(trk_context *context);

#endif
