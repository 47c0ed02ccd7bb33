! SPDX-License-Identifier: GPL-3.0-or-later
!> Which points of a whole curve with adhesion belong to the base line, where no column says so.
!>
!> Without adhesion nothing need be known: before touch the load of contact is 0. With adhesion contact ends, or begins, by a jump, and which
!> points lie on which side of it is a matter of the data, not of the variables that are sought. So the points are marked before the fit.
!> A pass is a stretch of points along which the abscissa goes one way, or a segment. From its outermost point inward the base line goes on
!> as long as points lie on a straight line within their noise, and it ends where the next points leave that line together, beyond all
!> noise, by a jump that the base line has nowhere. Noise is that of second differences, of which few belong to jumps.
module adfric_fit_base_line
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: find_word
   use adfric_fit_order, only: order_of, sort
   use adfric_fit_parts, only: has_others
   use adfric_fit_problem, only: fit_t, data_set_t
   implicit none (type, external)
   private
   public :: mark_base_lines, wants_marks, find_passes

   !> Fewest points of a base line, and of the contact beside it.
   integer, parameter, public :: fewest = 6
   !> A jump is larger than so many times the noise, and so many points behind it have left the line.
   real(dp), parameter :: least_jump = 6.0_dp
   integer, parameter :: n_behind = 2
   !> A base line has a noise of at most so many times that of second differences, of few points some more.
   real(dp), parameter :: most_noise = 1.6_dp

contains

   !> Mark the points of all data sets that need it.
   subroutine mark_base_lines(fit)
      !> The fit, whose data sets receive `is_contact` where a base line is found.
      type(fit_t), intent(inout) :: fit
      logical, allocatable :: is_contact(:)
      logical :: wants(size(fit%data_sets))
      integer :: k

      wants = wants_marks(fit)
      do k = 1, size(fit%data_sets)
         if (.not. wants(k)) cycle
         call mark_points(fit%data_sets(k), is_contact)
         if (.not. all(is_contact)) fit%data_sets(k)%is_contact = is_contact
      end do
   end subroutine mark_base_lines

   !> Which data sets may have a base line that no column marks: loads against approaches, where something adheres. One with further
   !> variables has none: its points are no passes of one curve.
   function wants_marks(fit) result(wants)
      type(fit_t), intent(in) :: fit
      logical :: wants(size(fit%data_sets))
      integer :: k

      wants = .false.
      if (.not. associated(fit%model)) return
      if (.not. adheres(fit)) return
      do k = 1, size(fit%data_sets)
         associate (data => fit%data_sets(k))
            if (allocated(data%is_contact) .or. has_others(data)) cycle
            if (fit%model%results(data%ordinate)%name /= 'load') cycle
            wants(k) = any(fit%model%variables(data%abscissa)%name == [character(13) :: 'approach', 'base_approach'])
         end associate
      end do
   end function wants_marks

   !> Does anything adhere in a fit?
   function adheres(fit)
      type(fit_t), intent(in) :: fit
      logical :: adheres
      character(:), allocatable :: theory
      integer :: k

      adheres = .false.
      do k = 1, size(fit%model%variables)
         associate (variable => fit%model%variables(k))
            if (variable%name == 'work_of_adhesion') then
               if (is_set(fit%base(k))) adheres = adheres .or. fit%base(k) > 0
               adheres = adheres .or. any(fit%frees%variable == k)
            end if
         end associate
      end do
      k = fit%model%solver_index_of('model', 'theory')
      if (k == 0) return
      call find_word(fit%model%variables(k)%choices, nint(fit%base(k)), theory)
      adheres = adheres .and. theory /= 'hertz' .and. theory /= 'none'
   end function adheres

   !> Mark the points of a data set.
   subroutine mark_points(data, is_contact)
      type(data_set_t), intent(in) :: data
      logical, allocatable, intent(out) :: is_contact(:)
      integer, allocatable :: used(:), pass(:), order(:), members(:)
      logical :: is_used(size(data%x))
      integer :: i, k

      is_used = ieee_is_finite(data%x) .and. ieee_is_finite(data%y)
      if (allocated(data%is_used)) is_used = is_used .and. data%is_used
      used = pack([(i, i=1, size(data%x))], is_used)
      allocate (is_contact(size(data%x)), source=.true.)
      if (size(used) < 2*fewest) return
      call find_passes(data, used, pass)
      do k = minval(pass), maxval(pass)
         members = pack(used, pass == k)
         if (size(members) < 2*fewest) cycle
         order = order_of(data%x(members))
         members = members(order)
         is_contact(members(:length_of(data%x(members), data%y(members)))) = .false.
      end do
   end subroutine mark_points

   !> Number of the pass of each point: its segment, or whether it stands before or behind the innermost point.
   subroutine find_passes(data, used, pass)
      type(data_set_t), intent(in) :: data
      integer, intent(in) :: used(:)
      !> Receives the numbers.
      integer, allocatable, intent(out) :: pass(:)
      integer, allocatable :: numbers(:)
      integer :: inmost, i, k

      allocate (pass(size(used)), source=1)
      if (allocated(data%segment)) then
         allocate (numbers(0))
         do i = 1, size(used)
            if (.not. any(numbers == data%segment(used(i)))) numbers = [numbers, data%segment(used(i))]
         end do
         do k = 1, size(numbers)
            where (data%segment(used) == numbers(k)) pass = k
         end do
      else
         inmost = maxloc(data%x(used), 1)
         pass(inmost + 1:) = 2
      end if
   end subroutine find_passes

   !> Number of the outermost points that make a base line; 0: there is none.
   pure integer function length_of(x, y) result(length)
      !> Abscissas, rising.
      real(dp), intent(in) :: x(:)
      real(dp), intent(in) :: y(:)
      real(dp) :: noise, remaining, spread, sums(5), middle, at, slope, mean, of_line, size_of
      integer :: n, k

      length = 0
      n = size(x)
      noise = noise_of(y)
      middle = x(1)
      size_of = max(x(n) - x(1), tiny(x))
      sums = 0
      do k = 1, n - fewest - n_behind
         at = (x(k) - middle)/size_of
         sums = sums + [1.0_dp, at, at**2, y(k) - y(1), at*(y(k) - y(1))]
         if (k < fewest) cycle
         ! the line of the first k points
         of_line = sums(1)*sums(3) - sums(2)**2
         if (.not. of_line > 0) cycle
         slope = (sums(1)*sums(5) - sums(2)*sums(4))/of_line
         mean = (sums(4) - slope*sums(2))/sums(1)
         remaining = norm2(y(:k) - y(1) - mean - slope*(x(:k) - middle)/size_of)/sqrt(k - 2.0_dp)
         if (remaining > most_noise*(1 + 2/sqrt(real(k, dp)))*noise) cycle
         spread = minval(abs(y(k + 1:k + n_behind) - y(1) - mean - slope*(x(k + 1:k + n_behind) - middle)/size_of))
         if (spread > least_jump*max(noise, &
            & remaining) .and. all(y(k + 1:k + n_behind) < y(1) + mean + slope*(x(k + 1:k + n_behind) &
            & - middle)/size_of)) then
            length = k
            return
         end if
      end do
   end function length_of

   !> Noise of ordinates: that of a normal error with the median size of their second differences.
   pure real(dp) function noise_of(y) result(noise)
      !> The ordinates, along the abscissa.
      real(dp), intent(in) :: y(:)
      !> Median of the size of a normal number.
      real(dp), parameter :: median = 0.6744897501960817_dp
      real(dp) :: second(size(y) - 2)
      integer :: n

      n = size(y)
      second = abs(y(:n - 2) - 2*y(2:n - 1) + y(3:))
      call sort(second)
      noise = second((n - 1)/2)/(median*sqrt(6.0_dp))
   end function noise_of

end module adfric_fit_base_line
