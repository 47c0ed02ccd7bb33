/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Batches of contacts: closed forms, round trips, and arguments that are not allowed. */

#include "check.h"

static const double pi = 3.14159265358979323846;

/* Units of Johnson (1997, eq. 2.11), and numbers that have none. */
static void test_units(void)
{
   const double radius[] = {1e-6, 1.0}, modulus[] = {1e9, 1.0}, work[] = {0.05, 1.0};
   const double wrong[] = {1.0, -1.0}, not_a_number[] = {NAN, 1.0};
   double length[2] = {7, 7}, closer[2], force[2], strength[2];
   CHECK_OK(adfric_sphere_scales(2, radius, modulus, work, length, closer, force, strength));
   for (int i = 0; i < 2; i++) {
      CHECK(is_close(force[i], pi*work[i]*radius[i], 1e-15));
      CHECK(is_close(length[i], cbrt(3*pi*work[i]*radius[i]*radius[i]/(4*modulus[i])), 1e-14));
      CHECK(is_close(closer[i], length[i]*length[i]/radius[i], 1e-14));
      CHECK(is_close(strength[i], cbrt(2*pi*work[i]*modulus[i]*modulus[i]/(9*radius[i])), 1e-14));
   }
   length[0] = 7;
   CHECK_REFUSED(adfric_sphere_scales(2, wrong, modulus, work, length, closer, force, strength),
                 "radius: out of range, given -1.0000E+00 at place 1, allowed: a number > 0 [m]");
   CHECK_REFUSED(adfric_sphere_scales(2, radius, not_a_number, work, length, closer, force, strength),
                 "contact_modulus: out of range, given NaN at place 0, allowed: a number > 0 [Pa]");
   CHECK(length[0] == 7);
}

/* Pull-off between the limits of JKR, -3/2, and DMT, -2; and there and back. */
static void test_sphere(void)
{
   enum { n = 3 };
   const double lambda[n] = {1e-6, 1.0, 1e4}, load[n] = {0.5, 0.5, 0.5};
   const int8_t yes[n] = {1, 1, 1};
   double least[n], approach[n], radius[n], adhesion[n], again[n], other[n], held[n];
   int32_t status[n];
   CHECK_OK(adfric_sphere_pull_off(n, lambda, NULL, least, approach, radius, status));
   /* the distance to either limit is of the order of lambda^(4/3) and lambda^-(4/3) */
   CHECK(is_close(least[0], -2, 1e-4) && is_close(least[2], -1.5, 1e-4) && least[1] > -2 && least[1] < -1.5);
   CHECK_OK(adfric_sphere_pull_off(n, lambda, yes, held, approach, radius, status));
   CHECK(held[2] > least[2]);
   CHECK_OK(adfric_sphere_load(n, lambda, load, NULL, radius, adhesion, approach, status));
   for (int i = 0; i < n; i++) CHECK(status[i] == ADFRIC_SOLVED && adhesion[i] > radius[i] && radius[i] > 0);
   CHECK_OK(adfric_sphere_approach(n, lambda, approach, NULL, other, adhesion, again, status));
   for (int i = 0; i < n; i++) CHECK(is_close(again[i], load[i], 1e-9) && is_close(other[i], radius[i], 1e-9));
   CHECK_OK(adfric_sphere_radius(n, lambda, radius, adhesion, again, other, status));
   for (int i = 0; i < n; i++) CHECK(is_close(again[i], load[i], 1e-9) && is_close(other[i], approach[i], 1e-9));
}

/* Each contact has its own status, and its own branch. */
static void test_status(void)
{
   const double lambda[] = {1, NAN, 1, -1, 1, 1}, load[] = {0, 0, -5, 0, -1, -1};
   const int8_t is_unstable[] = {0, 0, 0, 0, 0, 1};
   double radius[6], adhesion[6], approach[6];
   int32_t status[6];
   CHECK_OK(adfric_sphere_load(6, lambda, load, is_unstable, radius, adhesion, approach, status));
   CHECK(status[0] == ADFRIC_SOLVED && status[1] == ADFRIC_BAD_ARGUMENT && status[2] == ADFRIC_NO_EQUILIBRIUM);
   CHECK(status[3] == ADFRIC_BAD_ARGUMENT && isnan(radius[1]) && isnan(radius[2]) && isnan(approach[3]));
   CHECK(status[4] == ADFRIC_SOLVED && approach[5] != approach[4]);
   radius[0] = 7;
   CHECK_REFUSED(adfric_sphere_load(-1, lambda, load, NULL, radius, adhesion, approach, status), "n: out of range, given -1");
   CHECK_REFUSED(adfric_sphere_load(6, NULL, load, NULL, radius, adhesion, approach, status), "lambda: given NULL");
   CHECK_REFUSED(adfric_sphere_load(6, lambda, load, NULL, radius, adhesion, approach, NULL), "status: given NULL");
   CHECK_OK(adfric_sphere_load(0, NULL, NULL, NULL, NULL, NULL, NULL, NULL));
   CHECK(radius[0] == 7);
}

/* The same sphere by its model and in a batch. */
static void test_same_sphere(void)
{
   const double lambda = 0.7, load = 1.5;
   double radius, adhesion, approach;
   int32_t status;
   adfric_case tip = 0;
   adfric_results found = 0;
   adfric_array array;
   CHECK_OK(adfric_sphere_load(1, &lambda, &load, NULL, &radius, &adhesion, &approach, &status));
   CHECK_OK(adfric_open("sphere", &tip));
   CHECK_OK(adfric_set_word(tip, "units", "reduced"));
   CHECK_OK(adfric_set_word(tip, "theory", "maugis_dugdale"));
   CHECK_OK(adfric_set_real(tip, "lambda", lambda));
   CHECK_OK(adfric_set_real(tip, "load", load));
   CHECK_OK(adfric_solve(tip, 1, NULL, NULL, &found));
   CHECK_OK(adfric_array_of(found, "contact_radius", &array));
   CHECK(is_close(array.values[0], radius, 1e-12) && strcmp(array.unit, "1") == 0);
   CHECK_OK(adfric_array_of(found, "approach", &array));
   CHECK(is_close(array.values[0], approach, 1e-12));
   CHECK_OK(adfric_close_results(found));
   CHECK_OK(adfric_close_case(tip));
}

/* Full contact with an elastic foundation has half the load of the crest; a viscoelastic one is there and back. */
static void test_strip(void)
{
   const double phase[] = {1, 1}, ratio[] = {1, 10}, stress[] = {0, 0.05}, range[] = {0, 0.1}, depth[] = {1, 0.6};
   const int8_t yes[] = {1, 1};
   double load[2], friction[2], width[2], shift[2], again[2], other[2];
   int32_t status[2];
   CHECK_OK(adfric_strip_penetration(2, phase, ratio, stress, range, depth, NULL, NULL, load, friction, width, shift, status));
   CHECK(status[0] == ADFRIC_SOLVED && status[1] == ADFRIC_SOLVED);
   CHECK(is_close(load[0], 0.5, 1e-12) && fabs(friction[0]) < 1e-12 && is_close(width[0], 1, 1e-12) && friction[1] > 0);
   CHECK_OK(adfric_strip_load(2, phase, ratio, stress, range, load, NULL, NULL, again, other, width, shift, status));
   CHECK(is_close(again[1], depth[1], 1e-9) && is_close(other[1], friction[1], 1e-9));
   CHECK_OK(adfric_strip_load(2, phase, ratio, stress, range, load, yes, yes, again, other, width, shift, status));
   CHECK(status[1] == ADFRIC_SOLVED && !is_close(other[1], friction[1], 1e-9));
   CHECK_REFUSED(adfric_strip_load(2, phase, ratio, stress, NULL, load, NULL, NULL, again, other, width, shift, status),
                 "range: given NULL, allowed: an array");
}

/* Westergaard 1939: p = pi E* a/l sin^2(pi f/2) of a wave with amplitude a and share f in contact. */
static void test_periodic(void)
{
   enum { n = 256 };
   double heights[n], pressure[n], gap[n], depth, share, mean, sum = 0;
   int32_t status;
   const double full = pi*1e-3;
   for (int i = 0; i < n; i++) heights[i] = 1e-3*cos(2*pi*(i + 0.5)/n);
   CHECK_OK(adfric_periodic_pressure(1, n, heights, 0, 1, full/2, 1e-10, pressure, gap, &depth, &share, &status));
   CHECK(status == ADFRIC_SOLVED);
   /* within two cells */
   CHECK(fabs(share - 0.5) < 2.0/n);
   for (int i = 0; i < n; i++) sum += pressure[i];
   CHECK(is_close(sum/n, full/2, 1e-9));
   CHECK_OK(adfric_periodic_penetration(1, n, heights, 0, 1, depth, 1e-10, pressure, gap, &mean, &share, &status));
   CHECK(status == ADFRIC_SOLVED && is_close(mean, full/2, 1e-7));
   CHECK_OK(adfric_periodic_pressure(1, n, heights, 0, 1, NAN, 1e-10, pressure, gap, &depth, &share, &status));
   CHECK(status == ADFRIC_BAD_ARGUMENT && isnan(depth) && isnan(pressure[0]));
   CHECK_REFUSED(adfric_periodic_pressure(0, n, heights, 0, 1, full, 1e-10, pressure, gap, &depth, &share, &status),
                 "ny: out of range, given 0, allowed: 1 to ");
   CHECK_REFUSED(adfric_periodic_pressure(1, n, heights, 0, 1, full, 1e-10, NULL, gap, &depth, &share, &status),
                 "pressure: given NULL, allowed: an array");
}

int main(void)
{
   test_units();
   test_sphere();
   test_status();
   test_same_sphere();
   test_strip();
   test_periodic();
   return 0;
}
