! SPDX-License-Identifier: GPL-3.0-or-later
!> A model of the half-space with values that are set by name.
module trial_case
   use adfric, only: new_model
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_describe_model, only: model_t
   implicit none (type, external)
   private
   public :: trial_case_t, new_case

   !> A case.
   type :: trial_case_t
      class(model_t), allocatable :: model
      real(dp), allocatable :: values(:)
      real(dp), allocatable :: results(:, :)
      real(dp) :: error_estimate(1) = 0
      integer :: status(1) = -1
   contains
      procedure :: give
      procedure :: problems_of
      procedure :: solve
      procedure :: found
      procedure :: get_profiles
   end type trial_case_t

contains

   subroutine new_case(self, name)
      type(trial_case_t), intent(out) :: self
      character(*), intent(in) :: name
      type(error_t), allocatable :: error
      integer :: i

      call new_model(self%model, name, error)
      if (allocated(error)) error stop 'trial_case: no such model'
      allocate (self%values(size(self%model%variables)))
      do i = 1, size(self%values)
         self%values(i) = self%model%variables(i)%default
      end do
   end subroutine new_case

   subroutine give(self, name, value)
      class(trial_case_t), intent(inout) :: self
      character(*), intent(in) :: name
      real(dp), intent(in) :: value
      integer :: i

      do i = 1, size(self%values)
         if (self%model%variables(i)%name /= name) cycle
         self%values(i) = value
         return
      end do
      error stop 'trial_case: no such variable'
   end subroutine give

   !> What is wrong, a line for each problem.
   function problems_of(self, swept) result(text)
      class(trial_case_t), intent(in) :: self
      !> Name of a swept variable.
      character(*), intent(in), optional :: swept
      character(:), allocatable :: text
      type(problems_t) :: problems
      logical, allocatable :: is_swept(:)
      integer :: i

      allocate (is_swept(size(self%values)), source=.false.)
      if (present(swept)) then
         do i = 1, size(self%values)
            is_swept(i) = self%model%variables(i)%name == swept
         end do
      end if
      call self%model%check_values(self%values, is_swept, problems)
      text = ''
      do i = 1, problems%count()
         text = text//problems%line_of(i, 'case')//new_line('a')
      end do
   end function problems_of

   subroutine solve(self)
      class(trial_case_t), intent(inout) :: self
      real(dp) :: counts(size(self%model%counts))

      if (allocated(self%results)) deallocate (self%results)
      allocate (self%results(size(self%model%results), 1))
      call self%model%solve_block(reshape(self%values, [size(self%values), 1]), self%results, self%error_estimate, &
         & self%status, counts)
   end subroutine solve

   !> A result by its name.
   real(dp) function found(self, name)
      class(trial_case_t), intent(in) :: self
      character(*), intent(in) :: name
      integer :: i

      do i = 1, size(self%results, 1)
         if (self%model%results(i)%name /= name) cycle
         found = self%results(i, 1)
         return
      end do
      error stop 'trial_case: no such result'
   end function found

   subroutine get_profiles(self, profiles)
      class(trial_case_t), intent(in) :: self
      real(dp), allocatable, intent(out) :: profiles(:, :, :)
      integer :: n(3)

      n = self%model%profile_shape(self%values)
      allocate (profiles(n(1), n(2), n(3)))
      call self%model%solve_profiles(self%values, self%results(:, 1), profiles)
   end subroutine get_profiles

end module trial_case
