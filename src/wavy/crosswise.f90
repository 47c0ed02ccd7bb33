!> Sums the strips of a surface: one strip in 2-D; in 3-D an integral across the surface.
!>
!> The surface is symmetric about the crest line, so half a period is enough. Each panel of one regime is mapped by
!> \( \theta = \theta_0 + \Delta (1 - \cos\phi)/2 \): near a panel's ends forces go like half-integer powers of the
!> distance, which are smooth in \( \phi \). Gauss-Kronrod pairs on intervals that are halved where needed do the rest.
!> Saturated strips are summed in closed form, free ones not at all.
module adfric_wavy_crosswise
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_numerics_gauss, only: kronrod_nodes, kronrod_weights, kronrod_gauss_weights
   use adfric_wavy_panels, only: panel_t, division_t, divide_surface
   use adfric_wavy_steady_state, only: find_steady_state
   use adfric_wavy_strip, only: strip_t, steady_state_t, regime_free, regime_saturated
   use adfric_wavy_surface, only: negligible, surface_t, totals_t, new_surface_strip, share_at, add_strip, add_load_slope
   implicit none (type, external)
   private
   public :: memory_t, get_totals

   integer, parameter :: n_nodes = size(kronrod_nodes)
   !> Intervals that a surface may be divided into before the tolerance is given up.
   integer, parameter :: max_intervals = 400
   !> How many times more strips than usual are looked at in search of edges.
   integer, parameter :: finest = 32
   !> Intervals whose strips are remembered.
   integer, parameter :: n_remembered = 32

   !> Strips of the last surface that was summed, as first guesses for the next one.
   type :: memory_t
      !> The crest strips of the last surface and of the one before.
      type(steady_state_t) :: crest, before
      !> Do the surfaces change in equal steps, so that two of them foretell the next?
      logical :: is_even = .false.
      !> Is the change of the load with the penetration asked for?
      logical :: needs_slope = .true.
      type(steady_state_t), allocatable :: states(:, :)
      type(division_t) :: division
   end type memory_t

   !> A stretch of the mapped phase on one panel, and what its strips add up to.
   type :: interval_t
      type(panel_t) :: panel
      !> Number under which its strips are remembered.
      integer :: place = 0
      real(dp) :: start = 0, finish = pi
      type(totals_t) :: totals
      !> Errors of load and friction: of the rule, and of where the panel ends, which no finer rule takes away.
      real(dp) :: error(2) = 0, blur(2) = 0
      !> Are all strips in the regime of the panel?
      logical :: is_uniform = .true.
   end type interval_t

contains

   !> Forces and areas of a surface at a penetration.
   pure subroutine get_totals(surface, penetration, memory, totals, error)
      type(surface_t), intent(in) :: surface
      !> [h]
      real(dp), intent(in) :: penetration
      !> Guesses; they save time and change nothing. Out: the strips found.
      type(memory_t), intent(inout) :: memory
      type(totals_t), intent(out) :: totals
      !> Estimates of the quadrature errors of load and friction.
      real(dp), intent(out) :: error(2)
      type(strip_t) :: strip
      type(steady_state_t) :: crest
      type(totals_t) :: half

      error = 0
      call new_surface_strip(surface, penetration, 1.0_dp, strip)
      call find_steady_state(strip, surface%branch, crest, next_crest(memory))
      memory%before = memory%crest
      memory%crest = crest
      if (.not. surface%is_3d) then
         call add_strip(surface, strip, crest, 1.0_dp, 1.0_dp, totals)
         if (memory%needs_slope) call add_load_slope(strip, crest, 1.0_dp, totals)
         totals%n_closed_form = merge(1, 0, crest%regime == regime_saturated .or. crest%regime == regime_free)
      else if (surface%n_strips > 0) then
         call sum_equal_strips(surface, penetration, (surface%n_strips + 1)/2, crest, half, error)
         call sum_equal_strips(surface, penetration, surface%n_strips, crest, totals, error)
         ! what half as many strips would have given tells the error, but for that of jumps
         error = error + abs([totals%load - half%load, totals%friction - half%friction])
         totals%n_strips = totals%n_strips + half%n_strips
      else
         call integrate_strips(surface, penetration, memory, totals, error)
      end if
   end subroutine get_totals

   !> What the next crest strip is expected to be.
   pure type(steady_state_t) function next_crest(memory) result(next)
      type(memory_t), intent(in) :: memory
      real(dp) :: lengths(4), change(4)

      next = memory%crest
      if (.not. memory%is_even .or. memory%before%regime /= next%regime) return
      lengths = [next%half_width, pi - next%half_width, next%trailing, next%leading]
      change = next%half_width - memory%before%half_width
      change(2:4) = [-change(1), next%trailing - memory%before%trailing, next%leading - memory%before%leading]
      if (any(abs(change) > lengths/2)) return
      next%half_width = next%half_width + change(1)
      next%bound_width = 2*next%bound_width - memory%before%bound_width
      next%shift = 2*next%shift - memory%before%shift
      next%trailing = next%trailing + change(3)
      next%leading = next%leading + change(4)
   end function next_crest

   !> GM's sum of 2N strips of equal width.
   pure subroutine sum_equal_strips(surface, penetration, n_strips, crest, totals, jumps)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      !> On half a period.
      integer, intent(in) :: n_strips
      !> The strip of the crest line.
      type(steady_state_t), intent(in) :: crest
      type(totals_t), intent(inout) :: totals
      !> Half of what load and friction change by from strip to strip where the regime changes: the edge is in between.
      real(dp), intent(out) :: jumps(2)
      type(strip_t) :: strip
      type(steady_state_t) :: last, state
      type(totals_t) :: one
      real(dp) :: share, width, values(2), last_values(2)
      integer :: j

      last = crest
      last_values = 0
      jumps = 0
      width = 1.0_dp/n_strips
      do j = 0, n_strips
         ! the crest line itself is looked at, but not summed
         share = share_at(pi*max(j - 0.5_dp, 0.0_dp)*width)
         call new_surface_strip(surface, penetration, share, strip)
         state = crest
         if (j > 0) call find_steady_state(strip, surface%branch, state, last)
         one = totals_t()
         call add_strip(surface, strip, state, share, width, one)
         values = [one%load, one%friction]
         if (state%regime /= last%regime) jumps = jumps + abs(values - last_values)/2
         last = state
         last_values = values
         if (j == 0) cycle
         call add_load_slope(strip, state, width, one)
         one%n_closed_form = merge(1, 0, state%regime == regime_saturated .or. state%regime == regime_free)
         call add_totals(totals, one)
      end do
   end subroutine sum_equal_strips

   !> The integral over all strips, to the tolerance of the surface.
   pure subroutine integrate_strips(surface, penetration, memory, totals, error)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      type(memory_t), intent(inout) :: memory
      type(totals_t), intent(inout) :: totals
      real(dp), intent(out) :: error(2)
      type(interval_t), allocatable :: intervals(:)
      type(totals_t) :: closed
      integer :: n, worst, k, last_place, fineness
      logical :: is_fine, is_uniform, was_tracked

      if (.not. allocated(memory%states)) allocate (memory%states(n_nodes, n_remembered))
      allocate (intervals(n_remembered))
      closed = totals
      fineness = 1
      do
         was_tracked = memory%division%n_panels > 0
         call divide_surface(surface, penetration, fineness, memory%division)
         totals%n_strips = totals%n_strips + memory%division%n_strips
         call start_intervals(surface, penetration, memory, intervals, n, totals, is_uniform)
         if (is_uniform .or. fineness > finest) exit
         ! an edge was born since the last surface, or lies between the strips that were looked at: look closer
         if (.not. was_tracked) fineness = 4*fineness
         memory%division%n_panels = 0
         closed%n_strips = totals%n_strips
         totals = closed
      end do
      is_fine = n == 0
      last_place = n
      do while (.not. is_fine)
         call find_worst(surface%tolerance, totals, intervals(:n), worst, is_fine)
         if (is_fine .or. n == max_intervals) exit
         if (n == size(intervals)) intervals = [intervals, intervals]
         n = n + 1
         intervals(n) = intervals(worst)
         intervals(worst)%finish = (intervals(worst)%start + intervals(worst)%finish)/2
         intervals(n)%start = intervals(worst)%finish
         ! halves are remembered apart from the whole, which comes first next time
         intervals(worst)%place = last_place + 1
         intervals(n)%place = last_place + 2
         last_place = last_place + 2
         call integrate_interval(surface, penetration, intervals(worst), memory)
         call integrate_interval(surface, penetration, intervals(n), memory)
      end do
      error = 0
      do k = 1, n
         call add_totals(totals, intervals(k)%totals)
         error = error + intervals(k)%error + intervals(k)%blur
      end do
      totals%is_converged = totals%is_converged .and. is_fine
   end subroutine integrate_strips

   !> One interval for every panel that has no closed form, which is added to the totals.
   pure subroutine start_intervals(surface, penetration, memory, intervals, n, totals, is_uniform)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      type(memory_t), intent(inout) :: memory
      type(interval_t), intent(inout) :: intervals(:)
      integer, intent(out) :: n
      type(totals_t), intent(inout) :: totals
      !> Are all strips of each panel in its regime?
      logical, intent(out) :: is_uniform
      type(panel_t) :: panel
      integer :: k

      n = 0
      is_uniform = .true.
      do k = 1, memory%division%n_panels
         panel = memory%division%panels(k)
         if (panel%regime == regime_free .or. panel%finish <= panel%start) cycle
         if (panel%regime == regime_saturated .and. surface%steepness <= 0) then
            call add_saturated_panel(surface, penetration, panel, totals)
            cycle
         end if
         n = n + 1
         intervals(n) = interval_t(panel, n)
         call integrate_interval(surface, penetration, intervals(n), memory)
         is_uniform = is_uniform .and. intervals(n)%is_uniform
      end do
   end subroutine start_intervals

   !> The interval with the largest error, and whether all errors together are within the tolerance.
   pure subroutine find_worst(tolerance, base, intervals, worst, is_fine)
      real(dp), intent(in) :: tolerance
      !> What is summed in closed form.
      type(totals_t), intent(in) :: base
      type(interval_t), intent(in) :: intervals(:)
      integer, intent(out) :: worst
      logical, intent(out) :: is_fine
      type(totals_t) :: all_totals
      real(dp) :: scales(2), error(2), largest, weight
      integer :: k

      all_totals = base
      error = 0
      do k = 1, size(intervals)
         call add_totals(all_totals, intervals(k)%totals)
         error = error + intervals(k)%error
      end do
      ! a sum near zero cannot be had to a relative tolerance
      scales = max(abs([all_totals%load, all_totals%friction]), &
         & 0.01_dp*[all_totals%load_scale, all_totals%friction_scale], tiny(1.0_dp))
      ! nor can a friction that is nothing beside the load
      scales(2) = max(scales(2), negligible*scales(1))
      is_fine = all(error <= tolerance*scales)
      worst = 1
      largest = -1
      do k = 1, size(intervals)
         weight = maxval(intervals(k)%error/scales)
         if (weight <= largest) cycle
         largest = weight
         worst = k
      end do
   end subroutine find_worst

   !> Gauss-Kronrod pair on one interval.
   pure subroutine integrate_interval(surface, penetration, interval, memory)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      type(interval_t), intent(inout) :: interval
      type(memory_t), intent(inout) :: memory
      type(totals_t) :: node
      type(strip_t) :: strip
      type(steady_state_t) :: guess, state
      real(dp) :: phi, width, share, values(2, n_nodes), peak(2), half
      integer :: k

      interval%totals = totals_t()
      peak = 0
      state = steady_state_t()
      half = (interval%finish - interval%start)/2
      associate (panel => interval%panel, place => interval%place)
         do k = 1, n_nodes
            phi = (interval%start + interval%finish)/2 + half*kronrod_nodes(k)
            share = share_at(panel%start + (panel%finish - panel%start)*sin(phi/2)**2)
            ! dy = d theta/(2 pi), twice for both sides of the crest line
            width = (panel%finish - panel%start)/2*sin(phi)*half/pi
            call new_surface_strip(surface, penetration, share, strip)
            guess = state
            if (place <= n_remembered) then
               if (memory%states(k, place)%regime == panel%regime) guess = memory%states(k, place)
            end if
            call find_steady_state(strip, surface%branch, state, guess, guess%regime == panel%regime)
            interval%is_uniform = interval%is_uniform .and. state%regime == panel%regime
            if (place <= n_remembered) memory%states(k, place) = state
            node = totals_t()
            call add_strip(surface, strip, state, share, width, node)
            if (memory%needs_slope) call add_load_slope(strip, state, width, node)
            values(:, k) = [node%load, node%friction]
            peak = max(peak, abs(values(:, k))/width)
            call add_totals(interval%totals, node, kronrod_weights(k))
         end do
      end associate
      ! an end that is not known well moves the integral by what stands there
      interval%blur = interval%panel%blur/pi*peak
      interval%error = estimate_error(values) &
         & + epsilon(1.0_dp)*[interval%totals%load_scale, interval%totals%friction_scale]
   end subroutine integrate_interval

   !> Error of Kronrod's rule: its difference from Gauss's is the error of the lower rule; QUADPACK's exponent makes
   !> of it that of the higher one.
   pure function estimate_error(values) result(error)
      !> Load and friction at the nodes.
      real(dp), intent(in) :: values(2, n_nodes)
      real(dp) :: error(2), mean(2), variation(2)

      mean = matmul(values, kronrod_weights)/2
      variation = matmul(abs(values - spread(mean, 2, n_nodes)), kronrod_weights)
      error = abs(matmul(values, kronrod_weights - kronrod_gauss_weights))
      where (variation > 0) error = min(error, variation*(200*error/max(variation, tiny(1.0_dp)))**1.5_dp)
   end function estimate_error

   !> Saturated strips from start to finish in closed form (GM 17).
   pure subroutine add_saturated_panel(surface, penetration, panel, totals)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      type(panel_t), intent(in) :: panel
      type(totals_t), intent(inout) :: totals
      real(dp) :: width, first, second, load, friction

      ! integrals of 1, Y and Y^2 with Y = (1 + cos theta)/2
      width = panel%finish - panel%start
      first = (width + sin(panel%finish) - sin(panel%start))/2
      second = (1.5_dp*width + 2*(sin(panel%finish) - sin(panel%start)) &
         & + (sin(2*panel%finish) - sin(2*panel%start))/4)/4
      load = ((penetration - 1)*width + first/2)/pi
      friction = surface%foundation%loss*second/4
      totals%load = totals%load + load
      totals%load_slope = totals%load_slope + width/pi
      totals%load_scale = totals%load_scale + abs(load)
      totals%friction = totals%friction + friction
      totals%friction_scale = totals%friction_scale + friction
      totals%dissipation = totals%dissipation + friction
      totals%contact = totals%contact + width/pi
      totals%n_strips = totals%n_strips + 1
      totals%n_closed_form = totals%n_closed_form + 1
   end subroutine add_saturated_panel

   !> Add one sum to another, with a weight.
   pure subroutine add_totals(totals, part, weight)
      type(totals_t), intent(inout) :: totals
      type(totals_t), intent(in) :: part
      real(dp), intent(in), optional :: weight
      real(dp) :: w

      w = 1
      if (present(weight)) w = weight
      totals%load = totals%load + w*part%load
      totals%friction = totals%friction + w*part%friction
      totals%load_slope = totals%load_slope + w*part%load_slope
      totals%contact = totals%contact + w*part%contact
      totals%adhesion = totals%adhesion + w*part%adhesion
      totals%dissipation = totals%dissipation + w*part%dissipation
      totals%edge_loss = totals%edge_loss + w*part%edge_loss
      totals%load_mismatch = totals%load_mismatch + w*part%load_mismatch
      totals%energy_mismatch = totals%energy_mismatch + w*part%energy_mismatch
      totals%slope_error = totals%slope_error + w*part%slope_error
      totals%load_scale = totals%load_scale + w*part%load_scale
      totals%friction_scale = totals%friction_scale + w*part%friction_scale
      totals%n_strips = totals%n_strips + part%n_strips
      totals%n_closed_form = totals%n_closed_form + part%n_closed_form
      totals%is_converged = totals%is_converged .and. part%is_converged
   end subroutine add_totals

end module adfric_wavy_crosswise
