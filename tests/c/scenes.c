/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scenes whose arrays come later: the same as by the names of the solver, and what is refused. */

#include "check.h"

enum { nx = 16, ny = 8 };

static const char groups[] = "&job title = 'rough' /\n&surface kind = 'heights', length_x = 1e-4, length_y = 0.5e-4 /\n"
                             "&solid contact_modulus = 1e9 /\n&output profiles = .true. /\n";
static const char *const later[] = {"surface%heights", " Mean_Pressure "};
static const double pressures[] = {1e6, 5e6};
static const int64_t shape[] = {ny, nx};
static double heights[ny][nx];

static void set_heights(void)
{
   for (int j = 0; j < ny; j++) {
      for (int i = 0; i < nx; i++) heights[j][i] = 1e-6*(cos(6.283185307179586*i/nx) + 0.3*cos(6.283185307179586*(j + 2.0*i)/ny));
   }
}

/* The values of an array of results that are like those of other results. */
static void compare(adfric_results one, adfric_results other, const char *name)
{
   adfric_array a, b;
   CHECK_OK(adfric_array_of(one, name, &a));
   CHECK_OK(adfric_array_of(other, name, &b));
   CHECK(a.rank == b.rank);
   int64_t n = 1;
   for (int32_t k = 0; k < a.rank; k++) {
      CHECK(a.shape[k] == b.shape[k]);
      n *= a.shape[k];
   }
   CHECK(memcmp(a.values, b.values, (size_t)n*sizeof(double)) == 0);
}

/* Heights and a sweep that come later: every bit is that of the solver by its own names. */
static void test_heights(void)
{
   adfric_case scene = 0, model = 0;
   adfric_results found = 0, expected = 0;
   adfric_array array;
   const char *name = NULL;
   CHECK_OK(adfric_open_scene(groups, 2, later, &scene));
   CHECK_OK(adfric_model_of(scene, &name));
   CHECK(strcmp(name, "surface_elastic") == 0);
   CHECK_OK(adfric_scene_of(scene, &name));
   CHECK(strcmp(name, "heights on an elastic half-space, pressed") == 0);
   /* what is missing is said now */
   CHECK_REFUSED(adfric_check(scene), "&surface heights: is missing");
   CHECK(strstr(adfric_message(), "mean_pressure") != NULL);
   CHECK_REFUSED(adfric_solve(scene, 1, NULL, NULL, &found), "&surface heights: is missing");
   CHECK_OK(adfric_set_array(scene, "heights", 2, shape, heights[0]));
   CHECK_OK(adfric_sweep(scene, "mean_pressure", 2, pressures));
   CHECK_OK(adfric_check(scene));
   CHECK_OK(adfric_solve(scene, 1, NULL, NULL, &found));
   CHECK_OK(adfric_open("surface_elastic", &model));
   CHECK_OK(adfric_set_array(model, "heights", 2, shape, heights[0]));
   CHECK_OK(adfric_set_real(model, "length_x", 1e-4));
   CHECK_OK(adfric_set_real(model, "length_y", 0.5e-4));
   CHECK_OK(adfric_set_real(model, "contact_modulus", 1e9));
   CHECK_OK(adfric_set_logical(model, "profiles", 1));
   CHECK_OK(adfric_sweep(model, "mean_pressure", 2, pressures));
   CHECK_OK(adfric_solve(model, 1, NULL, NULL, &expected));
   compare(found, expected, "contact_fraction");
   compare(found, expected, "pressure");
   /* what has no meaning in the scene is absent */
   CHECK_OK(adfric_array_of(expected, "pull_off_pressure", &array));
   CHECK_REFUSED(adfric_array_of(found, "pull_off_pressure", &array), "pull_off_pressure");
   CHECK_OK(adfric_close_results(found));
   /* heights that are refused are not given any more */
   heights[0][0] = NAN;
   CHECK_REFUSED(adfric_set_array(scene, "heights", 2, shape, heights[0]), "&surface heights: NaN or Inf");
   CHECK_REFUSED(adfric_check(scene), "&surface heights: is missing");
   set_heights();
   CHECK_OK(adfric_set_array(scene, "surface%heights", 2, shape, heights[0]));
   CHECK_OK(adfric_solve(scene, 2, NULL, NULL, &found));
   compare(found, expected, "contact_fraction");
   CHECK_OK(adfric_close_results(found));
   CHECK_OK(adfric_close_results(expected));
   CHECK_OK(adfric_close_case(model));
   CHECK_OK(adfric_close_case(scene));
}

/* What is announced decides which solver answers, as what is given does. */
static void test_choice(void)
{
   const char *text = "&surface kind = 'paraboloid', radius = 1e-6 /\n&solid contact_modulus = 1e9 /\n&operating load = 0 /\n";
   const char *const work[] = {"work_of_adhesion"}, *const times[] = {"solid%relaxation_times"};
   adfric_case tip = 0;
   const char *name = NULL;
   double radius = 0, expected = pow(9*3.14159265358979323846*0.05*1e-12/(2*1e9), 1.0/3);
   const char *const wanted[] = {"contact_radius"};
   CHECK_OK(adfric_open_scene(text, 0, NULL, &tip));
   CHECK_OK(adfric_scene_of(tip, &name));
   CHECK(strcmp(name, "paraboloid on an elastic half-space, pressed") == 0);
   CHECK_REFUSED(adfric_set_real(tip, "relaxation_time", 1), "unknown variable");
   CHECK_OK(adfric_close_case(tip));
   CHECK_OK(adfric_open_scene(text, 1, work, &tip));
   CHECK_OK(adfric_scene_of(tip, &name));
   CHECK(strcmp(name, "paraboloid on an elastic half-space with adhesion, pressed") == 0);
   CHECK_OK(adfric_set_real(tip, "work_of_adhesion", 0.05));
   CHECK_OK(adfric_solve_point(tip, 1, wanted, &radius));
   /* without a load JKR's contact has a^3 = 9 pi w R^2/(2 E*) */
   CHECK(is_close(radius, expected, 1e-12));
   CHECK_OK(adfric_close_case(tip));
   CHECK_REFUSED(adfric_open_scene(text, 1, times, &tip), "&history: nothing solves paraboloid on a viscoelastic half-space");
}

/* Names, units and bounds of the variables and the results of a case. */
static void test_descriptions(void)
{
   adfric_case scene = 0, model = 0;
   adfric_variable_info variable;
   adfric_result_info described;
   CHECK_OK(adfric_open_scene(groups, 2, later, &scene));
   CHECK_OK(adfric_variable_of(scene, "heights", &variable));
   CHECK(strcmp(variable.group, "surface") == 0 && strcmp(variable.unit, "m") == 0);
   CHECK(variable.kind == ADFRIC_ARRAY && variable.largest_rank == 2 && variable.is_list == 0);
   CHECK_OK(adfric_variable_of(scene, "operating%mean_pressure", &variable));
   CHECK(variable.kind == ADFRIC_REAL && strcmp(variable.unit, "Pa") == 0 && variable.lower_is_open + variable.upper_is_open >= 0);
   CHECK_OK(adfric_describe(scene, "contact_fraction", &described));
   CHECK(strcmp(described.name, "contact_fraction") == 0 && strcmp(described.unit, "1") == 0 && strlen(described.long_name) > 3);
   CHECK_OK(adfric_describe(scene, "status", &described));
   CHECK(strcmp(described.flag_meanings, "solved no_equilibrium not_converged") == 0);
   variable.kind = 42;
   CHECK_REFUSED(adfric_variable_of(scene, "hieghts", &variable), "did you mean 'heights'?");
   CHECK(strstr(adfric_message(), " -,") == NULL && variable.kind == 42);
   CHECK_REFUSED(adfric_variable_of(scene, NULL, &variable), "name: given NULL");
   CHECK_REFUSED(adfric_variable_of(scene, "heights", NULL), "variable: given NULL");
   CHECK_REFUSED(adfric_variable_of(0, "heights", &variable), "");
   CHECK_REFUSED(adfric_describe(scene, "contact_fractoin", &described), "did you mean 'contact_fraction'?");
   CHECK_REFUSED(adfric_describe(scene, "status", NULL), "described: given NULL");
   CHECK_OK(adfric_close_case(scene));
   /* the same of a case of a model, by its own names */
   CHECK_OK(adfric_open("hertz", &model));
   CHECK_OK(adfric_describe(model, "load", &described));
   CHECK(strstr(described.unit, "N/m for line") != NULL);
   CHECK_OK(adfric_set_word(model, "kind", "line"));
   CHECK_OK(adfric_set_real(model, "radius", 0.01));
   CHECK_OK(adfric_set_real(model, "contact_modulus", 1e9));
   CHECK_OK(adfric_set_real(model, "load", 1));
   CHECK_OK(adfric_describe(model, "load", &described));
   CHECK(strcmp(described.unit, "N/m") == 0);
   CHECK_OK(adfric_close_case(model));
}

/* A fit of a scene: exact points of Hertz's contact give back the modulus, with the bits of the fit of the model. */
static void test_fit(void)
{
   enum { n_rows = 20 };
   const char *const data = "&data file = 'points', abscissa = 'approach', ordinate = 'load', sigma = 1e-12 /\n"
                            "&free variable = 'contact_modulus' /\n";
   const char *const known[] = {"&surface kind = 'paraboloid', radius = 1e-6 /\n&adhesion work_of_adhesion = 0, theory = 'hertz' /\n",
                                "&job model = 'sphere' /\n&sphere radius = 1e-6, work_of_adhesion = 0 /\n&model theory = 'hertz' /\n"};
   const char *const columns[] = {"approach", "load"};
   double values[2*n_rows], found_modulus[2];
   adfric_table table = {.name = "points", .columns = columns, .units = NULL, .values = values, .n = n_rows, .n_columns = 2};
   for (int k = 0; k < n_rows; k++) {
      values[k] = 0.5e-9*(k + 1);
      values[n_rows + k] = 4.0/3*2e9*sqrt(1e-6)*pow(values[k], 1.5);
   }
   for (int k = 0; k < 2; k++) {
      char text[400];
      adfric_case fit = 0;
      adfric_results found = 0;
      adfric_array modulus;
      const char *scene = NULL;
      CHECK(snprintf(text, sizeof text, "%s%s", known[k], data) < (int)sizeof text);
      CHECK_OK(adfric_read_fit(text, 1, &table, &fit));
      CHECK_OK(adfric_scene_of(fit, &scene));
      CHECK((strlen(scene) > 0) == (k == 0));
      CHECK_OK(adfric_solve(fit, 1, NULL, NULL, &found));
      CHECK_OK(adfric_array_of(found, "contact_modulus", &modulus));
      found_modulus[k] = modulus.values[0];
      CHECK_OK(adfric_close_results(found));
      CHECK_OK(adfric_close_case(fit));
   }
   CHECK(is_close(found_modulus[0], 2e9, 1e-9));
   CHECK(found_modulus[0] == found_modulus[1]);
}

/* Texts and names that are none. */
static void test_refusals(void)
{
   const char *const wrong[] = {"surface%hieghts"}, *const null[] = {NULL};
   static char letters[100000];
   const char *const long_name[] = {letters};
   adfric_case scene = 42;
   memset(letters, 'x', sizeof letters - 1);
   CHECK_REFUSED(adfric_open_scene(groups, 1, wrong, &scene), "unknown variable");
   CHECK_REFUSED(adfric_open_scene(groups, 1, null, &scene), "names: given NULL");
   CHECK_REFUSED(adfric_open_scene(groups, 1, long_name, &scene), "names: number 1 is too long, allowed: at most ");
   CHECK_REFUSED(adfric_open_scene(groups, 1, NULL, &scene), "names: given NULL");
   CHECK_REFUSED(adfric_open_scene(groups, -1, later, &scene), "n_names: out of range, given -1, allowed: 0 to 1000");
   CHECK_REFUSED(adfric_open_scene(NULL, 2, later, &scene), "text: given NULL");
   CHECK_REFUSED(adfric_open_scene(groups, 2, later, NULL), "opened: given NULL");
   CHECK_REFUSED(adfric_open_scene("", 0, NULL, &scene), "&job: the group is missing");
   CHECK_REFUSED(adfric_open_scene("&job model = 'sphere' /\n", 0, NULL, &scene), "&job model: given, allowed: a scene");
   CHECK_REFUSED(adfric_open_scene("&surface kind = 'heights' /\n&solid contact_modulos = 1 /\n", 2, later, &scene),
                 "&solid contact_modulos: ");
   CHECK_REFUSED(adfric_open_scene("&surface kind = 'cone', slope = 0.1 /\n&solid contact_modulus = 1 /\n&free variable = 'load' /\n", 0,
                                   NULL, &scene), "no fit");
   CHECK_REFUSED(adfric_open_scene("&surface kind = 'heights', length_x = 1 /\n&solid contact_modulus = 1 /\n&uncertain variable = 'length_x',"
                                   " relative_error = 0.1 /\n", 2, later, &scene), "&uncertain or &output derivatives");
   CHECK(scene == 42);
}

int main(void)
{
   set_heights();
   test_heights();
   test_choice();
   test_descriptions();
   test_fit();
   test_refusals();
   return 0;
}
