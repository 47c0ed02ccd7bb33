! SPDX-License-Identifier: GPL-3.0-or-later
!> The attraction of the cells of a surface: a law for all, how much of it each cell has, and a law of opening for those that have been in
!> contact. Chords bound the laws between gaps.
!>
!> The law of Lennard-Jones rises up to its largest tension. Its slope falls to the steepest gap and rises from there on. So the mean slope
!> from a gap on falls as the other end goes away from it, and then rises: the largest chord is that to one of the ends.
module adfric_periodic_attraction_cells
   use adfric_base_kinds, only: dp
   use adfric_interface_attraction, only: attraction_t, law_lennard_jones, law_table
   use adfric_periodic_cell_law, only: cell_law_t
   implicit none (type, external)
   private
   public :: attraction_cells_t

   !> Difference of gaps, in units of the range, below which a chord is the slope at its end.
   real(dp), parameter :: least_difference = 1.0e-6_dp
   !> Halvings of an interval of gaps in which the smallest chord ends.
   integer, parameter :: n_halvings = 30

   !> Attraction of cells.
   type, extends(cell_law_t) :: attraction_cells_t
      !> The law, in the units of the contact.
      type(attraction_t) :: law
      !> Work of adhesion of each cell over that of the law, >= 0; not allocated: 1. Shape of the cells.
      real(dp), allocatable :: part(:, :)
      !> Has the cell been in contact, so that it opens by `opening`? Shape of the cells; not allocated: none counts.
      logical, allocatable :: has_touched(:, :)
      !> The law of these cells: the same largest tension at longer gaps.
      type(attraction_t) :: opening
   contains
      procedure :: open_by
      procedure :: opening_loss
      procedure :: tension
      procedure :: tension_beyond
      procedure :: largest_tension
      procedure :: move_cell
      procedure :: slope
      procedure :: has_wall
      procedure :: contact_gap
      procedure :: largest_chord
      procedure :: smallest_chord
      procedure :: energy
   end type attraction_cells_t

contains

   !> Let the cells that have been in contact open with more work than closing gave.
   pure subroutine open_by(self, factor, has_touched)
      class(attraction_cells_t), intent(inout) :: self
      !> Work of opening over that of closing, >= 1; nothing is done where it is 1.
      real(dp), intent(in) :: factor
      !> Has the cell been in contact? Shape of the cells.
      logical, intent(in) :: has_touched(:, :)

      if (.not. factor > 1) return
      self%has_touched = has_touched
      self%opening = self%law%stretched(factor)
   end subroutine open_by

   !> Energy over area that opening has taken beyond what closing gave [E* times the unit of the gap].
   pure real(dp) function opening_loss(self, gap) result(loss)
      class(attraction_cells_t), intent(in) :: self
      !> Gaps, >= 0; shape of the cells.
      real(dp), intent(in) :: gap(:, :)
      real(dp) :: losses(size(gap, 1), size(gap, 2))

      loss = 0
      if (.not. allocated(self%has_touched)) return
      losses = (self%opening%work - self%law%work) - (self%opening%work_from(gap) - self%law%work_from(gap))
      if (allocated(self%part)) losses = self%part*losses
      loss = sum(losses, mask=self%has_touched)/size(gap)
   end function opening_loss

   !> Tensions at gaps [E*].
   pure function tension(self, gap) result(tensions)
      class(attraction_cells_t), intent(in) :: self
      !> Gaps, >= 0 but for Lennard-Jones's law; shape of the cells.
      real(dp), intent(in) :: gap(:, :)
      real(dp) :: tensions(size(gap, 1), size(gap, 2))

      tensions = self%law%tension(gap)
      if (allocated(self%has_touched)) tensions = merge(self%opening%tension(gap), tensions, self%has_touched)
      if (allocated(self%part)) tensions = self%part*tensions
   end function tension

   !> Largest tensions at gaps and beyond them [E*].
   pure function tension_beyond(self, gap) result(tensions)
      class(attraction_cells_t), intent(in) :: self
      !> Gaps; shape of the cells.
      real(dp), intent(in) :: gap(:, :)
      real(dp) :: tensions(size(gap, 1), size(gap, 2))

      tensions = self%tension(max(gap, self%contact_gap()))
   end function tension_beyond

   !> The largest tension of all cells [E*].
   pure real(dp) function largest_tension(self)
      class(attraction_cells_t), intent(in) :: self

      largest_tension = self%law%stress
   end function largest_tension

   !> Change the gap of one cell, whose tension follows; that of no other cell does.
   pure subroutine move_cell(self, i, j, step, gap, tension)
      class(attraction_cells_t), intent(inout) :: self
      !> The cell.
      integer, intent(in) :: i, j
      !> Change of its gap.
      real(dp), intent(in) :: step
      !> In: the gap in all cells. Out: with the change.
      real(dp), intent(inout), contiguous :: gap(:, :)
      !> A field that the change of the tension [E*] is added to; shape of the cells.
      real(dp), intent(inout), contiguous :: tension(:, :)
      real(dp) :: change
      logical :: has_touched

      has_touched = .false.
      if (allocated(self%has_touched)) has_touched = self%has_touched(i, j)
      associate (before => gap(i, j), behind => gap(i, j) + step)
         if (has_touched) then
            change = self%opening%tension(behind) - self%opening%tension(before)
         else
            change = self%law%tension(behind) - self%law%tension(before)
         end if
      end associate
      if (allocated(self%part)) change = self%part(i, j)*change
      gap(i, j) = gap(i, j) + step
      tension(i, j) = tension(i, j) + change
   end subroutine move_cell

   !> Is there a hard wall at the gap 0? Else the law pushes by itself.
   pure logical function has_wall(self)
      class(attraction_cells_t), intent(in) :: self

      has_wall = self%law%has_wall()
   end function has_wall

   !> Largest gap of cells in contact: 0, and without a wall the gap of the largest tension.
   pure real(dp) function contact_gap(self) result(gap)
      class(attraction_cells_t), intent(in) :: self

      gap = self%law%gap_of_largest()
   end function contact_gap

   !> Their slopes.
   pure function slope(self, gap) result(slopes)
      class(attraction_cells_t), intent(in) :: self
      !> Gaps, >= 0; shape of the cells.
      real(dp), intent(in) :: gap(:, :)
      real(dp) :: slopes(size(gap, 1), size(gap, 2))

      slopes = self%law%slope(gap)
      if (allocated(self%has_touched)) slopes = merge(self%opening%slope(gap), slopes, self%has_touched)
      if (allocated(self%part)) slopes = self%part*slopes
   end function slope

   !> No chord from a gap to one between it and another is larger.
   pure function largest_chord(self, from, to) result(chords)
      class(attraction_cells_t), intent(in) :: self
      !> Gaps, >= 0; shape of the cells.
      real(dp), intent(in) :: from(:, :), to(:, :)
      real(dp) :: chords(size(from, 1), size(from, 2))

      chords = chord_of(self%law, from, to, .true.)
      if (allocated(self%has_touched)) chords = merge(chord_of(self%opening, from, to, .true.), chords, self%has_touched)
      if (allocated(self%part)) chords = self%part*chords
   end function largest_chord

   !> No chord from a gap to one between it and another is smaller.
   pure function smallest_chord(self, from, to) result(chords)
      class(attraction_cells_t), intent(in) :: self
      !> Gaps, >= 0; shape of the cells.
      real(dp), intent(in) :: from(:, :), to(:, :)
      real(dp) :: chords(size(from, 1), size(from, 2))

      chords = chord_of(self%law, from, to, .false.)
      if (allocated(self%has_touched)) chords = merge(chord_of(self%opening, from, to, .false.), chords, self%has_touched)
      if (allocated(self%part)) chords = self%part*chords
   end function smallest_chord

   !> Energy over area by the law of closing, 0 far apart: the mean of what it takes to part the cells, below 0 [E* times the unit of the
   !> gap].
   pure real(dp) function energy(self, gap)
      class(attraction_cells_t), intent(in) :: self
      !> Gaps, >= 0; shape of the cells.
      real(dp), intent(in) :: gap(:, :)

      if (allocated(self%part)) then
         energy = -sum(self%part*self%law%work_from(gap))/size(gap)
      else
         energy = -sum(self%law%work_from(gap))/size(gap)
      end if
   end function energy

   !> The largest or smallest chord from a gap into an interval. Chords of a convex law grow with their other end.
   pure elemental real(dp) function chord_of(law, from, to, is_largest) result(chord)
      type(attraction_t), intent(in) :: law
      !> Where the chord begins, and the other end of the interval.
      real(dp), intent(in) :: from, to
      logical, intent(in) :: is_largest

      if (law%law == law_table) then
         chord = extreme_slope(law, min(from, to), max(from, to), is_largest)
      else if (law%law == law_lennard_jones) then
         chord = chord_without_wall(law, from, to, is_largest)
      else if (is_largest .neqv. to > from) then
         chord = law%slope(from)
      else if (abs(to - from) > least_difference*law%range) then
         chord = (law%tension(to) - law%tension(from))/(to - from)
      else
         ! beyond the chord on the safe side
         chord = law%slope(to)
      end if
   end function chord_of

   !> The largest or smallest chord of Lennard-Jones's law.
   pure real(dp) function chord_without_wall(law, from, to, is_largest) result(chord)
      type(attraction_t), intent(in) :: law
      !> Where the chord begins, and the other end of the interval.
      real(dp), intent(in) :: from, to
      logical, intent(in) :: is_largest
      real(dp) :: near, far, middle
      integer :: k

      if (abs(to - from) > least_difference*law%range) then
         chord = (law%tension(to) - law%tension(from))/(to - from)
      else
         chord = law%slope(to)
      end if
      if (is_largest) then
         chord = max(chord, law%slope(from))
         return
      end if
      chord = min(chord, law%slope(from))
      near = law%gap_of_steepest()
      if (.not. (near - from)*(to - near) > 0) return
      ! the mean slope is smallest where it is the slope itself, behind the steepest gap
      far = to
      do k = 1, n_halvings
         middle = (near + far)/2
         if (law%slope(middle)*(middle - from) < law%tension(middle) - law%tension(from) .eqv. middle > from) then
            near = middle
         else
            far = middle
         end if
      end do
      ! slopes rise from the steepest gap on, so this is below all chords
      if (abs(far - to) > 0) chord = min(chord, law%slope(near))
   end function chord_without_wall

   !> Largest or smallest slope of a table between two gaps.
   pure real(dp) function extreme_slope(law, low, high, is_largest) result(extreme)
      type(attraction_t), intent(in) :: law
      real(dp), intent(in) :: low, high
      logical, intent(in) :: is_largest
      real(dp) :: slope
      integer :: k, n

      n = size(law%gaps)
      ! behind the last gap there is no slope
      extreme = 0
      if (low >= law%gaps(n)) return
      if (high < law%gaps(n)) extreme = merge(-huge(extreme), huge(extreme), is_largest)
      do k = 1, n - 1
         if (law%gaps(k + 1) < low .or. law%gaps(k) > high) cycle
         slope = (law%tensions(k + 1) - law%tensions(k))/(law%gaps(k + 1) - law%gaps(k))
         extreme = merge(max(extreme, slope), min(extreme, slope), is_largest)
      end do
   end function extreme_slope

end module adfric_periodic_attraction_cells
