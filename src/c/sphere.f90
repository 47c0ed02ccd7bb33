! SPDX-License-Identifier: GPL-3.0-or-later
!> The functions of adfric.h for adhesive spheres, in batches.
module adfric_c_sphere
   use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int32_t, c_int64_t, c_int8_t
   use adfric_base_error, only: error_t
   use adfric_c_batches, only: check_batch, check_positive
   use adfric_c_texts, only: status_of
   use adfric_contact_sphere, only: find_sphere_pull_off, get_sphere_units, solve_sphere_approach, solve_sphere_load, &
      & solve_sphere_radius
   implicit none (type, external)
   private

contains

   !> See adfric.h.
   integer(c_int) function sphere_load(n, lambda, load, is_unstable, contact_radius, adhesion_radius, approach, status) &
      & bind(c, name='adfric_sphere_load') result(outcome)
      integer(c_int64_t), intent(in), value :: n
      real(c_double), intent(in), optional :: lambda(n), load(n)
      integer(c_int8_t), intent(in), optional :: is_unstable(n)
      real(c_double), intent(inout), optional :: contact_radius(n), adhesion_radius(n), approach(n)
      integer(c_int32_t), intent(inout), optional :: status(n)
      type(error_t), allocatable :: error
      integer(c_int64_t) :: i
      logical :: is_other

      call check_batch(n, [present(lambda), present(load), present(contact_radius), present(adhesion_radius), present(approach), &
         & present(status)], &
         & 'lambda load contact_radius adhesion_radius approach status', error)
      outcome = status_of(error)
      if (allocated(error)) return
      is_other = .false.
      do i = 1, n
         if (present(is_unstable)) is_other = is_unstable(i) /= 0
         call solve_sphere_load(lambda(i), load(i), contact_radius(i), adhesion_radius(i), approach(i), status(i), is_other)
      end do
   end function sphere_load

   !> See adfric.h.
   integer(c_int) function sphere_approach(n, lambda, approach, is_unstable, contact_radius, adhesion_radius, load, status) &
      & bind(c, name='adfric_sphere_approach') result(outcome)
      integer(c_int64_t), intent(in), value :: n
      real(c_double), intent(in), optional :: lambda(n), approach(n)
      integer(c_int8_t), intent(in), optional :: is_unstable(n)
      real(c_double), intent(inout), optional :: contact_radius(n), adhesion_radius(n), load(n)
      integer(c_int32_t), intent(inout), optional :: status(n)
      type(error_t), allocatable :: error
      integer(c_int64_t) :: i
      logical :: is_other

      call check_batch(n, [present(lambda), present(approach), present(contact_radius), present(adhesion_radius), present(load), &
         & present(status)], &
         & 'lambda approach contact_radius adhesion_radius load status', error)
      outcome = status_of(error)
      if (allocated(error)) return
      is_other = .false.
      do i = 1, n
         if (present(is_unstable)) is_other = is_unstable(i) /= 0
         call solve_sphere_approach(lambda(i), approach(i), contact_radius(i), adhesion_radius(i), load(i), status(i), is_other)
      end do
   end function sphere_approach

   !> See adfric.h.
   integer(c_int) function sphere_radius(n, lambda, contact_radius, adhesion_radius, load, approach, status) &
      & bind(c, name='adfric_sphere_radius') result(outcome)
      integer(c_int64_t), intent(in), value :: n
      real(c_double), intent(in), optional :: lambda(n), contact_radius(n)
      real(c_double), intent(inout), optional :: adhesion_radius(n), load(n), approach(n)
      integer(c_int32_t), intent(inout), optional :: status(n)
      type(error_t), allocatable :: error
      integer(c_int64_t) :: i

      call check_batch(n, [present(lambda), present(contact_radius), present(adhesion_radius), present(load), present(approach), &
         & present(status)], &
         & 'lambda contact_radius adhesion_radius load approach status', error)
      outcome = status_of(error)
      if (allocated(error)) return
      do i = 1, n
         call solve_sphere_radius(lambda(i), contact_radius(i), adhesion_radius(i), load(i), approach(i), status(i))
      end do
   end function sphere_radius

   !> See adfric.h.
   integer(c_int) function sphere_pull_off(n, lambda, holds_approach, load, approach, contact_radius, status) &
      & bind(c, name='adfric_sphere_pull_off') result(outcome)
      integer(c_int64_t), intent(in), value :: n
      real(c_double), intent(in), optional :: lambda(n)
      integer(c_int8_t), intent(in), optional :: holds_approach(n)
      real(c_double), intent(inout), optional :: load(n), approach(n), contact_radius(n)
      integer(c_int32_t), intent(inout), optional :: status(n)
      type(error_t), allocatable :: error
      integer(c_int64_t) :: i
      logical :: holds

      call check_batch(n, [present(lambda), present(load), present(approach), present(contact_radius), present(status)], &
         & 'lambda load approach contact_radius status', error)
      outcome = status_of(error)
      if (allocated(error)) return
      holds = .false.
      do i = 1, n
         if (present(holds_approach)) holds = holds_approach(i) /= 0
         call find_sphere_pull_off(lambda(i), load(i), approach(i), contact_radius(i), status(i), holds)
      end do
   end function sphere_pull_off

   !> See adfric.h.
   integer(c_int) function sphere_scales(n, radius, contact_modulus, work_of_adhesion, length, closer, force, strength) &
      & bind(c, name='adfric_sphere_scales') result(outcome)
      integer(c_int64_t), intent(in), value :: n
      real(c_double), intent(in), optional :: radius(n), contact_modulus(n), work_of_adhesion(n)
      real(c_double), intent(inout), optional :: length(n), closer(n), force(n), strength(n)
      type(error_t), allocatable :: error
      integer(c_int64_t) :: i

      call check_batch(n, [present(radius), present(contact_modulus), present(work_of_adhesion), present(length), &
         & present(closer), present(force), present(strength)], &
         & 'radius contact_modulus work_of_adhesion length closer force strength', error)
      if (.not. allocated(error) .and. n > 0) call check_positive('radius', n, radius, 'm', error)
      if (.not. allocated(error) .and. n > 0) call check_positive('contact_modulus', n, contact_modulus, 'Pa', error)
      if (.not. allocated(error) .and. n > 0) call check_positive('work_of_adhesion', n, work_of_adhesion, 'J/m^2', error)
      outcome = status_of(error)
      if (allocated(error)) return
      do i = 1, n
         call get_sphere_units(radius(i), contact_modulus(i), work_of_adhesion(i), length(i), closer(i), force(i), strength(i))
      end do
   end function sphere_scales

end module adfric_c_sphere
