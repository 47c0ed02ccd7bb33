/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A rough surface that a program has in memory, pressed against an elastic half-space: which share of it is in contact.

   The scene stands in a text. Its heights and its mean pressures come later, as arrays. */

#include <math.h>
#include <stdio.h>

#include "adfric.h"

enum { n = 64, n_pressures = 3 };

/* Lengths [m], contact modulus [Pa]. */
static const char scene[] = "&surface kind = 'heights', length_x = 1e-5, length_y = 1e-5 /\n"
                            "&solid contact_modulus = 1e9 /\n";
static const char *const later[] = {"heights", "mean_pressure"};

/* Has a call failed? Then the words of the library say why. */
static int has_failed(int status)
{
   if (status != ADFRIC_OK) fprintf(stderr, "rough_surface: %s\n", adfric_message());
   return status != ADFRIC_OK;
}

int main(void)
{
   static double heights[n][n]; /* [m], x varies fastest */
   const double two_pi = 6.283185307179586;
   const double pressures[n_pressures] = {1e6, 5e6, 20e6}; /* [Pa] */
   const int64_t shape[] = {n, n};
   adfric_case surface;
   adfric_results found;
   adfric_array fraction;

   for (int j = 0; j < n; j++) {
      for (int i = 0; i < n; i++)
         heights[j][i] = 1e-8*(cos(two_pi*i/n) + cos(two_pi*j/n) + 0.3*cos(two_pi*(5*i + 3*j)/n));
   }
   if (has_failed(adfric_open_scene(scene, 2, later, &surface))) return 1;
   if (has_failed(adfric_set_array(surface, "heights", 2, shape, heights[0]))) return 1;
   if (has_failed(adfric_sweep(surface, "mean_pressure", n_pressures, pressures))) return 1;
   if (has_failed(adfric_solve(surface, 0, NULL, NULL, &found))) return 1;
   if (has_failed(adfric_array_of(found, "contact_fraction", &fraction))) return 1;
   for (int i = 0; i < n_pressures; i++) printf("%.0e Pa: %.4f of the area\n", pressures[i], fraction.values[i]);
   adfric_close_results(found);
   adfric_close_case(surface);
   return 0;
}
