/* SPDX-License-Identifier: MIT */
/* Fits on fields of laws and beams find what made their targets. Needs NLOPT, Needs LAPACK */
#include "fit.h"
#include "laws.h"

typedef struct parameter {
    const char *pattern;
    trk_field field;
} parameter;

static trk_calibration *create(trk_context *context, int count, const parameter *parameters)
{
    trk_calibration *c;
    trk_spec *spec = support_truck_with_tail(context);
    assert_ok(context, trk_calibration_create(context, spec, NULL, &c));
    trk_spec_destroy(spec);
    for (int k = 0; k < count; k++) {
        char name[32];
        int32_t id;
        snprintf(name, sizeof name, "parameter %d", k);
        assert_ok(context, trk_calibration_add_parameter(c, name, NULL, &id));
        assert_ok(context, trk_calibration_act_on(c, id, parameters[k].field, parameters[k].pattern,
                                                  1, NULL));
    }
    return c;
}

static const char *const coordinate[] = {"front_axle.z", "rear_axle.z", "tail.z"};

enum { TARGETS = 3 };

/* Frequencies that these factors give, then a fit that starts from 1. */
static trk_status fit(trk_context *context, int count, const parameter *parameters,
                      const double *factor, double *out_fitted)
{
    double value[TARGETS];
    trk_calibration *c = create(context, count, parameters);
    for (int k = 0; k < TARGETS; k++)
        fit_mode(context, c, coordinate[k], 1);
    assert_ok(context, trk_calibration_evaluate(c, factor, value, NULL));
    trk_calibration_destroy(c);
    c = create(context, count, parameters);
    for (int k = 0; k < TARGETS; k++)
        fit_mode(context, c, coordinate[k], value[k]);
    trk_status status = trk_calibration_solve(c, NULL, NULL, NULL);
    for (int k = 0; k < count; k++)
        out_fitted[k] = fit_fitted(c, k + 1);
    trk_calibration_destroy(c);
    return status;
}

/* Stuck, a leaf is a spring of R / beta: either gives the frequencies of the axles. */
static void friction_approach_and_bending(void **state)
{
    static const parameter parameters[] = {{"front_*_spring", TRK_FIELD_FRICTION},
                                           {"rear_*_spring", TRK_FIELD_APPROACH},
                                           {"tail", TRK_FIELD_BENDING}};
    static const double factor[] = {0.6, 1.7, 1.4};
    double fitted[3];
    assert_ok(*state, fit(*state, 3, parameters, factor, fitted));
    for (int k = 0; k < 3; k++)
        assert_near(fitted[k] / factor[k], 1, 1e-5);
}

/* Only their ratio shows in small motions. */
static void friction_and_approach_of_one_spring(void **state)
{
    static const parameter parameters[] = {{"*_spring", TRK_FIELD_FRICTION},
                                           {"*_spring", TRK_FIELD_APPROACH}};
    static const double factor[] = {1.2, 1.1};
    double fitted[2];
    assert_status(*state, fit(*state, 2, parameters, factor, fitted), TRK_E_IDENTIFY);
}

/* Two fields of one law and the spring beside it, told apart by nothing but bookkeeping. */
static void fields_of_one_link_do_not_disturb_each_other(void **state)
{
    static const parameter parameters[] = {{"*_spring", TRK_FIELD_FRICTION},
                                           {"*_spring", TRK_FIELD_STIFFNESS},
                                           {"*_spring", TRK_FIELD_APPROACH}};
    static const double factor[3][3] = {{2, 1, 2}, {1, 1, 1}, {3, 1, 3}};
    double value[3][TARGETS];
    trk_calibration *c = create(*state, 3, parameters);
    for (int k = 0; k < TARGETS; k++)
        fit_mode(*state, c, coordinate[k], 1);
    for (int k = 0; k < 3; k++)
        assert_ok(*state, trk_calibration_evaluate(c, factor[k], value[k], NULL));
    for (int k = 0; k < TARGETS; k++) { /* R / beta is the same */
        assert_near(value[0][k] / value[1][k], 1, 1e-9);
        assert_near(value[2][k] / value[1][k], 1, 1e-9);
    }
    trk_calibration_destroy(c);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(friction_approach_and_bending),
        TEST(friction_and_approach_of_one_spring),
        TEST(fields_of_one_link_do_not_disturb_each_other),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
