! SPDX-License-Identifier: GPL-3.0-or-later
!> Energies of a state of contact, reduced, in units E* L H^2.
!>
!> The elastic one is that of the springs of depth coordinate g, U = int [delta - g(x)]^2 dx over 0 < x < a, and of Maugis's stress S beside
!> the contact V = int (2 S)^2 (c^2 - x^2) dx over a < x < c. By the theorem of Clapeyron twice of it is the work of the pressure on the
!> displacement delta - f + gap, so the gap that the stress has closed follows without an integral over the gap:
!>
!>     E = U - V + 4 S {K + D [c^2 th - a s]/2} - pi S h c^2,    D = g(a) - delta,    K of `adfric_round_annulus`
!>
!> is the energy with that of adhesion, 0 when the bodies are apart, and E = U - pi W a^2 in JKR. dE = P ddelta along a curve.
module adfric_round_energy
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_round_annulus, only: get_annulus
   use adfric_round_contact_state, only: contact_t
   use adfric_round_curve, only: curve_t
   use adfric_round_dugdale_curve, only: dugdale_curve_t
   implicit none (type, external)
   private
   public :: elastic_energy, adhesive_energy

contains

   !> Elastic energy of a state.
   pure real(dp) function elastic_energy(curve, contact) result(energy)
      class(curve_t), intent(in) :: curve
      type(contact_t), intent(in) :: contact

      energy = inner_energy(curve, contact) + outer_energy(contact)
   end function elastic_energy

   !> Energy of a state with that of adhesion, less that of the bodies apart. That of DMT, whose pull outside the contact ends nowhere,
   !> is NaN.
   pure real(dp) function adhesive_energy(curve, contact) result(energy)
      class(curve_t), intent(in) :: curve
      type(contact_t), intent(in) :: contact
      real(dp) :: opening, intensity, moment, s, lift

      energy = inner_energy(curve, contact)
      if (abs(curve%outer_pull) > 0) energy = not_a_number()
      select type (curve)
      type is (dugdale_curve_t)
         associate (a => contact%spot%radius, c => contact%adhesion_radius, pull => curve%stress)
            s = contact%neck/(2*pull)
            moment = 0
            if (curve%shape%n_pieces > 0) call get_annulus(curve%shape, contact%spot, contact%is_beyond, s, opening, intensity, &
               & moment)
            ! D of a contact is 2 S s; bodies that do not touch have any
            lift = contact%neck
            if (.not. a > 0) lift = -contact%approach
            energy = energy - outer_energy(contact) + 4*pull*(moment + lift*(c**2*atan2(s, a) - a*s)/2) &
               & - pi*pull*curve%range*c**2
         end associate
      class default
         energy = energy - (curve%tension*contact%spot%radius)**2/2
      end select
   end function adhesive_energy

   !> U, of the springs within the contact.
   pure real(dp) function inner_energy(curve, contact) result(energy)
      class(curve_t), intent(in) :: curve
      type(contact_t), intent(in) :: contact

      energy = 0
      if (.not. contact%spot%radius > 0) return
      energy = curve%shape%energy(contact%u, contact%is_beyond) &
         & + contact%neck*(contact%neck*contact%spot%radius - contact%spot%load)
   end function inner_energy

   !> V, of the stress beside the contact.
   pure real(dp) function outer_energy(contact) result(energy)
      type(contact_t), intent(in) :: contact

      energy = 0
      if (.not. contact%stress > 0) return
      associate (a => contact%spot%radius, c => contact%adhesion_radius)
         ! 4 S^2 (c - a)^2 (2 c + a)/3, c - a = s^2/(c + a), s = D/(2 S)
         energy = (contact%neck**2/(2*contact%stress*(c + a)))**2*(2*c + a)/3
      end associate
   end function outer_energy

end module adfric_round_energy
