! SPDX-License-Identifier: GPL-3.0-or-later
!> Bindings of the GNU Scientific Library. Its functions end the process where an argument is outside of their domain: only
!> `adfric_numerics_elliptic`, `adfric_numerics_bessel_ratios`, `adfric_numerics_unit_samples`, `adfric_numerics_distributions` and
!> `adfric_numerics_exponential_integral` call them, which look at the arguments before.
module adfric_numerics_gsl_bindings
   use, intrinsic :: iso_c_binding, only: c_double, c_int, c_long, c_ptr
   implicit none (type, external)
   private
   public :: gsl_sf_ellint_rf, gsl_sf_ellint_rd, gsl_prec_double
   public :: gsl_sf_bessel_i0_scaled, gsl_sf_bessel_i1_scaled, gsl_sf_bessel_k0_scaled, gsl_sf_bessel_k1_scaled
   public :: gsl_sf_expint_ei_scaled
   public :: gsl_qrng_sobol, gsl_qrng_alloc, gsl_qrng_get, gsl_qrng_free
   public :: gsl_rng_mt19937, gsl_rng_alloc, gsl_rng_set, gsl_rng_uniform, gsl_rng_uniform_int, gsl_rng_free, gsl_cdf_ugaussian_pinv
   public :: gsl_cdf_chisq_q, gsl_cdf_chisq_pinv, gsl_cdf_fdist_pinv, gsl_cdf_tdist_pinv, gsl_cdf_ugaussian_q

   !> Mode of a special function: all digits of double precision.
   integer(c_int), parameter :: gsl_prec_double = 0

   !> Constants of the library: its Sobol sequence and its Mersenne twister. They are variables only since C has them so.
   type(c_ptr), protected, bind(c, name='gsl_qrng_sobol') :: gsl_qrng_sobol
   type(c_ptr), protected, bind(c, name='gsl_rng_mt19937') :: gsl_rng_mt19937

   abstract interface
      !> A function of a number.
      pure real(c_double) function of_one_i(x) bind(c)
         import :: c_double
         implicit none (type, external)
         !> The number.
         real(c_double), intent(in), value :: x
      end function of_one_i

      !> A function of two numbers.
      pure real(c_double) function of_two_i(x, y) bind(c)
         import :: c_double
         implicit none (type, external)
         !> The numbers.
         real(c_double), intent(in), value :: x, y
      end function of_two_i
   end interface

   !> The number below which a standard normal variable lies with a probability > 0 and < 1.
   procedure(of_one_i), bind(c, name='gsl_cdf_ugaussian_Pinv') :: gsl_cdf_ugaussian_pinv
   !> The modified Bessel function e^(-|x|) I_0(x): x > 0.
   procedure(of_one_i), bind(c, name='gsl_sf_bessel_I0_scaled') :: gsl_sf_bessel_i0_scaled
   !> The modified Bessel function e^(-|x|) I_1(x): x > 0.
   procedure(of_one_i), bind(c, name='gsl_sf_bessel_I1_scaled') :: gsl_sf_bessel_i1_scaled
   !> The modified Bessel function e^x K_0(x): x > 0.
   procedure(of_one_i), bind(c, name='gsl_sf_bessel_K0_scaled') :: gsl_sf_bessel_k0_scaled
   !> The modified Bessel function e^x K_1(x): x > 0.
   procedure(of_one_i), bind(c, name='gsl_sf_bessel_K1_scaled') :: gsl_sf_bessel_k1_scaled
   !> The exponential integral e^(-x) Ei(x): x not 0.
   procedure(of_one_i), bind(c, name='gsl_sf_expint_Ei_scaled') :: gsl_sf_expint_ei_scaled
   !> Probability that a normal number is above a value.
   procedure(of_one_i), bind(c, name='gsl_cdf_ugaussian_Q') :: gsl_cdf_ugaussian_q
   !> Probability that chi squared is above a value >= 0; with its degrees of freedom, > 0.
   procedure(of_two_i), bind(c, name='gsl_cdf_chisq_Q') :: gsl_cdf_chisq_q
   !> The value that chi squared is below with a probability between 0 and 1; with its degrees of freedom, > 0.
   procedure(of_two_i), bind(c, name='gsl_cdf_chisq_Pinv') :: gsl_cdf_chisq_pinv
   !> The value that Student's t is below with a probability between 0 and 1; with its degrees of freedom, > 0.
   procedure(of_two_i), bind(c, name='gsl_cdf_tdist_Pinv') :: gsl_cdf_tdist_pinv

   interface
      !> Begin a sequence of points of low discrepancy.
      type(c_ptr) function gsl_qrng_alloc(kind, n_dimensions) bind(c, name='gsl_qrng_alloc')
         import :: c_int, c_ptr
         implicit none (type, external)
         !> `gsl_qrng_sobol`.
         type(c_ptr), intent(in), value :: kind
         !> Number of dimensions, 1 to 40 for Sobol's.
         integer(c_int), intent(in), value :: n_dimensions
      end function gsl_qrng_alloc

      !> The next point of a sequence; 0 if all went well.
      integer(c_int) function gsl_qrng_get(sequence, point) bind(c, name='gsl_qrng_get')
         import :: c_double, c_int, c_ptr
         implicit none (type, external)
         !> The sequence.
         type(c_ptr), intent(in), value :: sequence
         !> Receives the point, in the open unit cube.
         real(c_double), intent(inout) :: point(*)
      end function gsl_qrng_get

      !> Give a sequence back.
      subroutine gsl_qrng_free(sequence) bind(c, name='gsl_qrng_free')
         import :: c_ptr
         implicit none (type, external)
         !> The sequence.
         type(c_ptr), intent(in), value :: sequence
      end subroutine gsl_qrng_free

      !> Make a generator of random numbers.
      type(c_ptr) function gsl_rng_alloc(kind) bind(c, name='gsl_rng_alloc')
         import :: c_ptr
         implicit none (type, external)
         !> `gsl_rng_mt19937`.
         type(c_ptr), intent(in), value :: kind
      end function gsl_rng_alloc

      !> Begin anew with a seed.
      subroutine gsl_rng_set(generator, seed) bind(c, name='gsl_rng_set')
         import :: c_long, c_ptr
         implicit none (type, external)
         !> The generator.
         type(c_ptr), intent(in), value :: generator
         !> The seed, > 0.
         integer(c_long), intent(in), value :: seed
      end subroutine gsl_rng_set

      !> The next number of [0, 1).
      real(c_double) function gsl_rng_uniform(generator) bind(c, name='gsl_rng_uniform')
         import :: c_double, c_ptr
         implicit none (type, external)
         !> The generator.
         type(c_ptr), intent(in), value :: generator
      end function gsl_rng_uniform

      !> The next integer of 0 to n - 1.
      integer(c_long) function gsl_rng_uniform_int(generator, n) bind(c, name='gsl_rng_uniform_int')
         import :: c_long, c_ptr
         implicit none (type, external)
         !> The generator.
         type(c_ptr), intent(in), value :: generator
         !> Number of integers, 1 to 2**32 - 1.
         integer(c_long), intent(in), value :: n
      end function gsl_rng_uniform_int

      !> Give a generator back.
      subroutine gsl_rng_free(generator) bind(c, name='gsl_rng_free')
         import :: c_ptr
         implicit none (type, external)
         !> The generator.
         type(c_ptr), intent(in), value :: generator
      end subroutine gsl_rng_free

      !> Carlson's elliptic integral R_F(x, y, z).
      pure real(c_double) function gsl_sf_ellint_rf(x, y, z, mode) bind(c, name='gsl_sf_ellint_RF')
         import :: c_double, c_int
         implicit none (type, external)
         !> Arguments of the integral, >= 0, at most one of them 0.
         real(c_double), intent(in), value :: x, y, z
         !> Precision, `gsl_prec_double`.
         integer(c_int), intent(in), value :: mode
      end function gsl_sf_ellint_rf

      !> Carlson's elliptic integral R_D(x, y, z).
      pure real(c_double) function gsl_sf_ellint_rd(x, y, z, mode) bind(c, name='gsl_sf_ellint_RD')
         import :: c_double, c_int
         implicit none (type, external)
         !> Arguments of the integral, >= 0, at most one of them 0.
         real(c_double), intent(in), value :: x, y
         !> Third argument of the integral, > 0.
         real(c_double), intent(in), value :: z
         !> Precision, `gsl_prec_double`.
         integer(c_int), intent(in), value :: mode
      end function gsl_sf_ellint_rd

      !> The value that F is below with a probability.
      pure real(c_double) function gsl_cdf_fdist_pinv(p, nu1, nu2) bind(c, name='gsl_cdf_fdist_Pinv')
         import :: c_double
         implicit none (type, external)
         !> The probability, between 0 and 1.
         real(c_double), intent(in), value :: p
         !> Degrees of freedom of numerator and denominator, > 0.
         real(c_double), intent(in), value :: nu1, nu2
      end function gsl_cdf_fdist_pinv
   end interface

end module adfric_numerics_gsl_bindings
