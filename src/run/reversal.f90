! SPDX-License-Identifier: GPL-3.0-or-later
!> A body that slides against +x, or with a velocity below 0, where the solver knows a speed and one direction.
!>
!> The solver gets the speed |V|, and the direction is turned by pi where V < 0. Results and profiles that are vectors along the
!> motion take the sign of V. A solver whose profiles run along the motion has them mirrored, x -> -x, where the body slides
!> against +x, so that x is that of the surface.
module adfric_run_reversal
   use adfric_base_constants, only: pi
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: get_word, has_word
   use adfric_describe_model, only: model_t
   use adfric_describe_scene_rules, only: along_motion, of_speed
   implicit none (type, external)
   private
   public :: reversal_t, new_reversal

   !> Which values, results and profiles of a scene depend on the sense of the motion.
   type :: reversal_t
      !> Indices of velocity and direction among the variables; 0 where the solver knows a velocity of either sign.
      integer :: velocity = 0, direction = 0
      !> Does the result take the sign of the velocity? Shape `(n_results)`.
      logical, allocatable :: has_sign(:)
      !> Does the profile? Shape `(n_profiles)`.
      logical, allocatable :: profile_has_sign(:)
      !> Do the profiles of the solver run along the motion?
      logical :: is_along_motion = .false.
   contains
      procedure :: is_backward
      procedure :: is_against_x
      procedure :: angle_of
      procedure :: turn_values
      procedure :: turn_results
      procedure :: turn_profiles
   end type reversal_t

contains

   !> What the sense of the motion changes for a solver.
   subroutine new_reversal(self, model)
      type(reversal_t), intent(out) :: self
      !> The solver, with its tables in the language of scenes; its velocity may have either sign afterwards.
      class(model_t), intent(inout) :: model
      character(*), parameter :: sign_of_velocity = ', with the sign of the velocity'
      integer :: i, k

      allocate (self%has_sign(size(model%results)), self%profile_has_sign(size(model%profiles)), source=.false.)
      do k = 1, size(of_speed)
         if (get_word(of_speed(k), 1) /= model%name) cycle
         self%velocity = model%index_of('operating', 'velocity')
         self%direction = model%index_of('operating', 'direction')
         self%is_along_motion = has_word(along_motion, model%name)
         model%variables(self%velocity)%lower = -model%variables(self%velocity)%upper
         do i = 1, size(model%results)
            self%has_sign(i) = has_word(of_speed(k), model%results(i)%solver_name)
            if (self%has_sign(i)) model%results(i)%long_name = model%results(i)%long_name//sign_of_velocity
         end do
         do i = 1, size(model%profiles)
            self%profile_has_sign(i) = has_word(of_speed(k), model%profiles(i)%name)
            if (self%profile_has_sign(i)) model%profiles(i)%long_name = model%profiles(i)%long_name//sign_of_velocity
         end do
      end do
   end subroutine new_reversal

   !> Is the velocity of a point below 0?
   pure logical function is_backward(self, values)
      class(reversal_t), intent(in) :: self
      !> Values of the scene; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      is_backward = .false.
      if (self%velocity > 0) is_backward = values(self%velocity) < 0
   end function is_backward

   !> Does the body slide against +x, so that profiles along the motion are mirrored?
   pure logical function is_against_x(self, values)
      class(reversal_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      is_against_x = .false.
      if (self%is_along_motion) is_against_x = modulo(nint(self%angle_of(values)/pi), 2) == 1
   end function is_against_x

   !> Angle from +x to where the body slides [rad].
   pure real(dp) function angle_of(self, values) result(angle)
      class(reversal_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      angle = 0
      if (is_set(values(self%direction))) angle = values(self%direction)
      if (self%is_backward(values)) angle = angle + pi
   end function angle_of

   !> Velocities below 0 become speeds, with the direction turned by pi.
   pure subroutine turn_values(self, values)
      class(reversal_t), intent(in) :: self
      !> Values of points; shape `(n_variables, n_points)`.
      real(dp), intent(inout), contiguous :: values(:, :)
      integer :: i

      if (self%velocity == 0) return
      do i = 1, size(values, 2)
         if (.not. values(self%velocity, i) < 0) cycle
         values(self%direction, i) = self%angle_of(values(:, i))
         values(self%velocity, i) = -values(self%velocity, i)
      end do
   end subroutine turn_values

   !> Results of the solver become those of the scene, or the reverse.
   pure subroutine turn_results(self, values, results)
      class(reversal_t), intent(in) :: self
      !> Values of the scene for each point; shape `(n_variables, n_points)`.
      real(dp), intent(in), contiguous :: values(:, :)
      !> Results of the points; shape `(n_results, n_points)`.
      real(dp), intent(inout) :: results(:, :)
      integer :: i

      if (self%velocity == 0) return
      do i = 1, size(values, 2)
         if (.not. values(self%velocity, i) < 0) cycle
         where (self%has_sign) results(:, i) = -results(:, i)
      end do
   end subroutine turn_results

   !> Profiles of the solver become those of the scene.
   pure subroutine turn_profiles(self, values, profiles)
      class(reversal_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Profiles of the point; shape `(n_x, n_y, n_profiles)`.
      real(dp), intent(inout) :: profiles(:, :, :)
      integer :: k

      if (self%is_against_x(values)) profiles(:, :, :) = profiles(size(profiles, 1):1:-1, :, :)
      if (.not. self%is_backward(values)) return
      do k = 1, size(profiles, 3)
         if (self%profile_has_sign(k)) profiles(:, :, k) = -profiles(:, :, k)
      end do
   end subroutine turn_profiles

end module adfric_run_reversal
