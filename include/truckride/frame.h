/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/frame.h
 * @brief Ladder frames of beams: two side rails joined by cross members.
 *
 * A frame is no more than bodies (its nodes) and beams added to a spec, so links, sensors,
 * masses and ports attach to it as to any body: ask trk_spec_nearest_body() for the node next to a point;
 * the point itself may lie anywhere, it moves with the node.
 */
#ifndef TRUCKRIDE_FRAME_H
#define TRUCKRIDE_FRAME_H

#include <truckride/spec.h>

/**
 * Stiffness and mass of a section of a material into beam options (FRAME.1); ends, `up` and damping stay.
 * All need finite dimensions > 0 that fit together. Warping of open sections is not modelled, nor
 * that the shear centre of a channel lies outside of it: its axis is the centroid for both.
 *
 * @param young   [Pa] modulus of elasticity E
 * @param shear   [Pa] shear modulus G
 * @param density [kg/m^3]
 * @param height  [m] along z of the section
 * @param width   [m] along y of the section
 * @param web     [m] thickness of the walls along z
 * @param flange  [m] thickness of the walls along y
 * @param options owned by caller
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_OPTIONS  options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE    a value is not finite, not positive, or walls thicker than the section
 * Source: W. C. Young, R. G. Budynas, Roark's Formulas for Stress and Strain, 7th ed., tables 10.1 and A.1.
 */
TRK_API trk_status trk_beam_options_channel(trk_context *context, double young, double shear,
                                            double density, double height, double width, double web,
                                            double flange,
                                            trk_beam_options *options) TRK_MUST_CHECK;
TRK_API trk_status trk_beam_options_box(trk_context *context, double young, double shear,
                                        double density, double height, double width, double web,
                                        double flange, trk_beam_options *options) TRK_MUST_CHECK;

/**
 * The same for a full rectangle. Further errors as trk_beam_options_channel().
 *
 * @param young   [Pa] modulus of elasticity E
 * @param shear   [Pa] shear modulus G
 * @param density [kg/m^3]
 * @param height  [m] along z of the section
 * @param width   [m] along y of the section
 */
TRK_API trk_status trk_beam_options_rectangle(trk_context *context, double young, double shear,
                                              double density, double height, double width,
                                              trk_beam_options *options) TRK_MUST_CHECK;

/**
 * The same for a round tube. Further errors as trk_beam_options_channel().
 *
 * @param young   [Pa] modulus of elasticity E
 * @param shear   [Pa] shear modulus G
 * @param density [kg/m^3]
 * @param outer   [m] outer diameter
 * @param wall    [m] thickness, at most half of it: a full rod
 */
TRK_API trk_status trk_beam_options_tube(trk_context *context, double young, double shear,
                                         double density, double outer, double wall,
                                         trk_beam_options *options) TRK_MUST_CHECK;

/** Options of trk_spec_add_frame(). */
typedef struct trk_frame_options {
    size_t                  struct_size;  /**< [byte] set by trk_frame_options_init()            */
    int32_t                 freedoms;     /**< [-] of every node, sum of TRK_FREE_...; default all six.
                                               z, roll and pitch alone make a grillage that needs no
                                               ties in the horizontal plane                      */
    int32_t                 stations;     /**< [-] number of places along x, >= 2                */
    const double           *station;      /**< [m] x of the nodes of both rails, strictly rising or falling, length stations */
    int32_t                 crosses;      /**< [-] number of cross members, >= 1                 */
    const double           *cross;        /**< [m] x of the cross members, each one of the stations, length crosses */
    double                  half_width;   /**< [m] > 0, |y| of the axes of the rails             */
    double                  z;            /**< [m] height of their axes; default 0               */
    double                  longest;      /**< [m] rails are divided until no element is longer; default 0: by stations only */
    const trk_beam_options *rail;         /**< [-] stiffness, mass, damping of a rail; ends and `up` not used */
    const trk_beam_options *member;       /**< [-] of a cross member; ends and `up` not used     */
    int32_t                 member_elements; /**< [-] elements of a cross member, >= 1; default 1 */
    int32_t                 reserved;     /**< [-] must be 0                                     */
} trk_frame_options;

/** Set every field to its default. Call as trk_frame_options_init(&o, sizeof o). */
TRK_API void trk_frame_options_init(trk_frame_options *options, size_t struct_size);

/**
 * Add a ladder frame. Nodes are called "NAME.left.1", "NAME.right.1", ... in the order of
 * the stations, those inside of cross members "NAME.cross.2.1"; beams likewise. All or nothing.
 *
 * Dividing the rails adds nodes between the stations, which are counted too.
 *
 * @param name    of the frame; not empty, at most 100 characters
 * @param options copied, with all that they point to
 * @retval TRK_E_ARGUMENT a pointer is NULL, or freedoms has an unknown bit or is 0
 * @retval TRK_E_OPTIONS  options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE    a value is not finite or out of its range; stations do not rise or fall; a
 *                        cross member is not at a station
 * @retval TRK_E_NAME     a name of a node or beam is taken or too long
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_spec_add_frame(trk_spec *spec, const char *name,
                                      const trk_frame_options *options) TRK_MUST_CHECK;

/**
 * Id of the body whose centre of gravity is nearest to a point, among those whose name matches
 * ("frame.*"); of equally near ones the first.
 *
 * @param point [m] length 3
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_RANGE    the point is not finite
 * @retval TRK_E_NAME     nothing matches the pattern
 */
TRK_API trk_status trk_spec_nearest_body(const trk_spec *spec, const char *pattern, const double *point,
                                         int32_t *out_body) TRK_MUST_CHECK;

#endif
