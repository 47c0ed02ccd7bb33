! SPDX-License-Identifier: GPL-3.0-or-later
!> A law of attraction as a column meets it.
!>
!> Let \( G = \sum z_j - h \) be the distance from the heights at which a column that is let go would be: its `reach`. With the tension
!> s(g) at the gap g and the instantaneous stiffness \( k_g \) the column is where
!> $$ g + s(g)/k_g = G, $$
!> or in contact, g = 0, while G <= s(0)/k_g. Where the slope of the law is below \( k_g \) everywhere, that is one gap for each reach. Else
!> the left side falls over some gaps, which are unstable, and the column jumps over them where the reach passes the end of a span.
!>
!> Gaps are cut into spans, in each of which the law is smooth and the left side rises. Contact is the span 0. Spans that follow each other
!> without a jump are one branch. Of two columns the one with the smaller reach and the lower branch has the smaller gap, and after a jump it
!> still has: the gap is the first one beyond the jump that has the reach. So states keep their order.
module adfric_foundation_stepping_attraction
   use adfric_base_kinds, only: dp
   use adfric_interface_attraction, only: attraction_t, law_exponential, law_linear, law_table, law_van_der_waals
   implicit none (type, external)
   private
   public :: column_attraction_t, new_column_attraction

   !> Spans whose left side rises by less than this with the gap are jumped over.
   real(dp), parameter :: least_rise = 1.0e-10_dp

   !> A span of gaps.
   type :: attraction_span_t
      !> Gaps where it begins and ends, and the reaches there.
      real(dp) :: low_gap = 0, high_gap = huge(1.0_dp), low_reach = 0, high_reach = huge(1.0_dp)
      !> Number of its branch; contact is in the branch 0.
      integer :: branch = 0
      !> Is the law straight here?
      logical :: is_straight = .false.
      !> Tension where the span begins, and slope, where the law is straight.
      real(dp) :: tension = 0, slope = 0
   end type attraction_span_t

   !> A law on a column.
   type :: column_attraction_t
      !> The law, in units of the time stepping.
      type(attraction_t) :: law
      !> Instantaneous stiffness [k0], and the reach at which contact ends.
      real(dp) :: glassy = 1, contact_reach = 0
      !> Spans in the order of gaps; the last one has no end. Shape `(n_spans)`.
      type(attraction_span_t), allocatable :: spans(:)
   contains
      procedure :: get_tension
      procedure :: gap_at
      procedure :: span_above
      procedure :: span_below
      procedure :: span_of
      procedure :: branch_of
      procedure :: energy
   end type column_attraction_t

contains

   !> The spans of a law.
   pure subroutine new_column_attraction(self, law, glassy)
      type(column_attraction_t), intent(out) :: self
      !> The law with a wall, in units of the time stepping; not Dugdale's, which has an edge rule.
      type(attraction_t), intent(in) :: law
      !> Instantaneous stiffness [k0], >= 1.
      real(dp), intent(in) :: glassy
      real(dp) :: low

      self%law = law
      self%glassy = glassy
      self%contact_reach = law%stress/glassy
      select case (law%law)
      case (law_exponential)
         low = max(0.0_dp, law%range*log(law%stress/(law%range*glassy)))
         self%spans = [smooth_span(self, low)]
      case (law_van_der_waals)
         low = max(0.0_dp, law%range*((3*law%stress/(law%range*glassy))**0.25_dp - 1))
         self%spans = [smooth_span(self, low)]
      case (law_linear)
         call cut_table(self, [0.0_dp, law%range], [law%stress, 0.0_dp])
      case (law_table)
         call cut_table(self, law%gaps, law%tensions)
      end select
   end subroutine new_column_attraction

   !> The span of a law that is smooth and convex: it begins where the left side is least.
   pure type(attraction_span_t) function smooth_span(self, low) result(span)
      type(column_attraction_t), intent(in) :: self
      !> Gap where it begins.
      real(dp), intent(in) :: low

      span%low_gap = low
      span%low_reach = low + self%law%tension(low)/self%glassy
      if (low > 0) span%branch = 1
   end function smooth_span

   !> The spans of straight lines between tensions, and the one behind them.
   pure subroutine cut_table(self, gaps, tensions)
      type(column_attraction_t), intent(inout) :: self
      !> Gaps, growing from 0, and tensions, falling to 0; same shape `(n)`.
      real(dp), intent(in) :: gaps(:), tensions(:)
      type(attraction_span_t) :: spans(size(gaps))
      real(dp) :: slope, last_gap
      integer :: k, n, branch

      n = 0
      branch = 0
      last_gap = 0
      do k = 1, size(gaps)
         slope = 0
         if (k < size(gaps)) slope = (tensions(k + 1) - tensions(k))/(gaps(k + 1) - gaps(k))
         if (.not. 1 + slope/self%glassy > least_rise) cycle
         if (gaps(k) > last_gap) branch = branch + 1
         n = n + 1
         spans(n)%is_straight = .true.
         spans(n)%branch = branch
         spans(n)%low_gap = gaps(k)
         spans(n)%low_reach = gaps(k) + tensions(k)/self%glassy
         spans(n)%tension = tensions(k)
         spans(n)%slope = slope
         if (k < size(gaps)) then
            spans(n)%high_gap = gaps(k + 1)
            spans(n)%high_reach = gaps(k + 1) + tensions(k + 1)/self%glassy
            last_gap = gaps(k + 1)
         end if
      end do
      self%spans = spans(:n)
   end subroutine cut_table

   !> Tension and its slope at a gap, as the law of a span goes on beyond its ends.
   pure subroutine get_tension(self, span, gap, tension, slope)
      class(column_attraction_t), intent(in) :: self
      !> Number of the span.
      integer, intent(in) :: span
      real(dp), intent(in) :: gap
      !> Receive the tension and d tension/d gap.
      real(dp), intent(out) :: tension, slope
      real(dp) :: u

      associate (s => self%spans(span), law => self%law)
         if (s%is_straight) then
            tension = s%tension + s%slope*(gap - s%low_gap)
            slope = s%slope
         else if (law%law == law_exponential) then
            tension = law%stress*exp(-gap/law%range)
            slope = -tension/law%range
         else
            u = 1/(1 + gap/law%range)
            tension = law%stress*u**3
            slope = -3*law%stress/law%range*u**4
         end if
      end associate
   end subroutine get_tension

   !> The gap of a span at a reach; the end of the span where the reach is beyond it.
   pure real(dp) function gap_at(self, span, reach) result(gap)
      class(column_attraction_t), intent(in) :: self
      !> Number of the span; 0 for contact.
      integer, intent(in) :: span
      real(dp), intent(in) :: reach
      integer, parameter :: most_steps = 100
      real(dp) :: tension, slope, step
      integer :: k

      gap = 0
      if (span == 0) return
      associate (s => self%spans(span))
         gap = s%low_gap
         if (.not. reach > s%low_reach) return
         if (s%is_straight) then
            gap = min(s%high_gap, s%low_gap + (reach - s%low_reach)/(1 + s%slope/self%glassy))
            return
         end if
         ! the left side is convex and above the gap, so that Newton's method falls to the root
         gap = reach
         do k = 1, most_steps
            call self%get_tension(span, gap, tension, slope)
            if (.not. 1 + slope/self%glassy > 0) exit
            step = (gap + tension/self%glassy - reach)/(1 + slope/self%glassy)
            gap = max(s%low_gap, gap - step)
            if (.not. step > epsilon(gap)*(gap + reach)) exit
         end do
      end associate
   end function gap_at

   !> The span that a column goes to where the reach rises beyond a span.
   pure integer function span_above(self, span, reach) result(above)
      class(column_attraction_t), intent(in) :: self
      !> The span; not the last one.
      integer, intent(in) :: span
      real(dp), intent(in) :: reach

      do above = span + 1, size(self%spans) - 1
         if (self%spans(above)%high_reach > reach) return
      end do
      above = size(self%spans)
   end function span_above

   !> The span that a column goes to where the reach falls below a span; 0 for contact.
   pure integer function span_below(self, span, reach) result(below)
      class(column_attraction_t), intent(in) :: self
      integer, intent(in) :: span
      real(dp), intent(in) :: reach

      do below = span - 1, 1, -1
         if (self%spans(below)%low_reach < reach) return
      end do
      below = 0
   end function span_below

   !> The span of a reach for a column that was in a branch; 0 for contact.
   pure integer function span_of(self, branch, reach) result(span)
      class(column_attraction_t), intent(in) :: self
      integer, intent(in) :: branch
      real(dp), intent(in) :: reach
      integer :: first

      first = 1
      do span = 1, size(self%spans)
         if (self%spans(span)%branch < branch) first = span + 1
      end do
      first = min(first, size(self%spans))
      if (branch == 0) first = 0
      span = first
      if (reach < low_end(first)) then
         span = self%span_below(first, reach)
      else if (reach >= high_end(first)) then
         span = self%span_above(first, reach)
      end if

   contains

      !> Reach where a span begins.
      pure real(dp) function low_end(i)
         integer, intent(in) :: i

         low_end = -huge(reach)
         if (i > 0) low_end = self%spans(i)%low_reach
      end function low_end

      !> Reach where a span ends.
      pure real(dp) function high_end(i)
         integer, intent(in) :: i

         high_end = self%contact_reach
         if (i > 0) high_end = self%spans(i)%high_reach
      end function high_end

   end function span_of

   !> The branch of a span.
   pure integer function branch_of(self, span) result(branch)
      class(column_attraction_t), intent(in) :: self
      !> Number of the span; 0 for contact.
      integer, intent(in) :: span

      branch = 0
      if (span > 0) branch = self%spans(span)%branch
   end function branch_of

   !> Energy of the instantaneous spring and of the attraction at a gap, while the dashpots and the heights stay.
   pure real(dp) function energy(self, gap, reach)
      class(column_attraction_t), intent(in) :: self
      real(dp), intent(in) :: gap, reach

      energy = self%glassy*(reach - gap)**2/2 - self%law%work_from(gap)
   end function energy

end module adfric_foundation_stepping_attraction
