/* SPDX-License-Identifier: MIT */
/*
 * What every kind of law must obey, in many variants: tangents are derivatives, evaluation is
 * pure, memory moves only by commit, cycles take energy, and work is stored or lost.
 */
#include "support.h"

#include "law/law.h"

static const double two_pi = 6.283185307179586476925286766559;

/* A law and the motion it is tried in. */
typedef struct variant {
    const char *name;
    trk_law *law;
    double reach, offset; /* e = offset -+ reach [m] */
    double speed;         /* v up to this [m/s]      */
    double step;          /* [s] of a trial          */
} variant;

enum { MOST = 24 };

typedef struct variants {
    variant of[MOST];
    int count;
} variants;

static trk_law **more(variants *all, const char *name, double reach, double offset, double speed)
{
    assert_true(all->count < MOST);
    variant *next = &all->of[all->count++];
    *next = (variant){name, NULL, reach, offset, speed, 0.002};
    return &next->law;
}

static void add_tires(trk_context *context, variants *all)
{
    trk_tire_options o;
    trk_tire_options_init(&o, sizeof o);
    o.stiffness = 1e6;
    assert_ok(context, trk_law_create_tire(context, "tire", &o, more(all, "tire", 0.05, 0, 1)));
    o.preload = 30e3;
    o.damping = 20e3;
    assert_ok(context, trk_law_create_tire(context, "damped tire", &o,
                                           more(all, "damped tire", 0.05, 0, 1)));
    o.stiffening = 5e6;
    assert_ok(context, trk_law_create_tire(context, "stiffening tire", &o,
                                           more(all, "stiffening tire", 0.05, 0, 1)));
    o.stiffness = 0;
    assert_ok(context, trk_law_create_tire(context, "square tire", &o,
                                           more(all, "square tire", 0.05, 0, 1)));
}

static void add_stops(trk_context *context, variants *all)
{
    const double x[] = {0, 0.01, 0.02, 0.03, 0.05}, y[] = {0, 1000, 2500, 7500, 30000};
    trk_curve *curve;
    trk_stops_options o;
    trk_stops_options_init(&o, sizeof o);
    o.bump_clearance = 0.04;
    o.bump_stiffness = 2e5;
    o.rebound_clearance = 0.03;
    o.rebound_stiffness = 5e5;
    assert_ok(context, trk_law_create_stops(context, "stops", &o, more(all, "stops", 0.08, 0, 1)));
    assert_ok(context, trk_curve_create(context, "rubber", 5, x, y, NULL, &curve));
    o.bump_curve = o.rebound_curve = curve;
    o.rebound_stiffness = 0;
    assert_ok(context, trk_law_create_stops(context, "rubber stops", &o,
                                            more(all, "rubber stops", 0.1, 0, 1)));
    trk_curve_destroy(curve);
}

static void add_leaves(trk_context *context, variants *all)
{
    trk_leaf_options o;
    trk_leaf_options_init(&o, sizeof o);
    o.friction = 2500;
    o.approach_bump = 0.002;
    assert_ok(context, trk_law_create_leaf(context, "leaf", &o, more(all, "leaf", 0.03, 0, 0.5)));
    o.approach_rebound = 0.005;
    assert_ok(context, trk_law_create_leaf(context, "leaf, slow rebound", &o,
                                           more(all, "leaf, slow rebound", 0.03, 0, 0.5)));
    o.friction_slope = 40e3;
    assert_ok(context, trk_law_create_leaf(context, "growing, slow rebound", &o,
                                           more(all, "growing, slow rebound", 0.03, 0.055, 0.5)));
    o.approach_rebound = 0.001;
    assert_ok(context, trk_law_create_leaf(context, "growing, slow bump", &o,
                                           more(all, "growing, slow bump", 0.03, 0.055, 0.5)));
    o.approach_rebound = 0;
    assert_ok(context, trk_law_create_leaf(context, "growing leaf", &o,
                                           more(all, "growing leaf", 0.03, 0.055, 0.5)));
}

static void add_friction(trk_context *context, variants *all)
{
    trk_friction_options o;
    trk_friction_options_init(&o, sizeof o);
    o.friction = 800;
    o.stiffness = 4e5;
    assert_ok(context, trk_law_create_friction(context, "dry", &o, more(all, "dry", 0.01, 0, 1)));
    trk_seal_options s;
    trk_seal_options_init(&s, sizeof s);
    s.sliding = 40;
    assert_ok(context, trk_law_create_seal(context, "seal", &s, more(all, "seal", 0.05, 0, 0.2)));
    s.breakaway = 90;
    s.stribeck = 0.05;
    s.creep = 0.004;
    assert_ok(context, trk_law_create_seal(context, "Stribeck seal", &s,
                                           more(all, "Stribeck seal", 0.05, 0, 0.2)));
}

/* conductance of the throttles: pressures level out within about 0.1 s. */
static void add_air_springs(trk_context *context, variants *all)
{
    trk_air_spring_options o;
    trk_air_spring_options_init(&o, sizeof o);
    o.pressure = 5.5e5;
    o.volume = 0.012;
    o.area = 0.045;
    assert_ok(context,
              trk_law_create_air_spring(context, "bellows", &o, more(all, "bellows", 0.1, 0, 1)));
    o.area_slope = -0.08;
    o.auxiliary_volume = 0.02;
    assert_ok(context, trk_law_create_air_spring(context, "shut throttle", &o,
                                                 more(all, "shut throttle", 0.1, 0, 1)));
    o.conductance = 1e-6;
    assert_ok(context, trk_law_create_air_spring(context, "throttled", &o,
                                                 more(all, "throttled", 0.1, 0, 1)));
    o.exponent = 1;
    assert_ok(context, trk_law_create_air_spring(context, "isothermal", &o,
                                                 more(all, "isothermal", 0.1, 0, 1)));
    o.exponent = 1.6;
    o.area_slope = 0.1;
    o.conductance = 1e-5;
    assert_ok(context, trk_law_create_air_spring(context, "quick throttle", &o,
                                                 more(all, "quick throttle", 0.1, 0, 1)));
}

static variants make(trk_context *context)
{
    variants all = {.count = 0};
    add_tires(context, &all);
    add_stops(context, &all);
    add_leaves(context, &all);
    add_friction(context, &all);
    add_air_springs(context, &all);
    return all;
}

static void for_each(trk_context *context, void (*work)(const variant *))
{
    variants all = make(context);
    for (int k = 0; k < all.count; k++) {
        work(&all.of[k]);
        trk_law_destroy(all.of[k].law);
    }
}

/* Uniform in -1 .. 1; a sequence of its own for each test. */
static double draw(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) / 4503599627370496.0 - 1;
}

static double draw_place(const variant *w, uint64_t *seed)
{
    return w->offset + w->reach * draw(seed);
}

/* Commit a move to e in the time h; the force there. */
static double commit(const trk_law *law, double *z, double e, double v, double h)
{
    trk_law_point point;
    double next[TRK_LAW_STATES] = {0};
    law->ops->evaluate(law, z, e, v, h, &point, next);
    memcpy(z, next, sizeof next);
    return point.force;
}

/* Memory after a random walk of a few commits, long and short. */
static double wander(const variant *w, uint64_t *seed, double *z)
{
    double e = draw_place(w, seed);
    w->law->ops->relax(w->law, e, z);
    for (int k = 0; k < 4; k++) {
        double to = draw_place(w, seed), share = pow(10, 2 * draw(seed) - 2);
        e += share * (to - e);
        commit(w->law, z, e, 0, w->step * 10);
    }
    return e;
}

typedef struct motion {
    double e, v, h;
} motion;

static trk_law_point trial(const trk_law *law, const double *z, motion m)
{
    double next[TRK_LAW_STATES];
    trk_law_point point;
    law->ops->evaluate(law, z, m.e, m.v, m.h, &point, next);
    return point;
}

/* Whether the tangent is the derivative, or at a corner the one on either side. */
static bool is_slope(double tangent, double before, double at, double after, double width,
                     double scale, int *corners)
{
    double left = (at - before) / width, right = (after - at) / width;
    if (fabs(tangent - (right + left) / 2) <= 1e-5 * scale)
        return true;
    ++*corners;
    double sharp = fabs(right - left), near = fmin(fabs(tangent - left), fabs(tangent - right));
    return sharp > 1e-3 * scale && near <= 1e-2 * sharp;
}

static void tangents_hold(const variant *w)
{
    enum { TRIES = 4000 };
    uint64_t seed = 7;
    int corners = 0;
    double k_most, c_most, z[TRK_LAW_STATES] = {0};
    w->law->ops->steepest(w->law, &k_most, &c_most);
    for (int k = 0; k < TRIES; k++) {
        double from = wander(w, &seed, z), de = 1e-6 * w->reach, dv = 1e-6 * w->speed;
        double share = k % 2 ? 1 : 1e-3; /* as far as an iteration goes, or anywhere */
        motion m = {from + share * (draw_place(w, &seed) - from), w->speed * draw(&seed),
                    k % 3 ? w->step : 0};
        motion less = m, more_ = m, slow = m, fast = m;
        less.e -= de;
        more_.e += de;
        slow.v -= dv;
        fast.v += dv;
        trk_law_point p = trial(w->law, z, m);
        double k_scale = fabs(p.stiffness) + k_most, c_scale = fabs(p.damping) + c_most + 1e-9;
        assert_true(isfinite(p.force));
        assert_true(is_slope(p.stiffness, trial(w->law, z, less).force, p.force,
                             trial(w->law, z, more_).force, de, k_scale + c_scale, &corners));
        assert_true(is_slope(p.damping, trial(w->law, z, slow).force, p.force,
                             trial(w->law, z, fast).force, dv, c_scale + k_scale * 1e-3, &corners));
    }
    assert_true(corners < TRIES / 100);
}

static void tangents_are_derivatives(void **state)
{
    for_each(*state, tangents_hold);
}

static void is_pure(const variant *w)
{
    uint64_t seed = 11;
    double z[TRK_LAW_STATES] = {0}, next[TRK_LAW_STATES] = {0}, again[TRK_LAW_STATES] = {0};
    for (int k = 0; k < 500; k++) {
        double kept[TRK_LAW_STATES];
        trk_law_point first, second;
        wander(w, &seed, z);
        memcpy(kept, z, sizeof kept);
        motion m = {draw_place(w, &seed), w->speed * draw(&seed), w->step};
        w->law->ops->evaluate(w->law, z, m.e, m.v, m.h, &first, next);
        for (int other = 0; other < 3; other++) {
            motion astray = {draw_place(w, &seed), w->speed * draw(&seed), w->step * other};
            trial(w->law, z, astray);
        }
        w->law->ops->evaluate(w->law, z, m.e, m.v, m.h, &second, again);
        assert_memory_equal(&first, &second, sizeof first);
        assert_memory_equal(next, again, sizeof next);
        assert_memory_equal(z, kept, sizeof kept);
    }
}

static void evaluation_is_pure(void **state)
{
    for_each(*state, is_pure);
}

/* Trials between the commits, as a Newton iteration makes, leave no trace. */
static void forgets_trials(const variant *w)
{
    uint64_t path = 3, astray = 5;
    double z[TRK_LAW_STATES] = {0}, with_trials[TRK_LAW_STATES] = {0}, e = w->offset;
    w->law->ops->relax(w->law, e, z);
    w->law->ops->relax(w->law, e, with_trials);
    for (int k = 0; k < 300; k++) {
        e = draw_place(w, &path);
        double v = w->speed * draw(&path), force = commit(w->law, z, e, v, w->step);
        for (int other = 0; other < 5; other++)
            trial(w->law, with_trials,
                  (motion){draw_place(w, &astray), w->speed * draw(&astray), w->step});
        assert_near(commit(w->law, with_trials, e, v, w->step), force, 0);
        assert_memory_equal(z, with_trials, sizeof z);
    }
}

static void memory_moves_only_by_commit(void **state)
{
    for_each(*state, forgets_trials);
}

static void stays_at_rest(const variant *w)
{
    uint64_t seed = 13;
    for (int k = 0; k < 300; k++) {
        double e = draw_place(w, &seed), de = 1e-5 * w->reach, z[TRK_LAW_STATES] = {0};
        trk_law_point at, low, high;
        w->law->ops->relax(w->law, e, z);
        w->law->ops->rest(w->law, e, &at);
        w->law->ops->rest(w->law, e - de, &low);
        w->law->ops->rest(w->law, e + de, &high);
        double scale = fabs(at.stiffness) + 1, size = fabs(at.force) + 1;
        assert_near(at.force, trial(w->law, z, (motion){e, 0, 0}).force, 1e-12 * size);
        double difference = (high.force - low.force) / (2 * de);
        bool corner = fabs(high.stiffness - low.stiffness) > 1e-2 * scale;
        if (!corner)
            assert_near(at.stiffness, difference, 1e-5 * scale + 1e-10 * size / de);
        for (int s = 0; s < 50; s++)
            assert_near(commit(w->law, z, e, 0, 0.1), at.force, 1e-10 * size);
        assert_near(w->law->ops->lost(w->law, z, e, 0), 0, 1e-9);
    }
}

static void relaxed_laws_stay_at_rest(void **state)
{
    for_each(*state, stays_at_rest);
}

/* A closed random path: many harmonics of one period. */
enum { HARMONICS = 12 };

typedef struct path {
    double offset, pulsation, cosine[HARMONICS], sine[HARMONICS];
} path;

static path draw_path(const variant *w, uint64_t *seed)
{
    path p = {.offset = w->offset, .pulsation = two_pi * pow(10, draw(seed))};
    double sum = 0;
    int highest = 1 + (int)(0.5 * (HARMONICS - 1) * (1 + draw(seed)));
    for (int k = 0; k < highest; k++) {
        p.cosine[k] = draw(seed) / (k + 1);
        p.sine[k] = draw(seed) / (k + 1);
        sum += fabs(p.cosine[k]) + fabs(p.sine[k]);
    }
    double size = 1.5 * w->reach * pow(10, fmin(0, draw(seed))) / sum; /* half of them large */
    for (int k = 0; k < HARMONICS; k++) {
        p.cosine[k] *= size;
        p.sine[k] *= size;
    }
    return p;
}

static double place(const path *p, double angle, double *out_v)
{
    double e = p->offset;
    *out_v = 0;
    for (int k = 0; k < HARMONICS; k++) {
        double c = cos((k + 1) * angle), s = sin((k + 1) * angle);
        e += p->cosine[k] * c + p->sine[k] * s;
        *out_v += p->pulsation * (k + 1) * (p->sine[k] * c - p->cosine[k] * s);
    }
    return e;
}

/* What a path did: work on the law, the same without signs, and the heat of `lost`. */
typedef struct ledger {
    double work, turnover, heat;
} ledger;

/* Power into the law and heat out of it after a move from z; the memory goes to z_next. */
static void look(const variant *w, const double *z, const path *p, double angle, double h,
                 double *z_next, double *out_power, double *out_heat)
{
    double v, e = place(p, angle, &v);
    trk_law_point point;
    w->law->ops->evaluate(w->law, z, e, v, h, &point, z_next);
    *out_power = point.force * v;
    *out_heat = w->law->ops->lost(w->law, z_next, e, v);
    assert_true(*out_heat >= 0);
}

static bool turns_on_or_off(const double *power, const double *heat)
{
    return (power[0] == 0) != (power[2] == 0) || (heat[0] == 0) != (heat[2] == 0);
}

/* Commit the way from one angle to another and add f v and `lost` by Simpson's rule; where a law
 * takes hold, lets go, sticks or slides on the way, in shorter steps. */
static void go(const variant *w, const path *p, double *z, double from, double to, int depth,
               ledger *sum)
{
    double h = (to - from) / p->pulsation, middle = from + (to - from) / 2, power[3], heat[3];
    double next[TRK_LAW_STATES] = {0}, aside[TRK_LAW_STATES] = {0};
    look(w, z, p, from, 0, aside, &power[0], &heat[0]);
    look(w, z, p, middle, h / 2, aside, &power[1], &heat[1]);
    look(w, z, p, to, h, next, &power[2], &heat[2]);
    if (depth > 0 && turns_on_or_off(power, heat)) {
        go(w, p, z, from, middle, depth - 1, sum);
        go(w, p, z, middle, to, depth - 1, sum);
        return;
    }
    memcpy(z, next, sizeof next);
    sum->work += h * (power[0] + 4 * power[1] + power[2]) / 6;
    sum->turnover += h * (fabs(power[0]) + 4 * fabs(power[1]) + fabs(power[2])) / 6;
    sum->heat += h * (heat[0] + 4 * heat[1] + heat[2]) / 6;
}

/* A share of a period, in `steps` commits or more. */
static ledger go_along(const variant *w, const path *p, double *z, double share, int steps)
{
    ledger sum = {0, 0, 0};
    double angle = two_pi * share;
    for (int k = 0; k < steps; k++)
        go(w, p, z, angle * k / steps, angle * (k + 1) / steps, 16, &sum);
    return sum;
}

/*
 * No round gives more than was stored, and none gives anything once the memory comes back to
 * where it was.
 */
static void takes_energy(const variant *w)
{
    enum { PATHS = 15 };
    uint64_t seed = 17;
    int closed = 0;
    for (int k = 0; k < PATHS; k++) {
        path p = draw_path(w, &seed);
        double z[TRK_LAW_STATES] = {0}, z_before[TRK_LAW_STATES], v, e = place(&p, 0, &v);
        w->law->ops->relax(w->law, e, z);
        for (int turn = 0; turn < 60; turn++)
            go_along(w, &p, z, 1, 60);
        memcpy(z_before, z, sizeof z);
        double before = w->law->ops->stored(w->law, z, e);
        ledger round = go_along(w, &p, z, 1, 2000);
        double gain = w->law->ops->stored(w->law, z, e) - before, slack = 1e-6 * round.turnover;
        assert_true(round.work - gain >= -slack);
        if (fabs(z[0] - z_before[0]) > 1e-4 * fabs(z[0]))
            continue;
        closed++;
        assert_true(round.work >= -slack - fabs(gain));
    }
    assert_true(closed > PATHS / 3);
}

static void closed_cycles_dissipate(void **state)
{
    for_each(*state, takes_energy);
}

/* work = stored + lost, to 1e-6 of the work done, on paths that end elsewhere than they began. */
static void balances(const variant *w)
{
    uint64_t seed = 19;
    for (int k = 0; k < 5; k++) {
        path p = draw_path(w, &seed);
        double share = 1.25 + 0.5 * draw(&seed), v, e = place(&p, 0, &v), z[TRK_LAW_STATES] = {0};
        w->law->ops->relax(w->law, e, z);
        double before = w->law->ops->stored(w->law, z, e);
        ledger way = go_along(w, &p, z, share, 20000);
        e = place(&p, two_pi * share, &v);
        double gain = w->law->ops->stored(w->law, z, e) - before;
        assert_near(way.work, gain + way.heat, 1e-6 * way.turnover);
    }
}

static void work_is_stored_or_lost(void **state)
{
    for_each(*state, balances);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(tangents_are_derivatives),    TEST(evaluation_is_pure),
        TEST(memory_moves_only_by_commit), TEST(relaxed_laws_stay_at_rest),
        TEST(closed_cycles_dissipate),     TEST(work_is_stored_or_lost),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
