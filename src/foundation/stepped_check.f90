! SPDX-License-Identifier: GPL-3.0-or-later
!> What is missing, contradictory or impossible in an input of `wavy_sliding` on heights or with a spectrum.
module adfric_foundation_stepped_check
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_count
   use adfric_base_unset, only: is_set, unset
   use adfric_interface_adhesion_rows, only: check_stress, n_adhesion_rows
   use adfric_interface_attraction, only: law_lennard_jones, law_table
   use adfric_interface_attraction_rows, only: check_attraction, n_attraction_rows
   use adfric_solid_given_spectrum, only: check_curve, check_fit, check_numbers_of_arms
   use adfric_solid_master_curve, only: master_curve_fit_t
   use adfric_solid_prony, only: prony_t
   use adfric_solid_shift_rows, only: check_shift
   use adfric_describe_check, only: checks_t, new_checks
   use adfric_describe_table, only: variable_t
   use adfric_foundation_case, only: dugdale_of, kind_2d, kind_3d, kind_cosines, kind_map
   use adfric_foundation_given_surface, only: given_surface_t
   use adfric_foundation_stepping_relief, only: relief_t
   use adfric_foundation_stepped_case, only: stepped_case_t, get_relief, get_spectrum, has_heights, has_other_law, &
      & resolve_stepped, samples_of, &
      & spacing_of, strip_spacing_of
   use adfric_foundation_variables, only: in => foundation_input
   implicit none (type, external)
   private
   public :: check_stepped_values, check_load_values, require_modulus, require_single_time

   !> Fewest samples of a row.
   integer, parameter :: fewest_samples = 4
   !> Index of the word in the choice of the slope.
   integer, parameter :: slope_finite = 2
   !> Beyond it a number in the units of the time stepping is an input's mistake.
   real(dp), parameter :: largest = 1.0e100_dp

contains

   !> Add to `problems` what is wrong with the values together. It is long by its procedures, one a group, which share the checks.
   subroutine check_stepped_values(variables, values, given, is_swept, problems)
      !> Table of the variables; their names stand in the messages.
      type(variable_t), intent(in), target :: variables(:)
      !> Values in the order of `variables`, `unset` where none is given; shape `(n_variables)`.
      real(dp), intent(in), target :: values(:)
      type(given_surface_t), intent(in) :: given
      logical, intent(in), target :: is_swept(:)
      type(problems_t), intent(inout), target :: problems
      type(checks_t) :: c
      integer :: before

      before = problems%count()
      call new_checks(c, variables, values, problems, is_swept)
      call c%need([in%kind])
      if (problems%count() > before) return
      call check_surface()
      call check_foundation()
      call check_shift(variables, values, is_swept, in%shift, in%temperature, given%master_temperature, problems)
      call check_law()
      call c%need([in%velocity])
      call check_load_values(c)
      call c%refuse([in%pull_off], 'belongs to waves on a standard solid with Dugdale''s law; '// &
         & 'not to heights, cosines or a spectrum')
      call c%add(in%slope, 'is small for heights, cosines and spectra', c%is_choice(in%slope, slope_finite))
      call check_profiles()
      if (problems%count() == before) call check_numbers()

   contains

      !> What the kind of the surface needs, and what it has no use for.
      subroutine check_surface()
         integer, parameter :: of_heights(*) = [in%heights, in%spacing, in%interpolation, in%detrend, in%periodise, &
            & in%blend_share, &
            & in%shortest_wavelength]

         select case (nint(values(in%kind)))
         case (kind_2d)
            call c%need([in%period, in%height])
            call c%refuse([of_heights, in%strip_spacing, in%amplitudes, in%phases, in%reverse], 'has no meaning for kind wave_2d')
         case (kind_3d)
            if (has_other_law(values)) then
               call c%add(in%kind, 'is wave_3d, whose strips have Dugdale''s law; make a map of it for another one')
            else
               call c%add(in%kind, 'is wave_3d, which has one relaxation time; make a map of it for a spectrum')
            end if
         case (kind_cosines)
            call c%need([in%period, in%amplitudes, in%phases])
            call c%refuse([of_heights, in%strip_spacing, in%height], 'has no meaning for kind cosines')
            if (allocated(given%amplitudes) .and. allocated(given%phases)) then
               if (size(given%amplitudes) /= size(given%phases)) call c%add(in%phases, 'are not as many as amplitudes, given '// &
                  & show_count(size(given%phases))//', allowed: '//show_count(size(given%amplitudes)))
            end if
         case default
            call c%need([in%heights])
            call c%refuse([in%amplitudes, in%phases, in%period, in%height], 'has no meaning beside heights')
            if (allocated(given%heights)) call check_heights()
         end select
      end subroutine check_surface

      !> Number and distances of samples.
      subroutine check_heights()
         logical :: is_map

         is_map = nint(values(in%kind)) == kind_map
         if (.not. is_set(spacing_of(values, given))) call c%add(in%spacing, &
            & 'is missing [m]; it is needed for heights without an attribute dx')
         if (size(given%heights, 1) < fewest_samples) call c%add(in%heights, 'have too few samples along x, 4 are needed')
         if (is_map) then
            if (.not. is_set(strip_spacing_of(values, given))) call c%add(in%strip_spacing, &
               & 'is missing [m]; it is needed for heights without an attribute dy')
            if (size(given%heights, 2) < 2) call c%add(in%heights, 'of a map have two dimensions, y and x')
         else
            call c%refuse([in%strip_spacing], 'has no meaning for kind profile')
            if (size(given%heights, 2) > 1) call c%add(in%heights, &
               & 'of a profile have one dimension; a dataset of two is a map')
         end if
      end subroutine check_heights

      !> Relaxed stiffness and arms.
      subroutine check_foundation()
         integer, parameter :: of_layer(2) = [in%poisson_ratio, in%thickness]
         integer, parameter :: single(2) = [in%relaxation_time, in%retardation_ratio]

         if (c%has(in%master_curve)) then
            call c%refuse([in%stiffness, in%young_modulus, in%moduli, in%young_moduli, in%relaxation_times, single], &
               & 'stands beside master_curve, which gives all moduli and times')
            call c%need(of_layer)
            return
         end if
         call c%refuse([in%relaxed_modulus, in%terms_per_decade], 'has no meaning without master_curve')
         if (c%has(in%stiffness)) then
            call c%refuse([in%young_modulus, of_layer, in%young_moduli], &
               & 'stands beside stiffness; give stiffness and moduli, or young_modulus, young_moduli, poisson_ratio and thickness')
         else
            call require_modulus(c)
            call c%refuse([in%moduli], 'needs stiffness; young_moduli stand beside young_modulus')
         end if
         if (.not. c%has(in%relaxation_times)) then
            call c%refuse([in%moduli, in%young_moduli], 'needs relaxation_times')
            call require_single_time(c)
            return
         end if
         call c%refuse(single, 'stands beside relaxation_times; give one or the other')
         call c%need([merge(in%moduli, in%young_moduli, c%has(in%stiffness))])
         call check_numbers_of_arms(variables(in%moduli), variables(in%young_moduli), given, problems)
      end subroutine check_foundation

      !> Adhesion: Dugdale's, or another law, which has no edge rule.
      subroutine check_law()
         type(variable_t) :: rows(n_adhesion_rows + n_attraction_rows)
         real(dp) :: law(n_adhesion_rows + n_attraction_rows)
         integer, parameter :: stresses = in%range - in%stress + 1, first = n_adhesion_rows + 1

         if (.not. has_other_law(values)) then
            call check_stress(variables(in%stress:in%range), dugdale_of(values), problems)
            call c%refuse([in%tension_table], 'has no meaning without law = ''table''')
            return
         end if
         if (nint(values(in%law)) == law_lennard_jones) then
            call c%add(in%law, 'is ''lennard_jones'', which has no wall; columns are solved with laws that only pull')
            return
         end if
         call c%refuse([in%edge], 'is a rule for Dugdale''s law; others follow the column')
         rows = variables(in%law)
         rows(:stresses) = variables(in%stress:in%range)
         rows(first + 1) = variables(in%tension_table)
         law = unset
         law(:stresses) = values(in%stress:in%range)
         law(first:first + 1) = values([in%law, in%tension_table])
         if (nint(values(in%law)) /= law_table .and. count(is_set(law(:stresses))) == 1) then
            call c%add(in%law, 'needs two of '//rows(2)%name//', '//rows(1)%name//' and '//rows(3)%name)
            return
         end if
         call check_attraction(rows, law, given%attraction, problems)
      end subroutine check_law

      !> Axes of profiles are the same for all points.
      subroutine check_profiles()
         integer, parameter :: of_axes(*) = [in%period, in%spacing, in%strip_spacing, in%periodise, in%blend_share, in%n_x]
         integer :: k

         if (.not. values(in%profiles) > 0) return
         do k = 1, size(of_axes)
            call c%add(in%profiles, 'need one axis, and '//variables(of_axes(k))%name &
               & //' is swept; sweep another variable or switch profiles off', is_swept(of_axes(k)))
         end do
      end subroutine check_profiles

      !> Values that are possible one by one, and beyond all numbers together: the spectrum, the rows, and both.
      subroutine check_numbers()
         type(prony_t) :: prony
         type(relief_t) :: relief

         call check_spectrum(prony)
         call check_rows(relief)
         if (problems%count() == before) call check_reduced(prony, relief)
      end subroutine check_numbers

      !> What a fit makes of a master curve, and arms whose stiffness is a number.
      subroutine check_spectrum(prony)
         type(prony_t), intent(out) :: prony
         type(master_curve_fit_t) :: fit

         if (c%has(in%master_curve)) then
            call check_curve(variables(in%master_curve), variables(in%relaxed_modulus), values(in%relaxed_modulus), given, problems)
            if (problems%count() > before) return
         end if
         call get_spectrum(values, given, prony, fit)
         if (c%has(in%master_curve)) then
            call check_fit(variables(in%master_curve), fit, problems)
            if (.not. (fit%is_solved .and. fit%is_solid)) return
         end if
         associate (instantaneous => prony%relaxed + sum(prony%moduli))
            if (.not. (prony%relaxed > tiny(1.0_dp) .and. prony%relaxed > instantaneous/largest)) call c%add( &
               & merge(in%stiffness, merge(in%relaxed_modulus, in%young_modulus, c%has(in%relaxed_modulus)), &
               & c%has(in%stiffness)), 'is too small, or other moduli are too large, for a foundation')
         end associate
      end subroutine check_spectrum

      !> Heights that make rows.
      subroutine check_rows(relief)
         type(relief_t), intent(out) :: relief
         type(error_t), allocatable :: error
         real(dp), parameter :: round_off = 100*epsilon(1.0_dp)

         if (.not. has_heights(values)) then
            call get_relief(values, given, .false., relief, error)
            return
         end if
         if (samples_of(values, given) < fewest_samples) then
            call c%add(in%heights, 'have too few samples once their ends have been brought together, 4 are needed')
            return
         end if
         call get_relief(values, given, .false., relief, error)
         if (allocated(error)) then
            call c%add(in%heights, 'cannot be prepared: '//error%message)
         else if (.not. relief%height > round_off*maxval(abs(given%heights))) then
            call c%add(in%heights, 'are flat once trend and short waves are taken out')
         end if
      end subroutine check_rows

      !> Sizes in the units of the time stepping.
      subroutine check_reduced(prony, relief)
         type(prony_t), intent(in) :: prony
         type(relief_t), intent(in) :: relief
         type(stepped_case_t) :: point

         call resolve_stepped(values, given, relief, prony, point)
         if (.not. (point%pressure_unit > tiny(1.0_dp) .and. point%friction_unit > tiny(1.0_dp) &
            & .and. max(point%pressure_unit, point%load_unit, point%friction_unit) < largest)) then
            call c%add(in%kind, 'has heights and a period that are too small or too large for the stiffness')
            return
         end if
         if (.not. point%pace < largest) then
            call c%add(in%velocity, 'is too large for the period')
         else if (size(prony%times) > 0) then
            if (.not. sum(prony%moduli)/prony%relaxed*point%pace*maxval(prony%times) < largest) call c%add(in%velocity, &
               & 'times the longest retardation time is too large for the period')
         end if
         if (.not. max(point%stress, point%range) < largest) call c%add(in%stress, &
            & 'or its range is too large for these heights and this stiffness')
         if (.not. max(abs(point%load), abs(point%penetration)) < largest) then
            if (c%has(in%load)) call c%add(in%load, 'is too large for these heights and this stiffness')
            if (c%has(in%mean_pressure)) call c%add(in%mean_pressure, 'is too large for these heights and this stiffness')
            if (c%has(in%penetration)) call c%add(in%penetration, 'is too large for these heights')
         end if
      end subroutine check_reduced

   end subroutine check_stepped_values

   !> Without a stiffness all of a layer is asked for.
   subroutine require_modulus(c)
      type(checks_t), intent(in) :: c

      if (.not. c%has_any([in%young_modulus, in%poisson_ratio, in%thickness])) then
         call c%add(in%stiffness, 'is missing [Pa/m]; give it, or young_modulus, poisson_ratio and thickness, or master_curve')
         return
      end if
      call c%add(in%young_modulus, 'is missing [Pa]; a layer has it, or master_curve', .not. c%has(in%young_modulus))
      call c%need([in%poisson_ratio, in%thickness])
   end subroutine require_modulus

   !> The standard solid, which is asked for where there is no spectrum.
   subroutine require_single_time(c)
      type(checks_t), intent(in) :: c
      integer, parameter :: single(2) = [in%relaxation_time, in%retardation_ratio]
      integer :: k

      do k = 1, size(single)
         call c%add(single(k), 'is missing ['//c%variables(single(k))%unit &
            & //']; it is needed without relaxation_times or master_curve', .not. c%has(single(k)))
      end do
   end subroutine require_single_time

   !> Load, mean pressure or penetration: one of them.
   subroutine check_load_values(c)
      type(checks_t), intent(in) :: c
      integer, parameter :: list(3) = [in%load, in%mean_pressure, in%penetration]

      call c%add(in%load, 'is missing; load or penetration is needed', .not. c%has_any(list))
      call c%need_one(list, .false.)
   end subroutine check_load_values

end module adfric_foundation_stepped_check
