! SPDX-License-Identifier: GPL-3.0-or-later
!> Whether the derived quantities of a model name all variables that they follow from.
module derived_sources
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_describe_model, only: model_t, derived_t
   use adfric_describe_table, only: kind_real
   implicit none (type, external)
   private
   public :: find_missing_source

contains

   !> Change every number of a case, one by one: what changes that does not name it, as words; empty if there is nothing.
   function find_missing_source(model, values) result(words)
      class(model_t), intent(in) :: model
      !> A case that can be solved.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: words
      real(dp), parameter :: factor = 1.25_dp
      type(derived_t), allocatable :: before(:), after(:)
      real(dp), allocatable :: changed(:)
      integer :: i, k

      words = 'nothing is derived'
      allocate (before, source=model%derive_quantities(values))
      if (size(before) == 0) return
      words = ''
      do k = 1, size(values)
         if (model%variables(k)%kind /= kind_real .or. .not. is_set(values(k))) cycle
         changed = values
         changed(k) = factor*values(k)
         if (allocated(after)) deallocate (after)
         allocate (after, source=model%derive_quantities(changed))
         do i = 1, size(before)
            if (before(i)%follows_from(model%variables(k)%name)) cycle
            if (abs(before(i)%value - after(i)%value) > 0) words = words//' '//before(i)%name//' of '//model%variables(k)%name
         end do
      end do
   end function find_missing_source

end module derived_sources
