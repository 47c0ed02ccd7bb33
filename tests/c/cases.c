/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cases are set, solved and read from C. */

#include "check.h"

/* Every model has tables, and its texts are there. */
static void test_models(void)
{
   int32_t n;
   CHECK_OK(adfric_model_count(&n));
   CHECK(n == 25);
   for (int32_t i = 0; i < n; i++) {
      adfric_model_info model;
      CHECK_OK(adfric_model(i, &model));
      CHECK(model.n_variables > 3 && model.n_results > 2);
      for (int32_t k = 0; k < model.n_variables; k++) {
         adfric_variable_info variable;
         CHECK_OK(adfric_variable(model.name, k, &variable));
         CHECK(strlen(variable.group) > 0 && strlen(variable.name) > 0 && strlen(variable.meaning) > 3);
         CHECK(variable.kind >= ADFRIC_REAL && variable.kind <= ADFRIC_ARRAY);
         CHECK((strlen(variable.choices) > 0) == (variable.kind == ADFRIC_WORD));
         CHECK((strlen(variable.unit) > 0) == (variable.kind != ADFRIC_WORD && variable.kind != ADFRIC_LOGICAL));
         CHECK((variable.largest_rank > 0) == (variable.kind == ADFRIC_ARRAY));
         CHECK(variable.lower <= variable.upper);
         CHECK(isnan(variable.default_value) == (strlen(variable.default_text) == 0));
      }
      adfric_result_info result;
      CHECK_OK(adfric_result(model.name, model.n_results - 1, &result));
      CHECK(strcmp(result.name, "status") == 0);
      CHECK(strcmp(result.flag_meanings, "solved no_equilibrium not_converged") == 0);
      for (int32_t k = 0; k < model.n_profiles; k++) CHECK_OK(adfric_profile(model.name, k, &result));
   }
}

/* What the tables say of a few rows. */
static void test_tables(void)
{
   adfric_variable_info variable;
   int32_t k = 0;
   do CHECK_OK(adfric_variable("sphere", k++, &variable)); while (strcmp(variable.name, "radius") != 0);
   CHECK(strcmp(variable.group, "sphere") == 0 && strcmp(variable.unit, "m") == 0 && variable.kind == ADFRIC_REAL);
   CHECK(strstr(variable.allowed, "a number > 0 [m]") != NULL);
   do CHECK_OK(adfric_variable("sphere", k++, &variable)); while (strcmp(variable.name, "theory") != 0);
   CHECK(variable.kind == ADFRIC_WORD && strcmp(variable.default_text, "'auto'") == 0 && variable.default_value == 1);
   k = 0;
   do CHECK_OK(adfric_variable("surface_elastic", k++, &variable)); while (strcmp(variable.name, "heights") != 0);
   CHECK(variable.kind == ADFRIC_ARRAY && variable.largest_rank == 2 && variable.is_list == 0);
}

/* A case of JKR's sphere: radius 1 um, contact modulus 1 GPa, work of adhesion 50 mJ/m^2. */
static adfric_case open_jkr(void)
{
   adfric_case tip = 0;
   CHECK_OK(adfric_open("sphere", &tip));
   CHECK_OK(adfric_set_real(tip, "radius", 1e-6));
   CHECK_OK(adfric_set_real(tip, "contact_modulus", 1e9));
   CHECK_OK(adfric_set_real(tip, "work_of_adhesion", 0.05));
   CHECK_OK(adfric_set_real(tip, "adhesion_stress", 1e9));
   CHECK_OK(adfric_set_word(tip, "theory", "jkr"));
   return tip;
}

/* The contact radius without load, and the arrays that belong to a sweep. */
static void test_sweep(void)
{
   const double pi = 3.14159265358979323846;
   const double loads[] = {0.0, 1e-7, -1e-3};
   adfric_case tip = open_jkr();
   adfric_results found = 0;
   adfric_array radius, load, status, theory, modulus;
   int64_t n = 0;
   CHECK_OK(adfric_sweep(tip, "load", 3, loads));
   CHECK_OK(adfric_point_count(tip, &n));
   CHECK(n == 3);
   CHECK_OK(adfric_check(tip));
   CHECK_OK(adfric_solve(tip, 1, NULL, NULL, &found));
   /* results stay when their case is closed */
   CHECK_OK(adfric_close_case(tip));
   CHECK_OK(adfric_array_of(found, "contact_radius", &radius));
   CHECK(radius.role == ADFRIC_RESULT && radius.rank == 1 && radius.shape[0] == 3 && radius.strides[0] == 1);
   CHECK(strcmp(radius.dimensions[0], "load") == 0 && strcmp(radius.unit, "m") == 0 && radius.states == NULL);
   /* Johnson, Kendall, Roberts 1971: a^3 = 9 pi w R^2/(2 E*) */
   CHECK(is_close(radius.values[0], cbrt(9*pi*0.05*1e-12/(2*1e9)), 1e-12));
   CHECK(radius.values[1] > radius.values[0] && isnan(radius.values[2]));
   CHECK_OK(adfric_array_of(found, "LOAD", &load));
   CHECK(load.role == ADFRIC_COORDINATE && memcmp(load.values, loads, sizeof loads) == 0);
   CHECK_OK(adfric_array_of(found, "status", &status));
   CHECK(status.values == NULL && status.states[0] == ADFRIC_SOLVED && status.states[2] == ADFRIC_NO_EQUILIBRIUM);
   CHECK_OK(adfric_array_of(found, "theory", &theory));
   CHECK(theory.role == ADFRIC_PARAMETER && theory.rank == 0 && theory.first_flag == 1 && theory.states[0] == 3);
   CHECK_OK(adfric_array_of(found, "contact_modulus", &modulus));
   CHECK(modulus.role == ADFRIC_PARAMETER && modulus.values[0] == 1e9);
   CHECK_OK(adfric_close_results(found));
}

/* Several sweeps: the last one varies fastest; variables that are swept together share a dimension. */
static void test_sweeps(void)
{
   const double radii[] = {1e-6, 2e-6}, loads[] = {0.0, 1e-7, 2e-7};
   const double pairs[] = {1e9, 2e9, 0.0, 1e-7};
   const char *const names[] = {"contact_modulus", "load"};
   adfric_case tip = open_jkr();
   adfric_results found = 0;
   adfric_array force, other;
   CHECK_OK(adfric_sweep(tip, "radius", 2, radii));
   CHECK_OK(adfric_sweep(tip, "load", 3, loads));
   CHECK_OK(adfric_solve(tip, 0, NULL, NULL, &found));
   CHECK_OK(adfric_array_of(found, "contact_radius", &force));
   CHECK(force.rank == 2 && force.shape[0] == 2 && force.shape[1] == 3 && force.strides[0] == 3 && force.strides[1] == 1);
   CHECK(force.values[3] > force.values[0] && force.values[1] > force.values[0]);
   CHECK_OK(adfric_close_results(found));
   CHECK_OK(adfric_sweep_together(tip, 2, names, 2, pairs));
   CHECK_OK(adfric_set_real(tip, "radius", 1e-6));
   CHECK_OK(adfric_solve(tip, 0, NULL, NULL, &found));
   CHECK_OK(adfric_array_of(found, "contact_radius", &force));
   CHECK(force.rank == 1 && force.shape[0] == 2 && strcmp(force.dimensions[0], "point") == 0);
   CHECK_OK(adfric_array_of(found, "load", &other));
   CHECK(other.role == ADFRIC_COORDINATE && other.values[1] == 1e-7 && strcmp(other.dimensions[0], "point") == 0);
   CHECK_OK(adfric_array_of(found, "contact_modulus", &other));
   CHECK(other.role == ADFRIC_COORDINATE && other.values[1] == 2e9);
   CHECK_OK(adfric_close_results(found));
   CHECK_OK(adfric_unset(tip, "load"));
   CHECK_REFUSED(adfric_check(tip), "&operating");
   CHECK_OK(adfric_close_case(tip));
}

/* A map of heights goes in as an array, and maps come out, x varies fastest. */
static void test_maps(void)
{
   enum { ny = 16, nx = 32 };
   const double pi = 3.14159265358979323846;
   double heights[ny*nx];
   const int64_t shape[] = {ny, nx};
   const double pressures[] = {1e6, 2e6};
   for (int j = 0; j < ny; j++)
      for (int i = 0; i < nx; i++) heights[j*nx + i] = 1e-6*(cos(2*pi*(i + 0.5)/nx) + 0.5*cos(2*pi*(j + 0.5)/ny));
   adfric_case rough = 0;
   adfric_results found = 0;
   adfric_array pressure, mean;
   CHECK_OK(adfric_open("surface_elastic", &rough));
   CHECK_OK(adfric_set_array(rough, "heights", 2, shape, heights));
   CHECK_OK(adfric_set_real(rough, "length_x", 1e-4));
   CHECK_OK(adfric_set_real(rough, "length_y", 1e-4));
   CHECK_OK(adfric_set_real(rough, "contact_modulus", 1e9));
   CHECK_OK(adfric_sweep(rough, "mean_pressure", 2, pressures));
   CHECK_OK(adfric_set_logical(rough, "profiles", 1));
   CHECK_OK(adfric_solve(rough, 0, NULL, NULL, &found));
   CHECK_OK(adfric_array_of(found, "pressure", &pressure));
   CHECK(pressure.role == ADFRIC_PROFILE && pressure.rank == 3);
   CHECK(pressure.shape[0] == 2 && pressure.shape[1] == ny && pressure.shape[2] == nx);
   CHECK(strcmp(pressure.dimensions[0], "mean_pressure") == 0 && strcmp(pressure.dimensions[1], "y") == 0);
   CHECK_OK(adfric_array_of(found, "mean_pressure", &mean));
   for (int k = 0; k < 2; k++) {
      double sum = 0;
      for (int j = 0; j < ny; j++)
         for (int i = 0; i < nx; i++)
            sum += pressure.values[k*pressure.strides[0] + j*pressure.strides[1] + i*pressure.strides[2]];
      /* the tolerance of the solver */
      CHECK(is_close(sum/(nx*ny), pressures[k], 1e-8));
   }
   /* it is highest at the crest, in the corners of the map, and none is in the middle */
   CHECK(pressure.values[0] > pressure.values[pressure.strides[2]]);
   CHECK(pressure.values[ny/2*pressure.strides[1] + nx/2*pressure.strides[2]] == 0);
   CHECK_OK(adfric_close_results(found));
   CHECK_OK(adfric_close_case(rough));
}

/* Inputs are read from texts, and their values may be changed. */
static void test_input(void)
{
   const char *text = "&job model = 'sphere', title = 'a tip' /\n"
                      "&sphere radius = 1e-6, contact_modulus = 1e9, work_of_adhesion = 0.05, adhesion_stress = 1e9 /\n"
                      "&model theory = 'jkr' /\n&sweep variable = 'load', values = 0, 1e-7 /\n";
   adfric_case tip = 0;
   adfric_results found = 0;
   adfric_array radius;
   adfric_attribute_info attribute;
   const char *model = NULL, *scene = NULL;
   int32_t n = 0;
   int n_seen = 0;
   CHECK_OK(adfric_read_text(text, &tip));
   CHECK_OK(adfric_model_of(tip, &model));
   CHECK_OK(adfric_scene_of(tip, &scene));
   CHECK(strlen(scene) == 0);
   CHECK(strcmp(model, "sphere") == 0);
   CHECK_OK(adfric_solve(tip, 0, NULL, NULL, &found));
   CHECK_OK(adfric_attribute_count(found, &n));
   for (int32_t i = 0; i < n; i++) {
      CHECK_OK(adfric_attribute(found, i, &attribute));
      CHECK((attribute.text == NULL) == (strcmp(attribute.name, "wall_seconds") == 0 || !isnan(attribute.number)));
      if (strcmp(attribute.name, "title") == 0) n_seen += strcmp(attribute.text, "a tip") == 0;
      if (strcmp(attribute.name, "input") == 0) n_seen += strcmp(attribute.text, text) == 0;
   }
   CHECK(n_seen == 2);
   CHECK_OK(adfric_array_of(found, "contact_radius", &radius));
   const double before = radius.values[1];
   CHECK_OK(adfric_close_results(found));
   CHECK_OK(adfric_set_real(tip, "sphere%radius", 8e-6));
   CHECK_OK(adfric_solve(tip, 0, NULL, NULL, &found));
   CHECK_OK(adfric_array_of(found, "contact_radius", &radius));
   CHECK(radius.values[1] > before);
   CHECK_OK(adfric_close_results(found));
   CHECK_OK(adfric_close_case(tip));
}

/* A list of numbers, and a point without a sweep. */
static void test_list(void)
{
   const double amplitudes[] = {1e-4, 0.5e-4}, phases[] = {0, 0}, others[] = {1e-4, 0.2e-4}, wrong[] = {NAN, 1};
   const int64_t two = 2;
   adfric_variable_info variable;
   adfric_case wave = 0;
   adfric_results found = 0;
   adfric_array list, status;
   int32_t k = 0;
   do CHECK_OK(adfric_variable("wavy_sliding", k++, &variable)); while (strcmp(variable.name, "amplitudes") != 0);
   CHECK(variable.kind == ADFRIC_ARRAY && variable.is_list == 1);
   CHECK_OK(adfric_open("wavy_sliding", &wave));
   CHECK_OK(adfric_set_word(wave, "kind", "cosines"));
   CHECK_OK(adfric_set_real(wave, "period", 1e-2));
   CHECK_OK(adfric_set_array(wave, "amplitudes", 1, &two, amplitudes));
   CHECK_OK(adfric_set_array(wave, "phases", 1, &two, phases));
   CHECK_OK(adfric_set_real(wave, "stiffness", 1e8));
   CHECK_OK(adfric_set_real(wave, "relaxation_time", 1e-3));
   CHECK_OK(adfric_set_real(wave, "retardation_ratio", 10));
   CHECK_OK(adfric_set_real(wave, "velocity", 0.5));
   CHECK_OK(adfric_set_real(wave, "load", 1e3));
   CHECK_OK(adfric_solve(wave, 0, NULL, NULL, &found));
   CHECK_OK(adfric_array_of(found, "amplitudes", &list));
   CHECK(list.role == ADFRIC_LIST && list.rank == 1 && list.shape[0] == 2 && list.values[1] == 0.5e-4);
   CHECK(strcmp(list.dimensions[0], "amplitudes_place") == 0);
   CHECK_OK(adfric_array_of(found, "status", &status));
   CHECK(status.rank == 0);
   CHECK_OK(adfric_close_results(found));
   /* another list takes its place, one that is refused leaves none, and none is none */
   CHECK_OK(adfric_set_array(wave, "amplitudes", 1, &two, others));
   CHECK_OK(adfric_solve(wave, 0, NULL, NULL, &found));
   CHECK_OK(adfric_array_of(found, "amplitudes", &list));
   CHECK(list.values[1] == 0.2e-4);
   CHECK_OK(adfric_close_results(found));
   CHECK_REFUSED(adfric_set_array(wave, "amplitudes", 1, &two, wrong), "&surface amplitudes: ");
   CHECK_REFUSED(adfric_check(wave), "&surface amplitudes: is missing");
   CHECK_OK(adfric_set_array(wave, "amplitudes", 1, &two, amplitudes));
   CHECK_OK(adfric_unset(wave, "amplitudes"));
   CHECK_REFUSED(adfric_check(wave), "&surface amplitudes: is missing");
   CHECK_OK(adfric_close_case(wave));
}

/* A point of a case as numbers alone. */
static void test_point(void)
{
   const char *const names[] = {"contact_radius", "status", "error_estimate"};
   const char *const wrong[] = {"contact_radius", "contact_radus"};
   const double loads[] = {0, 1e-7};
   adfric_case tip = 0;
   adfric_results found = 0;
   adfric_array radius;
   double values[] = {-1, -1, -1};
   CHECK_OK(adfric_open("sphere", &tip));
   CHECK_OK(adfric_set_real(tip, "radius", 1e-6));
   CHECK_OK(adfric_set_real(tip, "contact_modulus", 1e9));
   CHECK_OK(adfric_set_real(tip, "work_of_adhesion", 0.05));
   CHECK_OK(adfric_set_word(tip, "theory", "jkr"));
   CHECK_REFUSED(adfric_solve_point(tip, 3, names, values), "is missing");
   CHECK_OK(adfric_set_real(tip, "load", 1e-7));
   CHECK_OK(adfric_solve(tip, 1, NULL, NULL, &found));
   CHECK_OK(adfric_array_of(found, "contact_radius", &radius));
   CHECK_OK(adfric_solve_point(tip, 3, names, values));
   CHECK(values[0] == radius.values[0] && values[1] == ADFRIC_SOLVED && values[2] >= 0);
   CHECK_OK(adfric_close_results(found));
   CHECK_REFUSED(adfric_solve_point(tip, 2, wrong, values), "did you mean 'contact_radius'");
   CHECK_REFUSED(adfric_solve_point(tip, 1, NULL, values), "names: given NULL");
   CHECK_REFUSED(adfric_solve_point(tip, 1, names, NULL), "values: given NULL");
   CHECK(values[0] > 0);
   CHECK_OK(adfric_set_real(tip, "load", -1));
   CHECK_OK(adfric_solve_point(tip, 2, names, values));
   CHECK(isnan(values[0]) && values[1] == ADFRIC_NO_EQUILIBRIUM);
   CHECK_OK(adfric_sweep(tip, "load", 2, loads));
   CHECK_REFUSED(adfric_solve_point(tip, 2, names, values), "the case has 2 points");
   CHECK_OK(adfric_close_case(tip));
}

/* A fit of a table in memory: exact points of Hertz's contact give back the modulus. */
static void test_fit(void)
{
   enum { n_rows = 20 };
   const char *text = "&job model = 'sphere' /\n&data file = 'points', abscissa = 'approach', ordinate = 'load', sigma = 1e-12 /\n"
                      "&free variable = 'contact_modulus' /\n&sphere radius = 1e-6, work_of_adhesion = 0 /\n&model theory = 'hertz' /\n";
   const char *const columns[] = {"approach", "load"}, *const units[] = {"nm", ""}, *const bad_units[] = {"kg", ""};
   double values[2*n_rows];
   adfric_table table = {.name = "points", .columns = columns, .units = units, .values = values, .n = n_rows, .n_columns = 2};
   adfric_case fit = 0;
   adfric_results found = 0;
   adfric_array modulus, names, residual, status;
   int64_t n = 0;
   for (int k = 0; k < n_rows; k++) {
      values[k] = 0.5*(k + 1);
      values[n_rows + k] = 4.0/3*2e9*sqrt(1e-6)*pow(values[k]*1e-9, 1.5);
   }
   CHECK_OK(adfric_read_fit(text, 1, &table, &fit));
   CHECK_OK(adfric_point_count(fit, &n));
   CHECK(n == 1);
   CHECK_REFUSED(adfric_set_real(fit, "radius", 1), "a fit is as its input describes it");
   CHECK_OK(adfric_check(fit));
   CHECK_OK(adfric_solve(fit, 0, NULL, NULL, &found));
   CHECK_OK(adfric_array_of(found, "status", &status));
   CHECK(status.states[0] == 0);
   CHECK_OK(adfric_array_of(found, "contact_modulus", &modulus));
   CHECK(is_close(modulus.values[0], 2e9, 1e-9) && modulus.role == ADFRIC_RESULT);
   CHECK_OK(adfric_array_of(found, "variable", &names));
   CHECK(names.role == ADFRIC_WORDS && names.shape[0] == 1 && strcmp(names.flag_meanings, "contact_modulus") == 0);
   CHECK_OK(adfric_array_of(found, "residual", &residual));
   CHECK(residual.role == ADFRIC_EXTRA && residual.shape[0] == n_rows && strcmp(residual.dimensions[0], "point") == 0);
   CHECK_OK(adfric_close_results(found));
   CHECK_REFUSED(adfric_solve(fit, 0, NULL, NULL, &found), "a fit is solved once");
   CHECK_OK(adfric_close_case(fit));
   fit = 42;
   table.units = bad_units;
   CHECK_REFUSED(adfric_read_fit(text, 1, &table, &fit), "column approach: the units 'kg'");
   table.units = NULL;
   table.n_columns = 1;
   CHECK_REFUSED(adfric_read_fit(text, 1, &table, &fit), "unknown column");
   table.n_columns = 0;
   CHECK_REFUSED(adfric_read_fit(text, 1, &table, &fit), "out of range");
   CHECK_REFUSED(adfric_read_fit(text, 0, NULL, &fit), "points");
   CHECK_REFUSED(adfric_read_fit(text, 1, NULL, &fit), "tables: given NULL");
   CHECK_REFUSED(adfric_read_fit(text, -1, &table, &fit), "n_tables: out of range");
   CHECK_REFUSED(adfric_read_fit("&job model = 'sphere' /", 0, NULL, &fit), "&data: the group is missing");
   CHECK_REFUSED(adfric_read_fit(NULL, 0, NULL, &fit), "text: given NULL");
   CHECK(fit == 42);
}

int main(void)
{
   CHECK(strlen(adfric_version()) > 4);
   test_models();
   test_tables();
   test_sweep();
   test_sweeps();
   test_maps();
   test_input();
   test_list();
   test_point();
   test_fit();
   return 0;
}
