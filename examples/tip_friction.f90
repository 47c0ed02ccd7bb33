! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction of a tip on mica (Johnson 1997, Fig. 5), from pull-off to 300 nN.
program tip_friction
   use adfric_api, only: dp, error_t, open_scene, simulation_t, status_solved
   implicit none (type, external)
   character(*), parameter :: newline = new_line('a'), scene = &
      & "&surface kind = 'paraboloid', radius = 140e-9 /"//newline// &         ! [m]
      & "&solid contact_modulus = 44e9 /"//newline// &                         ! [Pa]
      & "&adhesion work_of_adhesion = 0.19, lambda = 0.8 /"//newline// &       ! [J/m^2], [-]
      & "&friction shear_strength = 0.96e9 /"//newline// &                     ! [Pa]
      & "&operating state = 'sliding' /"
   type(simulation_t) :: tip
   type(error_t), allocatable :: error
   real(dp), allocatable :: friction(:)
   real(dp) :: loads(441)
   integer, allocatable :: status(:)
   integer :: i

   loads = [(-140.0e-9_dp + i*1.0e-9_dp, i=0, 440)]                              ! [N]
   call open_scene(tip, scene, ['load'], error)
   if (.not. allocated(error)) call tip%sweep('load', loads, error)
   if (.not. allocated(error)) call tip%solve(error)
   if (.not. allocated(error)) call tip%get('friction_force', friction, error)
   if (.not. allocated(error)) call tip%get('status', status, error)
   if (allocated(error)) error stop error%message
   do i = 1, size(loads), 40
      if (status(i) == status_solved) print '(2es14.6)', loads(i), friction(i)
   end do
end program tip_friction
