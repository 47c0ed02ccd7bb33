/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is refused, and in which words; nothing is changed by it. */

#include "check.h"

/* Handles that are no handles of what is asked for. */
static void test_handles(void)
{
   const double load = 0;
   const char *model = "as before";
   adfric_case tip = 0, other = 0;
   adfric_results found = 42;
   adfric_array array;
   int64_t n = 7;
   CHECK_OK(adfric_open("sphere", &tip));
   CHECK_REFUSED(adfric_set_real(0, "radius", 1), "unknown case, given 0, allowed: what adfric_open or adfric_read gave");
   CHECK_REFUSED(adfric_set_real(-1, "radius", 1), "unknown case, given -1");
   CHECK_REFUSED(adfric_point_count(tip + (1 << 10), &n), "unknown case");
   CHECK_REFUSED(adfric_model_of((adfric_case)(intptr_t)&tip, &model), "unknown case");
   CHECK(n == 7 && strcmp(model, "as before") == 0);
   CHECK_REFUSED(adfric_close_results(tip), "is no results, given case, allowed: what adfric_solve gave");
   CHECK_OK(adfric_close_case(tip));
   CHECK_REFUSED(adfric_close_case(tip), "closed case, given");
   CHECK_REFUSED(adfric_sweep(tip, "load", 1, &load), "closed case, given");
   CHECK_REFUSED(adfric_solve(tip, 1, NULL, NULL, &found), "closed case, given");
   CHECK(found == 42);
   /* the next case is another one, though it may be in the same place */
   CHECK_OK(adfric_open("sphere", &other));
   CHECK(other != tip);
   CHECK_REFUSED(adfric_check(tip), "closed case, given");
   CHECK_REFUSED(adfric_array_at(other, 0, &array), "is no results, given case");
   CHECK(adfric_stop(tip) == ADFRIC_BAD_INPUT && adfric_stop(0) == ADFRIC_BAD_INPUT && adfric_stop(other) == ADFRIC_OK);
   CHECK_OK(adfric_close_case(other));
}

/* Names that there are not, with the ones that may have been meant. */
static void test_names(void)
{
   adfric_case tip = 42;
   adfric_variable_info variable;
   adfric_result_info result;
   adfric_model_info model;
   CHECK_REFUSED(adfric_open("spere", &tip), "&job model: unknown model, given 'spere', allowed: 'wavy_sliding', 'sphere', ");
   CHECK(strstr(adfric_message(), "; did you mean 'sphere'?") != NULL && tip == 42);
   CHECK_REFUSED(adfric_variable("spere", 0, &variable), "&job model: unknown model, given 'spere'");
   CHECK_REFUSED(adfric_variable("sphere", -1, &variable), "there is no variable -1, allowed: 0 to 36");
   CHECK_REFUSED(adfric_result("sphere", 1000, &result), "there is no result 1000, allowed: 0 to ");
   CHECK_REFUSED(adfric_model(25, &model), "there is no model 25, allowed: 0 to 24");
   CHECK_OK(adfric_open("sphere", &tip));
   CHECK_REFUSED(adfric_set_real(tip, "radios", 1), "unknown variable, given 'radios', allowed: units, radius, ");
   CHECK(strstr(adfric_message(), "; did you mean 'radius'?") != NULL);
   CHECK_REFUSED(adfric_set_real(tip, "friction%radius", 1), "unknown variable, given 'friction%radius', it belongs to &sphere");
   CHECK_REFUSED(adfric_set_word(tip, "theory", "jkt"), "&model theory: unknown choice, given 'jkt', allowed: 'auto', ");
   CHECK_REFUSED(adfric_set_real(tip, "", 1), "unknown variable, given ''");
   CHECK_REFUSED(adfric_set_real(tip, "\001\xff", 1), "unknown variable, given '");
   CHECK_OK(adfric_close_case(tip));
}

/* Values that are not allowed. */
static void test_values(void)
{
   const double loads[] = {0, NAN}, none[1] = {0};
   const int64_t shapes[] = {0, -1, INT64_C(1) << 40};
   const int64_t one = 1;
   const char *const names[] = {"load", "load"};
   adfric_case tip = 0;
   adfric_results found = 0;
   adfric_array radius;
   int64_t n = 0;
   CHECK_OK(adfric_open("sphere", &tip));
   CHECK_OK(adfric_set_real(tip, "radius", 1e-6));
   CHECK_REFUSED(adfric_set_real(tip, "radius", -1), "&sphere radius: out of range, given -1 m, allowed: a number > 0 [m]");
   CHECK_REFUSED(adfric_set_real(tip, "radius", NAN), "&sphere radius: not a finite number, given NaN, allowed: a number > 0 [m]");
   CHECK_REFUSED(adfric_set_real(tip, "radius", -INFINITY), "&sphere radius: not a finite number, given -Infinity");
   CHECK_REFUSED(adfric_set_logical(tip, "radius", 1), "&sphere radius: ");
   CHECK_REFUSED(adfric_set_word(tip, "radius", "large"), "&sphere radius: ");
   CHECK_REFUSED(adfric_set_real(tip, "n_r", 2.5), "&output n_r: ");
   CHECK_REFUSED(adfric_set_integer(tip, "n_r", INT64_MAX), "&output n_r: ");
   CHECK_REFUSED(adfric_set_integer(tip, "profiles", 1), "&output profiles: ");
   CHECK_REFUSED(adfric_set_array(tip, "radius", 1, shapes, none), "shape: out of range, given 0, allowed: 1 to ");
   CHECK_REFUSED(adfric_set_array(tip, "radius", 1, shapes + 1, none), "shape: out of range, given -1");
   CHECK_REFUSED(adfric_set_array(tip, "radius", 1, shapes + 2, none), "shape: out of range, given 1");
   CHECK_REFUSED(adfric_set_array(tip, "radius", 1, &one, none), "&sphere radius: has one value, given an array of 1, allowed: ");
   CHECK_REFUSED(adfric_set_array(tip, "radius", 3, shapes, none), "rank: out of range, given 3, allowed: 1 or 2");
   CHECK_REFUSED(adfric_sweep(tip, "load", 2, loads), "&operating load: ");
   CHECK_REFUSED(adfric_sweep(tip, "load", 0, loads), "n: out of range, given 0");
   CHECK_REFUSED(adfric_sweep(tip, "theory", 1, loads), "&model theory: is not a number, it cannot be swept");
   CHECK_REFUSED(adfric_sweep_together(tip, 2, names, 1, loads), "load is given twice, allowed: once");
   CHECK_REFUSED(adfric_sweep_together(tip, -1, names, 1, loads), "n_names: out of range, given -1");
   CHECK_REFUSED(adfric_sweep_together(tip, INT32_MAX, names, 1, loads),
                 "n_names: out of range, given 2147483647, allowed: 1 to 1000");
   CHECK_OK(adfric_point_count(tip, &n));
   CHECK(n == 1);
   /* nothing was changed by all that */
   CHECK_OK(adfric_set_real(tip, "contact_modulus", 1e9));
   CHECK_OK(adfric_set_real(tip, "work_of_adhesion", 0));
   CHECK_OK(adfric_set_real(tip, "load", 1e-6));
   CHECK_OK(adfric_solve(tip, 1, NULL, NULL, &found));
   CHECK_OK(adfric_array_of(found, "radius", &radius));
   CHECK(radius.values[0] == 1e-6);
   CHECK_OK(adfric_close_results(found));
   CHECK_OK(adfric_close_case(tip));
}

/* Arrays that are none of the model. */
static void test_arrays(void)
{
   const int64_t shape[] = {8, 8};
   double heights[64] = {0};
   adfric_case rough = 0;
   CHECK_OK(adfric_open("surface_elastic", &rough));
   heights[9] = NAN;
   CHECK_REFUSED(adfric_set_array(rough, "heights", 2, shape, heights), "&surface heights: ");
   CHECK_REFUSED(adfric_set_array(rough, "length_x", 2, shape, heights), "&surface length_x: has one value, given an array of 64");
   CHECK_REFUSED(adfric_set_real(rough, "heights", 1), "&surface heights: ");
   CHECK_REFUSED(adfric_check(rough), "&surface heights: ");
   /* all that is missing is said at once, a line each */
   CHECK(strchr(adfric_message(), '\n') != NULL);
   CHECK_OK(adfric_close_case(rough));
}

/* Null pointers. */
static void test_null(void)
{
   const double load = 0;
   const int64_t one = 1;
   const char *const names[] = {NULL};
   adfric_case tip = 0;
   adfric_results found = 0;
   CHECK_REFUSED(adfric_open(NULL, &tip), "model: given NULL, allowed: a pointer");
   CHECK_REFUSED(adfric_open("sphere", NULL), "opened: given NULL");
   CHECK_REFUSED(adfric_read(NULL, &tip), "path: given NULL");
   CHECK_REFUSED(adfric_model_count(NULL), "n: given NULL");
   CHECK_REFUSED(adfric_variable("sphere", 0, NULL), "variable: given NULL");
   CHECK_OK(adfric_open("sphere", &tip));
   CHECK_REFUSED(adfric_set_real(tip, NULL, 1), "name: given NULL");
   CHECK_REFUSED(adfric_set_word(tip, "theory", NULL), "value: given NULL");
   CHECK_REFUSED(adfric_set_array(tip, "radius", 1, NULL, &load), "shape: given NULL");
   CHECK_REFUSED(adfric_set_array(tip, "radius", 1, &one, NULL), "values: given NULL");
   CHECK_REFUSED(adfric_sweep(tip, "load", 1, NULL), "values: given NULL");
   CHECK_REFUSED(adfric_sweep_together(tip, 1, NULL, 1, &load), "names: given NULL");
   CHECK_REFUSED(adfric_sweep_together(tip, 1, names, 1, &load), "name: given NULL");
   CHECK_REFUSED(adfric_point_count(tip, NULL), "n: given NULL");
   CHECK_REFUSED(adfric_solve(tip, 1, NULL, NULL, NULL), "found: given NULL");
   CHECK_REFUSED(adfric_solve(tip, -1, NULL, NULL, &found), "n_threads: out of range, given -1, allowed: an integer >= 0");
   CHECK_REFUSED(adfric_solve(tip, 1, NULL, NULL, &found), "&sphere radius: ");
   CHECK(found == 0);
   CHECK_OK(adfric_close_case(tip));
}

/* Results: names, places and null pointers. */
static void test_results(void)
{
   const char *text = "&job model = 'sphere' /\n&sphere radius = 1e-6, contact_modulus = 1e9, work_of_adhesion = 0 /\n"
                      "&operating load = 1e-7 /\n";
   adfric_case tip = 0;
   adfric_results found = 0;
   adfric_array array;
   adfric_attribute_info attribute;
   int32_t n = 0;
   CHECK_OK(adfric_read_text(text, &tip));
   CHECK_OK(adfric_solve(tip, 1, NULL, NULL, &found));
   CHECK_REFUSED(adfric_array_of(found, "contact_radios", &array), "unknown array, given 'contact_radios', allowed: ");
   CHECK(strstr(adfric_message(), "; did you mean 'contact_radius'?") != NULL);
   CHECK_OK(adfric_array_count(found, &n));
   CHECK_OK(adfric_array_at(found, n - 1, &array));
   CHECK_REFUSED(adfric_array_at(found, n, &array), "there is no array ");
   CHECK_REFUSED(adfric_array_at(found, 0, NULL), "array: given NULL");
   CHECK_REFUSED(adfric_array_of(found, NULL, &array), "name: given NULL");
   CHECK_REFUSED(adfric_attribute(found, -1, &attribute), "there is no attribute -1, allowed: 0 to ");
   CHECK_REFUSED(adfric_attribute(found, 0, NULL), "attribute: given NULL");
   CHECK_OK(adfric_close_results(found));
   CHECK_REFUSED(adfric_close_results(found), "closed results, given ");
   CHECK_REFUSED(adfric_array_count(found, &n), "closed results, given ");
   CHECK_OK(adfric_close_case(tip));
}

/* Results that no memory holds. */
static void test_memory(void)
{
   enum { n = 200000 };
   double *values = malloc(n*sizeof *values);
   adfric_case tip = 0;
   adfric_results found = 42;
   CHECK(values != NULL);
   for (int i = 0; i < n; i++) values[i] = 1e-6*(i + 1);
   CHECK_OK(adfric_open("sphere", &tip));
   CHECK_OK(adfric_set_real(tip, "contact_modulus", 1e9));
   CHECK_OK(adfric_set_real(tip, "work_of_adhesion", 0));
   CHECK_OK(adfric_sweep(tip, "radius", n, values));
   CHECK_OK(adfric_sweep(tip, "load", n, values));
   CHECK(adfric_solve(tip, 1, NULL, NULL, &found) == ADFRIC_FAILED && found == 42);
   CHECK(strcmp(adfric_message(), "there is too little memory for the results") == 0);
   /* the case goes on */
   CHECK_OK(adfric_set_real(tip, "radius", 1));
   CHECK_OK(adfric_sweep(tip, "load", 2, values));
   CHECK_OK(adfric_solve(tip, 1, NULL, NULL, &found));
   CHECK_OK(adfric_close_results(found));
   CHECK_OK(adfric_close_case(tip));
   free(values);
}

/* Inputs: files and texts that are none. */
static void test_inputs(void)
{
   adfric_case tip = 42;
   CHECK_REFUSED(adfric_read("absent.nml", &tip), "absent.nml: cannot open the input, there is no such file");
   CHECK_REFUSED(adfric_read_text("", &tip), "&job: the group is missing");
   CHECK_REFUSED(adfric_read_text("&job model = 'sphere' /\001", &tip), "cannot be an input, it is not a text");
   CHECK_REFUSED(adfric_read_text("&job model = 'sphere' /\n&sphere radios = 1 /\n", &tip), "&sphere radios: ");
   CHECK(strstr(adfric_message(), "(line 2)") != NULL && tip == 42);
   /* what is wrong with a file begins with its name */
   FILE *file = fopen("wrong.nml", "w");
   CHECK(file != NULL && fputs("&job model = 'spere' /\n", file) >= 0 && fclose(file) == 0);
   CHECK_REFUSED(adfric_read("wrong.nml", &tip), "wrong.nml: &job model: unknown model, given 'spere'");
   CHECK(remove("wrong.nml") == 0);
}

int main(void)
{
   test_handles();
   test_names();
   test_values();
   test_arrays();
   test_null();
   test_results();
   test_memory();
   test_inputs();
   return 0;
}
