!> The models of the half-space.
module adfric_classical_catalogue
   use adfric_classical_hertz_model, only: hertz_model_t, new_hertz_model
   use adfric_classical_line_load_model, only: line_load_model_t, new_line_load_model, strip_load_model_t, new_strip_load_model
   use adfric_classical_point_load_model, only: point_load_model_t, new_point_load_model
   use adfric_classical_punch_model, only: punch_model_t, new_punch_model
   use adfric_classical_wave_model, only: wave_model_t, new_wave_model
   use adfric_model_model, only: model_t
   use adfric_periodic_surface_model, only: surface_model_t, new_surface_model
   use adfric_periodic_wave_2d_model, only: wave_2d_model_t, new_wave_2d_model
   implicit none (type, external)
   private
   public :: halfspace_models, new_halfspace_model

   !> Names of these models, separated by a blank.
   character(*), parameter :: halfspace_models = 'hertz rigid_punch wave_1d wave_2d_elastic surface_elastic line_load '// &
      & 'strip_load point_load'

contains

   !> The model of a name; none if it is not one of these.
   subroutine new_halfspace_model(model, name)
      !> The new model with its tables; not allocated if the name is not one of `halfspace_models`.
      class(model_t), allocatable, intent(out) :: model
      !> Name of the model, as in `&job model = ...`.
      character(*), intent(in) :: name
      type(hertz_model_t), allocatable :: hertz
      type(punch_model_t), allocatable :: punch
      type(wave_model_t), allocatable :: wave
      type(wave_2d_model_t), allocatable :: wave_2d
      type(surface_model_t), allocatable :: surface
      type(line_load_model_t), allocatable :: line
      type(strip_load_model_t), allocatable :: strip
      type(point_load_model_t), allocatable :: point

      select case (name)
      case ('hertz')
         allocate (hertz)
         call new_hertz_model(hertz)
         call move_alloc(hertz, model)
      case ('rigid_punch')
         allocate (punch)
         call new_punch_model(punch)
         call move_alloc(punch, model)
      case ('wave_1d')
         allocate (wave)
         call new_wave_model(wave)
         call move_alloc(wave, model)
      case ('wave_2d_elastic')
         allocate (wave_2d)
         call new_wave_2d_model(wave_2d)
         call move_alloc(wave_2d, model)
      case ('surface_elastic')
         allocate (surface)
         call new_surface_model(surface)
         call move_alloc(surface, model)
      case ('line_load')
         allocate (line)
         call new_line_load_model(line)
         call move_alloc(line, model)
      case ('strip_load')
         allocate (strip)
         call new_strip_load_model(strip)
         call move_alloc(strip, model)
      case ('point_load')
         allocate (point)
         call new_point_load_model(point)
         call move_alloc(point, model)
      end select
   end subroutine new_halfspace_model

end module adfric_classical_catalogue
