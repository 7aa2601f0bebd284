/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/reduce.h
 * @brief Fewer coordinates for a flexible frame: Craig-Bampton reduction of a model.
 *
 * The nodes of a component that only beams (and linear links among its own nodes) touch are interior;
 * those where links to other bodies or roads, or curves and laws, attach are its interface. Interior motion becomes static
 * following of the interface and a few fixed-interface modes (REDUCE.1):
 *
 *     q_i = -K_ii^-1 K_ib q_b + Phi eta,   K_ii Phi = M_ii Phi diag(omega^2)
 *
 * The deflections of the interior under its weight and under a unit load on each port, as far as the modes
 * do not have them, are kept as further coordinates (REDUCE.3). The result is a model like any other:
 * same parts, same sensors, ports and static equilibrium.
 * Needs TRK_FEATURE_LAPACK; for large components TRK_FEATURE_CHOLMOD and TRK_FEATURE_ARPACK.
 */
#ifndef TRUCKRIDE_REDUCE_H
#define TRUCKRIDE_REDUCE_H

#include <truckride/linear.h>

/** Options of trk_model_reduce(). */
typedef struct trk_reduce_options {
    size_t      struct_size;     /**< [byte] set by trk_reduce_options_init()                     */
    const char *pattern;         /**< [-] names of the bodies of the component, "frame.*"; default "*.*", not copied */
    int32_t     modes;           /**< [-] fixed-interface modes kept, >= 0; default 20            */
    int32_t     interface_modes; /**< [-] 0 (default): interface coordinates stay; else their motion
                                      is reduced to that many modes of the component as a whole, the
                                      modes and rigid motions of lowest frequency: smaller, but no
                                      longer exact in statics                                     */
    double      modal_damping;   /**< [-] >= 0, damping ratio given to the kept fixed-interface modes, in place
                                      of the damping of the beams there; default -1: keep that of the beams */
} trk_reduce_options;

/** Set every field to its default. Call as trk_reduce_options_init(&o, sizeof o). */
TRK_API void trk_reduce_options_init(trk_reduce_options *options, size_t struct_size);

/**
 * Reduce the component of a model. Coordinates kept have their names, modes are "modes.1", ...: the
 * displacement [m] of the coordinate that the mode moves farthest. Of `modes` and `interface_modes`
 * there are at most as many as the component has. Beams keep their names, but what they do becomes
 * common to the component; links with a name stay what they are.
 *
 * @param model     may be destroyed afterwards
 * @param options   NULL for the defaults
 * @param out_model owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT    a pointer is NULL, also the pattern
 * @retval TRK_E_OPTIONS     options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE       a number of modes or a damping ratio is out of range
 * @retval TRK_E_NAME        no body matches the pattern
 * @retval TRK_E_MODEL       the component has no interior to reduce
 * @retval TRK_E_SINGULAR    the interior moves freely with the interface held; the message names a coordinate
 * @retval TRK_E_UNSUPPORTED this build has no LAPACK, or the component is large and it has no ARPACK or CHOLMOD
 * @retval TRK_E_CONVERGENCE the eigensolver did not converge
 * @retval TRK_E_MEMORY      no memory
 * Source: R. R. Craig, M. C. C. Bampton, AIAA J. 6 (1968) 1313-1319.
 */
TRK_API trk_status trk_model_reduce(trk_context *context, const trk_model *model,
                                    const trk_reduce_options *options,
                                    trk_model **out_model) TRK_MUST_CHECK;

#endif
