! SPDX-License-Identifier: GPL-3.0-or-later
!> Hertz's contacts of half-width a = 1 m and largest pressure p0 = 1 Pa: all others of their shape are these in other units.
!>
!> What does not depend on load, modulus and size is found here, once for the neighbouring points of a sweep that share it: the
!> numbers that it depends on are nu of a line, and A/B and nu of an ellipse.
module adfric_plane_hertz_unit
   use adfric_base_kinds, only: dp, i8
   use adfric_base_unset, only: is_set, unset
   use adfric_plane_contact_conditions, only: largest_violation
   use adfric_plane_hertz_ellipse, only: ellipse_t, ellipse_shape_t, find_shape, ellipse_pressure, ellipse_gap, &
      & ellipse_axial_stress, ellipse_edge_shear
   use adfric_plane_hertz_line, only: line_contact_t, line_pressure, line_gap
   use adfric_plane_largest_shear, only: axial_stress_t, find_largest_shear, find_largest_von_mises
   use adfric_plane_strip_tractions, only: hertz_strip_stress
   implicit none (type, external)
   private
   public :: unit_contact_t, find_unit_line, find_unit_ellipse
   public :: add_line_von_mises, add_ellipse_von_mises

   !> Positions on each axis where the conditions of contact are checked, a third of them in it; how far they reach, in half-widths.
   integer, parameter :: n_positions = 24
   real(dp), parameter :: reach = 3.0_dp

   !> A unit contact.
   type :: unit_contact_t
      !> All numbers that the contact follows from; not allocated before it is solved.
      real(dp), allocatable :: key(:)
      !> Shape of the ellipse; without meaning for a line.
      type(ellipse_shape_t) :: shape
      !> Largest shear stress and its depth; 0 for an ellipse without nu.
      real(dp) :: shear = 0, depth = 0
      !> Largest von Mises stress and its depth, where they have been asked for; below 0 before.
      real(dp) :: von_mises = -1, von_mises_depth = 0
      !> Largest violation of the conditions of contact at some positions.
      real(dp) :: violation = 0
   contains
      procedure, private :: is_of
   end type unit_contact_t

   !> Stress on the axis of an ellipse.
   type, extends(axial_stress_t) :: ellipse_stress_t
      !> The contact under whose centre the stress is.
      type(ellipse_t) :: contact
      !> Poisson's ratio of the solid [-].
      real(dp) :: poisson_ratio = 0
   contains
      procedure :: stress_at => ellipse_stress_at
   end type ellipse_stress_t

   !> Stress under a line contact in units of p0, depth in its half-width.
   type, extends(axial_stress_t) :: line_stress_t
      !> nu of plane strain; not set: the stress along the line is left out.
      real(dp) :: poisson_ratio = unset
   contains
      procedure :: stress_at => line_stress_at
   end type line_stress_t

contains

   !> Unit contact of a line; the last one stays, if it is of the same nu.
   subroutine find_unit_line(poisson_ratio, self)
      !> Poisson's ratio nu [-]; not set: the largest shear stress is that in the plane.
      real(dp), intent(in) :: poisson_ratio
      !> In: the last unit contact. Out: that of the line; `shape` has no meaning.
      type(unit_contact_t), intent(inout) :: self

      if (self%is_of([poisson_ratio])) return
      call solve_unit_line(poisson_ratio, self)
      self%key = [poisson_ratio]
   end subroutine find_unit_line

   !> Unit contact of an ellipse; the last one stays, if it is of the same A/B and nu.
   subroutine find_unit_ellipse(ratio, poisson_ratio, self)
      !> Ratio A/B of the curvatures [-], in (0, 1].
      real(dp), intent(in) :: ratio
      !> Poisson's ratio nu [-]; not set: no largest shear stress is looked for.
      real(dp), intent(in) :: poisson_ratio
      !> In: the last unit contact. Out: that of the ellipse; `shape%is_converged` tells whether it was found.
      type(unit_contact_t), intent(inout) :: self

      if (self%is_of([ratio, poisson_ratio])) return
      call solve_unit_ellipse(ratio, poisson_ratio, self)
      self%key = [ratio, poisson_ratio]
   end subroutine find_unit_ellipse

   !> Find the largest von Mises stress of a unit contact along a line, once.
   subroutine add_line_von_mises(poisson_ratio, self)
      !> Poisson's ratio nu of plane strain [-].
      real(dp), intent(in) :: poisson_ratio
      !> In: the contact of this nu. Out: with its von Mises stress.
      type(unit_contact_t), intent(inout) :: self

      if (.not. self%von_mises < 0) return
      call find_largest_von_mises(line_stress_t(poisson_ratio), 1.0_dp, self%von_mises_depth, self%von_mises)
   end subroutine add_line_von_mises

   !> Find the largest von Mises stress of a unit contact on an ellipse, once: on the axis, or for negative nu at the edge of the surface,
   !> where there is shear alone.
   subroutine add_ellipse_von_mises(poisson_ratio, self)
      !> Poisson's ratio nu [-].
      real(dp), intent(in) :: poisson_ratio
      !> In: the contact of this nu, converged. Out: with its von Mises stress.
      type(unit_contact_t), intent(inout) :: self
      type(ellipse_t) :: s
      real(dp) :: edge

      if (.not. self%von_mises < 0) return
      s%major = 1
      s%minor = self%shape%axis_ratio
      s%peak_pressure = 1
      s%approach = s%minor*self%shape%f
      call find_largest_von_mises(ellipse_stress_t(s, poisson_ratio), s%minor, self%von_mises_depth, self%von_mises)
      edge = sqrt(3.0_dp)*ellipse_edge_shear(s, poisson_ratio)
      if (.not. edge > self%von_mises) return
      self%von_mises = edge
      self%von_mises_depth = 0
   end subroutine add_ellipse_von_mises

   !> Does the contact follow from these numbers, to the last bit? Then results do not depend on which points came before.
   pure logical function is_of(self, key)
      class(unit_contact_t), intent(in) :: self
      !> nu of a line, or A/B and nu of an ellipse.
      real(dp), intent(in) :: key(:)

      is_of = .false.
      if (.not. allocated(self%key)) return
      if (size(self%key) == size(key)) is_of = all(transfer(self%key, [0_i8]) == transfer(key, [0_i8]))
   end function is_of

   !> Solve the unit contact along a line, R = 1 m.
   subroutine solve_unit_line(poisson_ratio, self)
      !> Poisson's ratio nu [-]; not set: the largest shear stress is that in the plane.
      real(dp), intent(in) :: poisson_ratio
      !> The unit contact; `shape` has no meaning for a line.
      type(unit_contact_t), intent(out) :: self
      type(line_contact_t) :: line

      line = line_contact_t(1.0_dp, 1.0_dp, 1.0_dp)
      call find_largest_shear(line_stress_t(poisson_ratio), 1.0_dp, self%depth, self%shear)
      self%violation = largest_violation(line_pressure(line, positions()), line_gap(line, positions()), 1.0_dp, 1.0_dp)
   end subroutine solve_unit_line

   !> Solve the unit contact on an ellipse, E* = 1 Pa.
   subroutine solve_unit_ellipse(ratio, poisson_ratio, self)
      !> Ratio A/B of the curvatures [-], in (0, 1].
      real(dp), intent(in) :: ratio
      !> Poisson's ratio nu [-]; not set: no largest shear stress is looked for.
      real(dp), intent(in) :: poisson_ratio
      !> The unit contact; `shape%is_converged` tells whether it was found.
      type(unit_contact_t), intent(out) :: self
      type(ellipse_t) :: s
      real(dp) :: x(2*n_positions), y(2*n_positions)

      call find_shape(ratio, self%shape)
      if (.not. self%shape%is_converged) return
      s%major = 1
      s%minor = self%shape%axis_ratio
      s%peak_pressure = 1
      s%approach = s%minor*self%shape%f
      if (is_set(poisson_ratio)) call solve_shear(s, poisson_ratio, self%shear, self%depth)
      x = [positions(), spread(0.0_dp, 1, n_positions)]
      y = [spread(0.0_dp, 1, n_positions), positions()*s%minor]
      self%violation = largest_violation(ellipse_pressure(s, x, y), ellipse_gap(s, 1.0_dp, x, y), 1.0_dp, s%approach)
   end subroutine solve_unit_ellipse

   !> The largest shear stress: on the axis, or for negative nu at the edge of the surface.
   pure subroutine solve_shear(s, poisson_ratio, shear, depth)
      !> Ellipse with the major half-axis 1 m and the largest pressure 1 Pa.
      type(ellipse_t), intent(in) :: s
      !> Poisson's ratio nu [-].
      real(dp), intent(in) :: poisson_ratio
      !> Receives the largest shear stress [Pa].
      real(dp), intent(inout) :: shear
      !> Receives the depth of the largest shear stress [m].
      real(dp), intent(inout) :: depth
      real(dp) :: edge

      call find_largest_shear(ellipse_stress_t(s, poisson_ratio), s%minor, depth, shear)
      edge = ellipse_edge_shear(s, poisson_ratio)
      if (.not. edge > shear) return
      shear = edge
      depth = 0
   end subroutine solve_shear

   !> Distances from the middle, in half-widths.
   pure function positions()
      real(dp) :: positions(n_positions)
      integer :: i

      positions = [(i*reach/n_positions, i=1, n_positions)]
   end function positions

   !> See `axial_stress_t`.
   pure function ellipse_stress_at(self, depth) result(stress)
      class(ellipse_stress_t), intent(in) :: self
      !> Depth on the axis [m], >= 0.
      real(dp), intent(in) :: depth
      real(dp) :: stress(3)

      stress = ellipse_axial_stress(self%contact, self%poisson_ratio, depth)
   end function ellipse_stress_at

   !> See `axial_stress_t`.
   pure function line_stress_at(self, depth) result(stress)
      class(line_stress_t), intent(in) :: self
      !> Depth on the axis, in half-widths [-], >= 0.
      real(dp), intent(in) :: depth
      real(dp) :: stress(3)

      stress = hertz_strip_stress(1.0_dp, 0.0_dp, 0.0_dp, depth)
      stress(3) = stress(1)
      if (is_set(self%poisson_ratio)) stress(3) = self%poisson_ratio*(stress(1) + stress(2))
   end function line_stress_at

end module adfric_plane_hertz_unit
