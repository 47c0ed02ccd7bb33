! SPDX-License-Identifier: GPL-3.0-or-later
!> Where a path in closed form ends while friction takes from adhesion: JKR, DMT (`adfric_round_weak_contact`).
module adfric_round_weak_end
   use adfric_base_kinds, only: dp
   use adfric_round_curve, only: control_approach, control_load, control_spring, get_stability_factor
   use adfric_round_shape, only: piece_t, spot_t
   use adfric_round_spring_pieces, only: divide_pieces, most_divided_pieces
   use adfric_round_weak_path, only: weak_path_t
   implicit none (type, external)
   private
   public :: find_closed_end

contains

   !> Where a path in closed form ends.
   pure subroutine find_closed_end(self)
      type(weak_path_t), intent(inout) :: self
      type(piece_t) :: pieces(most_divided_pieces)
      type(spot_t) :: spot
      real(dp) :: high
      integer :: k, n
      logical :: is_first

      associate (shape => self%curve%shape, start => self%nodes(1)%contact)
         n = shape%n_pieces
         pieces(:n) = shape%pieces(:n)
         if (self%control == control_spring) call divide_pieces(shape, self%curve%compliance, pieces, n)
         do k = n, 1, -1
            is_first = pieces(k)%is_beyond .eqv. start%is_beyond
            if (pieces(k)%is_beyond .and. .not. start%is_beyond) cycle
            if (is_first .and. pieces(k)%low > start%u) cycle
            high = pieces(k)%high
            if (is_first) high = min(high, start%u)
            self%low = pieces(k)%low
            self%low_is_beyond = pieces(k)%is_beyond
            if (.not. self%curve%tension > 0 .or. .not. closed_margin(self, self%low, self%low_is_beyond) < 0) cycle
            self%is_lost = .true.
            self%low = closed_fold(self, pieces(k)%is_beyond, pieces(k)%low, high)
            exit
         end do
         call shape%evaluate(self%low, self%low_is_beyond, spot)
         if (self%curve%tension > 0) then
            ! a face whose edge is reached lets go there
            if (shape%has_face .and. .not. self%is_lost) self%is_lost = neck_of(self, spot) > 0
            if (self%is_lost) self%least_ratio = min((neck_of(self, spot)/self%curve%tension)**2/spot%radius, 1.0_dp)
         else if (self%curve%outer_pull > 0 .and. self%control == control_load .and. self%given < 0) then
            ! DMT ends as a point
            self%is_lost = .true.
            self%least_ratio = -self%given/self%curve%outer_pull
         end if
      end associate
   end subroutine find_closed_end

   !> Dl of a spot, of what is prescribed.
   pure real(dp) function neck_of(self, spot) result(neck)
      type(weak_path_t), intent(in) :: self
      !> What the shape is there, of a radius > 0.
      type(spot_t), intent(in) :: spot

      neck = excess_of(self, spot)/share_of(self, spot)
   end function neck_of

   !> N = P1 - P, g - delta or g + s P1 - base.
   pure real(dp) function excess_of(self, spot) result(excess)
      type(weak_path_t), intent(in) :: self
      type(spot_t), intent(in) :: spot

      select case (self%control)
      case (control_load)
         excess = spot%load - self%given
      case (control_approach)
         excess = spot%depth - self%given
      case default
         excess = spot%depth + self%curve%compliance*spot%load - self%given
      end select
   end function excess_of

   !> d = 2 a, 1 or 1 + 2 s a.
   pure real(dp) function share_of(self, spot) result(share)
      type(weak_path_t), intent(in) :: self
      type(spot_t), intent(in) :: spot

      share = 1
      if (self%control == control_load) share = 2*spot%radius
      if (self%control == control_spring) share = 1 + 2*self%curve%compliance*spot%radius
   end function share_of

   !> (a g' d/q - N) da/du: > 0 where the state of JKR on the path is stable.
   pure real(dp) function closed_margin(self, u, is_beyond) result(margin)
      type(weak_path_t), intent(in) :: self
      !> The unknown, >= 0.
      real(dp), intent(in) :: u
      logical, intent(in) :: is_beyond
      type(spot_t) :: spot
      real(dp) :: factor, slope

      call self%curve%shape%evaluate(u, is_beyond, spot)
      call get_stability_factor(self%curve, self%control, spot%radius, factor, slope)
      margin = spot%radius*spot%depth_slope*share_of(self, spot)/factor - excess_of(self, spot)*spot%radius_slope
   end function closed_margin

   !> Where the margin is 0, by the method of Illinois.
   pure real(dp) function closed_fold(self, is_beyond, first, last) result(fold)
      type(weak_path_t), intent(in) :: self
      !> Do the positions lie beyond the corner?
      logical, intent(in) :: is_beyond
      !> Positions of an unstable and of a stable state.
      real(dp), intent(in) :: first, last
      integer, parameter :: most_steps = 200
      real(dp) :: low, high, at_low, at_high, value
      integer :: k, side

      low = first
      high = last
      at_low = closed_margin(self, low, is_beyond)
      at_high = max(closed_margin(self, high, is_beyond), 0.0_dp)
      fold = high
      side = 0
      do k = 1, most_steps
         if (.not. at_high > 0 .or. high - low <= 2*epsilon(high)*high) exit
         fold = low + (high - low)*(at_low/(at_low - at_high))
         if (.not. (fold > low .and. fold < high) .or. modulo(k, 4) == 0) fold = low + (high - low)/2
         value = closed_margin(self, fold, is_beyond)
         if (value < 0) then
            low = fold
            at_low = value
            if (side == 1) at_high = at_high/2
            side = 1
         else
            high = fold
            at_high = value
            if (side == 2) at_low = at_low/2
            side = 2
         end if
      end do
      fold = high
   end function closed_fold

end module adfric_round_weak_end
