! SPDX-License-Identifier: GPL-3.0-or-later
!> Names of what a fit has in its results file.
module adfric_fit_names
   use adfric_base_text, only: show_count
   use adfric_base_words, only: count_words, get_word, has_word
   use adfric_base_unset, only: is_set
   use adfric_base_kinds, only: dp
   use adfric_fit_parts, only: has_others
   use adfric_fit_problem, only: data_set_t, fit_t, nuisance_names
   use adfric_describe_derived, only: add_derived, derived_t
   implicit none (type, external)
   private
   public :: list_free_names, list_extra_names, name_of_other, suffix_of, find_derived_rows

   !> Names of what a single fit has in addition, of the fit and of each data set.
   character(*), parameter :: names_of_fit = 'variable other_variable start null_vector covariance covariance_internal '// &
      & 'correlation covariance_scaled level piece end interval interval_pieces minimum minima minima_chi2 theory_name '// &
      & 'theory_chi2 theory_aic theory_bic theory_estimate event event_kind event_data event_value event_sigma'
   character(*), parameter :: names_of_data = 'point abscissa ordinate sigma abscissa_sigma branch segment used fitted '// &
      & 'residual curve_x curve second_curve band_low band_high'

contains

   !> Names of the free variables as datasets, separated by a blank: without the group, unless two of them would have one name.
   function list_free_names(fit) result(names)
      type(fit_t), intent(in) :: fit
      character(:), allocatable :: names, name
      integer :: i, k, n_same

      names = ''
      name = ''
      do i = 1, size(fit%frees)
         associate (free => fit%frees(i))
            if (free%nuisance > 0) then
               name = get_word(nuisance_names, free%nuisance)//suffix_of(fit, free%data_set)
            else
               name = fit%model%variables(free%variable)%name
               n_same = 0
               do k = 1, size(fit%frees)
                  if (fit%frees(k)%variable == 0) cycle
                  if (fit%model%variables(fit%frees(k)%variable)%name == name) n_same = n_same + 1
               end do
               if (n_same > 1) name = fit%model%variables(free%variable)%group//'_'//name
            end if
         end associate
         names = names//' '//name
      end do
      names = trim(adjustl(names))
   end function list_free_names

   !> Names of the datasets that a single fit may have beside its results, separated by a blank.
   function list_extra_names(fit) result(names)
      !> The fit with its data sets and free variables.
      type(fit_t), intent(in) :: fit
      character(:), allocatable :: names, frees, name
      integer :: i, k

      names = names_of_fit
      name = ''
      frees = ''
      do k = 1, size(fit%data_sets)
         do i = 1, count_words(names_of_data)
            names = names//' '//get_word(names_of_data, i)//suffix_of(fit, k)
         end do
         if (.not. has_others(fit%data_sets(k))) cycle
         names = names//' curve_point'//suffix_of(fit, k)
         do i = 1, size(fit%data_sets(k)%others)
            name = name_of_other(fit, fit%data_sets(k), i)//suffix_of(fit, k)
            names = names//' point_'//name//' curve_'//name
         end do
      end do
      frees = list_free_names(fit)
      do i = 1, count_words(frees)
         names = names//' '//get_word(frees, i)//'_profile '//get_word(frees, i)//'_profile_value'
      end do
   end function list_extra_names

   !> Name of a further variable of a data set in the names of datasets: with its group where the data set has two of its name.
   function name_of_other(fit, data_set, number) result(name)
      type(fit_t), intent(in) :: fit
      type(data_set_t), intent(in) :: data_set
      !> Which of its further variables, from 1.
      integer, intent(in) :: number
      character(:), allocatable :: name
      integer :: i, n_same

      associate (rows => fit%model%variables, others => data_set%others)
         name = rows(others(number))%name
         n_same = 0
         do i = 1, size(others)
            if (rows(others(i))%name == name) n_same = n_same + 1
         end do
         if (n_same > 1) name = rows(others(number))%group//'_'//name
      end associate
   end function name_of_other

   !> What stands behind the names of what each data set has; nothing if there is only one.
   pure function suffix_of(fit, data_set) result(suffix)
      type(fit_t), intent(in) :: fit
      !> Number of the data set, from 1.
      integer, intent(in) :: data_set
      character(:), allocatable :: suffix

      suffix = ''
      if (size(fit%data_sets) > 1) suffix = '_'//show_count(data_set)
   end function suffix_of

   !> Names and units of the derived quantities that a fit gives (`adfric_fit_derived`): those of a sphere that are asked for, and that
   !> are neither free nor given.
   subroutine find_derived_rows(fit, rows)
      !> The fit with its model and its free variables.
      type(fit_t), intent(in) :: fit
      !> Receives the rows; their values have no meaning.
      type(derived_t), allocatable, intent(out) :: rows(:)
      type(derived_t), allocatable :: all_rows(:)
      logical, allocatable :: is_wanted(:)
      integer :: i, k, first, theory

      allocate (rows(0))
      if (fit%model%name /= 'sphere') return
      call add_derived(all_rows, 'adhesion_stress', 'Pa', 'sigma0, the stress of Dugdale''s law', 0.0_dp)
      call add_derived(all_rows, 'adhesion_range', 'm', 'h0 = w/sigma0', 0.0_dp)
      call add_derived(all_rows, 'lambda', '-', 'Maugis''s parameter lambda', 0.0_dp)
      call add_derived(all_rows, 'pull_off_load', 'N', 'load at which the contact is lost when the load is held', 0.0_dp)
      first = 1
      theory = fit%model%solver_index_of('model', 'theory')
      select case (get_word(fit%model%variables(theory)%choices, nint(fit%base(theory))))
      case ('hertz')
         first = size(all_rows) + 1
      case ('jkr', 'dmt')
         first = size(all_rows)
      end select
      allocate (is_wanted(size(all_rows)), source=.true.)
      is_wanted(:first - 1) = .false.
      do i = 1, size(all_rows)
         if (allocated(fit%derived)) then
            if (len_trim(fit%derived) > 0) is_wanted(i) = is_wanted(i) .and. has_word(fit%derived, all_rows(i)%name)
         end if
         k = fit%model%solver_index_of('sphere', all_rows(i)%name)
         if (k == 0) cycle
         is_wanted(i) = is_wanted(i) .and. .not. is_set(fit%base(k)) .and. .not. any(fit%frees%variable == k)
      end do
      rows = pack(all_rows, is_wanted)
   end subroutine find_derived_rows

end module adfric_fit_names
