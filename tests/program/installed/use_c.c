/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Use adfric.h: Hertz's contact radius of a ball of 1 m under 4/3 N, E* = 1 Pa, is 1 m. */

#include <adfric.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

int main(void)
{
   char version[32] = "";
   adfric_case ball = 0;
   adfric_results found = 0;
   adfric_array radius;
   int status = adfric_open("sphere", &ball);
   if (status == ADFRIC_OK) status = adfric_set_real(ball, "radius", 1);
   if (status == ADFRIC_OK) status = adfric_set_real(ball, "contact_modulus", 1);
   if (status == ADFRIC_OK) status = adfric_set_real(ball, "work_of_adhesion", 0);
   if (status == ADFRIC_OK) status = adfric_set_real(ball, "load", 4.0/3);
   if (status == ADFRIC_OK) status = adfric_solve(ball, 0, NULL, NULL, &found);
   if (status == ADFRIC_OK) status = adfric_array_of(found, "contact_radius", &radius);
   if (status != ADFRIC_OK) {
      fprintf(stderr, "use_c: %s\n", adfric_message());
      return 1;
   }
   if (!(fabs(radius.values[0] - 1) <= 1e-14)) return 1;
   adfric_close_results(found);
   adfric_close_case(ball);
   /* without the revision */
   strncpy(version, adfric_version(), sizeof version - 1);
   version[strcspn(version, " ")] = '\0';
   printf("c %s\n", version);
   return 0;
}
