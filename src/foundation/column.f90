! SPDX-License-Identifier: GPL-3.0-or-later
!> Displacement and pressure under one strip at any phase of its steady state.
module adfric_foundation_column
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_foundation_contact_zone, only: decay
   use adfric_foundation_strip, only: strip_t, profile, lifted_profile, steady_state_t, regime_free, regime_saturated, &
      & regime_adhesion_only, regime_adhesion_zones
   implicit none (type, external)
   private
   public :: get_column

contains

   !> Displacement and pressure at a phase, in units of the strip.
   elemental subroutine get_column(strip, state, xi, displacement, pressure)
      type(strip_t), intent(in) :: strip
      !> Steady state of the strip, which tells where its zones end.
      type(steady_state_t), intent(in) :: state
      !> Phase [rad]; the crest is at 0.
      real(dp), intent(in) :: xi
      !> Displacement of the foundation at the phase, positive into the foundation [c].
      real(dp), intent(out) :: displacement
      !> Pressure at the phase, compression positive [c/K].
      real(dp), intent(out) :: pressure
      real(dp) :: passed, trailing, start, excess

      select case (state%regime)
      case (regime_free)
         displacement = 0
         pressure = 0
         return
      case (regime_saturated)
         displacement = profile(strip, xi)
         pressure = strip%mean + steady_pressure(strip, xi)
         return
      case (regime_adhesion_only)
         trailing = 2*state%half_width
         if (trailing >= two_pi) then
            displacement = -strip%adhesion%stress
            pressure = -strip%adhesion%stress
            return
         end if
         start = state%shift + state%half_width
         passed = modulo(start - xi, two_pi)
         excess = lifted_profile(strip, start) + strip%adhesion%attach_gap - strip%adhesion%jump
      case default
         ! phase passed since the contact began
         start = state%shift + state%half_width
         passed = modulo(start - xi, two_pi)
         if (passed <= 2*state%half_width) then
            displacement = profile(strip, xi)
            pressure = strip%mean + steady_pressure(strip, xi) + (state%entry - strip%level &
               & - steady_pressure(strip, start))*(1 - decay(passed/strip%foundation%u))
            return
         end if
         passed = passed - 2*state%half_width
         trailing = two_pi - 2*state%half_width
         if (state%regime == regime_adhesion_zones) trailing = state%trailing
         excess = lifted_profile(strip, state%shift - state%half_width)
      end select
      call get_open_column(strip, state, trailing, excess, passed, displacement, pressure)
   end subroutine get_column

   !> Pressure of endless contact, above the mean level.
   elemental real(dp) function steady_pressure(strip, xi)
      type(strip_t), intent(in) :: strip
      real(dp), intent(in) :: xi

      steady_pressure = strip%foundation%storage*cos(xi) + strip%foundation%loss*sin(xi)
   end function steady_pressure

   !> A column that has left the contact, or entered adhesion: adhesion, free, adhesion again.
   elemental subroutine get_open_column(strip, state, trailing, excess, passed, displacement, pressure)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      !> Length of the first zone of adhesion [rad].
      real(dp), intent(in) :: trailing
      !> Displacement + stress where that zone begins [c].
      real(dp), intent(in) :: excess
      !> Phase passed since that zone began [rad].
      real(dp), intent(in) :: passed
      real(dp), intent(out) :: displacement, pressure
      real(dp) :: free, w, edge

      associate (v => strip%foundation%v)
         if (passed <= trailing) then
            pressure = -strip%adhesion%stress
            displacement = pressure + excess*(1 - decay(passed/v))
            return
         end if
         w = excess*(1 - decay(trailing/v)) - strip%adhesion%stress + strip%adhesion%jump
         free = two_pi - 2*state%half_width - trailing - state%leading
         if (state%regime == regime_adhesion_only) free = two_pi - trailing
         if (passed <= trailing + free) then
            pressure = 0
            displacement = w*(1 - decay((passed - trailing)/v))
            return
         end if
         edge = state%shift + state%half_width + state%leading
         w = lifted_profile(strip, edge) + strip%adhesion%attach_gap - strip%adhesion%jump
         pressure = -strip%adhesion%stress
         displacement = pressure + w*(1 - decay((passed - trailing - free)/v))
      end associate
   end subroutine get_open_column

end module adfric_foundation_column
