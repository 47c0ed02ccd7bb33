! SPDX-License-Identifier: GPL-3.0-or-later
!> What the classical models share whose solid may be viscoelastic: the lists and datasets of its spectrum, and the table of a law of
!> the interface.
module adfric_plane_viscoelastic_model
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_interface_friction_law_rows, only: given_law_t, take_law_attribute, take_law_table
   use adfric_plane_model, only: halfspace_model_t
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_spectrum_rows, only: take_spectrum, take_spectrum_attribute
   implicit none (type, external)
   private
   public :: viscoelastic_model_t

   !> A model with rows of a spectrum, of which alone it has lists and datasets.
   type, abstract, extends(halfspace_model_t) :: viscoelastic_model_t
      !> Index of the first row of the material.
      integer :: first_material = 0
      !> Lists and datasets of the material.
      type(given_spectrum_t) :: given
      !> Index of the first row of the law of the interface, or 0.
      integer :: first_law = 0
      !> What is given of that law beside numbers.
      type(given_law_t) :: given_law
   contains
      procedure :: take_dataset
      procedure :: take_attribute
   end type viscoelastic_model_t

contains

   !> See `model_t`.
   subroutine take_dataset(self, index, values, problems)
      class(viscoelastic_model_t), intent(inout) :: self
      !> Index of the variable, one of the rows of the material or of the interface.
      integer, intent(in) :: index
      !> The values in SI units; shape `(n, n_columns)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives what is wrong with the values; nothing here.
      type(problems_t), intent(inout) :: problems

      call take_spectrum(self%given, index - self%first_material + 1, values)
      if (self%first_law > 0) call take_law_table(self%given_law, index - self%first_law + 1, values)
      associate (unused => problems)
      end associate
   end subroutine take_dataset

   !> See `model_t`.
   subroutine take_attribute(self, index, name, value, problems)
      class(viscoelastic_model_t), intent(inout) :: self
      !> Index of the variable, one of the rows of the material or of the interface.
      integer, intent(in) :: index
      character(*), intent(in) :: name
      !> Its value in SI units.
      real(dp), intent(in) :: value
      !> Receives what is wrong with it.
      type(problems_t), intent(inout) :: problems

      call take_spectrum_attribute(self%given, self%variables(index), index - self%first_material + 1, name, value, problems)
      if (self%first_law > 0) call take_law_attribute(self%given_law, self%variables(index), index - self%first_law + 1, name, &
         & value, problems)
   end subroutine take_attribute

end module adfric_plane_viscoelastic_model
