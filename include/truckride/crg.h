/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/crg.h
 * @brief Measured road surfaces from ASAM OpenCRG 1.2 files, and profiles under the wheels.
 *
 * A surface is a grid of heights over u, the distance along a reference line, and v, the distance
 * to the left of it, plus the height of the reference line itself and its banking:
 *
 *     z(u, v) = grid(u, v) + z_line(u) + banking(u) v                                     (CRG.1)
 *
 * bilinear between grid points, as the C library of ASAM evaluates it. A truck drives along u:
 * both wheel tracks are profiles over u at constant v, whatever the reference line does in the
 * plane; in a curve the outer wheel's own path is longer than u.
 *
 * Readers work as those of truckride/files.h.
 */
#ifndef TRUCKRIDE_CRG_H
#define TRUCKRIDE_CRG_H

#include <truckride/series.h>
#include <truckride/signal.h>

/** A road surface; immutable. */
typedef struct trk_crg trk_crg;

/** What lies beyond the grid. Offsets of the file (BORDER_OFFSET_U, _V) are added. */
typedef int32_t trk_crg_border;
enum {
    TRK_CRG_BORDER_FILE    = 0, /**< what the file says (BORDER_MODE_U, _V), else KEEP         */
    TRK_CRG_BORDER_NONE    = 1, /**< nothing: heights there are NaN                            */
    TRK_CRG_BORDER_ZERO    = 2, /**< height 0, without reference line and banking              */
    TRK_CRG_BORDER_KEEP    = 3, /**< the height at the border                                  */
    TRK_CRG_BORDER_REPEAT  = 4, /**< the grid again from its other end                         */
    TRK_CRG_BORDER_REFLECT = 5  /**< the grid backwards                                        */
};

/** What becomes of missing heights (NaN) in the grid. */
typedef int32_t trk_crg_missing;
enum {
    TRK_CRG_MISSING_FILE  = 0, /**< what the file says (GRID_NAN_MODE), else NEIGHBOUR        */
    TRK_CRG_MISSING_KEEP  = 1, /**< stay NaN, and heights next to them, too                   */
    TRK_CRG_MISSING_ZERO  = 2, /**< 0, plus GRID_NAN_OFFSET                                   */
    TRK_CRG_MISSING_NEIGHBOUR = 3 /**< the nearest height to the right in the same row, else to the
                                       left, plus GRID_NAN_OFFSET; rows without any stay NaN   */
};

/** Options of trk_crg_read(). */
typedef struct trk_crg_options {
    size_t          struct_size; /**< [byte] set by trk_crg_options_init()                 */
    trk_crg_border  border_u;    /**< [-] before and behind; default TRK_CRG_BORDER_FILE   */
    trk_crg_border  border_v;    /**< [-] right and left; default TRK_CRG_BORDER_FILE      */
    trk_crg_missing missing;     /**< [-] default TRK_CRG_MISSING_FILE                     */
    int32_t         reserved;    /**< [-] must be 0                                        */
} trk_crg_options;

/** Set every field to its default. Call as trk_crg_options_init(&o, sizeof o). */
TRK_API void trk_crg_options_init(trk_crg_options *options, size_t struct_size);

/**
 * Read a surface: data formats LRFI, LDFI (text), KRBI, KDBI (binary) and, padded to records of 80
 * bytes, LRBI and LDBI (CRG.2). Of the modifiers (ROAD_CRG_MODS) SCALE_Z_GRID, SCALE_SLOPE,
 * SCALE_BANKING, GRID_NAN_MODE and GRID_NAN_OFFSET are applied; REFLINE_... and REFPOINT_... in x, y
 * and phi do not change heights over u and v, and are left out, as are checks and search settings.
 *
 * @param path    file to read
 * @param options NULL for the defaults
 * @param out_crg owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT    a pointer is NULL
 * @retval TRK_E_OPTIONS     options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE       an option is out of range
 * @retval TRK_E_FILE        the file cannot be read
 * @retval TRK_E_SYNTAX      no such file: a section, key or column is missing, doubled or malformed,
 *                           the grid is not one, or data are missing
 * @retval TRK_E_UNSUPPORTED the road data stand in another file (ROAD_CRG_FILE), a modifier that
 *                           changes heights otherwise, or BORDER_SMOOTH_...
 * @retval TRK_E_MEMORY      no memory
 * Source: ASAM OpenCRG 1.2; evaluation as in its C library (crgEvalz.c, crgLoader.c).
 */
TRK_API trk_status trk_crg_read(trk_context *context, const char *path,
                                const trk_crg_options *options, trk_crg **out_crg) TRK_MUST_CHECK;

/**
 * The same from memory.
 *
 * @param name  stands in messages for the path
 * @param bytes length size; may be NULL if size is 0; not needed any more when this returns
 * Further parameters and errors as trk_crg_read().
 */
TRK_API trk_status trk_crg_parse(trk_context *context, const char *name, const void *bytes,
                                 size_t size, const trk_crg_options *options,
                                 trk_crg **out_crg) TRK_MUST_CHECK;

/** Free a surface. NULL is allowed. */
TRK_API void trk_crg_destroy(trk_crg *crg);

/** Rows of the grid along u; 0 for NULL. */
TRK_API int64_t trk_crg_rows(const trk_crg *crg);

/** Columns of the grid across, along v; 0 for NULL. */
TRK_API int64_t trk_crg_columns(const trk_crg *crg);

/**
 * Extent of the grid.
 *
 * @param out_u         [m] first row; NULL to skip
 * @param out_increment [m] between rows; NULL to skip
 * @param out_right     [m] v of the first column, the rightmost; NULL to skip
 * @param out_left      [m] v of the last column; NULL to skip
 * @retval TRK_E_ARGUMENT crg is NULL
 */
TRK_API trk_status trk_crg_extent(const trk_crg *crg, double *out_u, double *out_increment,
                                  double *out_right, double *out_left);

/**
 * Height at a place (CRG.1).
 *
 * @param u [m] along the reference line
 * @param v [m] positive to the left
 * @return  [m] NaN where there is none: a NaN argument, a missing height, beyond TRK_CRG_BORDER_NONE
 */
TRK_API double trk_crg_height(const trk_crg *crg, double u, double v);

/**
 * Height along a wheel path as a signal over u, from the first to the last row: the surface itself,
 * linear between rows with its slope, or smooth (SIGNAL.4). Beyond its ends the end height is held.
 *
 * @param v          [m] of the path, positive to the left
 * @param smooth     0: linear, the slope jumps at rows; 1: C2 cubic spline through the rows, for
 *                   which there must be 4
 * @param out_signal owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_RANGE    v is not finite, smooth is not 0 or 1, or a height on the path is NaN
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_crg_profile(trk_context *context, const trk_crg *crg, double v,
                                   int32_t smooth, trk_signal **out_signal) TRK_MUST_CHECK;

/**
 * Heights along several wheel paths as channels over u [m], "v=0.9" and so on: input of
 * trk_iri() and trk_psd(). The sample rate is 1/spacing [1/m].
 *
 * @param paths      number of paths, >= 1
 * @param v          [m] length paths, all different
 * @param start      [m] u of the first sample
 * @param spacing    [m] > 0
 * @param samples    number of samples, >= 1
 * @param out_series owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_RANGE    a number is out of range, two paths are equal, or a height is NaN
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_crg_sample(trk_context *context, const trk_crg *crg, int32_t paths,
                                  const double *v, double start, double spacing, int64_t samples,
                                  trk_series **out_series) TRK_MUST_CHECK;

#endif
