! SPDX-License-Identifier: GPL-3.0-or-later
!> A row of viscoelastic springs that an indenter touches: the solid, what is prescribed, and the state at an instant.
!>
!> The half-space of a solid of relaxed modulus E0, moduli E_i and relaxation times t_i is a row of springs, each with the force
!> \( y = E_0 \theta + \sum_i E_i q_i \), where \( \dot q_i = \dot\theta - q_i/t_i \). In contact \( \theta = \delta - G \), with the
!> depth G = g(x) of the indenter (`shape`); free springs have y = 0. The contact is x < a(t) always (`docs/theory`), so the
!> state is known by the edge, D_i = int exp(-(t - s)/t_i) d delta(s), Q_i = int q_i dx over the contact, and two piles.
module adfric_round_timed_springs
   use adfric_base_kinds, only: dp
   use adfric_solid_prony, only: prony_t
   use adfric_solid_retardation, only: retardation_t, new_retardation
   use adfric_interface_normal_contact, only: normal_contact_t
   use adfric_round_timed_path, only: mark_t, timed_control_t, timed_leg_t
   use adfric_round_timed_pile, only: new_pile, timed_pile_t
   implicit none (type, external)
   private
   public :: timed_springs_t, new_timed_springs, get_spot, free_memory, lost, growing, growing_again, shrinking
   public :: mark_of, thin_depth

   !> What the edge does: there is no contact; it grows over springs that were never touched, or over some that were; it shrinks.
   integer, parameter :: lost = 0, growing = 1, growing_again = 2, shrinking = 3

   !> The springs at an instant, with all that they depend on.
   type :: timed_springs_t
      !> Relaxed and instantaneous modulus.
      real(dp) :: relaxed = 1, glassy = 1
      !> Moduli and relaxation times of the arms; shape `(n_arms)`.
      real(dp), allocatable :: moduli(:), times(:)
      !> Free springs: c_k = sum of `modes(k, i)` z_i with z_i = theta - q_i, and q_i = sum of `states(i, k)` c_k.
      real(dp), allocatable :: modes(:, :), states(:, :)
      !> Contacts of the indenter with an elastic half-space of modulus 1.
      class(normal_contact_t), allocatable :: contacts
      !> What is prescribed.
      type(timed_control_t) :: control
      !> Its legs; shape `(n_legs)`.
      type(timed_leg_t), allocatable :: legs(:)
      !> What counts as small, as a share of the following sizes of depths and loads.
      real(dp) :: tolerance = 1.0e-10_dp, depth_size = 1, load_size = 1
      !> Least modulus that the solid has along the path, over the instantaneous one.
      real(dp) :: softness = 1
      !> Leg.
      integer :: leg = 1
      !> Phase of the leg, and what its rounding left.
      real(dp) :: phase = 0, phase_rest = 0
      !> One of `lost`, `growing`, `growing_again`, `shrinking`.
      integer :: edge_mode = lost
      !> Depth below which springs left contact all at once, as good as 0, and the radius of these.
      real(dp) :: lost_depth = 0, lost_radius = 0
      !> delta, G(a), a and P.
      real(dp) :: approach = 0, depth = 0, radius = 0, load = 0
      !> D_i, Q_i and q_i at the edge; shape `(n_arms)`.
      real(dp), allocatable :: drive(:), sums(:), at_edge(:)
      !> Springs in contact, and free ones.
      type(timed_pile_t) :: touched, free
   end type timed_springs_t

contains

   !> Springs that were never touched.
   pure subroutine new_timed_springs(self, prony, contacts, control, legs)
      !> Receives the springs.
      type(timed_springs_t), intent(out) :: self
      !> The solid; its relaxed modulus is above 0.
      type(prony_t), intent(in) :: prony
      !> Contacts of the indenter with an elastic half-space of modulus 1.
      class(normal_contact_t), intent(in) :: contacts
      !> What is prescribed.
      type(timed_control_t), intent(in) :: control
      !> Its legs; shape `(n_legs)`.
      type(timed_leg_t), intent(in) :: legs(:)
      type(retardation_t) :: retardation
      integer :: n, i, k

      call new_retardation(retardation, prony)
      n = size(prony%times)
      self%relaxed = prony%relaxed
      self%glassy = prony%instantaneous_modulus()
      self%moduli = prony%moduli
      self%times = prony%times
      self%contacts = contacts
      self%control = control
      self%legs = legs
      allocate (self%modes(n, n), self%states(n, n), self%drive(n), self%sums(n), self%at_edge(n))
      do k = 1, n
         do i = 1, n
            ! v = r/(r - t), c_k = sum E t v z/sum E t v^2, and q = (1 - v) c = -t/(r - t) c
            self%modes(k, i) = prony%moduli(i)*prony%times(i)/retardation%distances(i, k)
            self%states(i, k) = -prony%times(i)/retardation%distances(i, k)
         end do
         self%modes(k, :) = self%modes(k, :)/(retardation%times(k)*sum(prony%moduli*prony%times/retardation%distances(:, k)**2))
      end do
      self%drive = 0
      self%sums = 0
      self%at_edge = 0
      call new_pile(self%touched, self%relaxed, self%moduli, 1/self%times)
      call new_pile(self%free, -1.0_dp, [(1.0_dp, k=1, n)], 1/retardation%times)
   end subroutine new_timed_springs

   !> The moment; at the end of the path the end of its last leg.
   pure type(mark_t) function mark_of(self)
      type(timed_springs_t), intent(in) :: self

      mark_of%leg = size(self%legs)
      mark_of%phase = 1
      if (self%leg > size(self%legs)) return
      mark_of%leg = self%leg
      mark_of%phase = self%phase
      mark_of%rest = self%phase_rest
   end function mark_of

   !> A depth that counts for nothing: neither beside other depths, nor by the force of springs that all arms hold.
   pure real(dp) function thin_depth(self, share) result(depth)
      type(timed_springs_t), intent(in) :: self
      !> The part of what is tolerated that it may be.
      real(dp), intent(in) :: share

      depth = min(share, self%softness)*self%tolerance*self%depth_size
   end function thin_depth

   !> Radius of the contact at a depth, and the integral of g over it.
   elemental subroutine get_spot(contacts, depth, radius, moment)
      class(normal_contact_t), intent(in) :: contacts
      !> G, below 0 as 0.
      real(dp), intent(in) :: depth
      !> Receive a, and int g dx from 0 to a.
      real(dp), intent(out) :: radius, moment

      call contacts%get_spot(depth, radius, moment)
   end subroutine get_spot

   !> Memory c_k of springs that leave contact.
   pure function free_memory(self, stretch, arms) result(memory)
      type(timed_springs_t), intent(in) :: self
      !> theta of the springs; shape `(n_springs)`.
      real(dp), intent(in) :: stretch(:)
      !> q_i; shape `(n_springs, n_arms)`.
      real(dp), intent(in) :: arms(:, :)
      real(dp) :: memory(size(stretch), size(self%times))
      integer :: i, k

      memory = 0
      do k = 1, size(self%times)
         do i = 1, size(self%times)
            memory(:, k) = memory(:, k) + self%modes(k, i)*(stretch - arms(:, i))
         end do
      end do
   end function free_memory

end module adfric_round_timed_springs
