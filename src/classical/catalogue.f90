!> The classical models of the half-space.
module adfric_classical_catalogue
   use adfric_classical_hertz_model, only: hertz_model_t, new_hertz_model
   use adfric_classical_line_load_model, only: line_load_model_t, new_line_load_model, strip_load_model_t, new_strip_load_model
   use adfric_classical_point_load_model, only: point_load_model_t, new_point_load_model
   use adfric_classical_punch_model, only: punch_model_t, new_punch_model
   use adfric_classical_wave_model, only: wave_model_t, new_wave_model
   use adfric_model_model, only: model_t
   implicit none (type, external)
   private
   public :: new_classical_model

contains

   !> The model of a name; none if it is not one of these.
   subroutine new_classical_model(model, name)
      !> Not allocated if the name is that of no model of this folder.
      class(model_t), allocatable, intent(out) :: model
      !> As it stands in `&job`.
      character(*), intent(in) :: name
      type(hertz_model_t), allocatable :: hertz
      type(punch_model_t), allocatable :: punch
      type(wave_model_t), allocatable :: wave
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
   end subroutine new_classical_model

end module adfric_classical_catalogue
