! SPDX-License-Identifier: GPL-3.0-or-later
!> What the words of `&surface kind` mean, as formulas.
module adfric_describe_scene_shapes
   use adfric_base_text, only: newline
   use adfric_base_words, only: count_words, get_word, has_word, pad
   implicit none (type, external)
   private
   public :: list_shapes

   !> A word, and the distance f of the surface from a plane through its foremost point; heights z where they are given as such.
   character(*), parameter :: shapes(*) = [character(110) :: &
      & 'sphere f = R - sqrt(R^2 - r^2), R = radius', &
      & 'paraboloid f = r^2/(2 R), R = radius', &
      & 'cone f = k r, k = slope, or the cotangent of half_angle', &
      & 'power f = C r^n, C = power_coefficient, n = exponent', &
      & 'flat_cone f = 0 up to b = face_radius, then k (r - b), k = slope', &
      & 'flat_paraboloid f = 0 up to b = face_radius, then (r^2 - b^2)/(2 R), R = radius', &
      & 'rounded_punch f = 0 up to b = face_radius, then (r - b)^2/(2 R), R = radius of the edge', &
      & 'rounded_cone f = r^2/(2 R) up to b = k R, then k (r - b/2); R = radius, k = slope', &
      & 'polynomial f = sum of C_i r^i, C_i = coefficient_i', &
      & 'flat_punch f = 0 up to face_radius, where the body ends', &
      & 'ellipsoid f = distance of two bodies with the main radii of curvature radius_1x to radius_2y', &
      & 'cylinder f = x^2/(2 R), R = radius, endless along y', &
      & 'line_punch f = 0 up to face_half_width, where the body ends; endless along y', &
      & 'wedge f = m |x|, m = slope; endless along y', &
      & 'line_polynomial f = sum of C_i x^i, C_i = coefficient_i, i even; endless along y', &
      & 'wave_1d f = A (1 - cos(2 pi x/l)), A = amplitude, l = period', &
      & 'wave_2d f = A (2 - cos(2 pi x/l) - cos(2 pi y/l)), A = amplitude, l = period', &
      & 'wave_product f = A (2 - (1 + cos(2 pi x/l)) (1 + cos(2 pi y/l))/2), A = amplitude, l = period', &
      & 'cosines z = sum of a_n cos(2 pi n x/l + phi_n), a_n = amplitudes, phi_n = phases, l = period', &
      & 'profile z = heights along x, samples of one period', &
      & 'heights z = heights over x and y, samples of one period along each', &
      & 'spectrum Gaussian heights z of the density C of &power_spectrum, <z^2> = int C d^2q']

contains

   !> What kinds of surfaces mean, a line for each.
   pure function list_shapes(kinds, name, width) result(lines)
      !> The kinds, separated by a blank.
      character(*), intent(in) :: kinds
      !> One of them; with another name, all.
      character(*), intent(in) :: name
      !> Width of the column of the kinds.
      integer, intent(in) :: width
      character(:), allocatable :: lines, kind
      integer :: k

      lines = ''
      kind = ''
      do k = 1, count_words(kinds)
         kind = get_word(kinds, k)
         if (has_word(kinds, name) .and. kind /= name) cycle
         lines = lines//pad('    '//kind, width)//shape_of(kind)//newline
      end do
   end function list_shapes

   !> The formula of a kind of surface; empty for another word.
   pure function shape_of(kind) result(formula)
      character(*), intent(in) :: kind
      character(:), allocatable :: formula
      integer :: k

      formula = ''
      do k = 1, size(shapes)
         if (get_word(shapes(k), 1) == kind) formula = trim(shapes(k)(len(kind) + 2:))
      end do
   end function shape_of

end module adfric_describe_scene_shapes
