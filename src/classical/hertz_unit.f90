!> Hertz's contacts of half-width a = 1 m and largest pressure p0 = 1 Pa: all others of their shape are these in other units.
!>
!> What does not depend on load, modulus and size is found here, once for the neighbouring points of a sweep that share it: the
!> numbers that it depends on are nu of a line, and A/B and nu of an ellipse.
module adfric_classical_hertz_unit
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set, unset
   use adfric_classical_contact_conditions, only: largest_violation
   use adfric_classical_hertz_ellipse, only: ellipse_t, ellipse_shape_t, find_shape, ellipse_pressure, ellipse_gap, &
      & ellipse_axial_stress, ellipse_edge_shear
   use adfric_classical_hertz_line, only: line_contact_t, line_pressure, line_gap
   use adfric_classical_largest_shear, only: axial_stress_t, find_largest_shear
   use adfric_classical_point_memory, only: point_memory_t
   use adfric_classical_strip_tractions, only: hertz_strip_stress
   implicit none (type, external)
   private
   public :: unit_contact_t, find_unit_line, find_unit_ellipse

   !> Places on each axis where the conditions of contact are checked, a third of them in it; how far they reach, in half-widths.
   integer, parameter :: n_places = 24
   real(dp), parameter :: reach = 3.0_dp
   !> Numbers of a unit contact.
   integer, parameter :: n_kept = 8

   !> A unit contact.
   type :: unit_contact_t
      !> Shape of the ellipse; without meaning for a line.
      type(ellipse_shape_t) :: shape
      !> Largest shear stress and its depth; 0 for an ellipse without nu.
      real(dp) :: shear = 0, depth = 0
      !> Largest violation of the conditions of contact at some places.
      real(dp) :: violation = 0
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

   !> Unit contact of a line; that of the last point, if this was solved for a line of the same nu.
   subroutine find_unit_line(poisson_ratio, memory, self)
      !> Poisson's ratio nu [-]; not set: the largest shear stress is that in the plane.
      real(dp), intent(in) :: poisson_ratio
      !> What earlier points of the block have found; this point keeps there what it finds.
      type(point_memory_t), intent(inout) :: memory
      !> The unit contact; `shape` has no meaning for a line.
      type(unit_contact_t), intent(out) :: self
      logical :: is_known

      call recall_unit_contact([poisson_ratio], memory, self, is_known)
      if (is_known) return
      call solve_unit_line(poisson_ratio, self)
      call keep_unit_contact([poisson_ratio], self, memory)
   end subroutine find_unit_line

   !> Unit contact of an ellipse; that of the last point, if this was solved for the same A/B and nu.
   subroutine find_unit_ellipse(ratio, poisson_ratio, memory, self)
      !> Ratio A/B of the curvatures [-], in (0, 1].
      real(dp), intent(in) :: ratio
      !> Poisson's ratio nu [-]; not set: no largest shear stress is looked for.
      real(dp), intent(in) :: poisson_ratio
      !> What earlier points of the block have found; this point keeps there what it finds.
      type(point_memory_t), intent(inout) :: memory
      !> The unit contact; `shape%is_converged` tells whether it was found.
      type(unit_contact_t), intent(out) :: self
      logical :: is_known

      call recall_unit_contact([ratio, poisson_ratio], memory, self, is_known)
      if (is_known) return
      call solve_unit_ellipse(ratio, poisson_ratio, self)
      call keep_unit_contact([ratio, poisson_ratio], self, memory)
   end subroutine find_unit_ellipse

   !> Give back the unit contact that was kept for a key.
   pure subroutine recall_unit_contact(key, memory, self, is_known)
      !> All numbers that the contact depends on.
      real(dp), intent(in) :: key(:)
      !> Memory that is looked into.
      type(point_memory_t), intent(in) :: memory
      !> The unit contact as it was kept; without meaning if the key is not known.
      type(unit_contact_t), intent(out) :: self
      !> Does the memory have this key?
      logical, intent(out) :: is_known
      real(dp) :: found(n_kept)

      call memory%recall(key, found, is_known)
      if (is_known) self = unit_contact_t(ellipse_shape_t(found(1), found(2), found(3), found(4), found(5) > 0), found(6), &
         & found(7), found(8))
   end subroutine recall_unit_contact

   !> Keep the unit contact for a key.
   pure subroutine keep_unit_contact(key, self, memory)
      !> All numbers that the contact depends on.
      real(dp), intent(in) :: key(:)
      !> The unit contact that is kept.
      type(unit_contact_t), intent(in) :: self
      !> Memory, which receives the contact in place of what it held.
      type(point_memory_t), intent(inout) :: memory
      real(dp) :: found(n_kept)

      associate (s => self%shape)
         found = [s%axis_ratio, s%d_along, s%d_across, s%f, merge(1.0_dp, 0.0_dp, s%is_converged), self%shear, self%depth, &
            & self%violation]
      end associate
      call memory%keep(key, found)
   end subroutine keep_unit_contact

   !> Solve the unit contact along a line, R = 1 m.
   subroutine solve_unit_line(poisson_ratio, self)
      !> Poisson's ratio nu [-]; not set: the largest shear stress is that in the plane.
      real(dp), intent(in) :: poisson_ratio
      !> The unit contact; `shape` has no meaning for a line.
      type(unit_contact_t), intent(out) :: self
      type(line_contact_t) :: line

      line = line_contact_t(1.0_dp, 1.0_dp, 1.0_dp)
      call find_largest_shear(line_stress_t(poisson_ratio), 1.0_dp, self%depth, self%shear)
      self%violation = largest_violation(line_pressure(line, places()), line_gap(line, places()), 1.0_dp, 1.0_dp)
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
      real(dp) :: x(2*n_places), y(2*n_places)

      call find_shape(ratio, self%shape)
      if (.not. self%shape%is_converged) return
      s%major = 1
      s%minor = self%shape%axis_ratio
      s%peak_pressure = 1
      s%approach = s%minor*self%shape%f
      if (is_set(poisson_ratio)) call solve_shear(s, poisson_ratio, self%shear, self%depth)
      x = [places(), spread(0.0_dp, 1, n_places)]
      y = [spread(0.0_dp, 1, n_places), places()*s%minor]
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
   pure function places()
      real(dp) :: places(n_places)
      integer :: i

      places = [(i*reach/n_places, i=1, n_places)]
   end function places

   !> See `axial_stress_t`.
   pure function ellipse_stress_at(self, depth) result(stress)
      !> Field with its ellipse and Poisson's ratio.
      class(ellipse_stress_t), intent(in) :: self
      !> Depth on the axis [m], >= 0.
      real(dp), intent(in) :: depth
      real(dp) :: stress(3)

      stress = ellipse_axial_stress(self%contact, self%poisson_ratio, depth)
   end function ellipse_stress_at

   !> See `axial_stress_t`.
   pure function line_stress_at(self, depth) result(stress)
      !> Field with its Poisson's ratio.
      class(line_stress_t), intent(in) :: self
      !> Depth on the axis, in half-widths [-], >= 0.
      real(dp), intent(in) :: depth
      real(dp) :: stress(3)

      stress = hertz_strip_stress(1.0_dp, 0.0_dp, 0.0_dp, depth)
      stress(3) = stress(1)
      if (is_set(self%poisson_ratio)) stress(3) = self%poisson_ratio*(stress(1) + stress(2))
   end function line_stress_at

end module adfric_classical_hertz_unit
