! SPDX-License-Identifier: GPL-3.0-or-later
!> What an input gives of a relaxation spectrum beside single numbers: lists of arms, or a master curve.
!>
!> Every model with a spectrum has the rows of the arms in its table, one behind the other. What is a modulus is the model's: a
!> stiffness of columns, or the contact modulus of a half-space.
module adfric_solid_given_spectrum
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_count, show_number
   use adfric_base_unset, only: unset, is_set
   use adfric_solid_master_curve, only: master_curve_fit_t, fit_master_curve, default_terms_per_decade
   use adfric_solid_prony, only: prony_t, most_arms
   use adfric_solid_retardation, only: retardation_t, new_retardation
   use adfric_describe_rows, only: above_zero, any_number, columns_row, list_row, positive
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: given_spectrum_t, set_arm_rows, fit_given_curve, check_numbers_of_arms, check_curve, check_fit
   public :: describe_fit, describe_arms, doubt_range
   public :: n_arm_rows

   !> Number of rows.
   integer, parameter :: n_arm_rows = 6
   !> Positions among the rows.
   integer, parameter :: young_moduli = 1, relaxation_times = 2, master_curve = 3, relaxed_modulus = 4, terms_per_decade = 5, &
      & time_factor = 6

   !> A misfit of |E| up to this one is good enough, and so many arms in a decade are offered at most to make it so.
   real(dp), parameter :: good_misfit = 5.0e-3_dp, most_terms_per_decade = 6.0_dp

   !> Lists and datasets of an input; what is not given is not allocated.
   type :: given_spectrum_t
      !> Moduli of arms in the unit of the model, Young's moduli of arms [Pa], and the relaxation times of either [s]; shape `(n)`.
      real(dp), allocatable :: moduli(:), young_moduli(:), relaxation_times(:)
      !> Angular frequency [rad/s], storage and loss modulus [Pa] of a master curve; shape `(n, 3)`.
      real(dp), allocatable :: master_curve(:, :)
      !> Temperature of the master curve [K], or unset.
      real(dp) :: master_temperature = unset
   end type given_spectrum_t

contains

   !> The rows of the arms.
   subroutine set_arm_rows(group, rows)
      !> Namelist group of the rows, without `&`.
      character(*), intent(in) :: group
      !> Receives the rows; shape `(n_arm_rows)`.
      type(variable_t), intent(out) :: rows(:)

      rows(young_moduli) = list_row(group=group, name='young_moduli', unit='Pa', &
         & meaning='moduli of arms beside young_modulus, one for each of relaxation_times', lower=0.0_dp, least_count=1, &
         & most_count=most_arms)
      rows(relaxation_times) = list_row(group=group, name='relaxation_times', unit='s', meaning='relaxation times of the arms', &
         & lower=1.0e-60_dp, least_count=1, most_count=most_arms)
      rows(master_curve) = columns_row(group=group, name='master_curve', columns='omega storage loss', units='rad/s Pa Pa', &
         & meaning='group with storage and loss modulus over the frequency, to which arms are fitted', least_count=2, &
         & attributes='reference_temperature', attribute_units='K')
      rows(relaxed_modulus) = positive(group=group, name='relaxed_modulus', unit='Pa', &
         & meaning='relaxed modulus of master_curve, where its data do not reach such low frequencies')
      rows(terms_per_decade) = any_number(group=group, name='terms_per_decade', unit='-', &
         & meaning='arms that are offered to a master curve in a decade; if not given 1.5, or 3 or 6 where the misfit halves', &
         & lower=0.1_dp, upper=10.0_dp)
      rows(time_factor) = above_zero(group=group, name='time_factor', unit='-', &
         & meaning='factor of all relaxation times; 1 if not given')
   end subroutine set_arm_rows

   !> Fit arms to the master curve.
   pure subroutine fit_given_curve(given, relaxed_modulus, terms_per_decade, fit)
      !> Lists and datasets of the input, with a master curve that has been checked.
      class(given_spectrum_t), intent(in) :: given
      !> Relaxed modulus in the unit of the curve, or unset: that of the fit.
      real(dp), intent(in) :: relaxed_modulus
      !> Arms that are offered in a decade, or unset.
      real(dp), intent(in) :: terms_per_decade
      !> Receives the fit.
      type(master_curve_fit_t), intent(out) :: fit
      type(master_curve_fit_t) :: finer
      real(dp) :: terms

      if (is_set(terms_per_decade)) then
         call fit_terms(given, relaxed_modulus, terms_per_decade, fit)
         return
      end if
      terms = default_terms_per_decade
      call fit_terms(given, relaxed_modulus, terms, fit)
      ! scatter of the data stays, however many arms there are; what halves was the distance of the times from those of the solid
      do while (fit%is_solved .and. terms < most_terms_per_decade)
         terms = 2*terms
         call fit_terms(given, relaxed_modulus, terms, finer)
         if (.not. (finer%is_solved .and. finer%modulus%rms < fit%modulus%rms/2 .and. fit%modulus%largest > good_misfit)) return
         fit = finer
      end do
   end subroutine fit_given_curve

   !> Fit arms to the master curve, of which so many are offered in a decade.
   pure subroutine fit_terms(given, relaxed_modulus, terms, fit)
      !> Lists and datasets of the input, with a master curve that has been checked.
      class(given_spectrum_t), intent(in) :: given
      !> Relaxed modulus in the unit of the curve, or unset: that of the fit.
      real(dp), intent(in) :: relaxed_modulus
      !> Arms that are offered in a decade.
      real(dp), intent(in) :: terms
      type(master_curve_fit_t), intent(out) :: fit

      associate (omega => given%master_curve(:, 1), storage => given%master_curve(:, 2), loss => given%master_curve(:, 3))
         if (is_set(relaxed_modulus)) then
            call fit_master_curve(fit, omega, storage, loss, terms, relaxed_modulus)
         else
            call fit_master_curve(fit, omega, storage, loss, terms)
         end if
      end associate
   end subroutine fit_terms

   !> Add to `problems` lists of arms that are not as long as that of their times.
   subroutine check_numbers_of_arms(moduli_row, young_moduli_row, given, problems)
      !> Rows of both lists; their names are part of the messages.
      type(variable_t), intent(in) :: moduli_row, young_moduli_row
      !> Lists and datasets of the input.
      class(given_spectrum_t), intent(in) :: given
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      if (.not. allocated(given%relaxation_times)) return
      if (allocated(given%moduli)) call compare(moduli_row, size(given%moduli))
      if (allocated(given%young_moduli)) call compare(young_moduli_row, size(given%young_moduli))
   contains
      !> Are there as many as times?
      subroutine compare(row, n)
         type(variable_t), intent(in) :: row
         integer, intent(in) :: n

         if (n /= size(given%relaxation_times)) call problems%add(row%group, row%name, &
            & 'are not as many as relaxation_times, given '//show_count(n)//', allowed: '//show_count(size(given%relaxation_times)))
      end subroutine compare
   end subroutine check_numbers_of_arms

   !> Add to `problems` what no master curve has.
   subroutine check_curve(row, relaxed_row, relaxed_modulus, given, problems)
      !> Row of the master curve; its name is part of the messages.
      type(variable_t), intent(in) :: row
      !> Row of the relaxed modulus.
      type(variable_t), intent(in) :: relaxed_row
      !> The relaxed modulus that is given, or unset.
      real(dp), intent(in) :: relaxed_modulus
      !> Lists and datasets of the input, with a master curve.
      class(given_spectrum_t), intent(in) :: given
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      if (.not. all(given%master_curve(:, 1) > 0)) then
         call problems%add(row%group, row%name, 'has frequencies that are not > 0, the least is '// &
            & show_number(minval(given%master_curve(:, 1)))//' rad/s')
      else if (.not. all(given%master_curve(:, 2:) >= 0) .or. &
         & .not. all(given%master_curve(:, 2) + given%master_curve(:, 3) > 0)) then
         call problems%add(row%group, row%name, 'has moduli < 0, or both 0')
      else if (is_set(relaxed_modulus)) then
         ! the storage modulus of a solid nowhere lies below the relaxed one
         if (relaxed_modulus > minval(given%master_curve(:, 2))) call problems%add(relaxed_row%group, relaxed_row%name, 'is '// &
            & show_number(relaxed_modulus)//' Pa, allowed: up to the least storage modulus of master_curve, '// &
            & show_number(minval(given%master_curve(:, 2)))//' Pa')
      end if
   end subroutine check_curve

   !> Add to `problems` a fit that gives no solid.
   subroutine check_fit(row, fit, problems)
      !> Row of the master curve; its name is part of the messages.
      type(variable_t), intent(in) :: row
      !> The fit of the master curve.
      type(master_curve_fit_t), intent(in) :: fit
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      if (.not. fit%is_solved) then
         call problems%add(row%group, row%name, 'cannot be fitted')
      else if (.not. fit%is_solid) then
         call problems%add(row%group, row%name, &
            & 'gives a fluid: its data do not reach the relaxed modulus; give relaxed_modulus, or add data at lower frequencies')
      end if
   end subroutine check_fit

   !> A line on the fit of a master curve.
   function describe_fit(given, fit) result(text)
      !> Lists and datasets of the input, with a master curve.
      class(given_spectrum_t), intent(in) :: given
      !> The fit of the master curve.
      type(master_curve_fit_t), intent(in) :: fit
      character(:), allocatable :: text
      character(200) :: line

      write (line, '(a, i0, a, i0, a, es9.2, a, es9.2)') 'master curve: ', size(given%master_curve, 1), ' frequencies, ', &
         & size(fit%prony%times), ' arms; misfit of |E| at most', fit%modulus%largest, ', root mean square', fit%modulus%rms
      text = trim(line)//new_line('a')
   end function describe_fit

   !> A line on each arm.
   function describe_arms(prony, name, unit) result(text)
      !> The spectrum.
      type(prony_t), intent(in) :: prony
      !> What its moduli are, and their unit.
      character(*), intent(in) :: name, unit
      character(:), allocatable :: text
      type(retardation_t) :: kelvin
      character(200) :: line
      integer :: i

      text = ''
      call new_retardation(kelvin, prony)
      do i = 1, size(prony%times)
         write (line, '(a, i0, 3(a, es13.6), a)') 'arm ', i, ': '//name, prony%moduli(i), ' '//unit//', relaxation time', &
            & prony%times(i), ' s, retardation time', kelvin%times(i), ' s'
         text = text//trim(line)//new_line('a')
      end do
   end function describe_arms

   !> A line where a surface excites frequencies at which the master curve was not measured; else nothing.
   function doubt_range(fit, frequencies) result(text)
      !> The fit of the master curve.
      type(master_curve_fit_t), intent(in) :: fit
      !> Lowest and highest angular frequency that the surface excites, at the reference temperature [rad/s].
      real(dp), intent(in) :: frequencies(2)
      character(:), allocatable :: text
      character(200) :: line

      text = ''
      ! nothing is excited where the surface does not vary along the motion
      if (.not. frequencies(2) > 0) return
      if (.not. (frequencies(1) < fit%lowest_frequency .or. frequencies(2) > fit%highest_frequency)) return
      write (line, '(4(a, es9.2), a)') 'the surface excites', frequencies(1), ' to', frequencies(2), &
         & ' rad/s, and the master curve was measured from', fit%lowest_frequency, ' to', fit%highest_frequency, &
         & ' rad/s: beyond it friction is missing'
      text = trim(line)//new_line('a')
   end function doubt_range

end module adfric_solid_given_spectrum
