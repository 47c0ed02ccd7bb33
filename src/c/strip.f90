! SPDX-License-Identifier: GPL-3.0-or-later
!> The functions of adfric.h for wavy strips that slide, in batches.
module adfric_c_strip
   use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int32_t, c_int64_t, c_int8_t
   use adfric_base_error, only: error_t
   use adfric_c_batches, only: check_batch
   use adfric_c_texts, only: status_of
   use adfric_contact_strip, only: solve_strip_load, solve_strip_penetration
   implicit none (type, external)
   private

contains

   !> See adfric.h.
   integer(c_int) function strip_load(n, phase, ratio, stress, range, load, &
      & is_instantaneous, is_approach, penetration, friction, width, shift, status) &
      & bind(c, name='adfric_strip_load') result(outcome)
      integer(c_int64_t), intent(in), value :: n
      real(c_double), intent(in), optional :: phase(n), ratio(n), stress(n), range(n), load(n)
      integer(c_int8_t), intent(in), optional :: is_instantaneous(n), is_approach(n)
      real(c_double), intent(inout), optional :: penetration(n), friction(n), width(n), shift(n)
      integer(c_int32_t), intent(inout), optional :: status(n)
      type(error_t), allocatable :: error
      integer(c_int64_t) :: i
      logical :: jumps, is_loading

      call check_batch(n, [present(phase), present(ratio), present(stress), present(range), present(load), &
         & present(penetration), present(friction), present(width), present(shift), present(status)], &
         & 'phase ratio stress range load penetration friction width shift status', error)
      outcome = status_of(error)
      if (allocated(error)) return
      jumps = .false.
      is_loading = .false.
      do i = 1, n
         if (present(is_instantaneous)) jumps = is_instantaneous(i) /= 0
         if (present(is_approach)) is_loading = is_approach(i) /= 0
         call solve_strip_load(phase(i), ratio(i), stress(i), range(i), load(i), penetration(i), friction(i), &
            & width(i), shift(i), status(i), jumps, is_loading)
      end do
   end function strip_load

   !> See adfric.h.
   integer(c_int) function strip_penetration(n, phase, ratio, stress, range, penetration, &
      & is_instantaneous, is_approach, load, friction, width, shift, status) &
      & bind(c, name='adfric_strip_penetration') result(outcome)
      integer(c_int64_t), intent(in), value :: n
      real(c_double), intent(in), optional :: phase(n), ratio(n), stress(n), range(n), penetration(n)
      integer(c_int8_t), intent(in), optional :: is_instantaneous(n), is_approach(n)
      real(c_double), intent(inout), optional :: load(n), friction(n), width(n), shift(n)
      integer(c_int32_t), intent(inout), optional :: status(n)
      type(error_t), allocatable :: error
      integer(c_int64_t) :: i
      logical :: jumps, is_loading

      call check_batch(n, [present(phase), present(ratio), present(stress), present(range), present(penetration), &
         & present(load), present(friction), present(width), present(shift), present(status)], &
         & 'phase ratio stress range penetration load friction width shift status', error)
      outcome = status_of(error)
      if (allocated(error)) return
      jumps = .false.
      is_loading = .false.
      do i = 1, n
         if (present(is_instantaneous)) jumps = is_instantaneous(i) /= 0
         if (present(is_approach)) is_loading = is_approach(i) /= 0
         call solve_strip_penetration(phase(i), ratio(i), stress(i), range(i), penetration(i), load(i), friction(i), &
            & width(i), shift(i), status(i), jumps, is_loading)
      end do
   end function strip_penetration

end module adfric_c_strip
