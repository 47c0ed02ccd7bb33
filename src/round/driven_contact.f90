! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact whose lateral spring is driven: the position of its path where h = D + T/k first reaches a value, with the states
!> themselves.
!>
!> The polynomials of the path know h to the round-off of its largest value. That says which position is the first one; of a small h
!> it leaves few digits, so the position is found again with the states themselves, between positions of which the polynomials are
!> certain.
module adfric_round_driven_contact
   use adfric_base_kinds, only: dp
   use adfric_round_pulled_contact, only: extension_at, first_reach, pulled_contact_t, pulled_curve_t, pulled_spot_t
   use adfric_round_stick_slip, only: stick_slip_t
   use adfric_numerics_secant_root, only: find_rising_root, rising_equation_t
   implicit none (type, external)
   private
   public :: find_driven_position, driven_error

   !> How far the position of the polynomials is looked for at first, relative, how much farther each time, and how often.
   real(dp), parameter :: first_width = 1.0e-13_dp, wider = 16.0_dp
   integer, parameter :: most_widenings = 60
   !> What the polynomials know of h, relative to its largest value.
   real(dp), parameter :: certain = 1.0e-11_dp
   !> At a small position h is about the second to fourth power of it: a guess of the slope of its logarithm.
   real(dp), parameter :: usual_power = 2.0_dp

   !> h over the value that it has to have, less 1, as a function of the logarithm of the position in a piece.
   type, extends(rising_equation_t) :: driven_position_t
      !> The contact.
      class(pulled_contact_t), allocatable :: contact
      !> The piece.
      integer :: piece = 1
      !> Stiffness of the spring, and the value.
      real(dp) :: stiffness = 1, extension = 1
   contains
      procedure :: evaluate => excess_extension
   end type driven_position_t

contains

   !> The position at a displacement of the base that has grown from rest. Beyond the largest h it slides, or in stick-slip the same
   !> positions come again and again, from the force of sliding up to the jump.
   pure subroutine find_driven_position(contact, curve, jump, stiffness, base, piece, position, is_reached)
      class(pulled_contact_t), intent(in) :: contact
      type(pulled_curve_t), intent(in) :: curve
      type(stick_slip_t), intent(in) :: jump
      !> Stiffness of the spring, > 0, and displacement of its base, >= 0.
      real(dp), intent(in) :: stiffness, base
      !> Receives the piece of the path.
      integer, intent(out) :: piece
      !> Receives the position in it, 0 to 1.
      real(dp), intent(out) :: position
      logical, intent(out) :: is_reached
      type(pulled_spot_t) :: spot
      real(dp) :: extension

      piece = 1
      position = 0
      extension = base
      if (jump%slides) then
         if (base > jump%base_displacement) extension = jump%base_displacement - jump%period &
            & + modulo(base - jump%base_displacement, jump%period)
      end if
      spot = pulled_spot_t(1, -1.0_dp)
      is_reached = .true.
      ! the largest h itself is reached
      if (extension > 0) call first_reach(curve, 1.0_dp, 1/stiffness, extension*(1 - 8*epsilon(extension)), pulled_spot_t(1, &
         & -1.0_dp), &
         & spot, is_reached)
      if (is_reached) call settle(contact, curve, stiffness, extension, spot, piece, position)
   end subroutine find_driven_position

   !> Relative error of the force on a driven spring: in stick-slip round-off of the displacement of the base is as much for a
   !> short way as for a long one, and each jump before adds what its own period is off.
   pure real(dp) function driven_error(jump, stiffness, base, force) result(error)
      type(stick_slip_t), intent(in) :: jump
      real(dp), intent(in) :: stiffness, base
      !> The force, >= 0.
      real(dp), intent(in) :: force
      ! digits of the displacement at a jump, which polynomials have found
      real(dp), parameter :: digits_of_jump = 4096*epsilon(1.0_dp)

      real(dp) :: n_jumps

      error = 0
      if (.not. jump%slides) return
      if (.not. (base > jump%base_displacement .and. force > 0)) return
      ! beyond so many no digit is left
      n_jumps = (base - jump%base_displacement)/max(jump%period, epsilon(error)*base)
      error = stiffness*(2*epsilon(error)*base + digits_of_jump*jump%base_displacement*n_jumps)
      error = error/max(error, force)
   end function driven_error

   !> The position with a given h, next to one that the polynomials have found.
   pure subroutine settle(contact, curve, stiffness, extension, spot, piece, position)
      class(pulled_contact_t), intent(in) :: contact
      type(pulled_curve_t), intent(in) :: curve
      !> Stiffness of the spring, and h.
      real(dp), intent(in) :: stiffness, extension
      type(pulled_spot_t), intent(in) :: spot
      integer, intent(out) :: piece
      real(dp), intent(out) :: position
      type(driven_position_t) :: equation
      real(dp) :: x, ends(2)
      logical :: is_between, is_converged

      associate (panel => curve%panels(spot%panel))
         piece = panel%piece
         position = panel%low + (panel%high - panel%low)*(1 + spot%x)/2
         if (.not. extension > 0) return
         ! next to rest the polynomials do not tell one position from another
         position = max(position, epsilon(position)*panel%high)
         allocate (equation%contact, source=contact)
         equation%piece = piece
         equation%stiffness = stiffness
         equation%extension = extension
         x = log(position)
         call find_bracket(curve, equation, spot%panel, x, ends, is_between)
         if (.not. is_between) return
         call find_rising_root(equation, ends(1), ends(2), usual_power, 2*epsilon(x), x, is_converged)
         if (is_converged) position = min(exp(x), 1.0_dp)
      end associate
   end subroutine settle

   !> Positions around one of the polynomials, before and behind the one of a given h.
   pure subroutine find_bracket(curve, equation, number, x, ends, is_between)
      type(pulled_curve_t), intent(in) :: curve
      type(driven_position_t), intent(in) :: equation
      !> Number of the panel.
      integer, intent(in) :: number
      !> Logarithm of the position.
      real(dp), intent(in) :: x
      !> Receive logarithms of the positions.
      real(dp), intent(out) :: ends(2)
      !> Are there such positions, of which the polynomials are certain?
      logical, intent(out) :: is_between
      real(dp) :: value, width, margin, position, within
      integer :: k

      ends = x
      is_between = .false.
      width = first_width
      do k = 1, most_widenings
         ends(1) = x - width
         call equation%evaluate(ends(1), value)
         if (value < 0) exit
         width = wider*width
      end do
      if (.not. value < 0) return
      associate (panel => curve%panels(number))
         margin = certain*sum(abs(panel%displacement) + abs(panel%force)/equation%stiffness)
         width = first_width
         do k = 1, most_widenings
            position = min(exp(x + width), panel%high)
            ends(2) = log(position)
            call equation%evaluate(ends(2), value)
            is_between = value > 0
            if (is_between .or. .not. position < panel%high) return
            ! beyond what the polynomials leave open there would be another position
            within = 2*(position - panel%low)/(panel%high - panel%low) - 1
            if (extension_at(curve, 1.0_dp, 1/equation%stiffness, pulled_spot_t(number, &
               & within)) > equation%extension + margin) return
            width = wider*width
         end do
      end associate
   end subroutine find_bracket

   !> See `driven_position_t`.
   pure subroutine excess_extension(self, x, value)
      class(driven_position_t), intent(in) :: self
      !> Logarithm of the position.
      real(dp), intent(in) :: x
      !> Receives h over its value, less 1.
      real(dp), intent(out) :: value
      real(dp) :: displacement, force

      call self%contact%get_state(self%piece, exp(x), displacement, force)
      value = displacement + force/self%stiffness
      value = value/self%extension - 1
   end subroutine excess_extension

end module adfric_round_driven_contact
