!> What the models of a periodic surface on an elastic half-space share; a model says what its surface is.
module adfric_periodic_elastic_model
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_material_contact_modulus, only: check_contact_modulus, contact_modulus_of, derive_contact_modulus, n_two_bodies, &
      & set_modulus_rows
   use adfric_model_derived, only: derived_t
   use adfric_model_rows, only: positive
   use adfric_model_table, only: variable_t
   use adfric_periodic_model, only: periodic_model_t
   use adfric_periodic_point, only: periodic_surface_t, periodic_solid_t
   implicit none (type, external)
   private
   public :: elastic_model_t

   !> The models of surfaces on an elastic half-space.
   type, abstract, extends(periodic_model_t) :: elastic_model_t
   contains
      procedure :: set_elastic_tables
      procedure :: check_solid
      procedure :: set_solid
      procedure :: derive_solid
   end type elastic_model_t

contains

   !> Set the tables of the model.
   subroutine set_elastic_tables(self, name, summary, surface)
      !> The model, which receives the tables.
      class(elastic_model_t), intent(inout) :: self
      !> Name of the model in `&job model = ...`.
      character(*), intent(in) :: name
      !> What the model is, in one line for `adfric help`.
      character(*), intent(in) :: summary
      !> Variables of the surface.
      type(variable_t), intent(in) :: surface(:)
      type(variable_t) :: solid(n_two_bodies)

      call set_modulus_rows(positive(group='solid', name='contact_modulus', unit='Pa', meaning=''), solid)
      call self%set_tables(name, summary, surface, solid)
   end subroutine set_elastic_tables

   !> See `periodic_model_t`.
   subroutine check_solid(self, values, is_swept, problems)
      !> The model; its tables give the variables their names.
      class(elastic_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Not asked here; shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      associate (first => self%first_of_solid, last => self%last_of_solid)
         call check_contact_modulus(self%variables(first:last), values(first:last), problems, .false.)
      end associate
      associate (unused => is_swept)
      end associate
   end subroutine check_solid

   !> See `periodic_model_t`.
   subroutine set_solid(self, values, surface)
      !> The model, for the places of the rows of the solid.
      class(elastic_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the contact modulus.
      type(periodic_surface_t), intent(inout) :: surface

      if (.not. allocated(surface%solid)) allocate (periodic_solid_t :: surface%solid)
      surface%solid%modulus = contact_modulus_of(values(self%first_of_solid:self%last_of_solid))
   end subroutine set_solid

   !> See `periodic_model_t`: the contact modulus.
   function derive_solid(self, values, surface) result(derived)
      !> The model, for the rows of the solid.
      class(elastic_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> The surface, not used here.
      type(periodic_surface_t), intent(in) :: surface
      type(derived_t), allocatable :: derived(:)

      associate (first => self%first_of_solid, last => self%last_of_solid)
         derived = derive_contact_modulus(self%variables(first:last), values(first:last))
      end associate
      associate (unused => surface)
      end associate
   end function derive_solid

end module adfric_periodic_elastic_model
