! SPDX-License-Identifier: GPL-3.0-or-later
!> A rigid wave h = D cos kx that slides steadily to +x over a viscoelastic half-plane without friction, in closed form for any
!> relaxation spectrum.
!>
!> Reduced: lengths along the wave in 1/k, heights and displacements in D, pressures in p* = k D E0/2, the mean pressure of full
!> contact at rest, and tangential stresses in k D p*. h and u are positive into the solid. One contact of half-width w stands at
!> m - w < x < m + w. Its width is free, and everything else follows: `sliding_means` gives the means rho_i, nu_i of the contact
!> and rho'_j of the gap, `sliding_shift` the shift m, and, with s = sin(w/2), C = cos(w/2) and S = sum_j eta_j (b_j + 1/b_j)
!> rho'_j,
!>
!>     c = cos m + sum_j eta_j b_j,    q = s^2 c + 2 S,    penetration = 1 - C^2 c - q ln s^2 = 1 - (C^2 + s^2 ln s^2) cos m + Z
!>     Z = -2 ln s^2 sum_j eta_j [rho'_j/b_j + b_j (rho'_j - C^2 mu)]
!>     T = sum_i [e_i/(a_i + 1/a_i)] {s^2 (s^2 + 2 C^2 nu_i)/2
!>         + 2 C^2 sin m (rho_i sin m + G_i) + 2 C^2 cos m rho_i (a_i sin m + (1 + a_i^2) sigma_i)}
!>
!> with sigma_i, G_i the `slopes` and `edge_pressures` of the shift. For one arm all terms are positive:
!>
!>     tan m = (b - a)/[(1 + a b) + (a/rho) (b + 1/b) rho']
!>
!> The solution of the contact problem is unique for each mean pressure and each penetration below full contact, and it determines
!> w. So both change with w monotonically, and the search of w has one root.
module adfric_plane_sliding_wave
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_numerics_secant_root, only: rising_equation_t, find_rising_root
   use adfric_plane_sliding_solid, only: sliding_solid_t
   use adfric_plane_sliding_means, only: arc_t, get_contact_means, get_gap_means, logarithm_of_sine, elastic_mean_gap
   use adfric_plane_sliding_shift, only: sliding_shift_t, find_shift
   use adfric_plane_westergaard, only: find_wave_pressure
   implicit none (type, external)
   private
   public :: wave_contact_t, get_full_contact, wave_of_width, wave_of_pressure, wave_of_penetration

   !> Bounds of x = ln tan(w/2).
   real(dp), parameter :: least_logarithm = -300.0_dp, largest_logarithm = 40.0_dp
   !> Mean pressure and penetration that make no contact.
   real(dp), parameter :: least_amount = 1.0e-250_dp
   !> What a logarithm of two equal pressures, or penetrations, may be.
   real(dp), parameter :: round_off = 4*epsilon(1.0_dp)

   !> A contact.
   type :: wave_contact_t
      !> Is the whole wave in contact? Then the shift is the one of the pressure, the phase of the modulus.
      logical :: is_full = .false.
      !> Half-width w of the contact [1/k], 0 to pi.
      real(dp) :: half_width = 0
      !> sin(w/2) and cos(w/2).
      real(dp) :: sine = 0, cosine = 1
      !> Mean pressure q [p*], >= 0.
      real(dp) :: mean_pressure = 0
      !> How far the mean planes have approached since first touch [D], 0 to 1, and the mean gap, which is the rest to 1.
      real(dp) :: penetration = 0, mean_gap = 1
      !> Tangential stress T against the motion, resistance per area [k D p*], >= 0.
      real(dp) :: friction = 0
      !> The factor c of the mean pressure.
      real(dp) :: stiffness = 1
      !> Shift m and sums over the arms.
      type(sliding_shift_t) :: shift
      !> Means rho_i and nu_i of the contact; shape `(n)`.
      real(dp), allocatable :: rho(:), nu(:)
      !> Means rho'_j of the gap; shape `(n)`.
      real(dp), allocatable :: gap_rho(:)
   end type wave_contact_t

   !> Logarithm of mean pressure or penetration over the one that is wanted, which rises with x = ln tan(w/2).
   type, extends(rising_equation_t) :: width_equation_t
      !> The solid.
      type(sliding_solid_t) :: solid
      !> What is wanted: a mean pressure [p*], or a penetration, or the mean gap [D].
      real(dp) :: wanted = 1
      !> Which of these: 1, 2 or 3.
      integer :: quantity = 1
   contains
      procedure :: evaluate
   end type width_equation_t

contains

   !> Full contact: p = q + |E| cos(x - d), tan d = E''/E', which is there from the mean pressure |E| on.
   pure subroutine get_full_contact(solid, contact)
      !> The solid, with lengths in 1/k.
      type(sliding_solid_t), intent(in) :: solid
      !> The contact at the least mean pressure that closes the gap.
      type(wave_contact_t), intent(out) :: contact
      real(dp) :: storage, loss

      call solid%get_complex_ratio(storage, loss)
      contact%is_full = .true.
      contact%half_width = pi
      contact%sine = 1
      contact%cosine = 0
      contact%mean_pressure = hypot(storage, loss)
      contact%penetration = 1
      contact%mean_gap = 0
      contact%friction = loss/2
      contact%stiffness = contact%mean_pressure
      contact%shift%shift = atan2(loss, storage)
   end subroutine get_full_contact

   !> The contact of a given width.
   pure subroutine wave_of_width(solid, x, contact, is_converged)
      !> The solid, with lengths in 1/k.
      type(sliding_solid_t), intent(in) :: solid
      !> ln tan(w/2), any number from -300 to 40.
      real(dp), intent(in) :: x
      type(wave_contact_t), intent(out) :: contact
      !> Have all sums come to rest, and is the system solved?
      logical, intent(out) :: is_converged
      type(arc_t) :: arc, gap
      real(dp) :: excess(solid%n_arms)
      logical :: has_contact_means, has_gap_means
      integer :: i, n

      n = solid%n_arms
      call get_arcs(x, arc, gap)
      allocate (contact%rho(n), contact%nu(n), contact%gap_rho(n))
      is_converged = .true.
      do i = 1, n
         call get_contact_means(arc, solid%relaxation(i), contact%rho(i), contact%nu(i), has_contact_means)
         call get_gap_means(gap, solid%retardation(i), contact%gap_rho(i), excess(i), has_gap_means)
         is_converged = is_converged .and. has_contact_means .and. has_gap_means
      end do
      if (is_converged) call find_shift(solid, 1.0_dp, contact%rho, contact%gap_rho, contact%shift, is_converged)
      if (.not. is_converged) return
      contact%half_width = arc%half_width
      contact%sine = arc%sine
      contact%cosine = arc%cosine
      call complete(solid, gap, excess, contact)
   end subroutine wave_of_width

   !> Contact and gap of a given width.
   pure subroutine get_arcs(x, arc, gap)
      !> ln tan(w/2).
      real(dp), intent(in) :: x
      type(arc_t), intent(out) :: arc, gap
      real(dp) :: tangent

      if (has_asserts) call assert(abs(x) <= max(-least_logarithm, largest_logarithm), 'get_arcs: |x| <= 300')
      tangent = exp(-abs(x))
      arc = arc_t(2*atan(tangent), tangent/hypot(1.0_dp, tangent), 1/hypot(1.0_dp, tangent))
      gap = arc_t(pi - arc%half_width, arc%cosine, arc%sine)
      if (x > 0) call exchange(arc, gap)
   end subroutine get_arcs

   !> Exchange two arcs.
   pure subroutine exchange(first, second)
      type(arc_t), intent(inout) :: first, second
      type(arc_t) :: third

      third = first
      first = second
      second = third
   end subroutine exchange

   !> Mean pressure, penetration and friction of a contact whose shift is known.
   pure subroutine complete(solid, gap, excess, contact)
      type(sliding_solid_t), intent(in) :: solid
      type(arc_t), intent(in) :: gap
      !> Excess of the means over the gap; shape `(n)`.
      real(dp), intent(in) :: excess(:)
      type(wave_contact_t), intent(inout) :: contact
      real(dp) :: open_part, closed_part, raise

      open_part = contact%cosine**2
      closed_part = contact%sine**2
      associate (shift => contact%shift, c => contact%stiffness)
         c = shift%cosine + shift%stiffening
         contact%mean_pressure = closed_part*c + 2*shift%edge_load
         raise = 2*logarithm_of_sine(gap)*sum(shift%shares*(contact%gap_rho/solid%retardation + solid%retardation*excess))
         if (closed_part < 0.5_dp) then
            contact%penetration = closed_part*(1 + logarithm_of_sine(gap))*shift%cosine + shift%sine**2/(1 + shift%cosine) + raise
            contact%mean_gap = 1 - contact%penetration
         else
            contact%mean_gap = elastic_mean_gap(gap)*shift%cosine - raise
            contact%penetration = 1 - contact%mean_gap
         end if
         contact%friction = sum(solid%ratios/(solid%relaxation + 1/solid%relaxation) &
            & *(closed_part*(closed_part + 2*open_part*contact%nu)/2 &
            & + 2*open_part*shift%sine*(contact%rho*shift%sine + shift%edge_pressures) &
            & + 2*open_part*shift%cosine*contact%rho*(solid%relaxation*shift%sine + (1 + solid%relaxation**2)*shift%slopes)))
      end associate
   end subroutine complete

   !> The contact under a mean pressure.
   pure subroutine wave_of_pressure(solid, q, contact, is_converged)
      !> The solid, with lengths in 1/k.
      type(sliding_solid_t), intent(in) :: solid
      !> Mean pressure [p*], >= 0; below 1e-250 there is no contact.
      real(dp), intent(in) :: q
      type(wave_contact_t), intent(out) :: contact
      logical, intent(out) :: is_converged
      type(width_equation_t) :: equation
      real(dp) :: full

      call get_full_contact(solid, contact)
      full = contact%mean_pressure
      is_converged = q >= full
      if (is_converged) contact%mean_pressure = q
      if (is_converged) return
      contact = wave_contact_t()
      is_converged = q >= 0 .and. q < least_amount
      if (is_converged .or. .not. q >= 0) return
      equation%solid = solid
      equation%wanted = q
      equation%quantity = 1
      call find_width(equation, q/full, 2*(1 - q/full), contact, is_converged)
   end subroutine wave_of_pressure

   !> The contact at a penetration. In full contact every mean pressure from a threshold on belongs to the penetration 1, and the
   !> least is given.
   pure subroutine wave_of_penetration(solid, penetration, contact, is_converged)
      !> The solid, with lengths in 1/k.
      type(sliding_solid_t), intent(in) :: solid
      !> Approach of the mean planes since first touch [D]; no contact belongs to more than 1, and a negative one to none.
      real(dp), intent(in) :: penetration
      type(wave_contact_t), intent(out) :: contact
      logical, intent(out) :: is_converged
      type(width_equation_t) :: equation
      real(dp) :: q, gap

      is_converged = penetration <= 1
      if (penetration >= 1) call get_full_contact(solid, contact)
      if (is_converged .and. penetration < least_amount) contact%penetration = penetration
      if (is_converged .and. penetration < least_amount) contact%mean_gap = 1 - penetration
      if (.not. penetration < 1 .or. penetration < least_amount) return
      call find_wave_pressure(penetration, q, is_converged)
      if (.not. is_converged) return
      gap = 1 - penetration
      equation%solid = solid
      equation%quantity = merge(2, 3, penetration < 0.5_dp)
      equation%wanted = merge(penetration, gap, penetration < 0.5_dp)
      call find_width(equation, q, -2*q*(1 - q)*log(q)/equation%wanted, contact, is_converged)
   end subroutine wave_of_penetration

   !> Find the width, and the contact that has it.
   pure subroutine find_width(equation, closed_part, slope, contact, is_converged)
      type(width_equation_t), intent(in) :: equation
      !> A guess of sin^2(w/2), 0 to 1.
      real(dp), intent(in) :: closed_part
      !> A guess of the slope of the equation.
      real(dp), intent(in) :: slope
      type(wave_contact_t), intent(out) :: contact
      logical, intent(out) :: is_converged
      real(dp) :: x

      x = 0.5_dp*log(closed_part/max(1 - closed_part, tiny(x)))
      call find_rising_root(equation, least_logarithm, largest_logarithm, slope, round_off, x, is_converged)
      if (is_converged) call wave_of_width(equation%solid, x, contact, is_converged)
   end subroutine find_width

   !> See `rising_equation_t`.
   pure subroutine evaluate(self, x, value)
      class(width_equation_t), intent(in) :: self
      !> ln tan(w/2).
      real(dp), intent(in) :: x
      !> Logarithm of what is found over what is wanted; the other way round for the mean gap. NaN if there is no solution.
      real(dp), intent(out) :: value
      type(wave_contact_t) :: contact
      logical :: is_converged

      call wave_of_width(self%solid, x, contact, is_converged)
      value = not_a_number()
      if (.not. is_converged) return
      select case (self%quantity)
      case (1)
         value = log(contact%mean_pressure/self%wanted)
      case (2)
         value = log(contact%penetration/self%wanted)
      case default
         value = log(self%wanted/contact%mean_gap)
      end select
   end subroutine evaluate

end module adfric_plane_sliding_wave
