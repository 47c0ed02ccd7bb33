/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Granular dynamics with Maugis-Dugdale contacts: the forces of all pairs of grains in one call. Here a row of grains that touch is
   let go, is drawn together by adhesion, and comes to rest.

   A pair has the radius R1 R2/(R1 + R2), and Maugis's lambda says how short the range of its adhesion is. */

#include <math.h>
#include <stdio.h>

#include "adfric.h"

enum { n_grains = 8, n_pairs = n_grains - 1, n_steps = 20000 };

/* Grains of a soft powder: radius [m], density [kg/m^3], contact modulus [Pa], work of adhesion [J/m^2], adhesion stress [Pa]. */
static const double radius = 5e-6, density = 2500, modulus = 1e8, work = 0.02, stress = 1e7;

/* The four units of the reduced variables, and lambda, of each pair. */
struct pairs {
   double length[n_pairs], closer[n_pairs], force[n_pairs], strength[n_pairs], lambda[n_pairs];
};

/* Has a call failed? Then the words of the library say why. */
static int has_failed(int status)
{
   if (status != ADFRIC_OK) fprintf(stderr, "maugis_dugdale: %s\n", adfric_message());
   return status != ADFRIC_OK;
}

static int set_pairs(struct pairs *pairs)
{
   double radii[n_pairs], moduli[n_pairs], works[n_pairs];
   for (int i = 0; i < n_pairs; i++) {
      radii[i] = radius/2;
      moduli[i] = modulus;
      works[i] = work;
   }
   const int status = adfric_sphere_scales(n_pairs, radii, moduli, works, pairs->length, pairs->closer, pairs->force,
                                           pairs->strength);
   for (int i = 0; i < n_pairs; i++) pairs->lambda[i] = stress/pairs->strength[i];
   return status;
}

/* Forces of the pairs [N], pressing positive. A pair that is out of reach has none. */
static int find_forces(const struct pairs *pairs, const double *place, double *force, double *contact_radius)
{
   double approach[n_pairs], adhesion_radius[n_pairs], load[n_pairs];
   int32_t status[n_pairs];
   for (int i = 0; i < n_pairs; i++) approach[i] = (2*radius - (place[i + 1] - place[i]))/pairs->closer[i];
   const int outcome = adfric_sphere_approach(n_pairs, pairs->lambda, approach, NULL, contact_radius, adhesion_radius, load,
                                              status);
   for (int i = 0; i < n_pairs; i++) {
      const int is_held = status[i] == ADFRIC_SOLVED;
      force[i] = is_held ? load[i]*pairs->force[i] : 0;
      contact_radius[i] = is_held ? contact_radius[i]*pairs->length[i] : 0;
   }
   return outcome;
}

int main(void)
{
   const double mass = 4.0/3*3.14159265358979*pow(radius, 3)*density, step = 2e-9, damping = 2e-6;
   struct pairs pairs;
   double place[n_grains], velocity[n_grains] = {0}, force[n_pairs], contact_radius[n_pairs];
   if (has_failed(set_pairs(&pairs))) return 1;
   for (int i = 0; i < n_grains; i++) place[i] = 2*radius*i;
   for (int k = 0; k < n_steps; k++) {
      if (has_failed(find_forces(&pairs, place, force, contact_radius))) return 1;
      for (int i = 0; i < n_grains; i++) {
         double sum = -damping*velocity[i];
         if (i > 0) sum += force[i - 1];
         if (i < n_pairs) sum -= force[i];
         velocity[i] += sum/mass*step;
         place[i] += velocity[i]*step;
      }
   }
   printf("lambda %.3f, pair at rest: approach %.3e m, contact radius %.3e m, force %.1e N\n", pairs.lambda[0],
          2*radius - (place[1] - place[0]), contact_radius[0], force[0]);
   return 0;
}
