! SPDX-License-Identifier: GPL-3.0-or-later
!> The law of adhesion of the strips of a wavy surface.
!>
!> Adhesion pulls with one stress \( \pi \) as long as the gap is within its range \( \delta \). The edge rule says what the
!> displacement does where the stress begins and ends: it may jump by \( J \). Adhesion takes hold of a free surface at the gap
!> of attachment \( A \), and the jump makes it \( A - J \), or contact if that is not above 0: the surface snaps. Adhesion is
!> lost at the gap of release \( R \), and the jump makes it \( R + J \). The solver of a strip reads \( A, R, J \) and what
!> follows from them here, not the rule:
!>
!> | edge rule | \( J \) | \( A \) | \( R \) |
!> | --- | --- | --- | --- |
!> | continuous | 0 | \( \delta \) | \( \delta \) |
!> | instantaneous | \( \pi/\beta \) | \( \delta \) | \( \delta \) |
!> | front | \( \pi/\beta \) | \( \delta + J/2 \) | \( \delta - J/2 \) |
!>
!> Let m be the displacement that a column would have at once if it were let go, and f the profile. A column that adheres is at
!> \( \max(f, m - J) \), a free one at m. So with the front adhesion takes hold and is lost at one and the same
!> \( m - f = A = R + J \): the displacement depends on m and f alone, and does not fall where m rises.
!>
!> A front with \( J > 2\delta \) has no gap of release. Contact then begins and ends at \( m - f = \sqrt{2 J \delta} \), as
!> energy demands, where the pressure is \( -\sqrt{2\beta\pi\delta} \). A law with this stress, and with the range that leaves the
!> surface energy \( \pi\delta \) what it is, has the jump \( \sqrt{2 J \delta} \), twice its range, and R = 0. It gives a column
!> the same displacement for every m and f, so it is the same law: `acting_adhesion` puts it in the position of the given one.
module adfric_foundation_adhesion
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   implicit none (type, external)
   private
   public :: adhesion_t, strip_adhesion_t, acting_adhesion, new_strip_adhesion, edge_work
   public :: edge_continuous, edge_instantaneous, edge_front

   !> What the displacement does where the adhesion stress starts or ends: stays (GM), or jumps by
   !> K/beta times the jump of stress (GM 4 read across the jump), at the range or with the range half way (the limit of a
   !> thin layer).
   integer, parameter :: edge_continuous = 1, edge_instantaneous = 2, edge_front = 3

   !> The adhesion of a surface, in the units of the surface (see `surface_t`), as it acts (see `acting_adhesion`).
   type :: adhesion_t
      !> Adhesion stress, >= 0; 0 without adhesion.
      real(dp) :: stress = 0
      !> Range of adhesion, > 0; not used where the stress is 0.
      real(dp) :: range = 0
      !> What the displacement does at the edges of adhesion, one of `edge_...`.
      integer :: edge = edge_continuous
   end type adhesion_t

   !> The adhesion of a strip, in the units of the strip (see `strip_t`), and what follows from the law for it.
   type, extends(adhesion_t) :: strip_adhesion_t
      !> Jump of the displacement where the adhesion stress ends [c]; it jumps back where the stress begins.
      real(dp) :: jump = 0
      !> Gaps at which adhesion takes hold of a free surface, and at which it is lost [c].
      real(dp) :: attach_gap = 0, release_gap = 0
      !> Gaps after the jumps there, attach_gap - jump and release_gap + jump [c]; the first is not above 0 if the surface snaps.
      real(dp) :: attached_gap = 0, released_gap = 0
      !> Growth of the gap from attachment to release, release_gap - attached_gap, and its fall from release to attachment,
      !> released_gap - attach_gap [c]: one number, which is kept without the round-off of the gaps.
      real(dp) :: gap_change = 0
      !> Does the jump bring the surface into contact where adhesion takes hold?
      logical :: snaps = .false.
      !> Is there no adhesion beside the contact, for it is lost where the contact ends (release_gap = 0)? The surface snaps then.
      logical :: is_lost_at_contact = .false.
      !> Stress above -stress with which a contact begins into which the surface snaps, else 0 [c/K].
      real(dp) :: entry = 0
      !> By how much the rate of the gap (times v) rises where adhesion takes hold, up to contact if it snaps [c].
      real(dp) :: attach_lift = 0
   end type strip_adhesion_t

contains

   !> The adhesion that acts: the given one, or, for a front that lets no gap adhere, that with the stress at which contact ends.
   elemental type(adhesion_t) function acting_adhesion(given, beta) result(acting)
      !> Adhesion as it is given, in any units in which stresses are lengths.
      type(adhesion_t), intent(in) :: given
      !> Ratio of retardation to relaxation time of the foundation [-], >= 1.
      real(dp), intent(in) :: beta

      if (has_asserts) call assert(beta >= 1, 'acting_adhesion: beta >= 1')
      acting = given
      if (given%edge /= edge_front .or. given%stress/beta <= 2*given%range) return
      ! no square root of a product that may overflow
      acting%stress = sqrt(2*beta)*sqrt(given%stress)*sqrt(given%range)
      acting%range = acting%stress/(2*beta)
   end function acting_adhesion

   !> The adhesion of a strip.
   elemental subroutine new_strip_adhesion(self, adhesion, amplitude, beta)
      !> Adhesion in units of the strip.
      type(strip_adhesion_t), intent(out) :: self
      !> Adhesion in units of the surface, as it acts.
      type(adhesion_t), intent(in) :: adhesion
      !> Half the peak-to-valley height of the strip in units of the surface, > 0.
      real(dp), intent(in) :: amplitude
      real(dp), intent(in) :: beta

      if (has_asserts) call assert(amplitude > 0, 'new_strip_adhesion: the strip has a height')
      if (has_asserts) call assert(adhesion%stress >= 0 .and. adhesion%range >= 0, 'new_strip_adhesion: stress >= 0, range >= 0')
      if (has_asserts) call assert(any(adhesion%edge == [edge_continuous, edge_instantaneous, edge_front]), &
         & 'new_strip_adhesion: the edge rule is known')
      if (has_asserts) call assert(adhesion%edge /= edge_front .or. adhesion%stress/beta <= 2*adhesion%range, &
         & 'new_strip_adhesion: the adhesion is one that acts')
      self%edge = adhesion%edge
      self%stress = adhesion%stress/amplitude
      self%range = adhesion%range/amplitude
      ! an elastic foundation (beta = 1) has w = K p at all times, so its displacement must jump
      if (self%edge /= edge_continuous .or. beta <= 1) self%jump = self%stress/beta
      self%attach_gap = self%range
      self%release_gap = self%range
      if (self%edge == edge_front) then
         ! this difference is exact where it is small, so all strips of a surface have a gap of release, or none has
         call set_front(self, (adhesion%range - adhesion%stress/beta/2)/amplitude)
      else
         self%attached_gap = self%attach_gap - self%jump
         self%released_gap = self%release_gap + self%jump
         self%gap_change = self%jump - (self%attach_gap - self%release_gap)
         self%snaps = self%jump >= self%attach_gap
      end if
      if (self%snaps) then
         self%entry = beta*(self%jump - self%attach_gap)
         self%attach_lift = (beta - 1)*self%attach_gap
      else
         self%attach_lift = self%stress - self%jump
      end if
   end subroutine new_strip_adhesion

   !> The gaps of a front, in which the displacement jumps from one side of the range to the other.
   elemental subroutine set_front(self, release_gap)
      !> The adhesion of the strip, whose stress and jump are known.
      type(strip_adhesion_t), intent(inout) :: self
      !> The range less half of the jump [c]; 0 if the jump leaves no gap that adheres.
      real(dp), intent(in) :: release_gap

      self%is_lost_at_contact = self%stress > 0 .and. .not. release_gap > 0
      self%snaps = self%is_lost_at_contact
      self%release_gap = max(release_gap, 0.0_dp)
      self%attach_gap = self%release_gap + self%jump
      ! both edges lie at the same gaps, to the last digit
      self%attached_gap = self%release_gap
      self%released_gap = self%attach_gap
      self%gap_change = 0
   end subroutine set_front

   !> Energy that both edges of adhesion take when adhesion takes hold once and is lost once.
   elemental real(dp) function edge_work(self, beta, has_snapped, rise) result(work)
      type(strip_adhesion_t), intent(in) :: self
      real(dp), intent(in) :: beta
      !> Has the surface snapped into contact? Else it has come into adhesion first.
      logical, intent(in) :: has_snapped
      !> Displacement before the free zone less that behind it [c]; only continuous edges read it.
      real(dp), intent(in) :: rise

      if (self%edge == edge_front) then
         ! what the displacement gives where adhesion takes hold it takes back where adhesion is lost
         work = 0
      else if (has_snapped) then
         work = self%stress*self%attach_gap - beta*self%attach_gap**2/2 + self%stress**2/(2*beta)
      else if (self%jump > 0) then
         work = self%stress**2/beta
      else
         ! q jumps with the pressure: [q^2](leading side) - [q^2](trailing side) at both edges
         work = self%stress*(2*rise)/(2*(beta - 1))
      end if
   end function edge_work

end module adfric_foundation_adhesion
