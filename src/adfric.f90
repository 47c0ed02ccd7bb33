! SPDX-License-Identifier: GPL-3.0-or-later
!> The models that the program knows: the only place that has all their names.
module adfric
   use adfric_base_error, only: error_t, set_error, input_failure
   use adfric_plane_adhesive_cylinder_model, only: adhesive_cylinder_t, new_adhesive_cylinder
   use adfric_plane_hertz_history_model, only: hertz_history_t, new_hertz_history
   use adfric_plane_hertz_model, only: hertz_model_t, new_hertz_model
   use adfric_plane_line_load_model, only: line_load_model_t, new_line_load_model
   use adfric_plane_rectangle_load_model, only: new_rectangle_load_model, rectangle_load_model_t
   use adfric_plane_point_load_model, only: point_load_model_t, new_point_load_model
   use adfric_plane_punch_model, only: punch_model_t, new_punch_model
   use adfric_plane_strip_load_model, only: strip_load_model_t, new_strip_load_model
   use adfric_plane_wave_model, only: wave_model_t, new_wave_model
   use adfric_round_adhesive_history_model, only: adhesive_indenter_history_t, new_adhesive_indenter_history
   use adfric_round_attracted_model, only: attracted_indenter_t, new_attracted_indenter
   use adfric_round_history_model, only: indenter_history_t, new_indenter_history
   use adfric_round_model, only: indenter_model_t, new_indenter_model
   use adfric_round_timed_adhesion_model, only: adhesive_indenter_time_t, new_adhesive_indenter_time
   use adfric_round_timed_model, only: indenter_time_t, new_indenter_time
   use adfric_describe_model, only: model_t
   use adfric_periodic_free_model, only: free_model_t, new_free_model
   use adfric_periodic_sliding_model, only: sliding_model_t, new_sliding_model
   use adfric_rough_spectrum_model, only: new_spectrum_model, spectrum_model_t
   use adfric_periodic_surface_model, only: surface_model_t, new_surface_model
   use adfric_periodic_surface_time, only: surface_time_t, new_surface_time
   use adfric_periodic_wave_2d_model, only: wave_2d_model_t, new_wave_1d_cells, new_wave_2d_model
   use adfric_rough_model, only: new_rough_theories, rough_theories_t
   use adfric_round_sphere_model, only: sphere_model_t, new_sphere_model
   use adfric_foundation_model, only: wavy_model_t, new_wavy_model
   implicit none (type, external)
   private
   public :: known_models, new_model

   !> Names of the models, separated by a blank.
   character(*), parameter :: known_models = 'wavy_sliding sphere hertz hertz_history rigid_punch indenter indenter_history '// &
      & 'wave_1d wave_2d_elastic surface_elastic surface_sliding line_load strip_load point_load adhesive_cylinder '// &
      & 'indenter_time adhesive_indenter_time surface_time adhesive_indenter_history wave_1d_elastic '// &
      & 'attracted_indenter rough_theories free_surface spectrum_elastic rectangle_load'

contains

   !> Make the model of a name. It is long by one case for each model.
   subroutine new_model(model, name, error)
      !> Receives the model with its tables; not allocated if the name is unknown.
      class(model_t), allocatable, intent(out) :: model
      !> Name of the model, as it stands in `&job`.
      character(*), intent(in) :: name
      !> Allocated if the name is unknown; lists those that are known.
      type(error_t), allocatable, intent(out) :: error
      type(wavy_model_t), allocatable :: wavy
      type(sphere_model_t), allocatable :: sphere
      type(indenter_model_t), allocatable :: indenter
      type(indenter_history_t), allocatable :: indenter_history
      type(attracted_indenter_t), allocatable :: attracted_indenter
      type(hertz_model_t), allocatable :: hertz
      type(hertz_history_t), allocatable :: hertz_history
      type(punch_model_t), allocatable :: punch
      type(wave_model_t), allocatable :: wave
      type(wave_2d_model_t), allocatable :: wave_2d
      type(surface_model_t), allocatable :: surface
      type(spectrum_model_t), allocatable :: spectrum
      type(free_model_t), allocatable :: free
      type(sliding_model_t), allocatable :: sliding
      type(adhesive_cylinder_t), allocatable :: adhesive_cylinder
      type(indenter_time_t), allocatable :: indenter_time
      type(surface_time_t), allocatable :: surface_time
      type(adhesive_indenter_time_t), allocatable :: adhesive_indenter_time
      type(adhesive_indenter_history_t), allocatable :: adhesive_indenter_history
      type(line_load_model_t), allocatable :: line_load
      type(rough_theories_t), allocatable :: rough_theories
      type(strip_load_model_t), allocatable :: strip_load
      type(point_load_model_t), allocatable :: point_load
      type(rectangle_load_model_t), allocatable :: rectangle_load

      select case (name)
      case ('wavy_sliding')
         allocate (wavy)
         call new_wavy_model(wavy)
         call move_alloc(wavy, model)
      case ('sphere')
         allocate (sphere)
         call new_sphere_model(sphere)
         call move_alloc(sphere, model)
      case ('indenter')
         allocate (indenter)
         call new_indenter_model(indenter)
         call move_alloc(indenter, model)
      case ('attracted_indenter')
         allocate (attracted_indenter)
         call new_attracted_indenter(attracted_indenter)
         call move_alloc(attracted_indenter, model)
      case ('indenter_history')
         allocate (indenter_history)
         call new_indenter_history(indenter_history)
         call move_alloc(indenter_history, model)
      case ('indenter_time')
         allocate (indenter_time)
         call new_indenter_time(indenter_time)
         call move_alloc(indenter_time, model)
      case ('adhesive_indenter_time')
         allocate (adhesive_indenter_time)
         call new_adhesive_indenter_time(adhesive_indenter_time)
         call move_alloc(adhesive_indenter_time, model)
      case ('adhesive_indenter_history')
         allocate (adhesive_indenter_history)
         call new_adhesive_indenter_history(adhesive_indenter_history)
         call move_alloc(adhesive_indenter_history, model)
      case ('hertz')
         allocate (hertz)
         call new_hertz_model(hertz)
         call move_alloc(hertz, model)
      case ('hertz_history')
         allocate (hertz_history)
         call new_hertz_history(hertz_history)
         call move_alloc(hertz_history, model)
      case ('rigid_punch')
         allocate (punch)
         call new_punch_model(punch)
         call move_alloc(punch, model)
      case ('wave_1d')
         allocate (wave)
         call new_wave_model(wave)
         call move_alloc(wave, model)
      case ('wave_1d_elastic')
         allocate (wave_2d)
         call new_wave_1d_cells(wave_2d)
         call move_alloc(wave_2d, model)
      case ('wave_2d_elastic')
         allocate (wave_2d)
         call new_wave_2d_model(wave_2d)
         call move_alloc(wave_2d, model)
      case ('surface_elastic')
         allocate (surface)
         call new_surface_model(surface)
         call move_alloc(surface, model)
      case ('spectrum_elastic')
         allocate (spectrum)
         call new_spectrum_model(spectrum)
         call move_alloc(spectrum, model)
      case ('free_surface')
         allocate (free)
         call new_free_model(free)
         call move_alloc(free, model)
      case ('surface_sliding')
         allocate (sliding)
         call new_sliding_model(sliding)
         call move_alloc(sliding, model)
      case ('surface_time')
         allocate (surface_time)
         call new_surface_time(surface_time)
         call move_alloc(surface_time, model)
      case ('rough_theories')
         allocate (rough_theories)
         call new_rough_theories(rough_theories)
         call move_alloc(rough_theories, model)
      case ('adhesive_cylinder')
         allocate (adhesive_cylinder)
         call new_adhesive_cylinder(adhesive_cylinder)
         call move_alloc(adhesive_cylinder, model)
      case ('line_load')
         allocate (line_load)
         call new_line_load_model(line_load)
         call move_alloc(line_load, model)
      case ('strip_load')
         allocate (strip_load)
         call new_strip_load_model(strip_load)
         call move_alloc(strip_load, model)
      case ('rectangle_load')
         allocate (rectangle_load)
         call new_rectangle_load_model(rectangle_load)
         call move_alloc(rectangle_load, model)
      case ('point_load')
         allocate (point_load)
         call new_point_load_model(point_load)
         call move_alloc(point_load, model)
      case default
         call set_error(error, input_failure, 'model '''//name//''' is unknown; known are '//known_models)
      end select
   end subroutine new_model

end module adfric
