! SPDX-License-Identifier: GPL-3.0-or-later
!> Random cases of any model, drawn from its table of variables.
!>
!> Numbers are drawn about sizes that fit together: a length, a stress and a time are drawn first, and every variable lies within
!> some decades of what these make of its unit. What the model finds wrong with the values together is drawn anew, or left out.
module search_draw
   use adfric_base_constants, only: two_pi
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: count_words
   use adfric_input_variable, only: is_in_range
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: variable_t, kind_real, kind_integer, kind_logical, kind_choice, kind_dataset
   use random_dice, only: dice_t
   use search_data, only: drawn_data_t, draw_data
   use search_units, only: n_dimensions, dimensions_of, unit_in_case
   implicit none (type, external)
   private
   public :: drawn_case_t, draw_case

   !> How often a case is mended before it is given up.
   integer, parameter :: max_repairs = 60
   !> How often a case of a drawn spectrum begins anew, whose solid or interface is not to be mended, and one of a body whose cells
   !> are too few for adhesion; how often one of Hertz's, which has one of many prescribed quantities, and one of an elastic surface.
   integer, parameter :: max_starts = 6, starts_of_some = 3
   !> Points of a block of neighbours.
   integer, parameter :: n_neighbours = 6
   !> Shares of cases with profiles; of numbers that are 0, or at a bound, or left at their default; of optional numbers that are
   !> given.
   real(dp), parameter :: share_with_profiles = 0.05_dp, share_zero = 0.04_dp, share_at_bound = 0.05_dp, &
      & share_default = 0.6_dp, share_given = 0.4_dp
   !> Decades of a size that is drawn about 1, for cases of usual and of any size.
   real(dp), parameter :: usual_decades = 9, many_decades = 60
   !> Shares of cases of any size, and of those whose variables have nothing to do with each other.
   real(dp), parameter :: share_any_size = 0.1_dp, share_wild = 0.03_dp, wild_decades = 40

   !> A case: neighbouring points.
   type :: drawn_case_t
      !> Shape `(n_variables, n_points)`.
      real(dp), allocatable :: values(:, :)
      !> Position of the variable in which the points differ, rising.
      integer :: swept = 0
      !> Datasets, whether the case takes them or not.
      type(drawn_data_t), allocatable :: data(:)
      !> Does the case lie within a rounding of where its answer changes, as hard cases do?
      logical :: is_hard = .false.
   end type drawn_case_t

   !> What the numbers of a case are drawn about.
   type :: sizes_t
      !> Decimal logarithms of Pa, m and s, and the decades about them.
      real(dp) :: logarithm(n_dimensions) = 0, spread = 1
   end type sizes_t

contains

   !> Draw a case that the model accepts; none if that was not to be had. The model has its datasets then.
   subroutine draw_case(model, dice, drawn, is_drawn)
      class(model_t), intent(inout) :: model
      type(dice_t), intent(inout) :: dice
      type(drawn_case_t), intent(out) :: drawn
      logical, intent(out) :: is_drawn
      real(dp), allocatable :: values(:)
      type(drawn_data_t), allocatable :: data(:)
      type(sizes_t) :: sizes
      integer :: trial, most

      select case (model%name)
      case ('spectrum_elastic', 'free_surface')
         most = max_starts
      case ('wave_2d_elastic', 'surface_elastic', 'hertz')
         most = starts_of_some
      case default
         most = 1
      end select
      call draw_sizes(dice, sizes)
      call draw_data(model, dice, sizes%logarithm, data, is_drawn)
      if (.not. is_drawn) return
      do trial = 1, most
         call draw_values(model, dice, sizes, values)
         if (model%name == 'spectrum_elastic') call draw_waves(model, dice, sizes, data, values)
         call mend_values(model, dice, sizes, values, is_drawn)
         if (is_drawn) exit
      end do
      if (is_drawn) call draw_neighbours(model, dice, sizes, values, drawn, is_drawn)
      call move_alloc(data, drawn%data)
   end subroutine draw_case

   subroutine draw_sizes(dice, sizes)
      type(dice_t), intent(inout) :: dice
      type(sizes_t), intent(out) :: sizes
      real(dp), parameter :: spreads(*) = [0.3_dp, 0.6_dp, 1.0_dp, 2.0_dp, 4.0_dp, 6.0_dp]
      logical :: is_any_size, is_wild
      real(dp) :: reach
      integer :: k, which

      call dice%happens(share_any_size, is_any_size)
      call dice%happens(share_wild, is_wild)
      reach = merge(many_decades, usual_decades, is_any_size)
      do k = 1, n_dimensions
         call dice%between(-reach, reach, sizes%logarithm(k))
      end do
      call dice%choose(size(spreads), which)
      sizes%spread = spreads(which)
      if (is_wild) sizes%spread = wild_decades
   end subroutine draw_sizes

   !> Values of all variables, whether they make sense together or not.
   subroutine draw_values(model, dice, sizes, values)
      class(model_t), intent(in) :: model
      type(dice_t), intent(inout) :: dice
      type(sizes_t), intent(in) :: sizes
      real(dp), allocatable, intent(out) :: values(:)
      logical :: is_given
      integer :: k

      allocate (values(size(model%variables)))
      do k = 1, size(values)
         values(k) = model%variables(k)%default
      end do
      do k = 1, size(values)
         associate (v => model%variables(k))
            ! what fits alone give
            if (v%is_hidden) cycle
            if (is_set(v%default)) then
               call dice%happens(1 - share_default, is_given)
               if (v%kind == kind_logical) call dice%happens(share_with_profiles, is_given)
            else if (v%kind == kind_choice) then
               is_given = .true.
            else
               call dice%happens(share_given, is_given)
            end if
         end associate
         if (is_given) call draw_value(model, dice, sizes, values, k)
      end do
   end subroutine draw_values

   !> A spectrum, a period and a few cells that fit together: the period has the longest wave, and the shortest one has more than
   !> two cells. Whatever else is drawn, such as the height, is left as it is.
   subroutine draw_waves(model, dice, sizes, data, values)
      class(model_t), intent(in) :: model
      type(dice_t), intent(inout) :: dice
      type(sizes_t), intent(in) :: sizes
      !> Datasets, of which the table of a spectrum may be one.
      type(drawn_data_t), intent(in) :: data(:)
      real(dp), intent(inout) :: values(:)
      character(*), parameter :: heights(3) = [character(23) :: 'root_mean_square_height', 'root_mean_square_slope', &
         & 'plateau_density']
      real(dp) :: octaves, band, step, longest, shortest
      logical :: is_table
      integer :: period, period_y, cells, which, k

      period = model%index_of('surface', 'length_x')
      period_y = model%index_of('surface', 'length_y')
      cells = model%index_of('numerics', 'cells')
      call draw_value(model, dice, sizes, values, model%index_of('surface', 'seed'))
      call draw_value(model, dice, sizes, values, period)
      ! a law of attraction on more cells takes minutes
      values(cells) = model%variables(cells)%lower
      ! octaves from the period to the shortest wave that cells have
      octaves = log(values(cells))/log(2.0_dp) - 1.1_dp
      call find_table(model, data, octaves - 1, is_table, longest)
      if (is_table) call dice%happens(0.5_dp, is_table)
      do k = 1, size(values)
         if (model%variables(k)%group == 'power_spectrum') values(k) = model%variables(k)%default
      end do
      call dice%between(0.0_dp, 1.0_dp, step)
      if (is_table) then
         values(spectrum_row('wave_numbers')) = 1
         values(spectrum_row('densities')) = 1
         call draw_value(model, dice, sizes, values, spectrum_row('convention'))
         if (nint(values(spectrum_row('convention'))) == 3) longest = longest/two_pi
         values(period) = longest*2**step
         if (is_set(values(period_y))) values(period_y) = values(period)
         return
      end if
      call draw_value(model, dice, sizes, values, spectrum_row('hurst_exponent'))
      call dice%choose(size(heights), which)
      call draw_value(model, dice, sizes, values, spectrum_row(trim(heights(which))))
      longest = values(period)*2**(-step)
      octaves = octaves - step
      if (is_set(values(period_y))) then
         call dice%between(0.0_dp, 1.0_dp, step)
         values(period_y) = values(period)*2**step
         octaves = octaves - step
      end if
      call dice%between(0.2_dp, octaves, band)
      shortest = longest*2**(-band)
      values(spectrum_row('shortest_wavelength')) = shortest
      call dice%between(0.0_dp, band, step)
      ! one of both, or both
      call dice%choose(3, which)
      if (which /= 1) values(spectrum_row('longest_wavelength')) = longest
      if (which == 1) values(spectrum_row('rolloff_wavelength')) = longest
      if (which == 3) values(spectrum_row('rolloff_wavelength')) = max(shortest, longest*2**(-step))

   contains

      integer function spectrum_row(name)
         character(*), intent(in) :: name

         spectrum_row = model%index_of('power_spectrum', name)
      end function spectrum_row

   end subroutine draw_waves

   !> Do the wave numbers of a table rise, over no more than some octaves?
   subroutine find_table(model, data, octaves, is_table, longest)
      class(model_t), intent(in) :: model
      type(drawn_data_t), intent(in) :: data(:)
      real(dp), intent(in) :: octaves
      logical, intent(out) :: is_table
      !> Receives the longest wave if the wave numbers are in radians [m]; 0 if there is no table.
      real(dp), intent(out) :: longest
      integer :: row, k, n

      is_table = .false.
      longest = 0
      row = model%index_of('power_spectrum', 'wave_numbers')
      do k = 1, size(data)
         if (data(k)%position /= row) cycle
         associate (q => data(k)%values(:, 1))
            n = size(q)
            is_table = all(q(2:) > q(:n - 1)*(1 + 1.0e-9_dp))
            if (is_table) is_table = q(n) < q(1)*2**octaves
            if (is_table) longest = two_pi/q(1)
         end associate
      end do
   end subroutine find_table

   !> Draw one value.
   subroutine draw_value(model, dice, sizes, values, k)
      class(model_t), intent(in) :: model
      type(dice_t), intent(inout) :: dice
      type(sizes_t), intent(in) :: sizes
      real(dp), intent(inout) :: values(:)
      !> Position of the variable.
      integer, intent(in) :: k
      integer :: number

      associate (v => model%variables(k))
         select case (v%kind)
         case (kind_choice)
            call dice%choose(count_words(v%choices), number)
            values(k) = number
         case (kind_logical, kind_dataset)
            values(k) = 1
         case (kind_integer)
            ! the least, doubled a few times: counts that ask for a multiple are met
            call dice%choose(4, number)
            values(k) = min(max(v%lower, 1.0_dp)*2**(number - 1), v%upper)
         case (kind_real)
            call draw_number(v, dimensions_of(unit_in_case(model, values, k)), dice, sizes, values(k))
         end select
      end associate
   end subroutine draw_value

   !> Draw a real number within its range.
   subroutine draw_number(v, powers, dice, sizes, value)
      type(variable_t), intent(in) :: v
      !> Powers of Pa, m, s in its unit.
      real(dp), intent(in) :: powers(:)
      type(dice_t), intent(inout) :: dice
      type(sizes_t), intent(in) :: sizes
      real(dp), intent(out) :: value
      logical :: is_zero, is_at_bound, is_negative
      real(dp) :: centre
      integer, parameter :: max_trials = 20
      integer :: trial

      call dice%happens(share_zero, is_zero)
      call dice%happens(share_at_bound, is_at_bound)
      call dice%happens(0.3_dp, is_negative)
      value = 0
      if (is_zero .and. is_in_range(value, v)) return
      value = merge(v%lower, v%upper, is_negative)
      if (is_at_bound .and. abs(value) < 1.0e20_dp .and. is_in_range(value, v)) return
      centre = dot_product(powers, sizes%logarithm)
      do trial = 1, max_trials
         if (v%lower > 0 .and. v%upper < 1) then
            call dice%decades(log10(v%lower), log10(v%upper), value)
         else if (v%lower > -1.0e20_dp .and. v%upper < 1.0e20_dp .and. maxval(abs(powers)) <= 0) then
            call dice%between(v%lower, v%upper, value)
         else
            call dice%decades(representable(centre - sizes%spread), representable(centre + sizes%spread), value)
            if (is_negative .and. v%lower < 0) value = -value
            ! numbers with a lowest value are drawn from there, such as ratios >= 1
            if (v%lower >= 1) value = v%lower + value
         end if
         if (is_in_range(value, v)) return
      end do
      value = v%default
   end subroutine draw_number

   !> A decimal logarithm within those of all numbers.
   pure real(dp) function representable(logarithm)
      real(dp), intent(in) :: logarithm

      representable = max(-300.0_dp, min(300.0_dp, logarithm))
   end function representable

   !> Draw anew, or leave out, what the model finds wrong.
   subroutine mend_values(model, dice, sizes, values, is_valid)
      class(model_t), intent(in) :: model
      type(dice_t), intent(inout) :: dice
      type(sizes_t), intent(in) :: sizes
      real(dp), intent(inout) :: values(:)
      logical, intent(out) :: is_valid
      type(problems_t) :: problems
      logical :: is_left_out
      integer :: trial, k, which

      do trial = 1, max_repairs
         call find_problems(model, values, 0, problems)
         is_valid = problems%count() == 0
         if (is_valid) return
         call dice%choose(problems%count(), which)
         associate (item => problems%items(which))
            k = model%index_of(item%group, item%variable)
         end associate
         if (k == 0) return
         call dice%happens(0.6_dp, is_left_out)
         if (is_set(values(k)) .and. is_left_out) then
            values(k) = model%variables(k)%default
         else
            call draw_value(model, dice, sizes, values, k)
         end if
      end do
   end subroutine mend_values

   !> Ask the model, and the ranges of its table, what is wrong.
   subroutine find_problems(model, values, swept, problems)
      class(model_t), intent(in) :: model
      real(dp), intent(in) :: values(:)
      !> Position of a swept variable; 0 if there is none.
      integer, intent(in) :: swept
      type(problems_t), intent(out) :: problems
      logical :: is_swept(size(values))
      integer :: k

      is_swept = .false.
      if (swept > 0) is_swept(swept) = .true.
      do k = 1, size(values)
         associate (v => model%variables(k))
            if (v%kind /= kind_real .or. .not. is_set(values(k))) cycle
            if (.not. is_in_range(values(k), v)) call problems%add(v%group, v%name, 'is out of range')
         end associate
      end do
      if (problems%count() == 0) call model%check_values(values, is_swept, problems)
   end subroutine find_problems

   !> Points that differ in one variable, by anything from round-off to a multiple.
   subroutine draw_neighbours(model, dice, sizes, values, drawn, is_drawn)
      class(model_t), intent(in) :: model
      type(dice_t), intent(inout) :: dice
      type(sizes_t), intent(in) :: sizes
      real(dp), intent(in) :: values(:)
      type(drawn_case_t), intent(out) :: drawn
      logical, intent(out) :: is_drawn
      type(problems_t) :: problems
      real(dp) :: step, point(size(values)), list(size(values), n_neighbours)
      integer, allocatable :: candidates(:)
      integer :: k, n

      is_drawn = .false.
      candidates = pack([(k, k=1, size(values))], is_set(values) .and. model%variables%kind == kind_real)
      if (size(candidates) == 0) return
      call dice%choose(size(candidates), k)
      drawn%swept = candidates(k)
      call dice%decades(-16.0_dp, 0.5_dp, step)
      associate (value => values(drawn%swept))
         step = step*abs(value)
         if (.not. step > 0) step = 10.0_dp**representable(dot_product(sizes%logarithm, &
            & dimensions_of(unit_in_case(model, values, drawn%swept))))
      end associate
      n = 0
      do k = 1, n_neighbours
         point = values
         point(drawn%swept) = values(drawn%swept) + (k - 3)*step
         call find_problems(model, point, drawn%swept, problems)
         if (problems%count() > 0) cycle
         n = n + 1
         list(:, n) = point
      end do
      is_drawn = n > 0
      drawn%values = list(:, :n)
   end subroutine draw_neighbours

end module search_draw
