! SPDX-License-Identifier: GPL-3.0-or-later
!> Stick-slip of a contact that is pulled through a spring: its base moves by x, T = k (x - D), and T(D) is that of the contact at rest.
!>
!> States are stable where h = D + T/k rises along the path, so x is the running maximum of h: the contact creeps along its path up
!> to a maximum of h, and jumps to the next position where h is as large, or beyond all of them to sliding at the force T_s. In a
!> jump the spring gives more than the contact takes on its path, by
!>
!>     E = k int (x - h) dD + k (x - h_s)^2/2,    h_s = D_s + T_s/k at the onset of sliding, D_s the displacement there.
!>
!> Motion ends there (damping takes E), and rest restores adhesion: the contact goes on as one that has been loaded to T_s from rest.
!> So the base moves by x - h(T_s) from one jump to the next, and its work is int T dh, which is what the contact takes and E.
!>
!> A jump ends in sliding where some h on the path is above h_s, that is for
!>
!>     k < max (T - T_s)/(D_s - D)
!>
!> whose right side is found by Dinkelbach's procedure for the largest of ratios: the position of the largest T + k D gives the next
!> k, which never falls. There T - T_s - k (D_s - D) > 0 as long as k is too small, for it is at the position of the largest ratio.
module adfric_round_stick_slip
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_round_pulled_contact, only: pulled_curve_t, pulled_spot_t, displacement_at, extension_at, first_fall, first_reach, &
      & force_at, work_between
   implicit none (type, external)
   private
   public :: stick_slip_t, find_stick_slip, find_critical_stiffness, forget_stick_slip

   !> A drop of the force of this size, relative to it, is round-off.
   real(dp), parameter :: round_off = 1.0e-13_dp
   !> Most jumps before sliding, and most steps of Dinkelbach's iteration.
   integer, parameter :: most_jumps = 20, most_steps = 60

   !> A jump.
   type :: jump_t
      !> Where it begins and, if that is on the path, ends.
      type(pulled_spot_t) :: onset, landing
      !> Force after it, and its energy.
      real(dp) :: arrest_force = 0, energy = 0
   end type jump_t

   !> What happens; NaN where there is nothing of the kind.
   type :: stick_slip_t
      !> Displacement of the base, D and T at the onset of the last jump, T after it.
      real(dp) :: base_displacement = 0, displacement = 0, force = 0, arrest_force = 0
      !> What it takes.
      real(dp) :: energy = 0
      !> Motion of the base from one jump to the next, and its work.
      real(dp) :: period = 0, work = 0
      !> Does the last jump end in sliding? Is contact lost in it?
      logical :: slides = .false., is_lost = .false.
      !> Number of jumps.
      integer :: n_jumps = 0
   end type stick_slip_t

contains

   !> The jumps of a pulled contact.
   pure subroutine find_stick_slip(curve, stiffness, found)
      type(pulled_curve_t), intent(in) :: curve
      !> k > 0.
      real(dp), intent(in) :: stiffness
      !> Receives what happens; of several jumps, the last one.
      type(stick_slip_t), intent(out) :: found
      type(jump_t) :: jumps(most_jumps)
      integer :: n
      logical :: slides

      call forget_stick_slip(found)
      call list_jumps(curve, stiffness, jumps, n, slides)
      found%n_jumps = n
      if (n == 0) return
      associate (jump => jumps(n))
         found%base_displacement = extension_at(curve, 1.0_dp, 1/stiffness, jump%onset)
         found%displacement = displacement_at(curve, jump%onset)
         found%force = force_at(curve, jump%onset)
         found%arrest_force = jump%arrest_force
         found%energy = jump%energy
      end associate
      found%slides = slides .and. curve%slides
      found%is_lost = slides .and. .not. curve%slides
      if (found%slides) call add_period(curve, stiffness, jumps(:n), found)
   end subroutine find_stick_slip

   !> Nothing happens.
   pure subroutine forget_stick_slip(found)
      type(stick_slip_t), intent(inout) :: found
      real(dp) :: none

      none = not_a_number()
      found%base_displacement = none
      found%displacement = none
      found%force = none
      found%arrest_force = none
      found%energy = none
      found%period = none
      found%work = none
   end subroutine forget_stick_slip

   !> The jumps as the base moves on from rest.
   pure subroutine list_jumps(curve, stiffness, jumps, n, slides)
      type(pulled_curve_t), intent(in) :: curve
      !> k.
      real(dp), intent(in) :: stiffness
      type(jump_t), intent(out) :: jumps(most_jumps)
      integer, intent(out) :: n
      !> Does the last one leave the path?
      logical, intent(out) :: slides
      type(pulled_spot_t) :: spot
      logical :: falls, lands

      n = 0
      slides = .false.
      spot = pulled_spot_t(1, -1.0_dp)
      do while (n < most_jumps)
         call first_fall(curve, 1.0_dp, 1/stiffness, (spot), spot, falls)
         if (.not. (falls .or. drops(curve))) return
         n = n + 1
         jumps(n)%onset = spot
         lands = .false.
         if (falls) call first_reach(curve, 1.0_dp, 1/stiffness, extension_at(curve, 1.0_dp, 1/stiffness, spot), spot, &
            & jumps(n)%landing, lands)
         if (.not. lands) exit
         jumps(n)%arrest_force = force_at(curve, jumps(n)%landing)
         jumps(n)%energy = stiffness*work_between(curve, extension_at(curve, 1.0_dp, 1/stiffness, spot), 1.0_dp, 1/stiffness, &
            & spot, jumps(n)%landing)
         spot = jumps(n)%landing
      end do
      if (n > 0) call leave_path(curve, stiffness, jumps(n), slides)
   end subroutine list_jumps

   !> Does the force fall at the onset of sliding?
   pure logical function drops(curve)
      type(pulled_curve_t), intent(in) :: curve

      drops = curve%last_force - curve%force_after > round_off*curve%last_force
   end function drops

   !> A jump beyond the end of the path. Where sliding needs more force than the end has, it may be short of that.
   pure subroutine leave_path(curve, stiffness, jump, slides)
      type(pulled_curve_t), intent(in) :: curve
      real(dp), intent(in) :: stiffness
      !> In: its onset. Out: with force and energy.
      type(jump_t), intent(inout) :: jump
      !> Does it come to sliding, or lose contact?
      logical, intent(out) :: slides
      real(dp) :: prescribed, excess

      prescribed = extension_at(curve, 1.0_dp, 1/stiffness, jump%onset)
      jump%energy = stiffness*work_between(curve, prescribed, 1.0_dp, 1/stiffness, jump%onset, pulled_spot_t(size(curve%panels), &
         & 1.0_dp))
      ! differences first, or a stiff spring would leave no digits
      excess = (displacement_at(curve, jump%onset) - curve%last_displacement) &
         & + (force_at(curve, jump%onset) - curve%force_after)/stiffness
      slides = excess > 0
      jump%arrest_force = curve%force_after
      if (slides) then
         jump%energy = jump%energy + stiffness*excess**2/2
      else
         jump%arrest_force = stiffness*(prescribed - curve%last_displacement)
      end if
   end subroutine leave_path

   !> From one jump to the next.
   pure subroutine add_period(curve, stiffness, jumps, found)
      type(pulled_curve_t), intent(in) :: curve
      real(dp), intent(in) :: stiffness
      !> The jumps from rest; the last one ends in sliding.
      type(jump_t), intent(in) :: jumps(:)
      !> In: the last jump. Out: with period, work, and the energy of all jumps of a period.
      type(stick_slip_t), intent(inout) :: found
      type(pulled_spot_t) :: arrest, from
      real(dp) :: force, last
      integer :: k
      logical :: is_reached

      ! T rises from 0, and is above the force of sliding at the onset of a jump that ends there
      call first_reach(curve, 0.0_dp, 1.0_dp, curve%force_after, pulled_spot_t(1, -1.0_dp), arrest, is_reached)
      found%slides = is_reached
      if (.not. is_reached) return
      found%period = found%base_displacement - (displacement_at(curve, arrest) + curve%force_after/stiffness)
      found%work = 0
      found%energy = 0
      from = arrest
      force = curve%force_after
      do k = 1, size(jumps)
         if (is_before(jumps(k)%onset, arrest)) cycle
         ! int T dD, and T dT/k
         last = force_at(curve, jumps(k)%onset)
         found%work = found%work - work_between(curve, 0.0_dp, 0.0_dp, 1.0_dp, from, jumps(k)%onset)
         found%work = found%work + (last - force)*(last + force)/(2*stiffness)
         found%energy = found%energy + jumps(k)%energy
         from = jumps(k)%landing
         force = jumps(k)%arrest_force
      end do
   end subroutine add_period

   !> Does a position come before another one?
   pure logical function is_before(one, other)
      type(pulled_spot_t), intent(in) :: one, other

      is_before = one%panel < other%panel .or. (one%panel == other%panel .and. one%x < other%x)
   end function is_before

   !> The stiffness from which on there is no stick-slip: 0 where there never is; NaN where each stiffness has it, or loses contact.
   pure subroutine find_critical_stiffness(curve, stiffness)
      type(pulled_curve_t), intent(in) :: curve
      real(dp), intent(out) :: stiffness
      type(pulled_spot_t) :: top
      real(dp) :: next
      integer :: k

      stiffness = not_a_number()
      if (.not. curve%slides .or. drops(curve)) return
      ! under a rigid drive D itself is the running maximum
      call find_top(curve, 1.0_dp, 0.0_dp, top)
      if (displacement_at(curve, top) - curve%last_displacement > round_off*curve%last_displacement) return
      call find_top(curve, 0.0_dp, 1.0_dp, top)
      stiffness = 0
      do k = 1, most_steps
         if (.not. force_at(curve, top) - curve%force_after > round_off*curve%force_after) return
         if (.not. curve%last_displacement > displacement_at(curve, top)) return
         next = (force_at(curve, top) - curve%force_after)/(curve%last_displacement - displacement_at(curve, top))
         if (.not. next > stiffness*(1 + 4*epsilon(next))) return
         stiffness = next
         call find_top(curve, stiffness, 1.0_dp, top)
      end do
   end subroutine find_critical_stiffness

   !> The position of the largest p D + q T.
   pure subroutine find_top(curve, p, q, top)
      type(pulled_curve_t), intent(in) :: curve
      !> Weights.
      real(dp), intent(in) :: p, q
      type(pulled_spot_t), intent(out) :: top
      type(pulled_spot_t) :: spot
      logical :: falls

      spot = pulled_spot_t(1, -1.0_dp)
      top = pulled_spot_t(size(curve%panels), 1.0_dp)
      do
         call first_fall(curve, p, q, (spot), spot, falls)
         if (.not. falls) return
         if (extension_at(curve, p, q, spot) >= extension_at(curve, p, q, top)) top = spot
         call first_reach(curve, p, q, extension_at(curve, p, q, top), (spot), spot, falls)
         if (.not. falls) return
      end do
   end subroutine find_top

end module adfric_round_stick_slip
