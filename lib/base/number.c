/* SPDX-License-Identifier: MIT */
/*
 * Decimal text to the nearest double (BASE.1). Three ways, each used when the one before it
 * cannot be sure: one exact operation; two doubles of precision with a bound of its error;
 * comparison with the midpoints between doubles in whole numbers of any length.
 */
#include "base/number.h"

#include <float.h>
#include <math.h>

enum {
    SHORT_DIGITS = 19,    /* fit into 64 bits                                               */
    LONGEST_DIGITS = 800, /* midpoints between doubles have at most 767 digits              */
    EXACT_POWER = 22,     /* the largest power of ten that is a double                      */
    WORDS = 160           /* of 32 bits: 5120 bits, room for 10^1124 2^54 and 10^800 2^1076 */
};

static const double power_of_ten[EXACT_POWER + 1] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/* value = short_value 10^short_exponent, and a little more if there are further digits. */
typedef struct decimal {
    const char *digits, *end; /* from the first digit that is not 0; with the point in between */
    int64_t count;            /* of these digits                                              */
    int64_t exponent;         /* of ten, of the last digit                                    */
    uint64_t short_value;     /* of the first SHORT_DIGITS digits                             */
    int64_t short_exponent;
} decimal;

typedef struct whole {
    int32_t count;
    uint32_t word[WORDS]; /* least significant first */
} whole;

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static void multiply(whole *w, uint32_t factor, uint32_t add)
{
    uint64_t carry = add;
    for (int32_t k = 0; k < w->count; k++) {
        carry += (uint64_t)w->word[k] * factor;
        w->word[k] = (uint32_t)carry;
        carry >>= 32;
    }
    if (carry)
        w->word[w->count++] = (uint32_t)carry;
}

static void multiply_by_power_of_ten(whole *w, int64_t power)
{
    for (; power >= 9; power -= 9)
        multiply(w, 1000000000u, 0);
    for (; power > 0; power--)
        multiply(w, 10, 0);
}

static void shift_left(whole *w, int bits)
{
    const int words = bits / 32;
    multiply(w, 1u << (bits % 32), 0);
    for (int32_t k = w->count - 1; k >= 0; k--)
        w->word[k + words] = w->word[k];
    for (int32_t k = 0; k < words; k++)
        w->word[k] = 0;
    w->count += words;
}

static int compare_whole(const whole *a, const whole *b)
{
    if (a->count != b->count)
        return a->count < b->count ? -1 : 1;
    for (int32_t k = a->count - 1; k >= 0; k--)
        if (a->word[k] != b->word[k])
            return a->word[k] < b->word[k] ? -1 : 1;
    return 0;
}

/* Sign of the decimal minus m 2^power. */
static int compare(const decimal *d, uint64_t m, int power)
{
    whole left = {0, {0}}, right = {0, {0}};
    int64_t taken = 0, exponent = d->exponent;
    const char *at = d->digits;
    for (; taken < LONGEST_DIGITS && taken < d->count; at++)
        if (is_digit(*at)) {
            multiply(&left, 10, (uint32_t)(*at - '0'));
            taken++;
        }
    if (taken < d->count) { /* what is cut off only breaks ties; it ends with a digit above 0 */
        multiply(&left, 10, 1);
        exponent += d->count - taken - 1;
    }
    multiply(&right, 1, (uint32_t)(m >> 32));
    shift_left(&right, 32);
    right.word[0] = (uint32_t)m;
    right.count = m >> 32 ? 2 : 1;
    multiply_by_power_of_ten(exponent > 0 ? &left : &right, exponent > 0 ? exponent : -exponent);
    shift_left(power > 0 ? &right : &left, power > 0 ? power : -power);
    return compare_whole(&left, &right);
}

/* From a guess to the double between whose midpoints the decimal lies; ties go to even. */
static double settle(const decimal *d, double z)
{
    while (isfinite(z)) {
        int power;
        double fraction = frexp(z, &power);
        power -= DBL_MANT_DIG;
        if (power < DBL_MIN_EXP - DBL_MANT_DIG || z == 0)
            power = DBL_MIN_EXP - DBL_MANT_DIG;
        const uint64_t m = (uint64_t)ldexp(z, -power), first = UINT64_C(1) << (DBL_MANT_DIG - 1);
        int side = compare(d, 2 * m + 1, power - 1);
        if (side > 0 || (side == 0 && m % 2)) {
            z = nextafter(z, INFINITY);
            continue;
        }
        if (m == 0)
            break;
        /* Below a power of two the doubles are twice as dense. */
        if (fraction == 0.5 && m == first && power > DBL_MIN_EXP - DBL_MANT_DIG)
            side = compare(d, 4 * m - 1, power - 2);
        else
            side = compare(d, 2 * m - 1, power - 1);
        if (side > 0 || (side == 0 && m % 2 == 0))
            break;
        z = nextafter(z, 0);
    }
    return z;
}

static double guess(const decimal *d)
{
    int power = 0, part;
    double z = (double)d->short_value;
    for (int64_t e = d->short_exponent; e != 0;) {
        int64_t step = e > EXACT_POWER ? EXACT_POWER : e < -EXACT_POWER ? -EXACT_POWER : e;
        z = frexp(step > 0 ? z * power_of_ten[step] : z / power_of_ten[-step], &part);
        power += part;
        e -= step;
    }
    z = ldexp(z, power);
    return isfinite(z) ? z : DBL_MAX;
}

/* The nearest double from a sum of two, or NAN if the error of the second may change it. */
static double round_pair(double high, double low)
{
    const double z = high + low, rest = (high - z) + low;
    const double gap = rest < 0 ? z - nextafter(z, 0) : nextafter(z, INFINITY) - z;
    return gap / 2 - fabs(rest) > 4 * DBL_EPSILON * fabs(low) ? z : NAN;
}

static double nearest(const decimal *d)
{
    const int64_t e = d->short_exponent;
    const bool small_power = e >= -EXACT_POWER && e <= EXACT_POWER;
    if (small_power && d->count <= SHORT_DIGITS && FLT_EVAL_METHOD == 0) {
        const double p = power_of_ten[e < 0 ? -e : e];
        if (d->short_value <= UINT64_C(1) << DBL_MANT_DIG)
            return e < 0 ? (double)d->short_value / p : (double)d->short_value * p;
        const double high = (double)(d->short_value & ~UINT64_C(2047)),
                     low = (double)(d->short_value & 2047);
        const double first = e < 0 ? high / p : high * p;
        const double second =
            e < 0 ? (fma(-first, p, high) + low) / p : fma(high, p, -first) + low * p;
        const double z = round_pair(first, second);
        if (!isnan(z))
            return z;
    }
    if (d->exponent + d->count > DBL_MAX_10_EXP + 1)
        return INFINITY;
    if (d->exponent + d->count < -323) /* below half the smallest double */
        return 0;
    return settle(d, guess(d));
}

/* Digits from `at` on; returns the end of them. *out_any: there was one. */
static const char *read_digits(const char *at, const char *end, char point, decimal *d,
                               bool *out_any)
{
    int64_t behind_point = 0, zeros = 0; /* zeros: not counted as long as no other digit follows */
    bool fraction = false;
    for (; at < end && (is_digit(*at) || (*at == point && !fraction)); at++) {
        if (*at == point) {
            fraction = true;
            continue;
        }
        *out_any = true;
        behind_point += fraction;
        if (*at == '0') {
            zeros++;
            continue;
        }
        d->digits = d->count ? d->digits : at;
        zeros = d->count ? zeros : 0;
        for (; zeros >= 0; zeros--) {
            if (d->count++ < SHORT_DIGITS)
                d->short_value = 10 * d->short_value + (uint64_t)(zeros ? 0 : *at - '0');
            else
                d->short_exponent++;
        }
        zeros = 0;
        d->exponent = -behind_point;
    }
    if (d->count) /* zeros at the end, before and behind the point */
        d->exponent = zeros - behind_point;
    d->short_exponent += d->exponent;
    d->end = at;
    return at;
}

static const char *read_exponent(const char *at, const char *end, int64_t *out_exponent)
{
    const int64_t largest = INT64_C(1) << 40; /* more than any text can balance with digits */
    const char *digit = at + 1;
    *out_exponent = 0;
    if (at == end || !(*at == 'e' || *at == 'E' || *at == 'd' || *at == 'D'))
        return at;
    const bool negative = digit < end && *digit == '-';
    if (digit < end && (*digit == '-' || *digit == '+'))
        digit++;
    if (digit == end || !is_digit(*digit))
        return at;
    int64_t exponent = 0;
    for (; digit < end && is_digit(*digit); digit++)
        if (exponent < largest)
            exponent = 10 * exponent + (*digit - '0');
    *out_exponent = negative ? -exponent : exponent;
    return digit;
}

const char *trk_number_read(const char *text, const char *end, char point, double *out_value)
{
    decimal d = {0};
    bool any = false;
    const bool negative = text < end && *text == '-';
    const char *at = text < end && (*text == '-' || *text == '+') ? text + 1 : text;
    at = read_digits(at, end, point, &d, &any);
    if (!any)
        return NULL;
    int64_t exponent;
    at = read_exponent(at, end, &exponent);
    d.exponent += exponent;
    d.short_exponent += exponent;
    const double value = d.count ? nearest(&d) : 0;
    *out_value = negative ? -value : value;
    return at;
}

const char *trk_integer_read(const char *text, const char *end, int64_t *out_value)
{
    const bool negative = text < end && *text == '-';
    const char *at = text < end && (*text == '-' || *text == '+') ? text + 1 : text;
    if (at == end || !is_digit(*at))
        return NULL;
    int64_t value = 0;
    for (; at < end && is_digit(*at); at++) {
        const int64_t digit = *at - '0';
        if (value > (INT64_MAX - digit) / 10)
            return NULL;
        value = 10 * value + digit;
    }
    *out_value = negative ? -value : value;
    return at;
}
