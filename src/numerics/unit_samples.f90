! SPDX-License-Identifier: GPL-3.0-or-later
!> Samples of the unit cube: Sobol's sequence (I. M. Sobol, USSR Comput. Math. Math. Phys. 7 (4), 86, 1967), Latin hypercubes
!> (M. D. McKay, R. J. Beckman, W. J. Conover, Technometrics 21, 239, 1979) and random points.
!>
!> All come from integers that the GNU Scientific Library makes, from Sobol's direction numbers or by the Mersenne twister MT19937,
!> so that a seed gives the same points on every machine.
module adfric_numerics_unit_samples
   use, intrinsic :: iso_c_binding, only: c_int, c_long, c_ptr
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_kinds, only: dp
   use adfric_numerics_gsl_bindings, only: gsl_qrng_sobol, gsl_qrng_alloc, gsl_qrng_get, gsl_qrng_free, gsl_rng_mt19937, &
      gsl_rng_alloc, gsl_rng_set, gsl_rng_uniform, gsl_rng_uniform_int, gsl_rng_free, gsl_cdf_ugaussian_pinv
   implicit none (type, external)
   private
   public :: fill_sobol, fill_latin_hypercube, fill_random, normal_quantile, most_sobol_dimensions

   !> Dimensions for which the library has direction numbers.
   integer, parameter :: most_sobol_dimensions = 40

contains

   !> Points of Sobol's sequence, without the corner of the cube with which it begins.
   subroutine fill_sobol(points)
      !> Receives the points, each coordinate > 0 and < 1; shape `(n_dimensions, n_points)`.
      real(dp), intent(out), contiguous :: points(:, :)
      type(c_ptr) :: sequence
      integer :: i, status

      if (has_asserts) call assert(size(points, 1) >= 1 .and. size(points, 1) <= most_sobol_dimensions, &
         & 'fill_sobol: 1 to 40 dimensions')
      sequence = gsl_qrng_alloc(gsl_qrng_sobol, int(size(points, 1), c_int))
      do i = 1, size(points, 2)
         status = gsl_qrng_get(sequence, points(:, i))
         if (has_asserts) call assert(status == 0, 'fill_sobol: gsl_qrng_get')
      end do
      call gsl_qrng_free(sequence)
   end subroutine fill_sobol

   !> A Latin hypercube: each of as many equal parts of a coordinate as there are points has one point, at random within it.
   subroutine fill_latin_hypercube(seed, points)
      !> Which one of all, >= 1.
      integer, intent(in) :: seed
      !> Receives the points, each coordinate >= 0 and < 1; shape `(n_dimensions, n_points)`.
      real(dp), intent(out) :: points(:, :)
      type(c_ptr) :: generator
      integer, allocatable :: parts(:)
      integer :: i, j, k, n, kept

      n = size(points, 2)
      allocate (parts(n))
      call begin_random(seed, generator)
      do k = 1, size(points, 1)
         parts = [(i, i=0, n - 1)]
         do i = n, 2, -1
            j = 1 + int(gsl_rng_uniform_int(generator, int(i, c_long)))
            kept = parts(i)
            parts(i) = parts(j)
            parts(j) = kept
         end do
         do i = 1, n
            points(k, i) = (parts(i) + gsl_rng_uniform(generator))/n
         end do
      end do
      call gsl_rng_free(generator)
   end subroutine fill_latin_hypercube

   !> Independent random points. A longer sample begins with a shorter one of the same seed.
   subroutine fill_random(seed, points)
      !> Which sample of all, >= 1.
      integer, intent(in) :: seed
      !> Receives the points, each coordinate >= 0 and < 1; shape `(n_dimensions, n_points)`.
      real(dp), intent(out) :: points(:, :)
      type(c_ptr) :: generator
      integer :: i, k

      call begin_random(seed, generator)
      do i = 1, size(points, 2)
         do k = 1, size(points, 1)
            points(k, i) = gsl_rng_uniform(generator)
         end do
      end do
      call gsl_rng_free(generator)
   end subroutine fill_random

   !> Make a generator with a seed.
   subroutine begin_random(seed, generator)
      !> The seed, >= 1.
      integer, intent(in) :: seed
      !> Receives the generator, which the caller gives back.
      type(c_ptr), intent(out) :: generator

      if (has_asserts) call assert(seed >= 1, 'begin_random: seed >= 1')
      generator = gsl_rng_alloc(gsl_rng_mt19937)
      call gsl_rng_set(generator, int(seed, c_long))
   end subroutine begin_random

   !> The number below which a standard normal variable lies with a probability; of 0 and 1 that of the nearest number within.
   pure real(dp) function normal_quantile(probability)
      !> The probability, 0 to 1.
      real(dp), intent(in) :: probability

      normal_quantile = gsl_cdf_ugaussian_pinv(min(max(probability, tiny(probability)), 1 - epsilon(probability)))
   end function normal_quantile

end module adfric_numerics_unit_samples
