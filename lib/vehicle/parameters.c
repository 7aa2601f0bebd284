/* SPDX-License-Identifier: MIT */
/* Defaults of the ready-made vehicles. */
#include "vehicle/parameters.h"

static const trk_quarter_car_parameters quarter_car = {.struct_size = sizeof quarter_car,
                                                       .sprung_mass = 5000,
                                                       .unsprung_mass = 500,
                                                       .spring_stiffness = 500e3,
                                                       .tire_stiffness = 1000e3,
                                                       .tire_damping = 500,
                                                       .damper_scale = 1};

static const trk_half_car_parameters half_car = {.struct_size = sizeof half_car,
                                                 .body_mass = 3542.5,
                                                 .body_inertia = 14242.489,
                                                 .position = {1.747996, -2.752004},
                                                 .unsprung_mass = {542.3905, 548.7905},
                                                 .spring_stiffness = {222276, 256061.9},
                                                 .damping = {20000, 20000},
                                                 .tire_stiffness = {817500, 817500},
                                                 .tire_damping = {500, 500},
                                                 .damper_scale = {1, 1}};

static const trk_truck_parameters truck = {
    .struct_size = sizeof truck,
    .cab_mass = 1242.63,
    .cab_inertia = {1490, 1273, 1476.4},
    .cab_cg = {0.4969, 0, 1.5704},
    .frame_mass = 5842.370,
    .frame_inertia = {921.863, 18588.582, 20324.320},
    .frame_cg = {-2.22547, 0, 0.56823},
    .axle_mass = {1084.781, 1097.581},
    .axle_roll_inertia = {733.815, 782.728},
    .axle_x = {0, -4.5},
    .axle_z = {0, 0},
    .tire_y = {1.033, 1.035},
    .tire_stiffness = {817500, 817500},
    .tire_damping = {500, 500},
    .spring_y = {0.571, 0.62},
    .spring_stiffness = {222276.0, 256061.9},
    .damper_y = {0.5425, 0.625},
    .damping = {20000, 20000},
    .anti_roll_stiffness = {145900, 0},
    .cab_mount_x = {1.325, -0.475},
    .cab_mount_y = {0.655, 0.5625},
    .cab_mount_z = {0.387, 0.350},
    .cab_vertical_stiffness = {40000, 40000, 13750, 13750},
    .cab_vertical_damping = {4807.69, 4807.69, 2307.69, 2307.69},
    .cab_longitudinal_x = {1.035, 0},
    .cab_longitudinal_y = {0.505, 0},
    .cab_longitudinal_z = {0.596, 0},
    .cab_longitudinal_stiffness = {4e5, 4e5, 0, 0},
    .cab_longitudinal_damping = {2000, 2000, 0, 0},
    .cab_lateral_x = {0, -0.475},
    .cab_lateral_y = {0, 0.35},
    .cab_lateral_z = {0, 0.56},
    .cab_lateral_stiffness = {0, 0, 1.5e5, 1.5e5},
    .cab_lateral_damping = {0, 0, 1000, 1000},
    .fifth_wheel = {-4, 0, 1.2},
    .damper_scale = {1, 1},
    .cab_damper_scale = {1, 1}};

void trk_quarter_car_parameters_init(trk_quarter_car_parameters *parameters, size_t struct_size)
{
    trk_write_defaults(parameters, struct_size, &quarter_car, sizeof quarter_car);
}

void trk_half_car_parameters_init(trk_half_car_parameters *parameters, size_t struct_size)
{
    trk_write_defaults(parameters, struct_size, &half_car, sizeof half_car);
}

void trk_truck_parameters_init(trk_truck_parameters *parameters, size_t struct_size)
{
    trk_write_defaults(parameters, struct_size, &truck, sizeof truck);
}

trk_status trk_quarter_car_read(trk_context *context, const trk_quarter_car_parameters *given,
                                trk_quarter_car_parameters *out)
{
    *out = quarter_car;
    return trk_read_options(context, "trk_quarter_car_parameters", given, out, sizeof *out);
}

trk_status trk_half_car_read(trk_context *context, const trk_half_car_parameters *given,
                             trk_half_car_parameters *out)
{
    *out = half_car;
    return trk_read_options(context, "trk_half_car_parameters", given, out, sizeof *out);
}

trk_status trk_truck_read(trk_context *context, const trk_truck_parameters *given,
                          trk_truck_parameters *out)
{
    *out = truck;
    return trk_read_options(context, "trk_truck_parameters", given, out, sizeof *out);
}

/* Masses on a front and a rear support that balance a mass at x. */
static void lever(double mass, double x, const double *support_x, double *out_share)
{
    double front = (x - support_x[TRK_REAR]) / (support_x[TRK_FRONT] - support_x[TRK_REAR]);
    out_share[TRK_FRONT] += mass * front;
    out_share[TRK_REAR] += mass * (1 - front);
}

void trk_truck_axle_share(const trk_truck_parameters *p, double *out_share)
{
    out_share[TRK_FRONT] = out_share[TRK_REAR] = 0;
    lever(p->cab_mass, p->cab_cg[0], p->axle_x, out_share);
    lever(p->frame_mass, p->frame_cg[0], p->axle_x, out_share);
}

void trk_truck_cab_share(const trk_truck_parameters *p, double *out_share)
{
    out_share[TRK_FRONT] = out_share[TRK_REAR] = 0;
    lever(p->cab_mass, p->cab_cg[0], p->cab_mount_x, out_share);
}
