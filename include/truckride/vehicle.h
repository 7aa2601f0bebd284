/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/vehicle.h
 * @brief Ready-made vehicles: quarter car, half car, half truck, 3D truck, and built-in data.
 *
 * Each function fills a spec that may be changed further. The written-out matrices
 * of all four are in docs/theory/vehicle.md (VEHICLE.1 to VEHICLE.4).
 *
 * The truck is described once, by trk_truck_parameters, as a whole vehicle. The 3D
 * truck uses all of it; the half truck is its left half (half the masses, the mean
 * of the left and right rates); an axle's quarter car is one wheel of it under its
 * static share of the sprung mass. So all models of one truck agree by construction.
 *
 * Names. Bodies: "cab", "frame", "front_axle", "rear_axle"; of the quarter car
 * "sprung", "unsprung"; of the half car "body" and "front_axle", "rear_axle", or
 * "left_wheel", "right_wheel". Links: "front_left_tire", "front_left_spring",
 * "front_left_damper", "front_left_bump_stop", "front_anti_roll_bar",
 * "cab_front_left_vertical", "cab_front_left_longitudinal",
 * "cab_rear_left_lateral", "cab_anti_roll_bar"; without left or right in the half
 * truck and half car. Roads: "front_left" and so on. Ports of both trucks:
 * "fifth_wheel_x", "fifth_wheel_z". Links without stiffness,
 * damping and curve are left out.
 *
 * Sensors: accelerations at the accelerometer places of the thesis (table 4),
 * "cab_front_left_z", "frame_rear_axle_left_z", "front_axle_left_z", ... and the
 * force of every tire, "front_left_tire_force". Half truck: without left or right.
 */
#ifndef TRUCKRIDE_VEHICLE_H
#define TRUCKRIDE_VEHICLE_H

#include <truckride/spec.h>

/** Index of arrays of two: axles, ends of the cab, ends of the half car. */
enum { TRK_FRONT = 0, TRK_REAR = 1 };

/** Index of arrays of four: cab mounts. */
enum { TRK_FRONT_LEFT = 0, TRK_FRONT_RIGHT = 1, TRK_REAR_LEFT = 2, TRK_REAR_RIGHT = 3 };

/** Quarter car: a sprung mass on a suspension on an unsprung mass on a tire (VEHICLE.1). */
typedef struct trk_quarter_car_parameters {
    size_t           struct_size;      /**< [byte] set by trk_quarter_car_parameters_init()   */
    double           sprung_mass;      /**< [kg] default 5000 (thesis, table 2)               */
    double           unsprung_mass;    /**< [kg] default 500                                  */
    double           spring_stiffness; /**< [N/m] default 500e3                               */
    double           damping;          /**< [N s/m] linear damper; default 0                  */
    double           tire_stiffness;   /**< [N/m] default 1000e3                              */
    double           tire_damping;     /**< [N s/m] default 500                               */
    const trk_curve *spring_curve;     /**< [N over m] added to the spring; default NULL      */
    const trk_curve *damper_curve;     /**< [N over m/s] added to the damper; default NULL    */
    double           spring_offset;    /**< [m] place on the spring curve at rest; default 0  */
    double           damper_scale;     /**< [-] of the damper curve; default 1                */
    const trk_curve *bump_stop_curve;  /**< [N over m] beside the spring; default NULL        */
    double           bump_stop_offset; /**< [m] place on that curve at rest; default 0        */
} trk_quarter_car_parameters;

/** Which half of a car. */
typedef int32_t trk_half_car_layout;
enum {
    TRK_HALF_CAR_PITCH = 0, /**< front and rear axle, body with z and pitch  */
    TRK_HALF_CAR_ROLL  = 1  /**< left and right wheel, body with z and roll  */
};

/** Half car: a rigid body on two quarter cars (VEHICLE.2). Index 0 front or left, 1 rear or right. */
typedef struct trk_half_car_parameters {
    size_t              struct_size;         /**< [byte] set by trk_half_car_parameters_init()  */
    trk_half_car_layout layout;              /**< [-] default TRK_HALF_CAR_PITCH                */
    double              body_mass;           /**< [kg] default 3542.5: one side of the reference tractor, cab and frame in one */
    double              body_inertia;        /**< [kg m^2] pitch or roll; default 14242.489      */
    double              position[2];         /**< [m] of the axles from the body's cg, forward or left positive; default 1.747996, -2.752004 */
    double              unsprung_mass[2];    /**< [kg] default 542.3905, 548.7905               */
    double              spring_stiffness[2]; /**< [N/m] default 222276, 256061.9                */
    double              damping[2];          /**< [N s/m] default 20000, 20000                  */
    double              tire_stiffness[2];   /**< [N/m] default 817500, 817500                  */
    double              tire_damping[2];     /**< [N s/m] default 500, 500                      */
    const trk_curve    *damper_curve[2];     /**< [N over m/s] added to the damper; default NULL */
    double              damper_scale[2];     /**< [-] of the damper curve; default 1            */
} trk_half_car_parameters;

/**
 * Truck: cab on frame on two axles (VEHICLE.3, VEHICLE.4). A whole vehicle,
 * rates per side. The defaults are the reference tractor with linear dampers: the
 * chassis of a MAN KAT1 4x4 (published with Project Chrono) and a European cab
 * suspension; a demonstration vehicle, not a real truck. Arrays of two are [TRK_FRONT],
 * [TRK_REAR], of four [TRK_FRONT_LEFT] and so on; points have y > 0 and hold for both sides.
 */
typedef struct trk_truck_parameters {
    size_t struct_size;                  /**< [byte] set by trk_truck_parameters_init()              */
    double cab_mass;                     /**< [kg] default 1242.63                                   */
    double cab_inertia[3];               /**< [kg m^2] roll, pitch, yaw; default 1490, 1273, 1476.4  */
    double cab_cg[3];                    /**< [m] default 0.4969, 0, 1.5704                          */
    double frame_mass;                   /**< [kg] default 5842.370                                  */
    double frame_inertia[3];             /**< [kg m^2] roll, pitch, yaw (not used); default 921.863, 18588.582, 20324.320 */
    double frame_cg[3];                  /**< [m] default -2.22547, 0, 0.56823                       */
    double axle_mass[2];                 /**< [kg] default 1084.781, 1097.581                        */
    double axle_roll_inertia[2];         /**< [kg m^2] default 733.815, 782.728                      */
    double axle_x[2];                    /**< [m] default 0, -4.5                                    */
    double axle_z[2];                    /**< [m] default 0, 0                                       */
    double tire_y[2];                    /**< [m] default 1.033, 1.035                               */
    double tire_stiffness[2];            /**< [N/m] per side; default 817500                         */
    double tire_damping[2];              /**< [N s/m] per side; default 500                          */
    double spring_y[2];                  /**< [m] default 0.571, 0.62                                */
    double spring_stiffness[2];          /**< [N/m] per side; default 222276, 256061.9               */
    double damper_y[2];                  /**< [m] default 0.5425, 0.625                              */
    double damping[2];                   /**< [N s/m] linear damper per side; default 20000          */
    double anti_roll_stiffness[2];       /**< [N m/rad] frame to axle; default 145900, 0             */
    double cab_mount_x[2];               /**< [m] vertical mounts; default 1.325, -0.475             */
    double cab_mount_y[2];               /**< [m] default 0.655, 0.5625                              */
    double cab_mount_z[2];               /**< [m] default 0.387, 0.350                               */
    double cab_vertical_stiffness[4];    /**< [N/m] default front 40000, rear 13750                  */
    double cab_vertical_damping[4];      /**< [N s/m] default front 4807.69, rear 2307.69            */
    double cab_longitudinal_x[2];        /**< [m] longitudinal arms; default 1.035, 0                */
    double cab_longitudinal_y[2];        /**< [m] default 0.505, 0                                   */
    double cab_longitudinal_z[2];        /**< [m] default 0.596, 0                                   */
    double cab_longitudinal_stiffness[4];/**< [N/m] default front 4e5, rear 0                        */
    double cab_longitudinal_damping[4];  /**< [N s/m] default front 2000, rear 0                     */
    double cab_lateral_x[2];             /**< [m] lateral arms; default 0, -0.475                    */
    double cab_lateral_y[2];             /**< [m] default 0, 0.35                                    */
    double cab_lateral_z[2];             /**< [m] default 0, 0.56                                    */
    double cab_lateral_stiffness[4];     /**< [N/m] default front 0, rear 1.5e5                      */
    double cab_lateral_damping[4];       /**< [N s/m] default front 0, rear 1000                     */
    double fifth_wheel[3];               /**< [m] place of the force ports; default -4, 0, 1.2 (assumed) */
    double cab_anti_roll_stiffness;      /**< [N m/rad] front cab suspension, cab to frame; default 0 */
    const trk_curve *spring_curve[2];    /**< [N over m] added to the axle spring; default NULL      */
    double spring_offset[2];             /**< [m] place on that curve at rest; default 0             */
    const trk_curve *damper_curve[2];    /**< [N over m/s] added to the axle damper; default NULL    */
    double damper_scale[2];              /**< [-] of that curve; default 1                           */
    const trk_curve *bump_stop_curve[2]; /**< [N over m] beside the axle spring; default NULL        */
    double bump_stop_offset[2];          /**< [m] place on that curve at rest; default 0             */
    const trk_curve *cab_spring_curve[2];/**< [N over m] added to the vertical mount; default NULL   */
    double cab_spring_offset[2];         /**< [m] place on that curve at rest; default 0             */
    const trk_curve *cab_damper_curve[2];/**< [N over m/s] added to the vertical mount; default NULL */
    double cab_damper_scale[2];          /**< [-] of that curve; default 1                           */
} trk_truck_parameters;

/** Set every field to its default. Call as trk_X_parameters_init(&p, sizeof p). */
TRK_API void trk_quarter_car_parameters_init(trk_quarter_car_parameters *parameters, size_t struct_size);
TRK_API void trk_half_car_parameters_init(trk_half_car_parameters *parameters, size_t struct_size);
TRK_API void trk_truck_parameters_init(trk_truck_parameters *parameters, size_t struct_size);

/**
 * Quarter car, 2 coordinates.
 *
 * @param parameters NULL for the defaults; curves are copied
 * @param out_spec   owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_OPTIONS  parameters come from a newer header and set an unknown field
 * @retval TRK_E_RANGE    a value is out of range; the message names part and field
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_vehicle_create_quarter_car(trk_context *context,
                                                  const trk_quarter_car_parameters *parameters,
                                                  trk_spec **out_spec) TRK_MUST_CHECK;

/** Half car, 4 coordinates. Arguments and errors as trk_vehicle_create_quarter_car();
 *  TRK_E_ARGUMENT also for an unknown layout. */
TRK_API trk_status trk_vehicle_create_half_car(trk_context *context,
                                               const trk_half_car_parameters *parameters,
                                               trk_spec **out_spec) TRK_MUST_CHECK;

/** Half truck, 7 coordinates: cab x, z, pitch; frame z, pitch; axles z. Arguments and errors as
 *  trk_vehicle_create_quarter_car(). */
TRK_API trk_status trk_vehicle_create_half_truck(trk_context *context,
                                                 const trk_truck_parameters *parameters,
                                                 trk_spec **out_spec) TRK_MUST_CHECK;

/** 3D truck, 13 coordinates: cab x, y, z, roll, pitch, yaw; frame z, roll, pitch; axles z,
 *  roll. Arguments and errors as trk_vehicle_create_quarter_car(). */
TRK_API trk_status trk_vehicle_create_truck(trk_context *context,
                                            const trk_truck_parameters *parameters,
                                            trk_spec **out_spec) TRK_MUST_CHECK;

/**
 * Quarter car of one wheel of a truck: half the axle's mass under half of its
 * static share of cab and frame (as the thesis does, section 8.1).
 *
 * @param axle TRK_FRONT or TRK_REAR
 * @retval TRK_E_ARGUMENT there is no such axle
 * @retval TRK_E_RANGE    the axle carries nothing
 * Further arguments and errors as trk_vehicle_create_quarter_car().
 */
TRK_API trk_status trk_vehicle_create_axle_quarter(trk_context *context,
                                                   const trk_truck_parameters *parameters,
                                                   int32_t axle, trk_spec **out_spec) TRK_MUST_CHECK;

/** Built-in vehicles. */
typedef int32_t trk_vehicle;
enum {
    TRK_VEHICLE_THESIS_QUARTER  = 1, /**< quarter car of the thesis, tables 2 and 3 */
    TRK_VEHICLE_REFERENCE_FRONT = 2, /**< front quarter car of the reference tractor */
    TRK_VEHICLE_REFERENCE_REAR  = 3, /**< rear quarter car of the reference tractor  */
    TRK_VEHICLE_REFERENCE_HALF  = 4, /**< half truck of the reference tractor        */
    TRK_VEHICLE_REFERENCE_TRUCK = 5  /**< 3D truck of the reference tractor          */
};

/** How the links of a built-in vehicle work. */
typedef int32_t trk_variant;
enum {
    TRK_VARIANT_LINEAR         = 0, /**< linear springs and dampers                           */
    TRK_VARIANT_THESIS_DAMPERS = 1, /**< linear springs, dampers of the thesis's table C3     */
    TRK_VARIANT_NONLINEAR      = 2  /**< published springs, shock absorbers and bump stops    */
};

/**
 * A built-in vehicle.
 *
 * The non-linear variant is drawn in its static equilibrium: the offsets of its
 * spring curves are such that every spring carries its static load at rest.
 * The thesis's quarter car always has the damper of table 3 and ignores the variant.
 * @param out_spec owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT a pointer is NULL, or there is no such vehicle or variant
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_vehicle_create_builtin(trk_context *context, trk_vehicle vehicle,
                                              trk_variant variant, trk_spec **out_spec) TRK_MUST_CHECK;

/** Built-in tables. Force over elongation or velocity, positive in extension. */
typedef int32_t trk_table;
enum {
    TRK_TABLE_THESIS_EXAMPLE_DAMPER = 1,     /**< thesis, table 1                                 */
    TRK_TABLE_THESIS_FRONT_AXLE_DAMPER = 2,  /**< thesis, tables 3 and C3                         */
    TRK_TABLE_THESIS_REAR_AXLE_DAMPER = 3,   /**< thesis, table C3                                */
    TRK_TABLE_THESIS_FRONT_CAB_DAMPER = 4,   /**< thesis, table C3                                */
    TRK_TABLE_THESIS_REAR_CAB_DAMPER = 5,    /**< thesis, table C3                                */
    TRK_TABLE_REFERENCE_AXLE_DAMPER = 6,     /**< c v / (1 + d |v|), sampled, within 0.1 % from 0.2 mm/s on */
    TRK_TABLE_REFERENCE_FRONT_SPRING = 7,    /**< k1 x + k2 x |x| from the free length            */
    TRK_TABLE_REFERENCE_REAR_SPRING = 8,     /**< the same, rear                                  */
    TRK_TABLE_REFERENCE_BUMP_STOP = 9,       /**< axle bump stop, 0 at first contact              */
    TRK_TABLE_REFERENCE_FRONT_CAB_SPRING = 10, /**< with preload and end stops                    */
    TRK_TABLE_REFERENCE_REAR_CAB_SPRING = 11,  /**< the same, rear                                */
    TRK_TABLE_REFERENCE_FRONT_CAB_DAMPER = 12, /**< European cab suspension                       */
    TRK_TABLE_REFERENCE_REAR_CAB_DAMPER = 13   /**< the same, rear                                */
};

/**
 * Curve through a built-in table.
 *
 * @param options   NULL for what suits the table: not-a-knot, which is exact, for the two
 *                  quadratic reference springs, PCHIP for the others; end-slope extrapolation
 * @param out_curve owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT a pointer is NULL, or there is no such table
 * Further errors as trk_curve_create().
 */
TRK_API trk_status trk_vehicle_create_curve(trk_context *context, trk_table table,
                                            const trk_curve_options *options,
                                            trk_curve **out_curve) TRK_MUST_CHECK;

#endif
