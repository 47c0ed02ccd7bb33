! SPDX-License-Identifier: GPL-3.0-or-later
!> What can be measured of a sphere, as a unit times a function of the state.
module adfric_fit_ordinate
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_fit_sphere_basis, only: basis_t, of_radius, of_modulus, of_work, of_strength
   use adfric_fit_state, only: fit_state_t
   use adfric_round_sphere_variables, only: out => sphere_output
   implicit none (type, external)
   private
   public :: ordinate_t, get_ordinate, get_unit, is_ordinate

   !> A function of the state, and its derivatives: `_t` by the index, `_l` by lambda, `_x` by the edge fraction.
   type :: ordinate_t
      !> The value and its derivatives.
      real(dp) :: y = 0, y_t = 0, y_tt = 0, y_l = 0, y_x = 0
   end type ordinate_t

contains

   !> Is a result of the model `sphere` one of these?
   pure logical function is_ordinate(index)
      integer, intent(in) :: index

      is_ordinate = any(index == [out%load, out%approach, out%contact_radius, out%adhesion_radius, out%friction_radius, &
         & out%contact_area, &
         & out%friction_area, out%friction_force])
   end function is_ordinate

   !> The unit of an ordinate, and the derivatives of its logarithm by the numbers that are fitted.
   pure subroutine get_unit(index, basis, unit, by_free)
      integer, intent(in) :: index
      type(basis_t), intent(in) :: basis
      !> Receives the unit.
      real(dp), intent(out) :: unit
      !> Receives the derivatives; shape `(n_free)`.
      real(dp), intent(out) :: by_free(:)

      associate (b => basis%by_free)
         select case (index)
         case (out%load)
            unit = basis%force
            by_free = b(:, of_work) + b(:, of_radius)
            return
         case (out%approach)
            unit = basis%approach
            by_free = (2*b(:, of_work) + b(:, of_radius) - 2*b(:, of_modulus))/3
            return
         case default
            unit = basis%length
            by_free = (b(:, of_work) + 2*b(:, of_radius) - b(:, of_modulus))/3
         end select
         if (.not. any(index == [out%contact_area, out%friction_area, out%friction_force])) return
         unit = pi*unit**2
         by_free = 2*by_free
         if (index /= out%friction_force) return
         unit = basis%strength*unit
         by_free = by_free + b(:, of_strength)
      end associate
   end subroutine get_unit

   !> The function of the state.
   pure subroutine get_ordinate(index, edge, s, o)
      integer, intent(in) :: index
      !> Edge fraction x.
      real(dp), intent(in) :: edge
      type(fit_state_t), intent(in) :: s
      !> Receives the function and its derivatives.
      type(ordinate_t), intent(out) :: o

      select case (index)
      case (out%load)
         o = ordinate_t(s%p, s%p_t, s%p_tt, s%p_l)
         return
      case (out%approach)
         o = ordinate_t(s%d, s%d_t, s%d_tt, s%d_l)
         return
      case (out%contact_radius, out%contact_area)
         o = ordinate_t(s%a, s%a_t, s%a_tt, s%a_l)
      case (out%adhesion_radius)
         o = ordinate_t(s%c, s%c_t, s%c_tt, s%c_l)
      case default
         ! without contact nothing rubs
         if (s%a > 0) o = ordinate_t(s%a + edge*(s%c - s%a), s%a_t + edge*(s%c_t - s%a_t), s%a_tt + edge*(s%c_tt - s%a_tt), &
            & s%a_l + edge*(s%c_l - s%a_l), s%c - s%a)
      end select
      if (.not. any(index == [out%contact_area, out%friction_area, out%friction_force])) return
      o%y_x = 2*o%y*o%y_x
      o%y_l = 2*o%y*o%y_l
      o%y_tt = 2*(o%y_t**2 + o%y*o%y_tt)
      o%y_t = 2*o%y*o%y_t
      o%y = o%y**2
   end subroutine get_ordinate

end module adfric_fit_ordinate
