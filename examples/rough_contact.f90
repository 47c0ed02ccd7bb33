! SPDX-License-Identifier: GPL-3.0-or-later
!> A rough surface given as an array, pressed against an elastic half-space: share in contact, and a map of the pressure.
program rough_contact
   use adfric_api, only: dp, error_t, i8, open_scene, simulation_t
   implicit none (type, external)
   integer, parameter :: n = 64
   real(dp), parameter :: two_pi = 6.283185307179586_dp
   ! lengths [m], contact modulus [Pa]; the heights and the mean pressure come later
   character(*), parameter :: newline = new_line('a'), scene = &
      & "&surface kind = 'heights', length_x = 1e-5, length_y = 1e-5 /"//newline// &
      & "&solid contact_modulus = 1e9 /"//newline// &
      & "&output profiles = .true. /"
   character(*), parameter :: later(2) = [character(13) :: 'heights', 'mean_pressure']
   type(simulation_t) :: surface
   type(error_t), allocatable :: error
   real(dp) :: heights(n, n)
   real(dp), allocatable :: fraction(:), pressure(:, :)
   integer :: i, j

   heights = reshape([((1.0e-8_dp*(cos(two_pi*i/n) + cos(two_pi*j/n) + 0.3_dp*cos(two_pi*(5*i + 3*j)/n)), i=1, n), j=1, n)], [n, n])
   call open_scene(surface, scene, later, error)
   if (.not. allocated(error)) call surface%set('heights', heights, error)                        ! [m]
   if (.not. allocated(error)) call surface%sweep('mean_pressure', [1.0e6_dp, 5.0e6_dp], error)   ! [Pa]
   if (.not. allocated(error)) call surface%solve(error, n_threads=2)
   if (.not. allocated(error)) call surface%get('contact_fraction', fraction, error)
   if (.not. allocated(error)) call surface%get_profile('pressure', 2_i8, pressure, error)
   if (allocated(error)) error stop error%message
   print '(a, 2f8.4)', 'share in contact', fraction
   print '(a, es12.4)', 'largest pressure of the second point [Pa]', maxval(pressure)
end program rough_contact
