! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction of a tip on mica (Johnson 1997, Fig. 5), from pull-off to 300 nN.
program tip_friction
   use adfric_api, only: dp, error_t, open_simulation, simulation_t, status_solved
   implicit none (type, external)
   type(simulation_t) :: tip
   type(error_t), allocatable :: error
   real(dp), allocatable :: friction(:)
   real(dp) :: loads(441)
   integer, allocatable :: status(:)
   integer :: i

   loads = [(-140.0e-9_dp + i*1.0e-9_dp, i=0, 440)]                              ! [N]
   call open_simulation(tip, 'sphere', error)
   if (.not. allocated(error)) call tip%set('radius', 140.0e-9_dp, error)         ! [m]
   if (.not. allocated(error)) call tip%set('contact_modulus', 44.0e9_dp, error) ! [Pa]
   if (.not. allocated(error)) call tip%set('work_of_adhesion', 0.19_dp, error)   ! [J/m^2]
   if (.not. allocated(error)) call tip%set('lambda', 0.8_dp, error)
   if (.not. allocated(error)) call tip%set('shear_strength', 0.96e9_dp, error)   ! [Pa]
   if (.not. allocated(error)) call tip%set('state', 'sliding', error)
   if (.not. allocated(error)) call tip%sweep('load', loads, error)
   if (.not. allocated(error)) call tip%solve(error)
   if (.not. allocated(error)) call tip%get('friction_force', friction, error)
   if (.not. allocated(error)) call tip%get('status', status, error)
   if (allocated(error)) error stop error%message
   do i = 1, size(loads), 40
      if (status(i) == status_solved) print '(2es14.6)', loads(i), friction(i)
   end do
end program tip_friction
