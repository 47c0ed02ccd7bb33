/* SPDX-License-Identifier: GPL-3.0-or-later */
/* GSL's solver types are variables, which Fortran cannot import from a library. */
#include <gsl/gsl_multiroots.h>

gsl_multiroot_fsolver *new_gsl_hybrids(size_t n)
{
   return gsl_multiroot_fsolver_alloc(gsl_multiroot_fsolver_hybrids, n);
}
