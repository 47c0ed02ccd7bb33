! SPDX-License-Identifier: GPL-3.0-or-later
!> Values of the model `indenter` as an input would give them.
module indenter_cases
   use adfric_base_kinds, only: dp
   use adfric_base_words, only: find_word, count_words
   use adfric_base_unset, only: unset
   use adfric_round_model, only: indenter_model_t, new_indenter_model
   use adfric_round_variables, only: kind_cone, kind_flat, kind_flat_cone, kind_flat_paraboloid, kind_paraboloid, &
      & kind_polynomial, kind_power, kind_rounded_cone, kind_rounded_punch, kind_sphere, in => indenter_input
   implicit none (type, external)
   private
   public :: new_indenter, new_named, hold, kind_of, n_kinds, size_of

   !> What can be held.
   integer, parameter :: controls(*) = [in%load, in%approach, in%contact_radius, in%face_angle, in%base_approach]
   integer, parameter :: n_kinds = 10

contains

   !> An indenter of a kind with all lengths and slopes 1, E* = 1 and no adhesion; nothing is held.
   subroutine new_indenter(model, values, kind)
      type(indenter_model_t), intent(out) :: model
      real(dp), allocatable, intent(out) :: values(:)
      !> One of `kind_...`.
      integer, intent(in) :: kind

      call new_indenter_model(model)
      values = model%variables%default
      values(in%kind) = kind
      values(in%contact_modulus) = 1
      select case (kind)
      case (kind_cone)
         values(in%slope) = 1
      case (kind_paraboloid, kind_sphere)
         values(in%radius) = 1
      case (kind_power)
         values([in%exponent, in%coefficient]) = [2.5_dp, 1.0_dp]
      case (kind_flat)
         values(in%face_radius) = 1
      case (kind_flat_cone)
         values([in%face_radius, in%slope]) = 1
      case (kind_flat_paraboloid, kind_rounded_punch)
         values([in%face_radius, in%radius]) = 1
      case (kind_rounded_cone)
         values([in%slope, in%radius]) = 1
      case default
         values([in%coefficient_1 + 1, in%coefficient_1 + 3]) = 1
      end select
   end subroutine new_indenter

   !> Position of a kind among the words.
   integer function kind_of(name)
      character(*), intent(in) :: name
      type(indenter_model_t) :: model
      character(:), allocatable :: word
      integer :: k

      call new_indenter_model(model)
      kind_of = 0
      do k = 1, count_words(model%variables(in%kind)%choices)
         call find_word(model%variables(in%kind)%choices, k, word)
         if (word == name) kind_of = k
      end do
   end function kind_of

   !> A row of a table: `flat_cone` with `b=0.4;slope=0.3`, and so on; E* = 1, no adhesion.
   subroutine new_named(model, values, name, parameters)
      type(indenter_model_t), intent(out) :: model
      real(dp), allocatable, intent(out) :: values(:)
      character(*), intent(in) :: name, parameters
      integer :: kind

      kind = kind_of(name)
      call new_indenter(model, values, kind)
      call take('c0', in%coefficient)
      call take('n', in%exponent)
      call take('R', in%radius)
      call take('slope', in%slope)
      if (kind == kind_polynomial) then
         call take('c2', in%coefficient_1 + 1)
         call take('c4', in%coefficient_1 + 3)
      else if (kind == kind_rounded_cone) then
         call take('b', in%radius)
         values(in%radius) = values(in%radius)/values(in%slope)
      else
         call take('b', in%face_radius)
      end if

   contains

      !> Take one number over, if it is there.
      subroutine take(key, position)
         character(*), intent(in) :: key
         integer, intent(in) :: position
         character(:), allocatable :: list
         integer :: first, last

         list = ';'//trim(parameters)//';'
         first = index(list, ';'//key//'=')
         if (first == 0) return
         first = first + len(key) + 2
         last = first + index(list(first:), ';') - 2
         read (list(first:last), *) values(position)
      end subroutine take

   end subroutine new_named

   !> Hold one quantity.
   pure subroutine hold(values, control, number)
      real(dp), intent(inout) :: values(:)
      !> Position of the variable.
      integer, intent(in) :: control
      real(dp), intent(in) :: number

      values(controls) = unset
      values(control) = number
   end subroutine hold

   !> Radius of the face or the tip of a kind made by `new_indenter`; 0 if it has none.
   pure real(dp) function size_of(kind)
      integer, intent(in) :: kind

      size_of = 0
      if (any(kind == [kind_flat, kind_flat_cone, kind_flat_paraboloid, kind_rounded_punch])) size_of = 1
   end function size_of

end module indenter_cases
