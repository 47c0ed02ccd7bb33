!> The models of a periodic surface on an elastic half-space.
module adfric_periodic_catalogue
   use adfric_model_model, only: model_t
   use adfric_periodic_surface_model, only: surface_model_t, new_surface_model
   use adfric_periodic_wave_2d_model, only: wave_2d_model_t, new_wave_2d_model
   implicit none (type, external)
   private
   public :: new_periodic_model

contains

   !> The model of a name; none if it is not one of these.
   subroutine new_periodic_model(model, name)
      !> Not allocated if the name is that of no model of this folder.
      class(model_t), allocatable, intent(out) :: model
      !> As it stands in `&job`.
      character(*), intent(in) :: name
      type(wave_2d_model_t), allocatable :: wave_2d
      type(surface_model_t), allocatable :: surface

      select case (name)
      case ('wave_2d_elastic')
         allocate (wave_2d)
         call new_wave_2d_model(wave_2d)
         call move_alloc(wave_2d, model)
      case ('surface_elastic')
         allocate (surface)
         call new_surface_model(surface)
         call move_alloc(surface, model)
      end select
   end subroutine new_periodic_model

end module adfric_periodic_catalogue
