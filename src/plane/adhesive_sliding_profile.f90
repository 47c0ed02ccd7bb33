! SPDX-License-Identifier: GPL-3.0-or-later
!> Pressure and gap along an adhesive sliding wave or cylinder, and how well the conditions of contact are met.
!>
!> Pressure in contact: twice the pressure is the imaginary part of the function whose real part is v',
!>
!>     p = sqrt(Q) [E' cos((m + x)/2) + E'' sin((m + x)/2)] - p0 + (2 p0/pi) [atan(|tau|/tau_l) - atan(|tau|/tau_t)]
!>         + (1/2) sqrt(Q) sum_i C_i PV integral e_i(y)/[pi sqrt(Q(y)) S(x - y)] dy
!>
!> with Q = sin sin of half the distances from both edges. The integral over a constant is 0, so e_i(x) is taken off.
!> The gap is what opens from the nearest end of a zone, where it is 0 or the range.
module adfric_plane_adhesive_sliding_profile
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_numerics_libm, only: expm1
   use adfric_plane_adhesive_sliding_nodes, only: nodes_t, get_nodes
   use adfric_plane_adhesive_sliding_slopes, only: slopes_outside
   use adfric_plane_adhesive_sliding_zones, only: adhesive_slide_t, slide_zones_t, outer_nodes_t, chord, set_layers
   implicit none (type, external)
   private
   public :: slide_profile_t, new_slide_profile, slide_pressure, slide_gap, slide_violation, zone_violation, may_bulge

   !> Positions in contact and in the free gap where the conditions are checked.
   integer, parameter :: n_positions = 12
   !> Length of a free gap below which zones are looked at.
   real(dp), parameter :: short_gap = 0.1_dp

   !> What a profile needs of a state.
   type :: slide_profile_t
      !> The wave or cylinder.
      type(adhesive_slide_t) :: slide
      !> Its state.
      type(slide_zones_t) :: zones
      !> Positions in the contact.
      type(nodes_t) :: inner
      !> Weights of the kernel, and layers of the arms (`set_layers`).
      real(dp), allocatable :: kernel_weights(:), layers(:, :)
   end type slide_profile_t

contains

   !> The profile of a state.
   pure subroutine new_slide_profile(slide, zones, profile)
      type(adhesive_slide_t), intent(in) :: slide
      !> A state that was evaluated.
      type(slide_zones_t), intent(in) :: zones
      type(slide_profile_t), intent(out) :: profile

      profile%slide = slide
      profile%zones = zones
      call set_layers(slide, zones, profile%inner, profile%kernel_weights, profile%layers)
   end subroutine new_slide_profile

   !> Pressure in the contact [E0 k D; for a cylinder E0 times the unit of length over R].
   pure real(dp) function slide_pressure(profile, left, right) result(pressure)
      type(slide_profile_t), intent(in) :: profile
      !> Distances from the trailing and from the leading edge, > 0.
      real(dp), intent(in) :: left, right
      real(dp) :: x, root, tau, storage, loss, distance(size(profile%inner%weights)), own
      integer :: i

      associate (slide => profile%slide, z => profile%zones, s => profile%slide%solid)
         x = z%middle - z%half_width + left
         if (right < left) x = z%middle + z%half_width - right
         root = sqrt(chord(slide%is_wave, left)*chord(slide%is_wave, right))
         tau = sqrt(chord(slide%is_wave, right)/chord(slide%is_wave, left))
         pressure = root/2
         if (slide%is_wave) then
            call s%get_complex_ratio(storage, loss)
            pressure = (root/2)*(storage*cos((z%middle + x)/2) + loss*sin((z%middle + x)/2))
         end if
         pressure = pressure - slide%stress + (2*slide%stress/pi)*(atan(tau/z%tau_leading) - atan(tau/z%tau_trailing))
         if (s%n_arms == 0) return
         ! y - x, from the edge that is nearer to x
         distance = profile%inner%left - left
         if (right < left) distance = right - profile%inner%right
         do i = 1, s%n_arms
            own = exp(-right/s%relaxation(i))
            pressure = pressure + (root/2)*(z%amplitudes(i) - merge(0.0_dp, s%ratios(i)*s%relaxation(i), slide%is_wave)) &
               & *sum(profile%kernel_weights*rise_over_chord(slide%is_wave, distance, s%relaxation(i), own, &
               & profile%layers(:, i)))
         end do
      end associate
   end function slide_pressure

   !> [e(y) - e(x)]/S(x - y) for e that rises as exp(x/a), without a number that is too large.
   elemental real(dp) function rise_over_chord(is_wave, d, a, own, other)
      logical, intent(in) :: is_wave
      !> y - x, the relaxation length, e(x) and e(y).
      real(dp), intent(in) :: d, a, own, other

      if (d > 0) then
         rise_over_chord = -other*expm1(-d/a)/chord(is_wave, -d)
      else if (d < 0) then
         rise_over_chord = own*expm1(d/a)/chord(is_wave, -d)
      else
         rise_over_chord = -own/a
      end if
   end function rise_over_chord

   !> Gap beside the contact [D; for a cylinder the unit of length squared over R].
   pure real(dp) function slide_gap(profile, distance, is_trailing) result(gap)
      type(slide_profile_t), intent(in) :: profile
      !> Distance from the leading edge, along the motion; for a cylinder also that from the trailing edge, against it. > 0, and
      !> less than the gap is long.
      real(dp), intent(in) :: distance
      !> Is it the distance from the trailing edge of a cylinder?
      logical, intent(in) :: is_trailing
      real(dp) :: free_end, end_elements(profile%slide%solid%n_arms)

      associate (slide => profile%slide, z => profile%zones)
         if (slide%is_wave) then
            free_end = z%leading + z%free
            if (distance < z%leading) then
               gap = slide%range - opening_between(profile, distance, z%leading, z%piece_end(:, 1), .false.)
            else if (distance < free_end) then
               gap = slide%range - opening_between(profile, distance, free_end, z%piece_end(:, 2), .false.)
            else
               gap = -opening_between(profile, distance, free_end + z%trailing, z%piece_end(:, 3), .false.)
            end if
         else if (is_trailing) then
            if (distance < z%trailing) then
               gap = -opening_between(profile, 0.0_dp, distance, z%piece_end(:, 3), .true.)
            else
               gap = slide%range - opening_between(profile, z%trailing, distance, z%trailing_end, .true.)
            end if
         else if (distance < z%leading) then
            gap = slide%range - opening_between(profile, distance, z%leading, z%piece_end(:, 1), .false.)
         else
            call find_elements_ahead(profile, distance, end_elements)
            gap = slide%range + opening_between(profile, z%leading, distance, end_elements, .false.)
         end if
      end associate
   end function slide_gap

   !> Kelvin elements ahead of a cylinder.
   pure subroutine find_elements_ahead(profile, distance, elements)
      type(slide_profile_t), intent(in) :: profile
      real(dp), intent(in) :: distance
      real(dp), intent(out) :: elements(:)
      type(outer_nodes_t) :: outer
      real(dp), allocatable :: slopes(:)
      real(dp) :: length
      integer :: j

      if (size(elements) == 0) return
      length = 45*profile%slide%solid%retardation(size(elements))
      call set_range_nodes(profile, distance, distance + length, .false., outer)
      call get_slopes(profile, outer, .false., slopes)
      do j = 1, size(elements)
         elements(j) = sum(outer%weights*exp(-(outer%from_leading - distance)/profile%slide%solid%retardation(j))*slopes) &
            & /profile%slide%solid%retardation(j)
      end do
   end subroutine find_elements_ahead

   !> The integral of u' - h' over a range that crosses no end of a zone.
   pure real(dp) function opening_between(profile, from, to, end_elements, is_trailing) result(opening)
      type(slide_profile_t), intent(in) :: profile
      !> Distances, see `slide_gap`.
      real(dp), intent(in) :: from, to
      !> Kelvin elements at the right end of the range.
      real(dp), intent(in) :: end_elements(:)
      logical, intent(in) :: is_trailing
      type(outer_nodes_t) :: outer
      real(dp), allocatable :: slopes(:), left(:)
      real(dp) :: x, b
      integer :: j

      associate (slide => profile%slide, z => profile%zones)
         opening = 0
         if (.not. to > from) return
         call set_range_nodes(profile, from, to, is_trailing, outer)
         call get_slopes(profile, outer, is_trailing, slopes)
         left = outer%from_leading - from
         x = z%middle + z%half_width + from
         if (is_trailing) left = to - outer%to_trailing
         if (is_trailing) x = z%middle - z%half_width - to
         opening = sum(outer%weights*slopes) + 2*sin(x + (to - from)/2)*sin((to - from)/2)
         if (.not. slide%is_wave) opening = sum(outer%weights*slopes) + (x + (to - from)/2)*(to - from)
         do j = 1, slide%solid%n_arms
            b = slide%solid%retardation(j)
            ! b times the change of an element, of which a long retardation length leaves no difference of digits
            opening = opening - slide%compliances(j)*(b*expm1(-(to - from)/b)*end_elements(j) &
               & + sum(outer%weights*exp(-left/b)*slopes))
         end do
      end associate
   end function opening_between

   !> v' at positions.
   pure subroutine get_slopes(profile, outer, is_trailing, slopes)
      type(slide_profile_t), intent(in) :: profile
      type(outer_nodes_t), intent(in) :: outer
      logical, intent(in) :: is_trailing
      real(dp), allocatable, intent(out) :: slopes(:)
      real(dp) :: columns(size(outer%weights), 0:profile%slide%solid%n_arms)

      call slopes_outside(profile%slide, profile%zones, profile%inner, profile%kernel_weights, profile%layers, outer, is_trailing, &
         & columns)
      slopes = columns(:, 0) + matmul(columns(:, 1:), profile%zones%amplitudes)
   end subroutine get_slopes

   !> Positions of a range beside the contact.
   pure subroutine set_range_nodes(profile, from, to, is_trailing, outer)
      type(slide_profile_t), intent(in) :: profile
      real(dp), intent(in) :: from, to
      logical, intent(in) :: is_trailing
      type(outer_nodes_t), intent(out) :: outer
      type(nodes_t) :: nodes
      real(dp) :: shortest, far

      associate (slide => profile%slide, z => profile%zones, s => profile%slide%solid)
         shortest = min(z%half_width, z%leading, z%trailing, to - from)
         if (s%n_arms > 0) shortest = min(shortest, s%relaxation(1))
         call get_nodes(to - from, [shortest, shortest], 38.0_dp, slide%refinement, nodes)
         outer%weights = nodes%weights
         if (is_trailing) then
            outer%to_trailing = from + nodes%right
            outer%to_c_trailing = merge((from - z%trailing) + nodes%right, -((z%trailing - to) + nodes%left), from >= z%trailing)
            outer%from_leading = outer%to_trailing + 2*z%half_width
            outer%from_c_leading = outer%from_leading + z%leading
            return
         end if
         outer%from_leading = from + nodes%left
         outer%from_c_leading = merge((from - z%leading) + nodes%left, -((z%leading - to) + nodes%right), from >= z%leading)
         if (slide%is_wave) then
            far = z%leading + z%free
            outer%to_trailing = max(far + z%trailing - to, 0.0_dp) + nodes%right
            outer%to_c_trailing = merge((far - to) + nodes%right, -((from - far) + nodes%left), to <= far)
         else
            outer%to_trailing = outer%from_leading + 2*z%half_width
            outer%to_c_trailing = outer%to_trailing + z%trailing
         end if
      end associate
   end subroutine set_range_nodes

   !> Largest violation of p >= -p0 in contact and of g >= d0 in the free gap, over p0 and d0; negative if there is none.
   pure real(dp) function slide_violation(profile) result(violation)
      type(slide_profile_t), intent(in) :: profile
      real(dp) :: length, share
      integer :: i

      associate (slide => profile%slide, z => profile%zones)
         violation = -huge(1.0_dp)
         length = 2*z%half_width
         do i = 1, n_positions
            share = (1 - cos(pi*(i - 0.5_dp)/n_positions))/2
            violation = max(violation, -1 - slide_pressure(profile, length*share, length*(1 - share))/slide%stress)
            if (slide%is_wave) violation = max(violation, 1 - slide_gap(profile, z%leading + z%free*share, .false.)/slide%range)
            if (slide%is_wave) cycle
            violation = max(violation, 1 - slide_gap(profile, z%leading + 4*(length + z%leading)*share, .false.)/slide%range, &
               & 1 - slide_gap(profile, z%trailing + 4*(length + z%trailing)*share, .true.)/slide%range)
         end do
         if (slide%is_wave .and. may_bulge(z)) violation = max(violation, zone_violation(profile))
      end associate
   end function slide_violation

   !> May the gap be larger in the middle of a zone than at its end? So it is where most of the gap of a wave is zones.
   pure logical function may_bulge(zones)
      type(slide_zones_t), intent(in) :: zones

      may_bulge = zones%free < max(short_gap, zones%leading, zones%trailing)
   end function may_bulge

   !> Largest violation of g <= d0 in the zones of a wave, over d0; below 0 if there is none.
   pure real(dp) function zone_violation(profile) result(violation)
      type(slide_profile_t), intent(in) :: profile
      real(dp) :: share
      integer :: i

      associate (range => profile%slide%range, z => profile%zones)
         violation = -1
         do i = 1, n_positions
            share = sin(pi*(i - 0.5_dp)/(2*n_positions))
            violation = max(violation, slide_gap(profile, z%leading*share, .false.)/range - 1, &
               & slide_gap(profile, z%leading + z%free + z%trailing*(1 - share), .false.)/range - 1)
         end do
      end associate
   end function zone_violation

end module adfric_plane_adhesive_sliding_profile
