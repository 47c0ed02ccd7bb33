! SPDX-License-Identifier: GPL-3.0-or-later
!> What classical models check of a solid over which something may slide: the rows of its spectrum, with the velocity behind them.
module adfric_plane_sliding_check
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_spectrum_rows, only: check_spectrum, n_spectrum_rows, needs_velocity
   use adfric_describe_check, only: require
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: check_sliding, refuse_sliding

   !> Index of the velocity among the rows.
   integer, parameter :: velocity = n_spectrum_rows + 1

contains

   !> Add to `problems` what is wrong with a viscoelastic solid, or that the velocity is missing.
   subroutine check_sliding(rows, values, given, problems)
      !> The rows of the spectrum and that of the velocity; their names are part of the messages.
      type(variable_t), intent(in) :: rows(:)
      !> Values of the rows; shape `(n_spectrum_rows + 1)`.
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      type(problems_t), intent(inout) :: problems
      logical :: is_swept(n_spectrum_rows)

      ! what is swept has a value here, and is refused for that
      is_swept = .false.
      call check_spectrum(rows(:n_spectrum_rows), values(:n_spectrum_rows), given, is_swept, problems)
      call require(rows, values, [velocity], problems, needs_velocity)
   end subroutine check_sliding

   !> Add to `problems` temperature and velocity, which have no meaning over an elastic solid.
   subroutine refuse_sliding(rows, values, problems)
      !> The rows of the spectrum and that of the velocity; their names are part of the messages.
      type(variable_t), intent(in) :: rows(:)
      !> Values of the rows; shape `(n_spectrum_rows + 1)`.
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      integer :: k

      ! the temperature is the last row of the spectrum
      do k = n_spectrum_rows, velocity
         if (is_set(values(k))) call problems%add(rows(k)%group, rows(k)%name, &
            & 'has no meaning without &material; over an elastic solid nothing rubs')
      end do
   end subroutine refuse_sliding

end module adfric_plane_sliding_check
