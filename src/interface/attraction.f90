! SPDX-License-Identifier: GPL-3.0-or-later
!> How surfaces attract each other over the gap between them: the tension, its slope, and the work that is left to part them.
!>
!> Every law has a largest tension `stress` and a length of its own, `range`; `work` is the integral of the tension over the gap from
!> contact (gap 0) on. With s = stress, r = range, g = gap:
!>
!> - Dugdale: s while g <= r. work = s r.
!> - exponential: s exp(-g/r). work = s r.
!> - linear: s (1 - g/r) while g <= r. work = s r/2.
!> - van der Waals: s (1 + g/r)^-3, half-spaces of which r is the distance in contact: s = A/(6 pi r^3) with Hamaker's constant A.
!>   work = s r/2 = A/(12 pi r^2).
!> - Lennard-Jones: (8 work/(3 r)) ((1 + g/r)^-3 - (1 + g/r)^-9), which pushes where g < 0; r is the distance at rest. The largest
!>   tension, 16 work/(9 sqrt(3) r), is at g = (3^(1/6) - 1) r (Greenwood, J. A.: Proc. R. Soc. Lond. A 453, 1997, 1277).
!> - table: straight lines between given tensions, 0 behind the last gap.
!>
!> All but Lennard-Jones's fall with the gap. The exponential law, van der Waals's and the linear one are convex as well.
module adfric_interface_attraction
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   implicit none (type, external)
   private
   public :: attraction_t, attraction_by_stress, attraction_by_work, attraction_of_two, attraction_of_table, work_ratio
   public :: law_dugdale, law_exponential, law_linear, law_van_der_waals, law_lennard_jones, law_table, law_words

   !> Words of the laws, in the order of their indices.
   character(*), parameter :: law_words = 'dugdale exponential linear van_der_waals lennard_jones table'
   !> Indices of the laws.
   integer, parameter :: law_dugdale = 1, law_exponential = 2, law_linear = 3, law_van_der_waals = 4, law_lennard_jones = 5, &
      & law_table = 6

   !> A law of attraction. Stresses and lengths are in any units that belong together; the work is in their product.
   type :: attraction_t
      !> One of `law_...`.
      integer :: law = law_dugdale
      !> Largest tension, > 0; the law's own length, > 0; work from contact to any distance.
      real(dp) :: stress = 0, range = 0, work = 0
      !> Gaps of a table, growing from 0; tensions there, falling to 0 at the last. Not allocated for other laws. Same shape `(n)`.
      real(dp), allocatable :: gaps(:), tensions(:)
   contains
      procedure :: tension
      procedure :: slope
      procedure :: work_from
      procedure :: reach
      procedure :: reach_of_work
      procedure :: has_end
      procedure :: end_of_tension
      procedure :: has_wall
      procedure :: gap_of_largest
      procedure :: gap_of_steepest
      procedure :: gap_before_largest
      procedure :: in_units
      procedure :: stretched
   end type attraction_t

contains

   !> Work of a law over the product of its stress and its range.
   pure elemental real(dp) function work_ratio(law) result(ratio)
      !> One of `law_...` but the table's, which has no range.
      integer, intent(in) :: law

      select case (law)
      case (law_linear, law_van_der_waals)
         ratio = 0.5_dp
      case (law_lennard_jones)
         ratio = 9*sqrt(3.0_dp)/16
      case default
         ratio = 1
      end select
   end function work_ratio

   !> A law by its largest tension and its range.
   pure type(attraction_t) function attraction_by_stress(law, stress, range) result(self)
      !> One of `law_...` but the table's.
      integer, intent(in) :: law
      !> Largest tension, > 0; range, > 0.
      real(dp), intent(in) :: stress, range

      self%law = law
      self%stress = stress
      self%range = range
      self%work = work_ratio(law)*stress*range
   end function attraction_by_stress

   !> A law by its work and its range.
   pure type(attraction_t) function attraction_by_work(law, work, range) result(self)
      !> One of `law_...` but the table's.
      integer, intent(in) :: law
      !> Work of adhesion, > 0; range, > 0.
      real(dp), intent(in) :: work, range

      self%law = law
      self%range = range
      self%work = work
      self%stress = work/(work_ratio(law)*range)
   end function attraction_by_work

   !> A law by two of its largest tension, work and range.
   pure type(attraction_t) function attraction_of_two(law, stress, work, range) result(self)
      !> One of `law_...` but the table's.
      integer, intent(in) :: law
      !> Largest tension, work of adhesion, range; two of them > 0, the third one `unset`.
      real(dp), intent(in) :: stress, work, range

      if (.not. is_set(stress)) then
         self = attraction_by_work(law, work, range)
      else if (is_set(range)) then
         self = attraction_by_stress(law, stress, range)
      else
         self = attraction_by_work(law, work, work/(work_ratio(law)*stress))
      end if
   end function attraction_of_two

   !> A law by tensions at gaps; its range is the first gap without tension.
   pure type(attraction_t) function attraction_of_table(gaps, tensions) result(self)
      !> Gaps, growing from 0, two at least; tensions there, falling, the last one 0. Same shape `(n)`.
      real(dp), intent(in) :: gaps(:), tensions(:)
      integer :: n

      n = findloc(tensions > 0, .false., 1)
      self%law = law_table
      allocate (self%gaps(n), source=gaps(:n))
      allocate (self%tensions(n), source=tensions(:n))
      self%stress = tensions(1)
      self%range = gaps(n)
      self%work = self%work_from(0.0_dp)
   end function attraction_of_table

   !> Tension at a gap, below 0 where the surfaces push.
   pure elemental real(dp) function tension(self, gap)
      class(attraction_t), intent(in) :: self
      !> Gap, >= 0; Lennard-Jones's law has gaps above -range.
      real(dp), intent(in) :: gap
      real(dp) :: u
      integer :: k

      tension = 0
      select case (self%law)
      case (law_dugdale)
         if (gap <= self%range) tension = self%stress
      case (law_exponential)
         tension = self%stress*exp(-gap/self%range)
      case (law_linear)
         tension = self%stress*max(0.0_dp, 1 - gap/self%range)
      case (law_van_der_waals)
         tension = self%stress/(1 + gap/self%range)**3
      case (law_lennard_jones)
         u = 1/(1 + gap/self%range)**3
         tension = 8*self%work/(3*self%range)*u*(1 - u)*(1 + u)
      case (law_table)
         if (gap >= self%range) return
         k = segment_of(self%gaps, gap)
         tension = self%tensions(k) + (gap - self%gaps(k))*segment_slope(self, k)
      end select
   end function tension

   !> d tension/d gap; at a corner that of larger gaps.
   pure elemental real(dp) function slope(self, gap)
      class(attraction_t), intent(in) :: self
      !> Gap, as of `tension`. Dugdale's law has no slope but at its end, where it has no number: 0 here.
      real(dp), intent(in) :: gap
      real(dp) :: u

      slope = 0
      select case (self%law)
      case (law_exponential)
         slope = -self%stress/self%range*exp(-gap/self%range)
      case (law_linear)
         if (gap < self%range) slope = -self%stress/self%range
      case (law_van_der_waals)
         slope = -3*self%stress/self%range/(1 + gap/self%range)**4
      case (law_lennard_jones)
         u = 1/(1 + gap/self%range)
         slope = 8*self%work/(self%range**2)*u**4*(3*u**6 - 1)
      case (law_table)
         if (gap < self%range) slope = segment_slope(self, segment_of(self%gaps, gap))
      end select
   end function slope

   !> Work that is left to part surfaces at a gap: the integral of the tension from there on.
   pure elemental real(dp) function work_from(self, gap)
      class(attraction_t), intent(in) :: self
      !> Gap, as of `tension`.
      real(dp), intent(in) :: gap
      real(dp) :: u
      integer :: k

      work_from = 0
      select case (self%law)
      case (law_dugdale)
         work_from = self%stress*max(0.0_dp, self%range - gap)
      case (law_exponential)
         work_from = self%work*exp(-gap/self%range)
      case (law_linear)
         work_from = self%work*max(0.0_dp, 1 - gap/self%range)**2
      case (law_van_der_waals)
         work_from = self%work/(1 + gap/self%range)**2
      case (law_lennard_jones)
         u = 1/(1 + gap/self%range)**2
         work_from = self%work*u*(4 - u**3)/3
      case (law_table)
         if (gap >= self%range) return
         k = segment_of(self%gaps, gap)
         work_from = (self%gaps(k + 1) - gap)*(self%tension(gap) + self%tensions(k + 1))/2
         do k = k + 1, size(self%gaps) - 1
            work_from = work_from + (self%gaps(k + 1) - self%gaps(k))*(self%tensions(k) + self%tensions(k + 1))/2
         end do
      end select
   end function work_from

   !> Gap behind which the tension is below a share of the largest one.
   pure real(dp) function reach(self, share)
      class(attraction_t), intent(in) :: self
      !> Share of the largest tension, above 0 and below 1.
      real(dp), intent(in) :: share

      select case (self%law)
      case (law_exponential)
         reach = -self%range*log(share)
      case (law_van_der_waals)
         reach = self%range*(share**(-1.0_dp/3) - 1)
      case (law_lennard_jones)
         ! without its repulsion the law is larger, so this is behind the gap that is sought
         reach = self%range*((share*self%stress*3*self%range/(8*self%work))**(-1.0_dp/3) - 1)
      case default
         reach = self%range
      end select
   end function reach

   !> Gap behind which less than a share of the work is left.
   pure real(dp) function reach_of_work(self, share) result(reach)
      class(attraction_t), intent(in) :: self
      !> Share of the work, above 0 and below 1.
      real(dp), intent(in) :: share

      select case (self%law)
      case (law_exponential)
         reach = -self%range*log(share)
      case (law_van_der_waals)
         reach = self%range*(1/sqrt(share) - 1)
      case (law_lennard_jones)
         ! without its repulsion the law is larger, so this is behind the gap that is sought
         reach = self%range*(sqrt(4/(3*share)) - 1)
      case default
         reach = self%range
      end select
   end function reach_of_work

   !> Does the attraction end at the range?
   pure logical function has_end(self)
      class(attraction_t), intent(in) :: self

      has_end = .not. any(self%law == [law_exponential, law_van_der_waals, law_lennard_jones])
   end function has_end

   !> Gap from which on there is no tension, or none that counts among numbers; `huge` where there always is one.
   pure real(dp) function end_of_tension(self) result(gap)
      class(attraction_t), intent(in) :: self
      !> exp(-300) is 1e-130, the square of which is still a number.
      real(dp), parameter :: ranges = 300

      gap = huge(gap)
      if (self%has_end()) gap = self%range
      if (self%law == law_exponential) gap = ranges*self%range
   end function end_of_tension

   !> Is there a hard wall at the gap 0? A law without one pushes by itself.
   pure logical function has_wall(self)
      class(attraction_t), intent(in) :: self

      has_wall = self%law /= law_lennard_jones
   end function has_wall

   !> Gap at which the tension is largest.
   pure real(dp) function gap_of_largest(self) result(gap)
      class(attraction_t), intent(in) :: self

      gap = 0
      if (self%law == law_lennard_jones) gap = self%range*(3.0_dp**(1.0_dp/6) - 1)
   end function gap_of_largest

   !> Gap at which the tension of Lennard-Jones falls most steeply: before it the law is concave, and convex behind it.
   pure real(dp) function gap_of_steepest(self) result(gap)
      class(attraction_t), intent(in) :: self

      gap = self%range*(7.5_dp**(1.0_dp/6) - 1)
   end function gap_of_steepest

   !> Gap before that of the largest tension at which Lennard-Jones's law has a tension.
   pure real(dp) function gap_before_largest(self, tension) result(gap)
      class(attraction_t), intent(in) :: self
      !> The tension, below the largest one; below 0 where the surfaces push.
      real(dp), intent(in) :: tension
      !> Newton's method falls to the root without passing it; far out by a third of the distance in each step.
      integer, parameter :: most_steps = 60
      real(dp) :: t, u, step
      integer :: k

      ! u^3 - u + t = 0 with u = (1 + g/r)^-3, the largest root
      t = 3*self%range*tension/(8*self%work)
      u = 1 + max(0.0_dp, -t)**(1.0_dp/3)
      do k = 1, most_steps
         step = (u**3 - u + t)/(3*u**2 - 1)
         if (.not. step > epsilon(u)*u) exit
         u = u - step
      end do
      gap = self%range*(u**(-1.0_dp/3) - 1)
   end function gap_before_largest

   !> The same law with stresses and lengths in other units.
   pure type(attraction_t) function in_units(self, stress, length) result(other)
      class(attraction_t), intent(in) :: self
      !> The units, in those of `self`.
      real(dp), intent(in) :: stress, length

      other%law = self%law
      other%stress = self%stress/stress
      other%range = self%range/length
      other%work = self%work/stress/length
      if (allocated(self%gaps)) allocate (other%gaps, source=self%gaps/length)
      if (allocated(self%tensions)) allocate (other%tensions, source=self%tensions/stress)
   end function in_units

   !> The law with the same largest tension and all gaps larger by a factor, so that its work is.
   pure type(attraction_t) function stretched(self, factor) result(other)
      class(attraction_t), intent(in) :: self
      !> The factor, > 0.
      real(dp), intent(in) :: factor

      other = self%in_units(1.0_dp, 1/factor)
   end function stretched

   !> The segment of a table that begins at a gap or before it.
   pure integer function segment_of(gaps, gap) result(k)
      !> Gaps of the table; a gap below the last one.
      real(dp), intent(in) :: gaps(:), gap
      integer :: high, middle

      k = 1
      high = size(gaps)
      do while (high - k > 1)
         middle = (k + high)/2
         if (gaps(middle) <= gap) then
            k = middle
         else
            high = middle
         end if
      end do
   end function segment_of

   !> Slope of a segment of a table.
   pure real(dp) function segment_slope(self, k)
      class(attraction_t), intent(in) :: self
      !> Index of the segment.
      integer, intent(in) :: k

      segment_slope = (self%tensions(k + 1) - self%tensions(k))/(self%gaps(k + 1) - self%gaps(k))
   end function segment_slope

end module adfric_interface_attraction
