! SPDX-License-Identifier: GPL-3.0-or-later
!> Quantities that follow from the variables of an input, such as Maugis's parameter from radius, modulus and energy.
module adfric_describe_derived
   use adfric_base_kinds, only: dp
   use adfric_base_words, only: count_words, get_word
   implicit none (type, external)
   private
   public :: derived_t, add_derived

   !> A derived quantity of a case.
   type :: derived_t
      !> Its name in the results file; where a namelist variable has the same name, this is its value where it is not given.
      character(:), allocatable :: name
      !> SI unit, `-` for a pure number.
      character(:), allocatable :: unit
      !> What it is, for `adfric check` and the results file.
      character(:), allocatable :: long_name
      !> Its value in the case.
      real(dp) :: value = 0
      !> Names of the namelist variables from which it follows, separated by a blank. Where one of them is swept it has no one
      !> value. If this is not allocated it is taken to follow from all of them.
      character(:), allocatable :: sources
   contains
      procedure :: follows_from
   end type derived_t

contains

   !> Add a quantity to a list.
   subroutine add_derived(list, name, unit, long_name, value, sources)
      !> The list, which grows by one; it need not be allocated before.
      type(derived_t), allocatable, intent(inout) :: list(:)
      !> Name of the quantity in the results file.
      character(*), intent(in) :: name
      !> SI unit, `-` for a pure number.
      character(*), intent(in) :: unit
      !> What the quantity is, in a few words.
      character(*), intent(in) :: long_name
      !> Value of the quantity, in this unit.
      real(dp), intent(in) :: value
      !> Names of the variables from which the quantity follows, separated by a blank; if absent, it follows from all of them.
      character(*), intent(in), optional :: sources
      type(derived_t) :: quantity

      quantity%name = name
      quantity%unit = unit
      quantity%long_name = long_name
      quantity%value = value
      if (present(sources)) quantity%sources = sources
      if (.not. allocated(list)) allocate (list(0))
      list = [list, quantity]
   end subroutine add_derived

   !> Does it follow from a variable?
   pure logical function follows_from(self, variable)
      class(derived_t), intent(in) :: self
      !> Name of the variable.
      character(*), intent(in) :: variable
      integer :: i

      follows_from = .not. allocated(self%sources)
      if (follows_from) return
      do i = 1, count_words(self%sources)
         if (get_word(self%sources, i) == variable) follows_from = .true.
      end do
   end function follows_from

end module adfric_describe_derived
