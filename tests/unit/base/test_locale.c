/* SPDX-License-Identifier: MIT */
/* Messages have a decimal point whatever the caller's locale, and the locale stays the caller's. */
#include "support.h"

#include "base/base.h"
#include <locale.h>
#include <truckride/spec.h>

/* The first locale of this machine with a decimal comma, or skip. */
static void use_decimal_comma(void)
{
    static const char *const names[] = {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "fr_FR.utf8"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++)
        if (setlocale(LC_ALL, names[k]) && localeconv()->decimal_point[0] == ',')
            return;
    setlocale(LC_ALL, "C");
    skip();
}

static void check_comma(void)
{
    char text[20];
    snprintf(text, sizeof text, "%g", 2.5);
    assert_string_equal(text, "2,5");
}

static void messages_have_a_point(void **state)
{
    use_decimal_comma();
    trk_spec *spec;
    assert_ok(*state, trk_spec_create(*state, "s", &spec));
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    body.mass = -2.5;
    assert_status(*state, trk_spec_add_body(spec, "cab", &body, NULL), TRK_E_RANGE);
    assert_message(*state, "body 'cab': mass is -2.5;");
    (void)trk_fail_within(*state, TRK_E_RANGE, "at %.1f s", 0.5);
    assert_message(*state, "at 0.5 s: body 'cab': mass is -2.5;");
    trk_spec_destroy(spec);
    check_comma();
    setlocale(LC_ALL, "C");
}

static void keep(void *user, const char *message)
{
    snprintf(user, 20, "%s", message);
}

static void notes_and_text_have_a_point(void **state)
{
    use_decimal_comma();
    char text[20];
    assert_int_equal(trk_format(text, sizeof text, "%.2f", -0.25), 5);
    assert_string_equal(text, "-0.25");
    trk_context_set_log(*state, keep, text);
    trk_note(*state, "%g", 1.5);
    assert_string_equal(text, "1.5");
    trk_locale locale;
    trk_locale_enter(&locale);
    assert_near(strtod("3.25", NULL), 3.25, 0);
    trk_locale_leave(&locale);
    check_comma();
    setlocale(LC_ALL, "C");
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(messages_have_a_point),
        TEST(notes_and_text_have_a_point),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
