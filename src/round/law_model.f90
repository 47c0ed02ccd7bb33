! SPDX-License-Identifier: GPL-3.0-or-later
!> What a model of round bodies keeps of its law of friction beside numbers.
module adfric_round_law_model
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_interface_friction_law_rows, only: given_law_t, take_law_attribute, take_law_table
   use adfric_round_velocity_law, only: law_row_of
   use adfric_describe_pointwise, only: pointwise_model_t
   implicit none (type, external)
   private
   public :: law_model_t

   !> A model with the table of a law.
   type, abstract, extends(pointwise_model_t) :: law_model_t
      !> The table.
      type(given_law_t) :: given_law
   contains
      procedure :: take_dataset
      procedure :: take_attribute
   end type law_model_t

contains

   !> See `model_t`.
   subroutine take_dataset(self, index, values, problems)
      class(law_model_t), intent(inout) :: self
      !> Index of the dataset in `variables`.
      integer, intent(in) :: index
      !> Its values; shape `(n, n_columns)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives what is wrong with the values; nothing here.
      type(problems_t), intent(inout) :: problems

      call take_law_table(self%given_law, law_row_of(index), values)
      associate (unused => problems)
      end associate
   end subroutine take_dataset

   !> See `model_t`.
   subroutine take_attribute(self, index, name, value, problems)
      class(law_model_t), intent(inout) :: self
      !> Index of the dataset in `variables`.
      integer, intent(in) :: index
      !> Name of the attribute.
      character(*), intent(in) :: name
      !> Its value in SI units.
      real(dp), intent(in) :: value
      !> Receives what is wrong with it.
      type(problems_t), intent(inout) :: problems

      call take_law_attribute(self%given_law, self%variables(index), law_row_of(index), name, value, problems)
   end subroutine take_attribute

end module adfric_round_law_model
