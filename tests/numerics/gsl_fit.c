/* SPDX-License-Identifier: GPL-3.0-or-later */
/* GSL's nonlinear least squares. Its types are variables, and its settings structures passed by value, which Fortran has neither of. */
#include <gsl/gsl_multifit_nlinear.h>

/* Find the least squares from a start, which receives the answer; 0 if there is one. */
int fit_by_gsl(gsl_multifit_nlinear_fdf *fdf, double *x)
{
   gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
   gsl_multifit_nlinear_workspace *work = gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, fdf->n, fdf->p);
   gsl_vector_view start = gsl_vector_view_array(x, fdf->p);
   int status, info;
   size_t k;

   if (!work)
      return -1;
   status = gsl_multifit_nlinear_init(&start.vector, fdf, work);
   if (!status)
      status = gsl_multifit_nlinear_driver(200, 1e-13, 1e-13, 0.0, NULL, NULL, &info, work);
   for (k = 0; k < fdf->p; k++)
      x[k] = gsl_vector_get(gsl_multifit_nlinear_position(work), k);
   gsl_multifit_nlinear_free(work);
   return status;
}
