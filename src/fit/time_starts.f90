! SPDX-License-Identifier: GPL-3.0-or-later
!> Starts of a fit over time: where contact begins in a history, and moduli, to which loads under a given approach are proportional.
module adfric_fit_time_starts
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_fit_objective, only: objective_t
   use adfric_fit_problem, only: fit_t, nuisance_load_offset
   use adfric_numerics_bounded_least_squares, only: squares_work_t
   implicit none (type, external)
   private
   public :: touch_of, level_moduli, scale_moduli

contains

   !> Where a contact begins in a history: from where the load has a tenth of its range while it grows, and from where it is
   !> largest, for a load that rises as the 1.5th power.
   pure real(dp) function touch_of(prescribed, load) result(touch)
      !> What is prescribed at the points, and the load, in the order of time.
      real(dp), intent(in) :: prescribed(:), load(:)
      real(dp), parameter :: share = 0.1_dp, power = 1.5_dp
      integer :: top, k

      touch = 0
      if (size(load) == 0) return
      top = maxloc(load, 1)
      do k = top, 1, -1
         if (load(k) < minval(load) + share*(load(top) - minval(load))) exit
      end do
      if (k == 0 .or. .not. prescribed(top) > prescribed(max(k, 1))) return
      associate (part => share**(1/power))
         touch = (prescribed(k) - part*prescribed(top))/(1 - part)
      end associate
   end function touch_of

   !> Which free variables are moduli?
   pure function are_moduli(fit) result(is_modulus)
      type(fit_t), intent(in) :: fit
      logical :: is_modulus(size(fit%frees))
      integer :: k

      is_modulus = .false.
      do k = 1, size(is_modulus)
         if (fit%frees(k)%variable > 0) is_modulus(k) = fit%model%variables(fit%frees(k)%variable)%unit == 'Pa'
      end do
   end function are_moduli

   !> A modulus without a start is as large as the largest that has one; an exponent of a power law has that of many soft samples.
   pure subroutine level_moduli(fit, v)
      !> What is fitted.
      type(fit_t), intent(in) :: fit
      !> Values of the free variables; moduli and exponents are changed.
      real(dp), intent(inout) :: v(:)
      real(dp), parameter :: usual_exponent = 0.2_dp
      logical :: has_start(size(v))
      integer :: k

      has_start = are_moduli(fit) .and. is_set(fit%frees%start)
      if (any(has_start)) where (are_moduli(fit) .and. .not. has_start) v = maxval(v, has_start)
      do k = 1, size(v)
         if (fit%frees(k)%variable == 0 .or. is_set(fit%frees(k)%start)) cycle
         if (fit%model%variables(fit%frees(k)%variable)%name == 'power_law_exponent') v(k) = usual_exponent
      end do
   end subroutine level_moduli

   !> Multiply all moduli by what loads are of those of the model, by least squares.
   subroutine scale_moduli(self, fit, work, q, v)
      !> The sum of squares.
      type(objective_t), intent(inout) :: self
      !> What is fitted.
      type(fit_t), intent(in) :: fit
      !> Space of an evaluation.
      type(squares_work_t), intent(inout) :: work
      !> The numbers that are fitted.
      real(dp), intent(in) :: q(:)
      !> Values of the free variables; moduli are changed.
      real(dp), intent(inout) :: v(:)
      real(dp) :: product, square, cost
      logical :: is_valid
      integer :: k

      if (.not. any(are_moduli(fit))) return
      call self%evaluate(q, work%n_rows, work%r, work%j, cost, is_valid)
      if (.not. is_valid) return
      product = 0
      square = 0
      do k = 1, size(self%others)
         associate (curve => self%others(k))
            if (.not. allocated(fit%data_sets(curve%data_set)%prescribed) .or. .not. curve%points%is_load) cycle
            associate (zero => self%nuisance(nuisance_load_offset, curve%data_set))
               product = product + sum((curve%fitted - zero)*(curve%y - zero)/curve%sigma**2)
               square = square + sum(((curve%fitted - zero)/curve%sigma)**2)
            end associate
         end associate
      end do
      if (product > 0 .and. square > 0) where (are_moduli(fit)) v = v*product/square
   end subroutine scale_moduli

end module adfric_fit_time_starts
