!> The models that the program knows.
module adfric
   use adfric_base_error, only: error_t, set_error, input_failure
   use adfric_classical_catalogue, only: new_classical_model
   use adfric_model_model, only: model_t
   use adfric_periodic_catalogue, only: new_periodic_model
   use adfric_sphere_model, only: sphere_model_t, new_sphere_model
   use adfric_wavy_model, only: wavy_model_t, new_wavy_model
   implicit none (type, external)
   private
   public :: known_models, new_model

   !> Names of the models, separated by a blank.
   character(*), parameter :: known_models = 'wavy_sliding sphere hertz rigid_punch wave_1d wave_2d_elastic surface_elastic '// &
      & 'line_load strip_load point_load'

contains

   !> The model of a name.
   subroutine new_model(model, name, error)
      class(model_t), allocatable, intent(out) :: model
      character(*), intent(in) :: name
      type(error_t), allocatable, intent(out) :: error
      type(wavy_model_t), allocatable :: wavy
      type(sphere_model_t), allocatable :: sphere

      select case (name)
      case ('wavy_sliding')
         allocate (wavy)
         call new_wavy_model(wavy)
         call move_alloc(wavy, model)
      case ('sphere')
         allocate (sphere)
         call new_sphere_model(sphere)
         call move_alloc(sphere, model)
      case default
         call new_classical_model(model, name)
         if (.not. allocated(model)) call new_periodic_model(model, name)
         if (.not. allocated(model)) call set_error(error, input_failure, &
            & 'model '''//name//''' is unknown; known are '//known_models)
      end select
   end subroutine new_model

end module adfric
