! SPDX-License-Identifier: GPL-3.0-or-later
!> What the n arms of a solid do to a sliding contact whose width is given: a system of n linear equations in closed form.
!>
!> The displacement u and the pressure Pi that an elastic half-plane of the relaxed modulus would need for it are an elastic pair.
!> In the gap Pi is a sum of exponentials e^(y/b_j) with amplitudes X_j, the stresses of the Kelvin elements, since p = 0 there;
!> and
!>
!>     sin m = sum_j eta_j,    eta_j = X_j int e^(-(y-w)/b_j) cos(y/2)/R dy/(2 pi C^2) > 0
!>
!> is the condition that the mean of p is real; m is the shift of the contact from the crest. That the pressure vanishes at both
!> edges is, with the means rho_i of the contact and rho'_j of the gap (`sliding_means`),
!>
!>     sum_j eta_j [(1 + a_i b_j) + (a_i/rho_i) (b_j + 1/b_j) rho'_j]/(b_j - a_i) = cos m,    i = 1 ... n
!>
!> A cylinder is a wave of no curvature: all lengths are short beside 1/k, so that 1 + a b, b + 1/b and sin m become 1, 1/b and m,
!> and cos m becomes 1.
module adfric_plane_sliding_shift
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_numerics_lapack, only: dgesv
   use adfric_plane_sliding_solid, only: sliding_solid_t
   implicit none (type, external)
   private
   public :: sliding_shift_t, find_shift

   !> The shift of a contact, and sums that friction and profiles are made of.
   type :: sliding_shift_t
      !> The shift m from the crest, towards the leading side [unit of length], >= 0.
      real(dp) :: shift = 0
      !> Sine and cosine of k m; m and 1 for a cylinder.
      real(dp) :: sine = 0, cosine = 1
      !> Shares eta_j of the sine; shape `(n)`.
      real(dp), allocatable :: shares(:)
      !> sum_j eta_j/(b_j - a_i) of each arm; shape `(n)`.
      real(dp), allocatable :: slopes(:)
      !> sum_j eta_j (b_j + 1/b_j) rho'_j/(b_j - a_i) of each arm; shape `(n)`.
      real(dp), allocatable :: edge_pressures(:)
      !> sum_j eta_j b_j, and 0 for a cylinder.
      real(dp) :: stiffening = 0
      !> sum_j eta_j (b_j + 1/b_j) rho'_j.
      real(dp) :: edge_load = 0
   end type sliding_shift_t

contains

   !> The shift of a contact.
   pure subroutine find_shift(solid, curvature, rho, gap_rho, self, is_converged)
      type(sliding_solid_t), intent(in) :: solid
      !> 1 for a wave, 0 for a cylinder.
      real(dp), intent(in) :: curvature
      !> Means over the contact with the relaxation lengths; shape `(n)`.
      real(dp), intent(in) :: rho(:)
      !> Means over the gap with the retardation lengths; shape `(n)`.
      real(dp), intent(in) :: gap_rho(:)
      type(sliding_shift_t), intent(out) :: self
      logical, intent(out) :: is_converged
      real(dp) :: tangents(solid%n_arms), gap_parts(solid%n_arms), tangent
      integer :: i, n

      n = solid%n_arms
      gap_parts = (curvature*solid%retardation + 1/solid%retardation)*gap_rho
      call solve_system(solid, curvature, rho, gap_parts, tangents, is_converged)
      tangent = sum(tangents)
      self%shift = tangent
      if (curvature > 0) then
         self%shift = atan(tangent)
         self%cosine = cos(self%shift)
      end if
      self%sine = tangent*self%cosine
      self%shares = tangents*self%cosine
      self%stiffening = curvature*sum(self%shares*solid%retardation)
      self%edge_load = sum(self%shares*gap_parts)
      self%slopes = [(sum(self%shares/solid%distances(i, :)), i=1, n)]
      self%edge_pressures = [(sum(self%shares*gap_parts/solid%distances(i, :)), i=1, n)]
   end subroutine find_shift

   !> Solve the system for eta_j/cos m, which are all positive. Rows and columns are scaled to numbers about 1.
   pure subroutine solve_system(solid, curvature, rho, gap_parts, tangents, is_converged)
      type(sliding_solid_t), intent(in) :: solid
      !> 1 for a wave, 0 for a cylinder.
      real(dp), intent(in) :: curvature
      !> Means over the contact; shape `(n)`.
      real(dp), intent(in) :: rho(:)
      !> (b_j + 1/b_j) times the means over the gap; shape `(n)`.
      real(dp), intent(in) :: gap_parts(:)
      !> The unknowns; shape `(n)`.
      real(dp), intent(out) :: tangents(:)
      logical, intent(out) :: is_converged
      real(dp) :: matrix(size(rho), size(rho)), right(size(rho), 1), columns(size(rho)), rows(size(rho))
      integer :: pivots(size(rho)), i, j, n, info

      n = size(rho)
      is_converged = .true.
      if (n == 0) return
      do j = 1, n
         matrix(:, j) = ((1 + curvature*solid%relaxation*solid%retardation(j)) + (solid%relaxation/rho)*gap_parts(j)) &
            & /solid%distances(:, j)
      end do
      columns = [(1/matrix(j, j), j=1, n)]
      do j = 1, n
         matrix(:, j) = matrix(:, j)*columns(j)
      end do
      rows = 1/maxval(abs(matrix), 2)
      do i = 1, n
         matrix(i, :) = matrix(i, :)*rows(i)
      end do
      right(:, 1) = rows
      call dgesv(n, 1, matrix, n, pivots, right, n, info)
      tangents = right(:, 1)*columns
      is_converged = info == 0
      if (is_converged) is_converged = all(ieee_is_finite(tangents) .and. tangents >= 0)
   end subroutine solve_system

end module adfric_plane_sliding_shift
