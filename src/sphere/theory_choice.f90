!> Which theory a point needs, and its contact.
!>
!> `auto` takes DMT or JKR where inequalities (see `theory_bounds`) prove that it is within the tolerance of
!> Maugis-Dugdale, and Maugis-Dugdale otherwise.
module adfric_sphere_theory_choice
   use adfric_base_kinds, only: dp
   use adfric_sphere_contact, only: contact_t, theory_t, theory_hertz, theory_jkr, theory_dmt, theory_maugis_dugdale, &
      & control_load, control_approach, branch_stable, find_contact
   use adfric_sphere_dmt, only: dmt_t
   use adfric_sphere_dugdale_curve, only: point_t, get_point, get_disc
   use adfric_sphere_hertz, only: hertz_t
   use adfric_sphere_jkr, only: jkr_t
   use adfric_sphere_maugis_dugdale, only: maugis_t
   use adfric_sphere_theory_bounds, only: get_theory_bounds
   implicit none (type, external)
   private
   public :: new_theory, choose_theory, get_mismatch

   !> Relative errors are those of the larger of a value and this.
   real(dp), parameter :: least_value = 0.1_dp
   !> What a term of an equation may be wrong by.
   real(dp), parameter :: round_off = 2*epsilon(1.0_dp)

contains

   !> A theory by its number, for X = 1.
   subroutine new_theory(theory, number, lambda)
      class(theory_t), allocatable, intent(out) :: theory
      !> One of `theory_...`.
      integer, intent(in) :: number
      !> Used by Maugis-Dugdale only, > 0.
      real(dp), intent(in) :: lambda

      select case (number)
      case (theory_hertz)
         allocate (hertz_t :: theory)
      case (theory_jkr)
         allocate (jkr_t :: theory)
      case (theory_dmt)
         allocate (dmt_t :: theory)
      case default
         allocate (theory, source=maugis_t(lambda=lambda))
      end select
   end subroutine new_theory

   !> The simplest theory that is proved to be within a tolerance.
   pure subroutine choose_theory(lambda, ratio, control, value, branch, needs_edge, tolerance, number, error)
      real(dp), intent(in) :: lambda, ratio
      integer, intent(in) :: control
      real(dp), intent(in) :: value
      integer, intent(in) :: branch
      !> Is the radius c of adhesion needed, too? Then DMT will not do.
      logical, intent(in) :: needs_edge
      !> Relative, of radii, load and approach.
      real(dp), intent(in) :: tolerance
      !> One of `theory_...`.
      integer, intent(out) :: number
      !> What is proved; 0 for Maugis-Dugdale.
      real(dp), intent(out) :: error
      type(jkr_t) :: jkr
      type(dmt_t) :: dmt

      number = theory_maugis_dugdale
      error = 0
      if (branch /= branch_stable .or. .not. ratio > 0 .or. (lambda < 1 .and. needs_edge)) return
      if (lambda < 1) then
         dmt%ratio = ratio
         call prove(dmt, theory_dmt, lambda, control, value, .false., error)
         number = theory_dmt
      else
         jkr%ratio = ratio
         call prove(jkr, theory_jkr, lambda, control, value, needs_edge, error)
         number = theory_jkr
      end if
      if (error <= tolerance) return
      number = theory_maugis_dugdale
      error = 0
   end subroutine choose_theory

   !> Bound of the relative error of radius, load and approach; huge where there is none.
   pure subroutine prove(theory, number, lambda, control, value, needs_edge, error)
      class(theory_t), intent(in) :: theory
      integer, intent(in) :: number
      real(dp), intent(in) :: lambda
      integer, intent(in) :: control
      real(dp), intent(in) :: value
      logical, intent(in) :: needs_edge
      real(dp), intent(out) :: error
      type(contact_t) :: contact, low, high
      real(dp) :: load, approach, edge, spread, load_slope, approach_slope

      error = huge(1.0_dp)
      call find_contact(theory, control, value, branch_stable, contact)
      if (.not. (contact%is_found .and. contact%is_stable .and. contact%radius > 0)) return
      call get_theory_bounds(number, lambda, theory%ratio, contact%radius, load, approach, edge)
      if (.not. max(load, approach) < 1) return
      if (.not. needs_edge) edge = 0
      spread = 0
      if (control == control_load .or. control == control_approach) then
         ! twice what the slope says is an interval of the radius; its ends must lie on either side for certain
         call get_slopes(number, theory%ratio, contact%radius, load_slope, approach_slope)
         if (control == control_load) then
            if (.not. 2*load < 0.5_dp*contact%radius*load_slope) return
            spread = 2*load/(contact%radius*load_slope)
         else
            if (.not. 2*approach < 0.5_dp*contact%radius*approach_slope) return
            spread = 2*approach/(contact%radius*approach_slope)
         end if
         if (.not. spread > 0) return
         call theory%of_radius(contact%radius*(1 - spread), low)
         call theory%of_radius(contact%radius*(1 + spread), high)
         if (.not. (lies_beyond(low, -1) .and. lies_beyond(high, 1))) return
         load = load + load_slope*contact%radius*spread
         approach = approach + abs(approach_slope)*contact%radius*spread
         if (control == control_load) load = 0
         if (control == control_approach) approach = 0
      end if
      ! relative to the least that the values of Maugis-Dugdale can be
      error = max(spread/(1 - spread) + 2*edge, load/max(abs(contact%load) - load, least_value), &
         & approach/max(abs(contact%approach) - approach, least_value))

   contains

      !> Is the value of Maugis-Dugdale at the radius of a contact beyond what is held, however wrong the theory is?
      pure logical function lies_beyond(other, side)
         type(contact_t), intent(in) :: other
         !> 1: above, -1: below.
         integer, intent(in) :: side
         real(dp) :: bounds(2)

         call get_theory_bounds(number, lambda, theory%ratio, other%radius, bounds(1), bounds(2))
         if (control == control_load) then
            lies_beyond = side*(other%load - value) >= bounds(1)
         else
            lies_beyond = side*(other%approach - value) >= bounds(2)
         end if
      end function lies_beyond

   end subroutine prove

   !> How well a contact is known: how far it is from fulfilling the equations of its theory at the place where it was found,
   !> and what the round-off of what is held does to the place. The largest relative error of radius, load and approach.
   pure real(dp) function get_mismatch(theory, number, control, contact) result(mismatch)
      class(theory_t), intent(in) :: theory
      !> One of `theory_...`, and of `control_...`.
      integer, intent(in) :: number, control
      type(contact_t), intent(in) :: contact
      type(contact_t) :: again
      type(point_t) :: point
      real(dp), dimension(3) :: values, others, terms, slopes, sizes
      real(dp) :: shift
      integer :: held

      again = contact_t()
      slopes = 0
      select type (theory)
      type is (maugis_t)
         if (contact%radius > 0) then
            call get_point(theory%lambda, theory%ratio, contact%place, point)
            again%radius = point%radius
            again%load = point%load
            again%approach = point%approach
            slopes = [point%radius_slope, point%load_slope, point%approach_slope]
         else
            call get_disc(theory%lambda, theory%ratio, contact%adhesion_radius, again%load, again%approach)
         end if
      class default
         call theory%of_radius(contact%radius, again)
         if (contact%radius > 0) then
            call get_slopes(number, theory%ratio, contact%radius, slopes(2), slopes(3))
            slopes = [1.0_dp, slopes(2:3)]*contact%radius
         end if
      end select
      values = [contact%radius, contact%load, contact%approach]
      others = [again%radius, again%load, again%approach]
      sizes = max(abs(values), [tiny(mismatch), least_value, least_value])
      ! load and approach are differences of these
      terms = [contact%radius, contact%radius**3 + abs(contact%load - contact%radius**3), &
         & contact%radius**2 + abs(contact%approach - contact%radius**2)]
      held = 1
      if (control == control_load) held = 2
      if (control == control_approach) held = 3
      ! at the end of stability what is held has no slope, and the place is known to the root of its round-off
      shift = sqrt(round_off)
      if (round_off*terms(held) < shift*abs(slopes(held))) shift = round_off*terms(held)/abs(slopes(held))
      mismatch = maxval((abs(others - values) + abs(slopes)*shift + round_off*terms)/sizes)
   end function get_mismatch

   !> Changes of load and approach with the radius.
   pure subroutine get_slopes(number, ratio, radius, load_slope, approach_slope)
      integer, intent(in) :: number
      real(dp), intent(in) :: ratio, radius
      real(dp), intent(out) :: load_slope, approach_slope

      load_slope = 3*radius**2
      approach_slope = 2*radius
      if (number /= theory_jkr) return
      load_slope = load_slope - 1.5_dp*sqrt(6*ratio*radius)
      approach_slope = approach_slope - sqrt(6*ratio/radius)/3
   end subroutine get_slopes

end module adfric_sphere_theory_choice
