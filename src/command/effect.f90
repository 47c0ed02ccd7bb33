! SPDX-License-Identifier: GPL-3.0-or-later
!> Which values that nobody gave have an effect in a scene: `adfric check` shows these alone.
module adfric_command_effect
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: get_word, has_word
   use adfric_describe_table, only: variable_t
   use adfric_input_run, only: run_input_t
   implicit none (type, external)
   private
   public :: has_effect

   !> Where profiles are sampled.
   character(*), parameter :: samples = 'n_x n_y n_z n_r x_min y_min z_min'
   !> Coefficients of a polynomial.
   character(*), parameter :: coefficients = &
      & 'coefficient_1 coefficient_2 coefficient_3 coefficient_4 coefficient_5 coefficient_6 coefficient_7 coefficient_8'
   !> What belongs to adhesion, to a shear strength, and to both.
   character(*), parameter :: of_adhesion = 'branch theory theory_tolerance pull_off', of_shear = 'law state', &
      & of_both = 'edge_fraction interaction'
   !> What belongs to surfaces that vary along y.
   character(*), parameter :: of_maps = 'strips n_y'
   !> Surfaces that vary along x alone.
   character(*), parameter :: lines(*) = [character(8) :: 'wave_1d', 'profile', 'cylinder']

contains

   !> Has the default of a variable an effect? Of an input that names a model every variable is shown.
   function has_effect(run, at) result(is_shown)
      type(run_input_t), intent(in) :: run
      !> Index of the variable in the table of the model.
      integer, intent(in) :: at
      logical :: is_shown
      logical :: adheres, shears

      is_shown = .true.
      if (run%is_given(at) .or. .not. allocated(run%model%scene)) return
      adheres = index(run%model%scene, 'adhesion') > 0 .and. word_of(run, 'theory') /= 'hertz'
      shears = index(run%model%scene, 'shear strength') > 0
      associate (name => run%model%variables(at)%name)
         if (has_word(samples, name)) is_shown = has_profiles(run)
         if (has_word(coefficients, name)) is_shown = index(run%model%scene, 'polynomial') > 0
         if (has_word(of_adhesion, name)) is_shown = adheres
         if (has_word(of_shear, name)) is_shown = shears
         if (has_word(of_both, name)) is_shown = adheres .and. shears
         if (has_word(of_maps, name)) is_shown = is_shown .and. .not. any(index(run%model%scene, lines) == 1)
         if (name == 'events') is_shown = adheres .or. shears
         if (name == 'theory_tolerance') is_shown = is_shown .and. word_of(run, 'theory') == 'auto'
      end associate
   end function has_effect

   !> Are profiles written?
   pure logical function has_profiles(run)
      type(run_input_t), intent(in) :: run
      integer :: i

      i = index_of(run%model%variables, 'profiles')
      has_profiles = i == 0
      if (i > 0) has_profiles = run%plan%base(i) > 0.5
   end function has_profiles

   !> The word that a variable has; empty where it has none.
   function word_of(run, name) result(word)
      type(run_input_t), intent(in) :: run
      !> Name of a variable.
      character(*), intent(in) :: name
      character(:), allocatable :: word
      integer :: i

      word = ''
      i = index_of(run%model%variables, name)
      if (i == 0) return
      if (is_set(run%plan%base(i))) word = get_word(run%model%variables(i)%choices, nint(run%plan%base(i)))
   end function word_of

   !> Index of a variable that the scene has; 0 if it has none.
   pure integer function index_of(variables, name) result(i)
      type(variable_t), intent(in) :: variables(:)
      !> Its name.
      character(*), intent(in) :: name

      do i = size(variables), 1, -1
         if (variables(i)%name == name .and. .not. variables(i)%is_hidden) return
      end do
   end function index_of

end module adfric_command_effect
